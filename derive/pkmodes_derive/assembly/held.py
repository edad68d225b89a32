r"""The matrices of one robot in use, whose motors are held, or are on springs whose other ends are held.

A motor turns by a linear form in the coordinates: its rotor, and the wind-up of its gearbox.  With the motor at rest
the rotor follows the wind-up, so all coordinates are :math:`q = T r` with those that remain, r, and a matrix A of
free motors becomes :math:`T^T A T`.  The inertia of the motors has no influence; it is left out before anything is
derived, so that nothing large cancels.

Motors on springs are coordinates like the others, so that T is the identity, and a command moves the other ends of
the springs.  Relative to the motion that it prescribes without strain, the matrices are those of free motors.
"""

from __future__ import annotations

from collections.abc import Sequence, Set
from dataclasses import replace

from sympy import Add, Expr, Integer, Matrix, Symbol

from pkmodes_derive import condensation
from pkmodes_derive.assembly.derived import (
    Derived,
    derive,
    flattened,
    joint_losses,
    matrix_sum,
    units_of_damping,
    units_of_mass,
    units_of_stiffness,
)
from pkmodes_derive.assembly.rank import nullity
from pkmodes_derive.functions import Function, HeldMotors, Output
from pkmodes_derive.machine import Machine

Rows = list[list[Expr]]
NAME = "held_matrices"


def held_motors(machine: Machine, zeros: Set[Symbol] = frozenset(), springs: str = "") -> HeldMotors:
    """Derive the matrices of a machine in use, or the reason why it has no modes of vibration.

    Parameters
    ----------
    machine : Machine
        With the active effects; changed here.
    zeros : set of sympy.Symbol
        Parameters that are zero for the robot: they select the driven rotors, and coordinates without inertia are
        condensed.
    springs : str
        The effect through which the motors hang on springs; without one they are held.
    """
    if not springs:
        for drive in machine.drives:
            drive.motor = Integer(0)
    d = derive(machine)
    zero_values = _zero_values(d, zeros)
    driven = {
        selected: Integer(selected not in zeros)
        for drive in machine.drives
        for _, selected in drive.rotors
        if isinstance(selected, Symbol)
    }
    remaining, T = _identity_map(machine) if springs else _follow_wind_up(machine, driven)

    def in_use(matrix: Sequence[Sequence[Expr]]) -> Rows:
        return condensation.project([[entry.xreplace(driven) for entry in row] for row in matrix], T)

    K_el = [list(row) for row in d.K_el]
    K_loss = [list(row) for row in d.K_loss]
    joints = zip(machine.compliances, joint_losses(machine), strict=True)
    for i, (compliance, loss) in enumerate(joints, start=machine.base):
        K_el[i][i] += 1 / compliance
        K_loss[i][i] += loss / compliance
    M, K_el, K_g, C_v, K_loss = map(in_use, (d.M, K_el, d.K_g, d.C_v, K_loss))
    massless = [
        a
        for a, i in enumerate(remaining)
        if i >= machine.base and not any(e.xreplace(zero_values) for e in M[a])
    ]
    with_inertia = [a for a in range(len(remaining)) if a not in massless]
    condensation_matrix = condensation.condensation_map(K_el, with_inertia, massless)
    K_el = condensation.condensed_stiffness(K_el, with_inertia, massless, condensation_matrix)
    names = tuple(machine.all_coordinates[remaining[a]].name for a in with_inertia)
    rates = _platform_rates(d)
    reason = _reason_for_free_motions(K_el) or _reason_for_missing_inertia(
        names, [M[a][a].xreplace(zero_values) for a in with_inertia]
    )
    if rates is None:
        reason = reason or "the pose does not determine how the coordinates move"
    if rates is None or reason:
        return HeldMotors(names, springs=springs, reason=reason)
    momentum = [
        [entry.xreplace(driven) for entry in row] for row in _product(d.M, _rigid_motion(machine, rates))
    ]
    momenta = _product(_transposed(T), momentum)
    # A controller needs the displacement of the platform's origin, not its rotation.
    platform = _product(_product(d.platform_motion(machine.rates), T), condensation_matrix)[
        : len(machine.directions)
    ]
    damping: tuple[tuple[Expr, ...], ...] = ()
    if any(effect.dissipates for effect in machine.effects):
        damping = tuple(
            flattened(condensation.project(matrix, condensation_matrix)) for matrix in (C_v, K_loss)
        )
    K = matrix_sum(K_el, [[K_g[a][b] for b in with_inertia] for a in with_inertia])
    motors = HeldMotors(names, dissipates=bool(damping), springs=springs)
    return replace(
        motors,
        functions=(
            _function(
                d,
                motors,
                flattened([[M[a][b] for b in with_inertia] for a in with_inertia]),
                flattened(K),
                flattened(platform),
                tuple(momenta[a][m] for m in range(len(machine.directions)) for a in with_inertia),
                damping,
            ),
        ),
    )


