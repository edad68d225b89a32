"""Everything derived from a machine, once for all models: kinematics, energies, equilibrium, M and K."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, replace
from typing import NamedTuple

from sympy import Add, Expr, Integer, Matrix, Symbol

from pkmodes_derive import implicit, lagrangian
from pkmodes_derive.assembly import energy, kinematics, statics
from pkmodes_derive.assembly.blocks import named_block
from pkmodes_derive.assembly.placed import energy_of_springs
from pkmodes_derive.chain import Chain
from pkmodes_derive.differentiation import partial_derivative
from pkmodes_derive.functions import Argument
from pkmodes_derive.machine import Machine

Rows = Sequence[Sequence[Expr]]


@dataclass(frozen=True)
class Derived:
    """A machine and everything derived from it.

    Attributes
    ----------
    M, K_el, K_g : list of lists
        In all coordinates, including released ones, without the springs of released joints.
    C_v, K_loss : list of lists
        Viscous damping and imaginary part of the elastic stiffness, likewise.
    hold : tuple of sympy.Symbol
        Values that small displacements leave unchanged: Jacobian and stiffnesses in the reference configuration.
    """

    machine: Machine
    kin: kinematics.Kinematics
    energies: energy.Energies
    equilibrium: statics.Statics
    M: list[list[Expr]]
    K_el: list[list[Expr]]
    K_g: list[list[Expr]]
    C_v: list[list[Expr]]
    K_loss: list[list[Expr]]
    hold: tuple[Symbol, ...]

    @property
    def pose(self) -> Argument:
        """The pose as an argument of a function."""
        units = (self.machine.vocabulary[q].unit for q in self.machine.pose)
        turned = ", then the platform's rotation vector" if self.machine.rotations else ""
        return Argument(
            "p", self.machine.pose, ", ".join(dict.fromkeys(units)), self.machine.pose_is + turned
        )

    @property
    def free(self) -> tuple[int, ...]:
        """Indices of the independent coordinates among the generalised coordinates."""
        return tuple(self.machine.coordinates.index(q) for q in self.machine.independent)

    def platform_motion(self, rates: Sequence[Symbol]) -> list[list[Expr]]:
        """Return the derivatives of the platform's absolute velocity with respect to some rates."""
        turning = self.machine.turning
        motion = (*self.machine.v_p, *(turning.rates if turning is not None else ()))
        return [[self.kin.chain.derivative(v, rate) for rate in rates] for v in motion]


def derive(machine: Machine) -> Derived:
    """Derive kinematics, energies, equilibrium, M, K and damping of a machine."""
    kin = kinematics.derive(machine)
    energies = energy.derive(machine, kin)
    equilibrium = statics.derive(machine, kin, energies)
    spring_energy, spring_symbols = energy_of_springs(machine, kin)
    energies = replace(energies, V_el=energies.V_el + spring_energy)
    hold = (*(d for d in kin.D if d.is_Symbol), *energies.stiffnesses, *spring_symbols)
    return Derived(
        machine,
        kin,
        energies,
        equilibrium,
        _mass_matrix(machine, kin, energies),
        kin.chain.hessian(energies.V_el, machine.small, hold=hold),
        _in_all_coordinates(machine, kin, equilibrium.gravity_hessian),
        lagrangian.damping_matrix(energies.R, machine.rates, kin.chain),
        kin.chain.hessian(energies.V_loss, machine.small, hold=hold),
        hold,
    )


