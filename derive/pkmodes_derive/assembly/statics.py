r"""Static equilibrium at a given pose: equation 44.

The independent coordinates hold the pose, so their displacements are zero; the displacements of all others and the
drive torques are unknown.  With G the gradient of the gravitational potential energy with respect to the independent
coordinates and E the gradient of the elastic energy, linear in the unknown displacements,

.. math:: G_j + E_{q_j} = 0, \qquad E_{\vartheta, free} = 0, \qquad \tau = E_{\vartheta, driven}.

The unknowns fall into blocks that share no equation: one axis each, or two crossed belts together.  The links support
the platform and themselves with the forces mu_j s_j, where D_l^T mu = dV_g/dp; these give the gravity Hessian its
geometric stiffness (`implicit.constrained_hessian`).
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

from sympy import Add, Expr, Integer, Matrix, Symbol, diff

from pkmodes_derive import implicit, lagrangian
from pkmodes_derive.assembly.blocks import named_block
from pkmodes_derive.assembly.energy import Energies
from pkmodes_derive.assembly.kinematics import Kinematics
from pkmodes_derive.machine import Machine
from pkmodes_derive.vocabulary import AXES, DeclarationError

CONNECT_REMEDY = "connect each coordinate that moves the platform to its own drive with a reducer or a belt"


@dataclass(frozen=True)
class Statics:
    """Named results of the equilibrium.

    Attributes
    ----------
    gravity_gradient : list
        dV_g/dq_j of the independent coordinates.
    gravity_hessian : list of lists
        d2V_g/dq_k dq_l along the constraints, for the coordinates that move the closures.
    force_densities : tuple
        mu_j [N/m]: the force in link j is mu_j s_j.
    rotations : tuple
        Displacements of the other coordinates relative to the unstrained transmissions, in order.
    torques : tuple
        Drive torques [N m], or forces [N], positive in the direction of their rotors.
    """

    gravity_gradient: list[Expr]
    gravity_hessian: list[list[Expr]]
    force_densities: tuple[Symbol, ...]
    rotations: tuple[Symbol, ...]
    torques: tuple[Symbol, ...]


@dataclass(frozen=True)
class _Equation:
    """A linear equation: coefficients of the unknowns, and the right-hand side."""

    row: dict[Symbol, Expr]
    right: Expr
    unit: str


def derive(machine: Machine, kinematics: Kinematics, energies: Energies) -> Statics:
    """Solve equation 44 in closed form, block by block, and name the solution in the chain of `kinematics`."""
    chain = kinematics.chain
    by_platform = _platform_forces(machine, kinematics, energies)
    mu = _force_densities(machine, kinematics, by_platform)
    if machine.turning is None:
        gravity = lagrangian.gradient(energies.V_g, machine.independent, chain)
        gravity = [force.xreplace(kinematics.reference) for force in gravity]
        jacobian = tuple(kinematics.D) if kinematics.closures else ()
        hessian = implicit.constrained_hessian(
            energies.V_g, kinematics.closures, mu, kinematics.independent, jacobian, chain
        )
    else:
        gravity = [
            Add(
                kinematics.partial.derivative(energies.V_g, q),
                *(f * d for f, d in zip(by_platform, D, strict=True)),
            )
            for q, D in zip(machine.independent, kinematics.D_p.T.tolist(), strict=True)
        ]
        hessian = _hessian_in_blocks(machine, kinematics, energies, mu)
    independent_indices = [machine.coordinates.index(q) for q in machine.independent]
    # The independent coordinates and released joints hold the pose.
    fixed_displacements = (
        *(machine.displacements[i] for i in independent_indices),
        *(c.position for c in machine.released),
    )
    at_pose = dict.fromkeys(fixed_displacements, Integer(0))
    hessian = [[entry.xreplace(at_pose) for entry in row] for row in hessian]
    # Springs that effects add are relaxed at the pose: only the transmissions are strained.
    elastic = [diff(energies.V_transmissions, q).xreplace(at_pose) for q in machine.displacements]
    forces = _name_forces(machine, gravity)
    unknown = [q for i, q in enumerate(machine.displacements) if i not in independent_indices]
    equations = [_equation(elastic[i], -forces[k], unknown, "N") for k, i in enumerate(independent_indices)]
    equations += [_equation(row, Integer(0), unknown, "N m") for row in _undriven(machine, elastic)]
    _check_determined(machine, equations, unknown)
    rotations: dict[Symbol, Symbol] = {}
    for number, (block_unknowns, block) in enumerate(_blocks(equations, unknown), start=1):
        rotations |= _solve_block(machine, number, block_unknowns, block)
    torques = tuple(drive.torque for drive in machine.drives)
    for drive in machine.drives:
        by_rotor = (driven * elastic[machine.coordinates.index(r.coordinate)] for r, driven in drive.rotors)
        chain.define(drive.torque, Add(*by_rotor).xreplace(rotations))
    return Statics(gravity, hessian, mu, tuple(rotations[angle] for angle in unknown), torques)


def _name_forces(machine: Machine, gravity: Sequence[Expr]) -> list[Symbol]:
    v = machine.vocabulary
    forces = []
    for j, (q, value) in enumerate(zip(machine.independent, gravity, strict=True), start=1):
        unit = machine.unit_by(q, "N", "N m")
        # One sentence for all of them: with respect to x_j, or to coordinates without numbers in their names.
        by = q.name.replace(f"_{j}", "_{j}") if q.name.endswith(f"_{j}") else "independent coordinate {j}"
        what = f"gradient of the gravitational potential energy with respect to {by}"
        forces.append(machine.define(v.declare("G_{j}", unit, what, "G_{j}", j=j), value))
    return forces


def _undriven(machine: Machine, elastic: Sequence[Expr]) -> list[Expr]:
    """Return the torques that must vanish: those on the undriven rotors of pairs."""
    rows = []
    for drive in machine.drives:
        if len(drive.rotors) == 2:
            (first_rotor, drives_first), (second_rotor, drives_second) = drive.rotors
            a, b = (elastic[machine.coordinates.index(r.coordinate)] for r in (first_rotor, second_rotor))
            rows.append(drives_second * a + drives_first * b)
    return rows


def _check_determined(machine: Machine, equations: Sequence[_Equation], unknown: Sequence[Symbol]) -> None:
    """Check that a spring acts on every coordinate."""
    for q, equation in zip(machine.independent, equations, strict=False):
        if not equation.row:
            what = f"the equilibrium is not determined: no spring connects {q} to a drive"
            raise DeclarationError(what, CONNECT_REMEDY)
    for q in unknown:
        if not any(q in equation.row for equation in equations):
            name = _coordinate(machine, q).name
            raise DeclarationError(
                f"the equilibrium is not determined: no spring acts on {name}", CONNECT_REMEDY
            )


def _coordinate(machine: Machine, displacement: Symbol) -> Symbol:
    return machine.coordinates[machine.displacements.index(displacement)]


def _equation(row: Expr, right: Expr, unknown: Sequence[Symbol], unit: str) -> _Equation:
    return _Equation({q: factor for q in unknown if (factor := diff(row, q)) != 0}, right, unit)


def _blocks(
    equations: Sequence[_Equation], unknown: Sequence[Symbol]
) -> list[tuple[list[Symbol], list[_Equation]]]:
    """Group the unknowns that share an equation, and return them with their equations."""
    groups: list[set[Symbol]] = []
    for equation in equations:
        group_of_equation = set(equation.row)
        for group in [g for g in groups if g & group_of_equation]:
            groups.remove(group)
            group_of_equation |= group
        groups.append(group_of_equation)
    blocks = []
    for group in sorted(groups, key=lambda g: min(unknown.index(q) for q in g)):
        block_unknowns = [q for q in unknown if q in group]
        blocks.append((block_unknowns, [equation for equation in equations if set(equation.row) & group]))
    return blocks


def _solve_block(
    machine: Machine, number: int, unknown: Sequence[Symbol], equations: Sequence[_Equation]
) -> dict[Symbol, Symbol]:
    """Solve one block by Cramer's rule and return the names of the solution."""
    v, n = machine.vocabulary, len(unknown)
    matrix = Matrix([[e.row.get(q, Integer(0)) for q in unknown] for e in equations])
    if len(equations) != n or matrix.det(method="berkowitz") == 0:
        names = ", ".join(_coordinate(machine, q).name for q in unknown)
        raise DeclarationError(
            f"the equilibrium has {len(equations)} equations for {n} unknowns: {names}",
            f"{CONNECT_REMEDY}; an idler forms a pair with the rotor that is driven: [(driven, 1), (idler, 0)]",
        )
    right = [e.right for e in equations]
    if n == 1:
        values = [right[0] / matrix[0, 0]]
    else:
        units = [e.unit for e in equations]
        metres = sum(unit == "N m" for unit in units)
        unit = f"N^{n}" + (" m" if metres == 1 else f" m^{metres}" if metres else "")
        what = "determinant of the equilibrium equations" + (
            " of axis {j}" if len(machine.drives) > 1 else ""
        )
        determinant = v.declare("det_{j}", unit, what, r"\Delta_{j}", j=number)
        if n == 2:
            (a, b), (c, d) = matrix.tolist()
            machine.define(determinant, a * d - b * c)
            numerators = [right[0] * d - right[1] * b, a * right[1] - c * right[0]]
        else:
            machine.define(determinant, matrix.det(method="berkowitz"))
            numerators = list(matrix.adjugate() * Matrix(right))
        values = [numerator / determinant for numerator in numerators]
    solution = {}
    for q, value in zip(unknown, values, strict=True):
        solution[q] = machine.define(_static_name(machine, _coordinate(machine, q)), value)
    return solution


