r"""Kinetic and potential energies of the linear delta, as a person would write them.

Everything that the modal analysis needs follows from these expressions by differentiation:

* T_ss of carriages, linkages and platform (equation 24); a slender rod whose ends move with v_e and v_c has
  :math:`\tfrac{m}{6}(v_e \cdot v_e + v_e \cdot v_c + v_c \cdot v_c)`, translation and rotation together;
* T_t of pulleys and motors (equations 28 to 30);
* V_g of platform, linkages and carriages (equation 26 with the sign of a potential energy; the carriages
  are kept because a rail need not be horizontal);
* V_el of the belts about a reference configuration (equations 34 to 41).

Effects add to them through the `Machine`: energies of their own, and coordinates that were locked.
"""

from __future__ import annotations

from dataclasses import dataclass

from sympy import Add, Expr, Rational, Symbol, collect, expand

from pkmodes_derive.linear_delta.kinematics import Kinematics
from pkmodes_derive.linear_delta.machine import HALF, Machine
from pkmodes_derive.linear_delta.symbols import Symbols
from pkmodes_derive.vectors import dot
from pkmodes_derive.vocabulary import AXES

SIXTH = Rational(1, 6)


@dataclass(frozen=True)
class Energies:
    """The energies [J] and the named values that they are written in.

    Attributes
    ----------
    T_ss, T_t : sympy.Expr
        Kinetic energy of the structure and of the transmissions.
    V_g : sympy.Expr
        Gravitational potential energy; depends on x through p.
    V_el : sympy.Expr
        Elastic potential energy of the belts and of what effects add, in small displacements from the
        reference configuration; without the springs of released coordinates.
    V_belts : sympy.Expr
        The belts' part of V_el: what the static rotations strain.
    V_r : tuple of sympy.Expr
        Energy of the spring of each released coordinate.
    D_p_dot : tuple of tuple
        Time derivative of the platform Jacobian (equation 17), index [axis][k-1].
    """

    T_ss: Expr
    T_t: Expr
    V_g: Expr
    V_el: Expr
    V_belts: Expr
    V_r: tuple[Expr, ...]
    D_p_dot: tuple[tuple[Symbol, ...], ...]


def derive(machine: Machine, kinematics: Kinematics) -> Energies:
    """Write the energies; named values are defined in the chain of `kinematics`."""
    sy = machine.sy
    inertia = _pulley_inertia(machine, kinematics)
    _define_belts(machine, kinematics)
    _define_platform_motion(machine, kinematics)
    D_p_dot = _jacobian_rate(sy, kinematics, sy.velocities[:3])
    for m in range(3):
        for k in range(3):
            # d(v_p)/dx_k = sum_l P_kl xdot_l, which is column k of the time derivative of D_p (equation 49).
            kinematics.chain.rule(machine.v_p[m], sy.x[k], D_p_dot[m][k])
    belts = _elastic(machine)
    return Energies(
        T_ss=_structure(machine),
        T_t=_transmissions(machine, inertia),
        V_g=_gravity(machine),
        V_el=Add(belts, *machine.elastic),
        V_belts=belts,
        V_r=tuple(
            HALF * q.position**2 / c for q, c in zip(machine.released, machine.compliances, strict=True)
        ),
        D_p_dot=D_p_dot,
    )


def _define_platform_motion(machine: Machine, kinematics: Kinematics) -> None:
    """Velocity and, where effects need it, small displacement of the platform: D times the coordinates."""
    sy = machine.sy
    elongations = [c for axis in machine.elongation for c in axis]
    rates = [*sy.velocities[:3], *(c.rate for c in elongations)]
    small = [*sy.displacements[:3], *(c.position for c in elongations)]
    for i in range(3):
        row = kinematics.D[i, :]
        moved = Add(*(d * rate for d, rate in zip(row, rates, strict=True)), machine.frame_rate[i])
        kinematics.chain.define(machine.v_p[i], moved)
        if machine.effects:
            frame = Add(*(c.position for c in machine.frame[i]))
            displaced = Add(*(d * q for d, q in zip(row, small, strict=True)), frame)
            kinematics.chain.define(machine.platform_displacement[i], displaced)


def _structure(machine: Machine) -> Expr:
    sy, v_p, frame = machine.sy, machine.v_p, machine.frame_rate
    T = Add(HALF * sy.m_p * dot(v_p, v_p), *machine.kinetic)
    for j in range(3):
        rate = sy.velocities[j]
        v_e = tuple(sy.n[j][m] * rate + frame[m] for m in range(3))
        v_e2 = rate**2 + 2 * rate * dot(sy.n[j], frame) + dot(frame, frame)  # n_j is a unit vector
        T += HALF * sy.m_t[j] * v_e2
        T += SIXTH * sy.m_d[j] * (v_e2 + dot(v_e, v_p) + dot(v_p, v_p))
    # One coefficient for each product of velocities: the apparent mass that a person would name.
    return collect(expand(T), [c**2 for c in v_p] + list(v_p))