def _mass_matrix(machine: Machine, kin: kinematics.Kinematics, energies: energy.Energies) -> list[list[Expr]]:
    """Return M: the twist of a platform that turns is eliminated in blocks, which takes far fewer operations."""
    T = energies.T_ss + energies.T_t
    if machine.turning is None:
        return lagrangian.mass_matrix(T, machine.rates, kin.chain)
    twist = (*machine.v_p, *machine.turning.rates)
    empty_chain = Chain()
    by_rates = Matrix(
        [[partial_derivative(kin.chain.definitions[v], rate) for rate in machine.rates] for v in twist]
    )
    second = implicit.second_derivatives(T, machine.rates, twist, empty_chain)
    # The apparent mass: that of the platform if it carried the other bodies at their joints.
    what = "apparent mass of the platform, entry {i}, {a}"
    mass = named_block(machine, second.dependent, "M_p", ("kg", "kg m", "kg m^2"), what)
    return implicit.congruent(
        replace(second, dependent=mass), by_rates, lambda i, k, value: _momentum(machine, i, k, value)
    )


def _momentum(machine: Machine, i: int, k: int, value: Expr) -> Expr:
    if value.is_number or value.is_Symbol:
        return value
    turns = i >= len(machine.directions)
    unit = machine.unit_by(machine.all_coordinates[k], *(("kg m", "kg m^2") if turns else ("kg", "kg m")))
    what = "momentum of the platform along {i} per unit rate of coordinate {k}"
    place = {"i": machine.components[i], "k": machine.all_coordinates[k].name}
    name = machine.vocabulary.declare("h_{i}_{k}", unit, what, "h_{{{i},{k}}}", **place)
    return machine.define(name, value)


def _in_all_coordinates(machine: Machine, kin: kinematics.Kinematics, block: Rows) -> list[list[Expr]]:
    """Extend the Hessian of gravity from the coordinates that move the closures to all coordinates."""
    coordinates = machine.all_coordinates
    indices = [coordinates.index(q) for q in kin.independent]
    extended = [[Integer(0)] * len(coordinates) for _ in coordinates]
    for row, k in zip(block, indices, strict=True):
        for entry, m in zip(row, indices, strict=True):
            extended[k][m] = entry
    return extended


def matrix_sum(a: Rows, b: Rows) -> list[list[Expr]]:
    """Return the sum of two matrices."""
    return [[Add(x, y) for x, y in zip(*rows, strict=True)] for rows in zip(a, b, strict=True)]


def flattened(rows: Rows) -> tuple[Expr, ...]:
    """Return the entries of a nested array, row by row."""
    return tuple(entry for row in rows for entry in row)


def joint_losses(machine: Machine) -> tuple[Expr, ...]:
    """Return the loss factor of the spring of each released coordinate."""
    gearbox_loss = {c.position: drive.loss for drive in machine.drives for c in drive.wind_up}
    return tuple(gearbox_loss.get(c.position, Integer(0)) for c in machine.released)


def units_of_mass(machine: Machine) -> str:
    """Return the units of the entries of M; only released joints couple translations with rotations."""
    return _listed_units(machine, "kg", "kg m" if machine.released else "", "kg m^2")


def units_of_stiffness(machine: Machine) -> str:
    """Return the units of the entries of K."""
    return _listed_units(machine, "N/m", "N", "N m")


def units_of_damping(machine: Machine) -> str:
    """Return the units of the entries of C_v."""
    return _listed_units(machine, "N s/m", "N s", "N m s")


class DriveWords(NamedTuple):
    """What drives exert and how they move, with the units: torques and rotations, or forces and displacements."""

    loads: str
    load_unit: str
    described: str
    motions: str
    motion_unit: str


def drive_words(machine: Machine) -> DriveWords:
    """Return the words for the drives of a machine."""
    if machine.linear_drives:
        what = "forces of the drives, positive in the direction of their coordinates"
        return DriveWords("forces", "N", what, "displacements", "m")
    what = "torques on the driven rotors, positive in the direction of their rotation"
    return DriveWords("torques", "N m", what, "rotations", "rad")


def _listed_units(machine: Machine, translation: str, both: str, rotation: str) -> str:
    units = {machine.vocabulary[q].unit for q in machine.all_coordinates}
    parts = [
        translation if "m" in units else "",
        both if len(units) > 1 else "",
        rotation if "rad" in units else "",
    ]
    return ", ".join(part for part in parts if part)