def _hessian_in_blocks(
    machine: Machine, kinematics: Kinematics, energies: Energies, mu: Sequence[Symbol]
) -> list[list[Expr]]:
    """Return the Hessian of gravity along the constraints for a platform that turns."""
    lagrangian = energies.V_g - Add(*(m * phi for m, phi in zip(mu, kinematics.closures, strict=True)))
    second = implicit.second_derivatives(
        lagrangian, kinematics.independent, machine.dependent, kinematics.partial
    )
    v = machine.vocabulary
    assert machine.turning is not None

    def gradient(number: int, i: int, value: Expr) -> Expr:
        what = "derivative of gravity and closures with respect to vector {j} that turns, component {i}"
        name = v.declare("g_{j}_{i}", "N", what, "g_{{{j},{i}}}", j=number + 1, i=AXES[i])
        return machine.define(name, value)

    second = implicit.with_small_rotations(second, lagrangian, machine.turning, kinematics.partial, gradient)
    what = "second derivative of gravity and closures with respect to the platform, entry {i}, {a}"
    matrix = named_block(machine, second.dependent, "L", ("N/m", "N", "N m"), what)
    mixed = second.mixed.xreplace(kinematics.reference)
    names, first = machine.components, len(machine.directions)

    def named(i: int, k: int, value: Expr) -> Expr:
        if value.is_number or value.is_Symbol:
            return value
        what = "force on the platform along {i} per unit of coordinate {k}"
        place = {"i": names[i], "k": kinematics.independent[k].name}
        unit = machine.unit_by(kinematics.independent[k], *(("N/m", "N") if i < first else ("N", "N m")))
        return machine.define(v.declare("f_{i}_{k}", unit, what, "f_{{{i},{k}}}", **place), value)

    independent = second.independent.xreplace(kinematics.reference)
    blocks = implicit.SecondDerivatives(independent, mixed, matrix)
    return implicit.congruent(blocks, kinematics.D, named)


