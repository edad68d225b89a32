r"""A platform that turns: its rotation, and vectors that are fixed in it.

The pose has a rotation vector r; the rotation matrix is its exponential,

.. math:: R = \exp([r]) = 1 + s c\,[r] + \tfrac12 s^2 [r]^2, \qquad
          s = \frac{\sin(|r|/2)}{|r|/2}, \quad c = \cos(|r|/2).

Nothing is ever differentiated with respect to r.  Small motions are parametrised *at the pose*: with
:math:`R \to \exp([\varphi]) R` and :math:`\varphi = 0`, a vector w that is fixed in the platform has the derivatives

.. math:: \frac{\partial w}{\partial \varphi_i} = e_i \times w, \qquad
          \frac{\partial^2 w}{\partial \varphi_i\, \partial \varphi_k}
          = \tfrac12 \left(e_i \times (e_k \times w) + e_k \times (e_i \times w)\right).

The chain rule knows the first line.  Applied twice it gives the second line without the symmetrisation, which
`implicit` adds.  There are no Euler angles, so no chart is singular and there is nothing to simplify.

Along coordinates q the platform turns with the angular velocity :math:`\omega_k = \partial \varphi/\partial q_k`.
The derivatives of these columns are not symmetric: with the symmetric second derivatives :math:`S_{kl}` of
:math:`\varphi`,

.. math:: \frac{\partial \omega_k}{\partial q_l} = S_{kl} + \tfrac12\, \omega_l \times \omega_k .
"""

from __future__ import annotations

from collections.abc import Callable, Sequence

from sympy import Add, Expr, Float, Integer, Rational, Symbol, cos, sin, sqrt

from pkmodes_derive.chain import Chain
from pkmodes_derive.vectors import axis, cross, placed, skew
from pkmodes_derive.vocabulary import AXES, Vocabulary

HALF = Rational(1, 2)
#: Added to the squared angle, so that nothing is divided by zero at the rotation 0: it changes no digit of R.
TINY = Float("1e-30")


