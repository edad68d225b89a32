"""Everything derived of the linear delta, collected for the functions that are emitted."""

from __future__ import annotations

from collections.abc import Iterable, Mapping, Sequence, Set
from dataclasses import replace
from functools import cached_property

from sympy import Add, Expr, Integer, Matrix, Symbol, default_sort_key, prime

from pkmodes_derive import condensation, lagrangian
from pkmodes_derive.functions import Argument, Function, Output
from pkmodes_derive.linear_delta import energy, kinematics, statics
from pkmodes_derive.linear_delta.machine import Machine

Rows = Sequence[Sequence[Expr]]


class Collected:
    """What the chapters of the catalogue draw on: derived quantities, arguments, and M and K.

    Parameters
    ----------
    machine, kin, energies, equilibrium
        The derived machine, with or without effects.
    zeros : set of sympy.Symbol
        Parameters that are zero: released coordinates that have no inertia for them are condensed.

    Attributes
    ----------
    coordinates, rates, displacements : tuple of sympy.Symbol
        Of the coordinates with inertia, which every function has.
    all_coordinates : tuple of sympy.Symbol
        The massless ones too.
    M, K_el, K : tuple of sympy.Expr
        In the coordinates with inertia, row by row; K_el with the springs of released joints.
    M_all, K_all : list of lists
        In all coordinates, with the springs.
    condensation : list of lists
        All coordinates by those with inertia, one row each.
    V_el : sympy.Expr
        Elastic energy, the springs of released joints included.
    K_g : tuple of sympy.Expr
        Gravity, by the carriages.
    at_rest, following : dict
        What the massless coordinates are, as rates and as displacements.
    """

    def __init__(
        self,
        machine: Machine,
        kin: kinematics.Kinematics,
        energies: energy.Energies,
        equilibrium: statics.Statics,
        zeros: Set[Symbol] = frozenset(),
    ) -> None:
        self.machine, sy = machine, machine.sy
        self.sy, self.kin, self.energies, self.equilibrium = sy, kin, energies, equilibrium
        self.definitions = kin.definitions
        self.pose = Argument("p", sy.p, "m", "platform centre in the base frame")
        self.carriages = Argument("x", sy.x, "m", "carriage positions x_1, x_2, x_3")
        self.x_dot = Argument("x_dot", sy.velocities[:3], "m/s", "carriage velocities")
        self._matrices(zeros)
        self.count = count = {9: "nine"}.get(self.n, str(self.n))
        self.units_M = "kg, kg m, kg m^2" if machine.released else "kg, kg m^2"
        self.q_dot = Argument(
            "q_dot", self.rates, "m/s, rad/s", f"rates of the {count} generalised coordinates"
        )
        self.delta_q = Argument(
            "delta_q",
            self.displacements,
            "m, rad",
            f"small displacements of the {count} generalised coordinates from the reference configuration at p",
        )

    def _matrices(self, zeros: Set[Symbol]) -> None:
        """M and K in all coordinates, and with those condensed that have no inertia."""
        sy, kin, energies, released = self.sy, self.kin, self.energies, self.machine.released
        positions = tuple(c.position for c in released)
        rates = (*sy.velocities, *(c.rate for c in released))
        # A released coordinate is its own small displacement.
        small = (*sy.displacements, *positions)
        self.all_coordinates = (*sy.coordinates, *positions)
        # Displacements are small: Jacobian and belt stiffnesses are those of the reference configuration.
        self.hold = (*kin.D, *(k for axis in self.machine.k for k in axis))
        M = lagrangian.mass_matrix(energies.T_ss + energies.T_t, rates, kin.chain)
        self.V_el = Add(energies.V_el, *energies.V_r)
        K_el = kin.chain.hessian(self.V_el, small, hold=self.hold)
        gravity = self._gravity(len(small))
        null = dict.fromkeys(zeros, Integer(0))
        massless = [i for i in range(9, len(small)) if not any(entry.xreplace(null) for entry in M[i])]
        kept = [i for i in range(len(small)) if i not in massless]
        self.massless, self.n = tuple(self.all_coordinates[i] for i in massless), len(kept)
        self.coordinates, self.rates, self.displacements = (
            tuple(symbols[i] for i in kept) for symbols in (self.all_coordinates, rates, small)
        )
        # Gravity acts on what has a mass: a massless coordinate follows elastic forces alone.
        self.condensation = condensation.follow(K_el, kept, massless)
        self.at_rest = {rates[i]: Integer(0) for i in massless}
        self.following = {
            small[i]: Add(*(f * q for f, q in zip(self.condensation[i], self.displacements, strict=True)))
            for i in massless
        }
        self.M_all, self.K_all = M, _sum(K_el, gravity)
        condensed = condensation.condensed(K_el, kept, massless, self.condensation)
        self.M = tuple(M[k][m] for k in kept for m in kept)
        self.K_el = flat(condensed)
        self.K_g = tuple(self.equilibrium.gravity_hessian[k][m] for k in range(3) for m in range(3))
        # Both potentials in the same coordinates: the gravitational one depends on carriages and elongations only.
        self.K = flat(_sum(condensed, [[gravity[k][m] for m in kept] for k in kept]))

    def _gravity(self, n: int) -> list[list[Expr]]:
        """Hessian of gravity, of which the closures' coordinates are known, in all coordinates."""
        index = [self.all_coordinates.index(q) for q in self.kin.independent]
        placed = [[Integer(0)] * n for _ in range(n)]
        for row, k in zip(self.equilibrium.gravity_hessian, index, strict=True):
            for entry, m in zip(row, index, strict=True):
                placed[k][m] = entry
        return placed

    @property
    def elastic_gradient(self) -> tuple[Expr, ...]:
        """Where the massless coordinates are in equilibrium, they add nothing to the gradient by the others."""
        return tuple(self.kin.chain.derivative(self.V_el, q, self.hold) for q in self.displacements)

    @property
    def locked(self) -> dict[Symbol, Expr]:
        """Released joints at rest, in the reference configuration."""
        released = self.machine.released
        return dict.fromkeys((s for c in released for s in (c.position, c.rate)), Integer(0))

    @property
    def moving_energy(self) -> Expr:
        """Kinetic energy of the structure while the carriages move and the belts do not stretch."""
        sy = self.sy
        turning = {sy.velocities[3 + i]: sy.velocities[i % 3] / sy.R_p[i % 3] for i in range(6)}
        return self.energies.T_ss.xreplace({**turning, **self.locked})

    @cached_property
    def rigid_modes(self) -> int:
        """Nullity of the elastic Hessian, for values without a relation between them: an exact rank."""
        symbols = sorted({s for entry in self.K_el for s in entry.free_symbols}, key=default_sort_key)
        values = {symbol: Integer(prime(i)) for i, symbol in enumerate(symbols, start=1)}
        hessian = Matrix(self.n, self.n, [entry.xreplace(values) for entry in self.K_el])
        return self.n - int(hessian.rank())

    def function(
        self,
        name: str,
        summary: str,
        source: str,
        arguments: Sequence[Argument],
        *outputs: Output,
        details: str = "",
        known: Mapping[Symbol, Expr] | None = None,
    ) -> Function:
        """A function of the pose, with the definitions that all of them share.

        Rates and displacements of massless coordinates are no arguments: they are what they have to be, as are
        others that are `known`.
        """
        known = {**self.at_rest, **self.following, **(known or {})}
        if not known:
            return Function(name, summary, source, tuple(arguments), outputs, self.definitions, details)
        given = tuple(
            replace(o, entries=tuple(entry.xreplace(known) for entry in o.entries)) for o in outputs
        )
        definitions = {s: e.xreplace(known) for s, e in self.definitions.items()}
        return Function(name, summary, source, tuple(arguments), given, definitions, details)


def _sum(a: Rows, b: Rows) -> list[list[Expr]]:
    return [[x + y for x, y in zip(*rows, strict=True)] for rows in zip(a, b, strict=True)]


def flat(rows: Iterable[Iterable[Expr]]) -> tuple[Expr, ...]:
    """Entries of a nested array, row by row."""
    return tuple(entry for row in rows for entry in row)
