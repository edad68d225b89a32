r"""Kinetic and potential energies of the linear delta, as a person would write them.

Everything that the modal analysis needs follows from these expressions by differentiation:

* T_ss of carriages, linkages and platform (equation 24); a slender rod whose ends move with v_e and v_c has
  :math:`\tfrac{m}{6}(v_e \cdot v_e + v_e \cdot v_c + v_c \cdot v_c)`, translation and rotation together;
* T_t of pulleys and motors (equations 28 to 30);
* V_g of platform, linkages and carriages (equation 26 with the sign of a potential energy; the carriages
  are kept because a rail need not be horizontal);
* V_el of the belts about a reference configuration (equations 34 to 41).
"""

from __future__ import annotations

from dataclasses import dataclass

from sympy import Add, Expr, Rational, Symbol, collect, expand

from pkmodes_derive.linear_delta.kinematics import Kinematics, dot
from pkmodes_derive.linear_delta.symbols import Symbols
from pkmodes_derive.vocabulary import AXES

HALF, SIXTH = Rational(1, 2), Rational(1, 6)


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
        Elastic potential energy of the belts, in the displacements from the reference configuration.
    pulley_inertia : tuple
        I_{j,k}, motors included; index [k-1][j-1], the order of the coordinates theta.
    spans, belt_stiffness : tuple
        Free lengths and stiffnesses of the belt spans; index [j-1][k-1].
    D_p_dot : tuple of tuple
        Time derivative of the platform Jacobian (equation 17), index [axis][k-1].
    """

    T_ss: Expr
    T_t: Expr
    V_g: Expr
    V_el: Expr
    pulley_inertia: tuple[tuple[Symbol, ...], ...]
    spans: tuple[tuple[Symbol, ...], ...]
    belt_stiffness: tuple[tuple[Symbol, ...], ...]
    D_p_dot: tuple[tuple[Symbol, ...], ...]


def derive(sy: Symbols, kinematics: Kinematics) -> Energies:
    """Write the energies; named values are defined in the chain of `kinematics`."""
    inertia = _pulley_inertia(sy, kinematics)
    spans, stiffness = _belts(sy, kinematics)
    T_t = Add(
        *(
            HALF * moment * theta_dot**2
            for moment, theta_dot in zip((*inertia[0], *inertia[1]), sy.velocities[3:], strict=True)
        )
    )
    T_ss, D_p_dot = _structure(sy, kinematics)
    return Energies(
        T_ss, T_t, _gravity(sy, kinematics), _elastic(sy, stiffness), inertia, spans, stiffness, D_p_dot
    )


def _structure(sy: Symbols, kinematics: Kinematics) -> tuple[Expr, tuple[tuple[Symbol, ...], ...]]:
    v, chain, D_p = sy.vocabulary, kinematics.chain, kinematics.D_p
    x_dot = sy.velocities[:3]
    v_p = v.vector("v_p", "m/s", "velocity of the platform", r"\dot{p}")
    for m in range(3):
        chain.define(v_p[m], Add(*(D_p[m, k] * x_dot[k] for k in range(3))))
    D_p_dot = _jacobian_rate(sy, kinematics, x_dot)
    for m in range(3):
        for k in range(3):
            # d(v_p)/dx_k = sum_l P_kl xdot_l, which is column k of the time derivative of D_p (equation 49).
            chain.rule(v_p[m], sy.x[k], D_p_dot[m][k])

    T = HALF * sy.m_p * dot(v_p, v_p)
    for j in range(3):
        v_e = tuple(sy.n[j][m] * x_dot[j] for m in range(3))
        v_e2 = x_dot[j] ** 2  # n_j is a unit vector
        T += HALF * sy.m_t[j] * v_e2
        T += SIXTH * sy.m_d[j] * (v_e2 + dot(v_e, v_p) + dot(v_p, v_p))
    # One coefficient for each product of velocities: the apparent mass that a person would name.
    T = collect(expand(T), [c**2 for c in v_p] + list(v_p))
    return T, D_p_dot


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


def _gravity(sy: Symbols, kinematics: Kinematics) -> Expr:
    """V_g = -g . (m_p p + sum m_d d_j + sum m_t e_j), with d_j midway (equations 4 and 26)."""
    moment = [sy.m_p * sy.p[m] for m in range(3)]
    for j in range(3):
        for m in range(3):
            e = sy.o[j][m] + sy.x[j] * sy.n[j][m]
            c = sy.p[m] + sy.b[j][m]
            moment[m] += sy.m_d[j] * (e + c) * HALF + sy.m_t[j] * e
    return -dot(sy.g, tuple(collect(expand(component), list(sy.p)) for component in moment))


def _pulley_inertia(sy: Symbols, kinematics: Kinematics) -> tuple[tuple[Symbol, ...], ...]:
    """Motor and gearbox turn rigidly with the driven pulley (after equation 30)."""
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
            reflected = sy.i_g[j] ** 2 * sy.I_m[j]
            kinematics.chain.define(names[k][j], sy.I_p[j] + sy.drive[j][k] * reflected)
    return names


def _belts(
    sy: Symbols, kinematics: Kinematics
) -> tuple[tuple[tuple[Symbol, ...], ...], tuple[tuple[Symbol, ...], ...]]:
    """Free lengths and stiffnesses (equations 34 to 37); they belong to the reference configuration.

    Small displacements leave them constant (the paper, before equation 38), so they are defined outside the
    rules: no derivative by x passes through them.
    """
    v, chain = sy.vocabulary, kinematics.chain
    of_span = "span {k} of belt {j} (1 between the pulleys, 2 from carriage to pulley 2, 3 from carriage to pulley 1)"
    spans, stiffness = [], []
    for j in range(3):
        lengths = (
            sy.x_max[j] - sy.x_min[j],
            sy.x[j] - sy.x_min[j] - HALF * sy.l_t[j],
            sy.x_max[j] - sy.x[j] - HALF * sy.l_t[j],
        )
        spans.append([])
        stiffness.append([])
        for k, length in enumerate(lengths, start=1):
            l_f = v.declare("l_f_{j}_{k}", "m", f"free length of {of_span}", "l_{{f,{j},{k}}}", j=j + 1, k=k)
            stiff = v.declare("k_{j}_{k}", "N/m", f"stiffness of {of_span}", "k_{{{j},{k}}}", j=j + 1, k=k)
            spans[j].append(chain.define(l_f, length))
            stiffness[j].append(chain.define(stiff, sy.w_b[j] * sy.k_sp[j] / l_f))
    return tuple(map(tuple, spans)), tuple(map(tuple, stiffness))


def _elastic(sy: Symbols, stiffness: tuple[tuple[Symbol, ...], ...]) -> Expr:
    """Equation 38 with the sign of a potential energy."""
    V = []
    for j in range(3):
        k1, k2, k3 = stiffness[j]
        carriage = sy.displacements[j]
        rim_1, rim_2 = (sy.R_p[j] * sy.displacements[i + j] for i in (3, 6))
        V.append(
            HALF * (k1 * (rim_2 - rim_1) ** 2 + k2 * (carriage - rim_2) ** 2 + k3 * (rim_1 - carriage) ** 2)
        )
    return Add(*V)