def _static_name(machine: Machine, coordinate: Symbol) -> Symbol:
    quantity = machine.vocabulary[coordinate]
    stem, *index = coordinate.name.split("_")
    letters = dict(zip("jk", index, strict=False))
    name = "_".join([stem, *(f"{{{letter}}}" for letter in letters), "st"])
    what = quantity.family[1]
    for letter in letters:
        what = what.replace(f" {letter} ", f" {{{letter}}} ").replace(f" {letter}", f" {{{letter}}}")
    indices = ",".join([*(f"{{{letter}}}" for letter in letters), "st"])
    tex = {"theta": r"\vartheta", "phi": r"\varphi"}.get(stem, stem)
    return machine.vocabulary.declare(
        name,
        quantity.unit,
        f"static {what}, relative to the unstrained transmissions",
        f"{tex}_{{{{{indices}}}}}",
        **letters,
    )


def _platform_forces(machine: Machine, kinematics: Kinematics, energies: Energies) -> list[Expr]:
    """Return dV_g/dp with the independent coordinates held, named where the platform turns."""
    if machine.turning is None:
        return [diff(energies.V_g, component) for component in machine.dependent]
    forces = []
    for i, component in enumerate(machine.dependent):
        unit = "N" if i < len(machine.directions) else "N m"
        what = "gradient of the gravitational potential energy with respect to the platform, component {i}"
        name = machine.vocabulary.declare("G_p_{i}", unit, what, "G_{{p,{i}}}", i=machine.components[i])
        forces.append(machine.define(name, kinematics.partial.derivative(energies.V_g, component)))
    return forces


def _force_densities(
    machine: Machine, kinematics: Kinematics, gradient: Sequence[Expr]
) -> tuple[Symbol, ...]:
    """Name the solution mu of D_l^T mu = dV_g/dp, with the independent coordinates held."""
    if kinematics.solver is None:
        return ()
    what = "static force in linkage {j} divided by its length, positive in compression"
    names = tuple(
        machine.vocabulary.declare("mu_{j}", "N/m", what, r"\mu_{j}", j=j)
        for j in range(1, len(machine.links) + 1)
    )
    for name, value in zip(names, kinematics.solver.multipliers(gradient), strict=True):
        machine.define(name, value)
    return names
