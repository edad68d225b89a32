"""Everything derived of the linear delta, collected for the functions that are emitted."""

from __future__ import annotations

from collections.abc import Iterable, Sequence

from sympy import Expr, Integer, Matrix, default_sort_key, prime

from pkmodes_derive import lagrangian
from pkmodes_derive.functions import Argument, Function, Output
from pkmodes_derive.linear_delta import energy, kinematics, statics
from pkmodes_derive.linear_delta.machine import Machine


class Collected:
    """What the chapters of the catalogue draw on: derived quantities, arguments, and M and K."""

    def __init__(
        self,
        machine: Machine,
        kin: kinematics.Kinematics,
        energies: energy.Energies,
        equilibrium: statics.Statics,
    ) -> None:
        self.machine, sy = machine, machine.sy
        self.sy, self.kin, self.energies, self.equilibrium = sy, kin, energies, equilibrium
        self.definitions = kin.definitions
        self.pose = Argument("p", sy.p, "m", "platform centre in the base frame")
        self.carriages = Argument("x", sy.x, "m", "carriage positions x_1, x_2, x_3")
        self.x_dot = Argument("x_dot", sy.velocities[:3], "m/s", "carriage velocities")
        self.q_dot = Argument(
            "q_dot", sy.velocities, "m/s, rad/s", "rates of the nine generalised coordinates"
        )
        self.delta_q = Argument(
            "delta_q",
            sy.displacements,
            "m, rad",
            "small displacements of the nine generalised coordinates from the reference configuration at p",
        )
        self.M = flat(lagrangian.mass_matrix(energies.T_ss + energies.T_t, sy.velocities, kin.chain))
        self.K_el = flat(lagrangian.stiffness_matrix(energies.V_el, sy.displacements, kin.chain))
        self.K_g = flat(equilibrium.gravity_hessian)
        # Both potentials in the same nine coordinates: the gravitational one depends on the carriages only.
        self.K = tuple(
            self.K_el[9 * k + m] + (self.K_g[3 * k + m] if k < 3 and m < 3 else 0)
            for k in range(9)
            for m in range(9)
        )

    @property
    def rigid_modes(self) -> int:
        """Nullity of the elastic Hessian, for values without a relation between them: an exact rank."""
        symbols = sorted({s for entry in self.K_el for s in entry.free_symbols}, key=default_sort_key)
        values = {symbol: Integer(prime(i)) for i, symbol in enumerate(symbols, start=1)}
        hessian = Matrix(9, 9, [entry.xreplace(values) for entry in self.K_el])
        return 9 - int(hessian.rank())

    def function(
        self,
        name: str,
        summary: str,
        source: str,
        arguments: Sequence[Argument],
        *outputs: Output,
        details: str = "",
    ) -> Function:
        """A function of the pose, with the definitions that all of them share."""
        return Function(name, summary, source, tuple(arguments), outputs, self.definitions, details)


def flat(rows: Iterable[Iterable[Expr]]) -> tuple[Expr, ...]:
    """Entries of a nested array, row by row."""
    return tuple(entry for row in rows for entry in row)