def _function(
    d: Derived,
    motors: HeldMotors,
    M: tuple[Expr, ...],
    K: tuple[Expr, ...],
    platform: tuple[Expr, ...],
    momenta: tuple[Expr, ...],
    damping: tuple[tuple[Expr, ...], ...],
) -> Function:
    m, n = d.machine, len(motors.coordinates)
    across = (len(m.directions), n)
    outputs = [
        Output("M", (n, n), M, units_of_mass(m), "mass matrix"),
        Output("K", (n, n), K, units_of_stiffness(m), "stiffness matrix, symmetric"),
        Output("J_p", across, platform, "1, m", "dp_i/dr_k: absolute motion of the platform"),
        Output(
            "momenta",
            across,
            momenta,
            "kg, kg m",
            "of coordinate k where the platform moves along i with speed 1, the motors too, and nothing is strained",
        ),
    ]
    if damping:
        C_v, K_loss = damping
        outputs += [
            Output("C_v", (n, n), C_v, units_of_damping(m), "viscous damping matrix, symmetric"),
            Output(
                "K_loss", (n, n), K_loss, units_of_stiffness(m), "imaginary part of the elastic stiffness"
            ),
        ]
    return Function(
        NAME,
        f"Matrices of the vibrations with motors {motors.motors}, evaluated together.",
        "M and K of free motors, relative to the commanded motion; momenta M q_dot for rigid transmissions"
        if motors.springs
        else "T^T A T with q = T r for motors at rest; momenta T^T M q_dot for rigid transmissions",
        (d.pose,),
        tuple(outputs),
        d.kin.definitions,
        f"The coordinates r are {', '.join(motors.coordinates)}.",
    )


def _zero_values(d: Derived, zeros: Set[Symbol]) -> dict[Symbol, Expr]:
    """Return parameters that are zero, and named values that are zero with them, such as an inertia."""
    zero_values: dict[Symbol, Expr] = dict.fromkeys(zeros, Integer(0))
    for symbol, value in d.kin.definitions.items():
        if value.free_symbols & zero_values.keys() and value.xreplace(zero_values) == 0:
            zero_values[symbol] = Integer(0)
    return zero_values


def _identity_map(machine: Machine) -> tuple[list[int], Rows]:
    """Return the result of `_follow_wind_up` for a machine in which every coordinate remains."""
    all_indices = range(len(machine.all_coordinates))
    return list(all_indices), [[Integer(i == r) for r in all_indices] for i in all_indices]


def _follow_wind_up(machine: Machine, driven: dict[Symbol, Expr]) -> tuple[list[int], Rows]:
    """Return the coordinates that remain, and all coordinates per unit of these: driven rotors undo the wind-up."""
    coordinates, follows = list(machine.all_coordinates), {}
    for drive in machine.drives:
        for rotor, selected in drive.rotors:
            if driven.get(selected, selected) != 0:  # a number where a mechanism leaves no choice
                follows[coordinates.index(rotor.coordinate)] = [
                    coordinates.index(c.position) for c in drive.wind_up
                ]
    remaining = [i for i in range(len(coordinates)) if i not in follows]
    T = [[Integer(i == r) for r in remaining] for i in range(len(coordinates))]
    for rotor_index, wind_up in follows.items():
        T[rotor_index] = [-Integer(r in wind_up) for r in remaining]
    return remaining, T


def _platform_rates(d: Derived) -> Matrix | None:
    """Return the rates of the independent coordinates per unit of the platform's; None if they do not follow."""
    if d.machine.links:  # D_l p_dot = D_r q_dot with a diagonal D_r
        n = len(d.machine.independent)
        return Matrix(n, d.kin.D_l.shape[1], lambda k, m: d.kin.D_l[k, m] / d.kin.D_r[k, k])
    D = d.kin.D_p
    if D.shape[0] != D.shape[1] or D.det() == 0:
        return None
    return D.inv()


def _rigid_motion(machine: Machine, rates: Matrix) -> Rows:
    """Return all coordinates per unit of the platform's motion with rigid transmissions and locked joints."""
    motion = []
    for q in machine.all_coordinates:
        form = machine.follows.get(q, q) if q in machine.coordinates else Integer(0)
        motion.append(
            [
                form.xreplace(dict(zip(machine.independent, rates[:, m], strict=True)))
                for m in range(rates.shape[1])
            ]
        )
    return motion


def _reason_for_free_motions(K_el: Sequence[Sequence[Expr]]) -> str:
    """Return why there are not only vibrations: from the nullity of the stiffness at unrelated values."""
    if not K_el:
        return "nothing moves"
    count = nullity(K_el)
    motions = "motion strains" if count == 1 else "motions strain"
    return f"{count} {motions} nothing elastic" if count else ""


def _reason_for_missing_inertia(names: Sequence[str], diagonal: Sequence[Expr]) -> str:
    massless = [name for name, entry in zip(names, diagonal, strict=True) if entry == 0]
    return f"{', '.join(massless)} moves no inertia" if massless else ""


def _product(a: Sequence[Sequence[Expr]], b: Sequence[Sequence[Expr]]) -> Rows:
    return [
        [Add(*(x * y for x, y in zip(row, column, strict=True))) for column in _transposed(b)] for row in a
    ]


def _transposed(rows: Sequence[Sequence[Expr]]) -> Rows:
    return [list(column) for column in zip(*rows, strict=True)]
