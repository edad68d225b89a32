"""The linear delta as effects find it: names to write energies in, and joints and springs to change.

Without effects the machine is the base model.  Effects are applied before anything is derived; what they
refer to (velocities, free lengths) are names, whose definitions follow from the whole machine.
"""

from __future__ import annotations

from collections.abc import Sequence

from sympy import Add, Expr, Integer, Rational, Symbol

from pkmodes_derive.effect import Coordinate, Effect
from pkmodes_derive.linear_delta.symbols import Symbols
from pkmodes_derive.vocabulary import AXES, Field, Vector

HALF = Rational(1, 2)


class Machine:
    """What effects may read and change.

    Attributes
    ----------
    sy : Symbols
        Parameters and base coordinates.
    v_p : tuple of sympy.Symbol
        Absolute velocity of the platform [m/s].
    platform_position : tuple of sympy.Expr
        Absolute position of the platform centre [m].
    platform_displacement : tuple of sympy.Symbol
        Small absolute displacement of the platform centre from the pose [m].
    l_f : tuple of tuple of sympy.Symbol
        Free lengths of the belt spans, [axis][span] [m].
    drive : tuple of tuple of sympy.Symbol
        1 where the motor drives the pulley, [axis][pulley].
    elongation, clamp, wind_up, frame : lists
        Released coordinates that add to link j, clamp j, gearbox j, frame component i.
    span_compliance, stiffness_change, driven_inertia : lists of sympy.Expr
        Sums over the effects, for each axis.
    kinetic, elastic : lists of sympy.Expr
        Energies [J] that effects add.
    weights : list of (mass, position)
        Bodies that effects add, for gravity.
    released : tuple of Coordinate
        Every released coordinate, in order.
    compliances : tuple of sympy.Symbol
        For each released coordinate, the compliance of its spring.
    """

    def __init__(self, sy: Symbols, effects: Sequence[Effect] = ()) -> None:
        self.sy = sy
        v = sy.vocabulary
        self.v_p: Vector = v.vector("v_p", "m/s", "velocity of the platform", r"\dot{p}")
        self.l_f, self.k = _spans(sy)
        self.drive = sy.drive
        self.elongation: list[list[Coordinate]] = [[], [], []]
        self.clamp: list[list[Coordinate]] = [[], [], []]
        self.wind_up: list[list[Coordinate]] = [[], [], []]
        self.frame: list[list[Coordinate]] = [[], [], []]
        self.span_compliance: list[Expr] = [Integer(0)] * 3
        self.stiffness_change: list[Expr] = [Integer(0)] * 3
        self.driven_inertia: list[Expr] = [Integer(0)] * 3
        self.kinetic: list[Expr] = []
        self.elastic: list[Expr] = []
        self.weights: list[tuple[Expr, Sequence[Expr]]] = []
        self.effects = tuple(effects)
        self.released: tuple[Coordinate, ...] = ()
        self.compliances: tuple[Symbol, ...] = ()
        self.fields: tuple[Field, ...] = ()
        self.platform_displacement: tuple[Symbol, ...] = ()
        if effects:  # only they need it
            self.platform_displacement = v.vector(
                "delta_p", "m", "small displacement of the platform from the pose", r"\Delta p"
            )
        # Two passes: effects see every released coordinate, whichever of them is applied first.
        prepared = [(effect, self._parameters(effect), self._release(effect)) for effect in effects]
        for _, parameters, released in prepared:
            if released:
                self.compliances += (parameters["compliance"],) * len(released)
        for effect, parameters, released in sorted(prepared, key=lambda item: not item[2]):
            effect.apply(self, parameters, released)

    @property
    def platform_position(self) -> tuple[Expr, ...]:
        """Absolute position of the platform centre: on the frame, and with it."""
        return tuple(
            Add(self.sy.p[i], *(coordinate.position for coordinate in self.frame[i])) for i in range(3)
        )

    @property
    def frame_rate(self) -> tuple[Expr, ...]:
        """Velocity of the frame [m/s]."""
        return tuple(Add(*(coordinate.rate for coordinate in component)) for component in self.frame)

    def pulley_displacements(self, j: int) -> tuple[Symbol, Symbol]:
        """Small rotations of pulleys 1 and 2 of axis j, counted from 0 [rad]."""
        return self.sy.displacements[3 + j], self.sy.displacements[6 + j]

    def span_end_rates(self, j: int) -> tuple[tuple[Expr, Expr], ...]:
        """Velocities of both ends of the three spans of axis j, relative to the frame [m/s]."""
        return self._span_ends(j, self.sy.velocities, [c.rate for c in self.clamp[j]])

    def span_end_displacements(self, j: int) -> tuple[tuple[Expr, Expr], ...]:
        """Small displacements of both ends of the three spans of axis j [m]."""
        return self._span_ends(j, self.sy.displacements, [c.position for c in self.clamp[j]])

    def _span_ends(
        self, j: int, q: Sequence[Symbol], clamp: Sequence[Symbol]
    ) -> tuple[tuple[Expr, Expr], ...]:
        rim_1, rim_2 = self.sy.R_p[j] * q[3 + j], self.sy.R_p[j] * q[6 + j]
        carriage = Add(q[j], *clamp)
        return (rim_2, rim_1), (carriage, rim_2), (rim_1, carriage)

    def add_kinetic(self, energy: Expr) -> None:
        """Add kinetic energy, a quadratic form of velocities."""
        self.kinetic.append(energy)

    def add_elastic(self, energy: Expr) -> None:
        """Add elastic energy, a quadratic form of small displacements."""
        self.elastic.append(energy)

    def add_weight(self, mass: Expr, position: Sequence[Expr]) -> None:
        """Add a body on which gravity acts."""
        self.weights.append((mass, position))

    def _parameters(self, effect: Effect) -> dict[str, Symbol]:
        symbols = {}
        for parameter in effect.parameters:
            symbol = self.sy.vocabulary.declare(
                parameter.symbol, parameter.unit, parameter.description, parameter.latex
            )
            symbols[parameter.name] = symbol
            name = f"{effect.name}_{parameter.name}"
            self.fields += (Field(name, (), (symbol,), parameter.unit, parameter.description),)
        return symbols

    def _release(self, effect: Effect) -> tuple[Coordinate, ...]:
        v, released = self.sy.vocabulary, []
        for name in effect.coordinates:
            stem, index = name.rsplit("_", 1)
            letter = "i" if index in AXES else "j"
            description = f"{effect.coordinate_description} {{{letter}}}"
            latex = rf"\{stem}" if len(stem) > 1 else stem
            latex = {r"\eps": r"\varepsilon"}.get(latex, latex)
            place = {letter: index}
            released.append(
                Coordinate(
                    v.declare(
                        f"{stem}_{{{letter}}}",
                        effect.coordinate_unit,
                        description,
                        f"{latex}_{{{letter}}}",
                        **place,
                    ),
                    v.declare(
                        f"{stem}_{{{letter}}}_dot",
                        f"{effect.coordinate_unit}/s",
                        f"rate of change: {description}",
                        rf"\dot{{{{{latex}}}}}_{{{letter}}}",
                        **place,
                    ),
                )
            )
        self.released += tuple(released)
        return tuple(released)


def _spans(sy: Symbols) -> tuple[tuple[tuple[Symbol, ...], ...], tuple[tuple[Symbol, ...], ...]]:
    """Names of the free lengths and stiffnesses of the spans, [axis][span]."""
    of_span = "span {s} of belt {j} (1 between the pulleys, 2 from carriage to pulley 2, 3 from carriage to pulley 1)"
    lengths, stiffnesses = (
        tuple(
            tuple(sy.vocabulary.declare(name, unit, f"{what} {of_span}", latex, j=j, s=s) for s in (1, 2, 3))
            for j in (1, 2, 3)
        )
        for name, unit, what, latex in (
            ("l_f_{j}_{s}", "m", "free length of", "l_{{f,{j},{s}}}"),
            ("k_{j}_{s}", "N/m", "stiffness of", "k_{{{j},{s}}}"),
        )
    )
    return lengths, stiffnesses