class Turning:
    """The rotation of the platform.

    Attributes
    ----------
    axes : tuple of str
        Axes about which it turns: all three, or one.
    directions : tuple of str
        Directions in which the mechanism moves; about one axis, at least the two across it.
    vector : tuple of sympy.Symbol
        Components of the rotation vector, which are components of the pose [rad].
    small : tuple of sympy.Symbol
        Small rotations from the pose; they are zero, and never evaluated.
    fixed : list of tuple
        Vectors that are fixed in the platform, in the base frame, three components each.
    given : dict
        Those that a mechanism names, by their names: in platform axes.
    rates : tuple of sympy.Symbol
        Angular velocity of the platform [rad/s], one component for each axis.
    """

    def __init__(
        self, axes: Sequence[str], directions: Sequence[str], vocabulary: Vocabulary, chain: Chain
    ) -> None:
        self.axes, self.directions = tuple(axes), tuple(directions)
        self._vocabulary, self._chain = vocabulary, chain
        what = "rotation vector of the platform"
        self.vector = vocabulary.vector("rot", "rad", what, "r", axes=self.axes)
        self.small = vocabulary.vector(
            "turn", "rad", "small rotation from the pose", r"\varphi", axes=self.axes
        )
        self.rates = vocabulary.vector(
            "w_p", "rad/s", "angular velocity of the platform", r"\omega", axes=axes
        )
        self.fixed: list[tuple[Expr, ...]] = []
        self.given: dict[tuple[Symbol, ...], tuple[Expr, ...]] = {}
        self._columns = self._matrix()

    @property
    def symbols(self) -> set[Symbol]:
        """Components of the vectors that are fixed in the platform."""
        return {component for vector in self.fixed for component in vector if component.is_Symbol}

    def fix(self, names: Sequence[Symbol], vector: Sequence[Expr]) -> tuple[Symbol, ...]:
        """Name a vector that is fixed in the platform: its components in the base frame, from those in platform axes.

        Parameters
        ----------
        names : sequence of sympy.Symbol
            One for each direction in which the mechanism moves: two in a plane.
        vector : sequence of sympy.Expr
            In platform axes, for the same directions.
        """
        given = self.given[tuple(names)] = placed(self.directions, vector)
        for name, i in zip(names, map(AXES.index, self.directions), strict=True):
            rotated = Add(*(column[i] * b for column, b in zip(self._columns, given, strict=True)))
            self._chain.define(name, rotated)
        self._set_small_rotation_rules(placed(self.directions, names))
        return tuple(names)

    def tensor(
        self, names: Callable[[int, int], Symbol], entries: Sequence[Sequence[Expr]]
    ) -> tuple[tuple[Expr, ...], ...]:
        """Name an inertia tensor in the base frame, from its entries in platform axes, for the axes of rotation."""
        if len(self.axes) == 1:
            return ((entries[0][0],),)
        named: dict[tuple[int, int], Expr] = {}
        for i in range(3):
            for k in range(i, 3):
                rotated = Add(
                    *(
                        self._columns[a][i] * entries[a][b] * self._columns[b][k]
                        for a in range(3)
                        for b in range(3)
                    )
                )
                named[i, k] = named[k, i] = self._chain.define(names(i, k), rotated)
        return tuple(tuple(named[i, k] for k in range(3)) for i in range(3))

    def follow(self, q: Symbol, rate: Sequence[Expr]) -> None:
        """Let the fixed vectors turn with a coordinate: `rate` is the angular velocity per unit of its rate."""
        angular_velocity = self.spatial(rate)
        for vector in self.fixed:
            for component, rate_of_component in zip(vector, cross(angular_velocity, vector), strict=True):
                if component.is_Symbol:
                    self._chain.rule(component, q, rate_of_component)

    def spatial(self, components: Sequence[Expr]) -> tuple[Expr, ...]:
        """Return a rotation or angular velocity with three components."""
        return placed(self.axes, components)

    def commutator(self, first: Sequence[Expr], second: Sequence[Expr]) -> list[Expr]:
        """Return the cross product of two angular velocities, one component for each axis of rotation."""
        product = cross(self.spatial(first), self.spatial(second))
        return [product[AXES.index(name)] for name in self.axes]

    def _set_small_rotation_rules(self, vector: tuple[Expr, ...]) -> None:
        """Set the derivatives of a fixed vector with respect to small rotations."""
        self.fixed.append(vector)
        for small, name in zip(self.small, self.axes, strict=True):
            for component, rate in zip(vector, cross(axis(name), vector), strict=True):
                if component.is_Symbol:
                    self._chain.rule(component, small, rate)

    def _matrix(self) -> list[tuple[Expr, ...]]:
        """Define the rotation matrix and return its columns, the platform's axes in the base frame."""
        v, chain = self._vocabulary, self._chain
        v.letters["a"] = "axis a of the platform"
        if len(self.axes) == 1:
            (r,), first = self.vector, AXES.index(self.axes[0]) + 1
            what = "component {i} of axis {a} of the platform"
            plane = AXES[first % 3], AXES[(first + 1) % 3]  # it turns from the first to the second
            names = [
                [v.declare("R_{i}_{a}", "1", what, "R_{{{i}{a}}}", i=i, a=a) for a in plane] for i in plane
            ]
            for row, entries in zip(names, ((cos(r), -sin(r)), (sin(r), cos(r))), strict=True):
                for name, entry in zip(row, entries, strict=True):
                    chain.define(name, entry)
            plane_columns = (placed(plane, column) for column in zip(*names, strict=True))
            column_of = dict(zip(plane, plane_columns, strict=True))
            columns = [column_of.get(name, axis(name)) for name in AXES]
        else:
            half = v.declare("half_angle", "rad", "half the angle of rotation", "|r|/2")
            chain.define(half, sqrt(Add(*(r**2 for r in self.vector), TINY)) / 2)
            s = v.declare("s_half", "1", "sine of half the angle over half the angle", "s")
            c = v.declare("c_half", "1", "cosine of half the angle", "c")
            chain.define(s, sin(half) / half)
            chain.define(c, cos(half))
            what = "rotation matrix of the platform: component {i} of its axis {a}"
            r = skew(self.vector)
            r_squared = [[Add(*(r[i][m] * r[m][k] for m in range(3))) for k in range(3)] for i in range(3)]
            columns = []
            for k, a in enumerate(AXES):
                named = [v.declare("R_{i}_{a}", "1", what, "R_{{{i}{a}}}", i=i, a=a) for i in AXES]
                for i, name in enumerate(named):
                    chain.define(name, Integer(i == k) + s * c * r[i][k] + s**2 * r_squared[i][k] * HALF)
                columns.append(tuple(named))
        for column in columns:
            if any(component.is_Symbol for component in column):
                self._set_small_rotation_rules(column)
        return columns
