"""The symbols of the linear delta, with the paper's letters; inputs first, then everything derived.

The robot's parameters are grouped into `Field`s: the arrays in which the generated code receives them.
A field that one axis may override (formats: ``[axis.link]`` and the like) has one entry for each axis.
"""

from __future__ import annotations

from collections.abc import Iterator
from itertools import chain as concatenate

from sympy import Symbol

from pkmodes_derive.vocabulary import Field, Vector, Vocabulary

#: What the letters of indices count.
LETTERS = {
    "j": "axis j",
    "k": "pulley k, or carriage k of a derivative",
    "l": "carriage l of a second derivative",
    "s": "belt span s",
    "i": "component i = x, y, z",
}


class Symbols:
    """Everything that the derivation of the linear delta names.

    Parameters, coordinates and velocities are declared here; the derived quantities are declared where
    they are derived, through `vocabulary`.
    """

    def __init__(self) -> None:
        self.vocabulary = v = Vocabulary(LETTERS)
        self._declare_parameters(v)
        self.p = v.vector("p", "m", "platform centre in the base frame", "p")
        self.coordinates = self._nine("{q}", "{unit}", "{what}", "{latex}")
        self.x, self.theta = self.coordinates[:3], self.coordinates[3:]
        self.velocities = self._nine("{q}_dot", "{unit}/s", "rate of change: {what}", r"\dot{latex}")
        self.displacements = self._nine(
            "delta_{q}",
            "{unit}",
            "small displacement from the reference configuration: {what}",
            r"\Delta {latex}",
        )
        self.phi = v.per_axis(
            "phi", "rad", "angular position of universal joint {j} on the platform", r"\varphi_{j}"
        )
        self.u = v.vectors_per_axis(
            "u", "m", "carriage {j} seen from its platform joint, in the joint's own frame", "u_{j}"
        )
        self.assembly = v.declare(
            "assembly", "1", "assembly branch: +1 or -1, the sign of det D_l", r"\operatorname{sgn}\det D_l"
        )

    def _nine(self, name: str, unit: str, description: str, latex: str) -> tuple[Symbol, ...]:
        """Declare something for each of the nine coordinates, in their order (equations 29 and 32)."""

        def text(template: str, q: str, si: str, what: str, symbol: str) -> str:
            replacements = {"{q}": q, "{unit}": si, "{what}": what, "{latex}": symbol}
            for mark, replacement in replacements.items():
                template = template.replace(mark, replacement)
            return template

        carriage = ("x_{j}", "m", "position of carriage {j} along its rail", "{{x}}_{j}")
        pulley = ("theta_{j}_{k}", "rad", "rotation of pulley {k} of axis {j}", r"{{\vartheta}}_{{{j},{k}}}")
        templates = (name, unit, description, latex)
        return tuple(
            self.vocabulary.declare(*(text(t, *kind) for t in templates), **index)
            for kind, indices in (
                (carriage, [{"j": j} for j in (1, 2, 3)]),
                (pulley, [{"j": j, "k": k} for k in (1, 2) for j in (1, 2, 3)]),
            )
            for index in indices
        )

    def _declare_parameters(self, v: Vocabulary) -> None:
        self.m_p = v.declare("m_p", "kg", "platform mass", "m_p")
        self.g = v.vector("g", "m/s^2", "gravitational acceleration", "g")
        self.o = v.vectors_per_axis("o", "m", "point of rail {j} where x_{j} = 0", "o_{j}")
        self.n = v.vectors_per_axis("n", "1", "unit vector along rail {j}", "n_{j}")
        self.b = v.vectors_per_axis("b", "m", "joint {j} of the platform seen from its centre", "b_{j}")
        self.l_d = v.per_axis("l_d", "m", "length of linkage {j}", r"l_{{d,{j}}}")
        self.m_d = v.per_axis("m_d", "kg", "mass of linkage {j}, both rods together", r"m_{{d,{j}}}")
        self.m_t = v.per_axis("m_t", "kg", "mass of carriage {j}", r"m_{{t,{j}}}")
        self.l_t = v.per_axis("l_t", "m", "length of carriage {j} along its rail", r"l_{{t,{j}}}")
        self.k_sp = v.per_axis(
            "k_sp", "N/m", "specific stiffness of belt {j}: k = w_b k_sp / free length", r"k_{{sp,{j}}}"
        )
        self.w_b = v.per_axis("w_b", "m", "width of belt {j}", r"w_{{b,{j}}}")
        self.R_p = v.per_axis("R_p", "m", "radius of the pulleys of axis {j}", r"R_{{p,{j}}}")
        self.I_p = v.per_axis("I_p", "kg m^2", "moment of inertia of each pulley of axis {j}", r"I_{{p,{j}}}")
        self.I_m = v.per_axis(
            "I_m", "kg m^2", "moment of inertia of motor {j} at the motor shaft", r"I_{{m,{j}}}"
        )
        self.i_g = v.per_axis("i_g", "1", "gear ratio of axis {j}, motor over driven pulley", r"i_{{g,{j}}}")
        self.drive = tuple(
            tuple(
                v.declare(
                    "d_{j}_{k}",
                    "1",
                    "1 where the motor drives pulley {k} of axis {j}, else 0",
                    "d_{{{j},{k}}}",
                    j=j,
                    k=k,
                )
                for k in (1, 2)
            )
            for j in (1, 2, 3)
        )
        self.x_min = v.per_axis("x_min", "m", "lower end of axis {j}, at pulley 2", r"\min(x_{j})")
        self.x_max = v.per_axis("x_max", "m", "upper end of axis {j}, at pulley 1", r"\max(x_{j})")
        self.branch = v.per_axis(
            "sigma",
            "1",
            "branch of axis {j}: +1 the carriage is ahead of the platform joint along the rail, -1 behind",
            r"\sigma_{j}",
        )

    @property
    def fields(self) -> tuple[Field, ...]:
        """The parameters as the arrays of the generated code, in the order of its `Parameters`."""

        def per_axis(name: str, symbols: Vector, unit: str, description: str) -> Field:
            return Field(name, (3,), symbols, unit, description)

        def vectors(name: str, symbols: tuple[Vector, ...], unit: str, description: str) -> Field:
            return Field(name, (3, 3), tuple(concatenate(*symbols)), unit, description)

        limits = tuple(concatenate(*zip(self.x_min, self.x_max, strict=True)))
        return (
            Field("platform_mass", (), (self.m_p,), "kg", "platform mass m_p"),
            Field("gravity", (3,), self.g, "m/s^2", "gravitational acceleration g, base frame"),
            vectors("origin", self.o, "m", "o_j, the point of rail j where x_j = 0; one row for each axis"),
            vectors("direction", self.n, "1", "n_j, unit vector along rail j; one row for each axis"),
            vectors("joint", self.b, "m", "b_j = c_j - p, platform joint seen from the platform centre"),
            per_axis("link_length", self.l_d, "m", "length l_d of each linkage"),
            per_axis("link_mass", self.m_d, "kg", "mass m_d of each linkage, both rods together"),
            per_axis("carriage_mass", self.m_t, "kg", "mass m_t of each carriage"),
            per_axis("carriage_length", self.l_t, "m", "length l_t of each carriage along its rail"),
            per_axis("belt_specific_stiffness", self.k_sp, "N/m", "specific stiffness k_sp of each belt"),
            per_axis("belt_width", self.w_b, "m", "width w_b of each belt"),
            per_axis("pulley_radius", self.R_p, "m", "radius R_p of the pulleys of each axis"),
            per_axis(
                "pulley_inertia", self.I_p, "kg m^2", "moment of inertia I_p of each of the two pulleys"
            ),
            per_axis("motor_inertia", self.I_m, "kg m^2", "moment of inertia of each motor, at its shaft"),
            per_axis("gear_ratio", self.i_g, "1", "gear ratio, motor over driven pulley"),
            Field(
                "drive",
                (3, 2),
                tuple(concatenate(*self.drive)),
                "1",
                "1 where the motor drives pulley k of axis j, else 0; one row for each axis",
            ),
            Field("limits", (3, 2), limits, "m", "min(x_j), max(x_j): pulley 2 sits at min, pulley 1 at max"),
            per_axis(
                "branch", self.branch, "1", "+1: carriage ahead of the platform joint along n_j; -1: behind"
            ),
        )

    @property
    def parameters(self) -> Iterator[Symbol]:
        """Every parameter symbol."""
        return concatenate.from_iterable(field.symbols for field in self.fields)