def _transmissions(machine: Machine, inertia: tuple[tuple[Symbol, ...], ...]) -> Expr:
    """Pulleys, and the motor on the driven one; a wind-up turns the motor further than the pulley."""
    sy = machine.sy
    T = Add(
        *(
            HALF * moment * rate**2
            for moment, rate in zip((*inertia[0], *inertia[1]), sy.velocities[3:], strict=True)
        )
    )
    for j in range(3):
        wind_up = Add(*(c.rate for c in machine.wind_up[j]))
        for k in range(2):
            motor = sy.drive[j][k] * sy.i_g[j] ** 2 * sy.I_m[j]
            T += motor * (sy.velocities[3 + 3 * k + j] * wind_up + HALF * wind_up**2)
    return T


def _jacobian_rate(
    sy: Symbols, kinematics: Kinematics, x_dot: tuple[Symbol, ...]
) -> tuple[tuple[Symbol, ...], ...]:
    """Equation 17: D_p_dot = D_l^-1 (D_r_dot - D_l_dot D_p), with the rows of D_l_dot the rates of s_j."""
    v, chain = sy.vocabulary, kinematics.chain
    s_dot = v.vectors_per_axis("s_dot", "m/s", "rate of change of linkage vector {j}", r"\dot{{s}}_{j}")
    for j in range(3):
        for m in range(3):
            chain.define(
                s_dot[j][m],
                Add(*(chain.derivative(kinematics.s[j][m], sy.x[k]) * x_dot[k] for k in range(3))),
            )
    names = tuple(
        tuple(
            v.declare(
                "D_p_dot_{i}_{k}",
                "1/s",
                "time derivative of dp_{i}/dx_{k}",
                r"(\dot{{D}}_p)_{{{i}{k}}}",
                i=axis,
                k=k,
            )
            for k in (1, 2, 3)
        )
        for axis in AXES
    )
    for k in range(3):
        right = []
        for j in range(3):
            rate = dot(s_dot[j], sy.n[j]) if j == k else 0
            right.append(rate - dot(s_dot[j], tuple(kinematics.D_p[:, k])))
        for m in range(3):
            column = Add(*(kinematics.adjugate[m, j] * right[j] for j in range(3))) / kinematics.determinant
            chain.define(names[m][k], column)
    return names


def _gravity(machine: Machine) -> Expr:
    """V_g = -g . (m_p p + sum m_d d_j + sum m_t e_j), with d_j midway (equations 4 and 26)."""
    sy = machine.sy
    frame = [Add(*(c.position for c in component)) for component in machine.frame]
    bodies = [(sy.m_p, machine.platform_position), *machine.weights]
    moment = [Add(*(mass * position[m] for mass, position in bodies)) for m in range(3)]
    for j in range(3):
        for m in range(3):
            e = sy.o[j][m] + sy.x[j] * sy.n[j][m] + frame[m]
            c = sy.p[m] + sy.b[j][m] + frame[m]
            moment[m] += sy.m_d[j] * (e + c) * HALF + sy.m_t[j] * e
    return -dot(sy.g, tuple(collect(expand(component), list(sy.p)) for component in moment))


def _pulley_inertia(machine: Machine, kinematics: Kinematics) -> tuple[tuple[Symbol, ...], ...]:
    """Motor and gearbox turn rigidly with the driven pulley (after equation 30)."""
    sy = machine.sy
    names = tuple(
        tuple(
            sy.vocabulary.declare(
                "I_{j}_{k}",
                "kg m^2",
                "moment of inertia of pulley {k} of axis {j}, with the motor where it is driven",
                "I_{{p,{j},{k}}}",
                j=j,
                k=k,
            )
            for j in (1, 2, 3)
        )
        for k in (1, 2)
    )
    for k in range(2):
        for j in range(3):
            driven = sy.i_g[j] ** 2 * sy.I_m[j] + machine.driven_inertia[j]
            kinematics.chain.define(names[k][j], sy.I_p[j] + sy.drive[j][k] * driven)
    return names


def _define_belts(machine: Machine, kinematics: Kinematics) -> None:
    """Free lengths and stiffnesses of the spans (equations 34 to 37), in the reference configuration.

    Small displacements leave the stiffnesses constant (the paper, before equation 38): V_el is written in
    displacements, and no derivative by a displacement passes through them.
    """
    sy = machine.sy
    for j in range(3):
        lengths = (
            sy.x_max[j] - sy.x_min[j],
            sy.x[j] - sy.x_min[j] - HALF * sy.l_t[j],
            sy.x_max[j] - sy.x[j] - HALF * sy.l_t[j],
        )
        modulus = sy.w_b[j] * sy.k_sp[j] * (1 + machine.stiffness_change[j])
        for name, stiffness, length in zip(machine.l_f[j], machine.k[j], lengths, strict=True):
            kinematics.chain.define(name, length)
            # 1/k = l/(w k_sp (1 + a)) + c, so written that c = 0 is no special case.
            kinematics.chain.define(stiffness, modulus / (name + machine.span_compliance[j] * modulus))


def _elastic(machine: Machine) -> Expr:
    """Equation 38 with the sign of a potential energy."""
    V = []
    for j in range(3):
        for stiffness, (a, b) in zip(machine.k[j], machine.span_end_displacements(j), strict=True):
            V.append(HALF * stiffness * (a - b) ** 2)
    return Add(*V)
