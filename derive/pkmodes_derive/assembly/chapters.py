"""The functions of a model, with or without effects, each with its equation; nothing is derived here."""

from __future__ import annotations

from sympy import Matrix, Rational

from pkmodes_derive import lagrangian
from pkmodes_derive.assembly.closure_functions import closures
from pkmodes_derive.assembly.condensed import NUMBER_WORDS, Condensed
from pkmodes_derive.assembly.derived import (
    drive_words,
    flattened,
    units_of_damping,
    units_of_mass,
    units_of_stiffness,
)
from pkmodes_derive.assembly.twist_forces import forces_of_twist
from pkmodes_derive.functions import Function, Output
from pkmodes_derive.machine import Extra
from pkmodes_derive.vectors import cross

HALF = Rational(1, 2)


def chapters(c: Condensed) -> tuple[Function, ...]:
    """Return every function of a model."""
    return (
        *_position(c),
        *_motion(c),
        *_gravity(c),
        *_transmissions(c),
        *_modal(c),
        *_damping(c),
    )


def extra(c: Condensed, e: Extra) -> Function:
    """Return a function specific to the mechanism."""
    if e.definitions is None:
        arguments = [c.pose] if e.arguments is None else e.arguments
        return c.function(e.name, e.summary, e.source, arguments, *e.outputs, details=e.details)
    return Function(e.name, e.summary, e.source, e.arguments or (), e.outputs, e.definitions, e.details)


def _with_respect_to(c: Condensed) -> str:
    """Return the phrase that names the independent coordinates as variables of a derivative."""
    return f"with respect to the {c.machine.independent_are}"


def _unit(c: Condensed, for_length: str, for_angle: str) -> str:
    return c.machine.unit_by(c.machine.independent[0], for_length, for_angle)


def _position(c: Condensed) -> list[Function]:
    """Return the functions for positions and workspace limits."""
    m, n = c.machine, len(c.machine.independent)
    what = f"{m.independent_are} {', '.join(q.name for q in m.independent)}"
    functions = [
        c.function(
            "inverse_kinematics",
            f"{m.independent_are.capitalize()} at a pose.",
            "equations 1 to 3" if m.links else "the pose itself",
            [c.pose],
            Output(m.argument, (n,), m.independent, _unit(c, "m", "rad"), what),
            details="NaN if the pose is out of reach (see `reach_margin`)."
            if any(e.name == "reach_margin" for e in m.extras)
            else "",
        ),
        *(extra(c, e) for e in m.extras),
    ]
    if m.belts:
        runs = tuple(tuple(run.length for run in belt.runs) for belt in m.belts)
        names = "free length l_f[j-1, s-1] of span s of belt j"
        functions.append(
            c.function(
                "belt_spans",
                "Free lengths of the belt spans.",
                "equations 35 to 37; a pose is within the limits if all are positive",
                [c.pose],
                Output("l_f", (len(runs), len(runs[0])), flattened(runs), "m", names),
            )
        )
    return functions + (closures(c) if m.links else [])


def _motion(c: Condensed) -> list[Function]:
    """Return the functions for velocities, accelerations and kinetic energy."""
    m, kin, energies = c.machine, c.kin, c.energies
    n, d, q = len(m.independent), len(m.components), m.argument
    turns = bool(m.rotations)
    functions = [
        c.function(
            "platform_jacobian",
            "Platform Jacobian D_p" + (" = D_l^-1 D_r." if m.links else "."),
            "equation 15",
            [c.pose],
            Output("D_p", (d, n), tuple(kin.D_p), _unit(c, *_units(c, "1", "m")), "dp_i/dq_k, base frame"),
        ),
        c.function(
            "platform_jacobian_rate",
            "Time derivative of the platform Jacobian.",
            "equation 17",
            [c.pose, c.free_rates],
            Output(
                "D_p_dot",
                (d, n),
                flattened(energies.D_p_dot),
                _unit(c, *_units(c, "1/s", "m/s")),
                f"d(D_p)/dt at {q}_dot",
            ),
        ),
        c.function(
            "platform_second_derivatives",
            f"Second derivatives of the platform position {_with_respect_to(c)}.",
            "equation 49, by the implicit function theorem to second order",
            [c.pose],
            Output(
                "P",
                (d, n, n),
                flattened([tuple(of) for of in kin.P]),
                _unit(c, *_units(c, "1/m", "m")),
                "d2p_i/dq_k dq_l as P[i, k, l]"
                + (", of rotations in the exponential chart at the pose" if turns else ""),
            ),
        ),
    ]
    return [*functions, *(_links(c) if m.rods and len(m.directions) == 3 else []), *_dynamics(c)]


def _units(c: Condensed, for_length: str, for_angle: str) -> tuple[str, str]:
    """Return the units of a Jacobian of the platform, whose rotations come last."""
    if not c.machine.rotations:
        return for_length, for_angle
    rotation_unit = {"1": "1/m", "m": "1", "1/s": "1/(m s)", "m/s": "1/s", "1/m": "1/m^2"}
    return f"{for_length}, {rotation_unit[for_length]}", f"{for_angle}, {rotation_unit[for_angle]}"


def _links(c: Condensed) -> list[Function]:
    m, n = c.machine, len(c.machine.independent)
    D_d = [_midpoint_jacobian(c, j) for j in range(len(m.rods))]
    D_omega = [_angular_jacobian(c, j) for j in range(len(m.links))]
    q = m.argument
    return [
        c.function(
            "link_jacobians",
            "Jacobians of the linkages: centre of mass and angular velocity.",
            "equations 16 and 23; the angular velocity without spin about the rod, which carries no energy",
            [c.pose],
            Output(
                "D_d",
                (len(D_d), 3, n),
                flattened([tuple(of) for of in D_d]),
                _unit(c, "1", "m"),
                f"D_d[j-1] {q}_dot is the velocity of the centre of mass of linkage j",
            ),
            Output(
                "D_omega",
                (len(D_omega), 3, n),
                flattened([tuple(of) for of in D_omega]),
                _unit(c, "1/m", "1"),
                f"D_omega[j-1] {q}_dot is the angular velocity of linkage j",
            ),
        )
    ]


def _midpoint_jacobian(c: Condensed, j: int) -> Matrix:
    """Return D_d,j (equation 16 with W_c = W_t: the centre of mass is midway)."""
    q = c.machine.independent
    first, second = (
        Matrix(3, len(q), lambda m, k, end=end: c.kin.chain.derivative(end[m], q[k]))
        for end in c.machine.rods[j].ends
    )
    return Matrix(3, len(q), lambda m, k: (second[m, k] + first[m, k]) * HALF)


def _angular_jacobian(c: Condensed, j: int) -> Matrix:
    """Return D_omega,j = s_j x U_j / l_d^2, without spin about the rod."""
    link, U, n = c.machine.links[j], c.kin.U[j], len(c.machine.independent)
    columns = [cross(link.vector, tuple(U[:, k])) for k in range(n)]
    return Matrix(3, n, lambda m, k: columns[k][m] / link.length**2)


def _dynamics(c: Condensed) -> list[Function]:
    m, energies, n = c.machine, c.energies, len(c.machine.independent)
    structure = (
        f"symmetric; block diagonal: M_ss ({n} by {n}) and the diagonal M_t"
        if m.links and not m.arms
        else "symmetric"
    )
    velocities = tuple(m.velocities[i] for i in c.derived.free)
    if m.turning is None:
        h = lagrangian.velocity_forces(c.moving_energy, m.independent, velocities, c.kin.chain)
    else:
        h = forces_of_twist(c, m.turning, velocities)
    return [
        c.function(
            "kinetic_energy",
            "Kinetic energies of the structure and of the transmissions.",
            "equations 24 and 28",
            [c.pose, c.q_dot],
            Output("T_ss", (), (energies.T_ss,), "J", "platform and the bodies that move it"),
            Output("T_t", (), (energies.T_t,), "J", "rotors and motors"),
        ),
        c.function(
            "mass_matrix",
            f"Mass matrix M in the {c.count}.",
            "equations 24, 30 and 33",
            [c.pose],
            Output("M", (c.n, c.n), c.M, units_of_mass(m), "symmetric" if m.effects else structure),
        ),
        c.function(
            "velocity_forces",
            f"Coriolis and centrifugal forces h of M_ss {m.argument}_ddot + h + grad V = Q.",
            "Lagrange's equations; equation 47 before linearisation",
            [c.pose, c.free_rates],
            Output(
                "h",
                (n,),
                tuple(h),
                _unit(c, "N", "N m"),
                f"generalised forces conjugate to the {m.independent_are}",
            ),
            details="With released joints locked and transmissions rigid." if m.effects else "",
            substitutions=c.locked,
        ),
    ]


def _gravity(c: Condensed) -> list[Function]:
    """Return the functions for the gravitational potential energy and its derivatives."""
    n, by = len(c.machine.independent), _with_respect_to(c)
    return [
        c.function(
            "gravity_potential",
            "Gravitational potential energy V_g = -U_g, with the force function U_g.",
            "equation 26, for gravity in any direction and all moving bodies",
            [c.pose],
            Output("V_g", (), (c.energies.V_g,), "J", "zero at the origin of the base frame"),
            substitutions=c.locked,
        ),
        c.function(
            "gravity_gradient",
            f"Gradient of the gravitational potential energy {by}.",
            "equation 27",
            [c.pose],
            Output("G", (n,), tuple(c.equilibrium.gravity_gradient), _unit(c, "N", "N m"), "dV_g/dq_k"),
        ),
        c.function(
            "gravity_hessian",
            f"Hessian of the gravitational potential energy {by}.",
            "section 4 and equation 49",
            [c.pose],
            Output("H_g", (n, n), c.K_g, _unit(c, "N/m", "N m"), "d2V_g/dq_k dq_l, symmetric"),
        ),
    ]


def _transmissions(c: Condensed) -> list[Function]:
    """Return the functions for stiffness, elastic potential energy and static equilibrium of transmissions."""
    m, functions = c.machine, []
    rotations = c.equilibrium.rotations
    if m.belts:
        k = tuple(tuple(run.stiffness for run in belt.runs) for belt in m.belts)
        shape, what = (len(k), len(k[0])), "k[j-1, s-1] of span s of belt j, as in `belt_spans`"
        functions.append(
            c.function(
                "belt_stiffness",
                "Stiffnesses of the belt spans.",
                "equations 34 to 37",
                [c.pose],
                Output("k", shape, flattened(k), "N/m", what),
            )
        )
    force = ", ".join({"m": "N", "rad": "N m"}[u] for u in c.delta_q.unit.split(", "))
    words = drive_words(m)
    zero_count = NUMBER_WORDS.get(c.rigid_modes, str(c.rigid_modes)) if c.rigid_modes else "no"
    return functions + [
        c.function(
            "elastic_potential",
            "Elastic potential energy V_el = -U_el of the transmissions, with the force function U_el.",
            "equation 38, summed",
            [c.pose, c.delta_q],
            Output("V_el", (), (c.V_el,), "J", "zero in the reference configuration"),
        ),
        c.function(
            "elastic_gradient",
            "Gradient of the elastic potential energy.",
            "equation 38 differentiated",
            [c.pose, c.delta_q],
            Output("E", (c.n,), c.elastic_gradient, force, "dV_el/dq"),
        ),
        c.function(
            "elastic_hessian",
            "Hessian of the elastic potential energy.",
            "equation 38 differentiated twice",
            [c.pose],
            Output(
                "H_el",
                (c.n, c.n),
                c.K_el,
                units_of_stiffness(m),
                f"d2V_el/dq2, symmetric, with {zero_count} zero eigenvalues",
            ),
        ),
        c.function(
            "static_equilibrium",
            f"Drive {words.loads} that hold the pose, and the corresponding {words.motions}.",
            "equation 44, solved at the pose",
            [c.pose],
            Output(
                "tau_st",
                (len(m.drives),),
                c.equilibrium.torques,
                words.load_unit,
                words.described,
            ),
            Output(
                "theta_st",
                (len(rotations),),
                rotations,
                words.motion_unit,
                f"{words.motions} relative to the unstrained transmissions, in the order of the coordinates",
            ),
            details="Springs added by effects are relaxed at the pose, and released joints are locked."
            if m.effects
            else "",
        ),
    ]


def _modal(c: Condensed) -> list[Function]:
    """Return the functions for the stiffness matrix, alone and with the mass matrix."""
    m, what = c.machine, "symmetric; Hessian of V_el + V_g, positive for a restoring force"
    K = Output("K", (c.n, c.n), c.K, units_of_stiffness(m), what)
    M = Output("M", (c.n, c.n), c.M, units_of_mass(m), "mass matrix")
    return [
        c.function(
            "stiffness_matrix",
            f"Stiffness matrix K in the {c.count}.",
            "equations 46 and 48: K = -H_U",
            [c.pose],
            K,
        ),
        c.function(
            "modal_matrices",
            "Mass and stiffness matrices of M q_ddot + K q = 0, evaluated together.",
            "equation 48",
            [c.pose],
            M,
            K,
            details="Common intermediate values are evaluated once: call this function for an eigenproblem.",
        ),
    ]


def _damping(c: Condensed) -> list[Function]:
    """Return the functions for viscous damping and for the loss of springs, where something dissipates."""
    if not c.C_v:
        return []
    m, shape = c.machine, (c.n, c.n)
    return [
        c.function(
            "damping_matrix",
            f"Viscous damping matrix C_v in the {c.count}.",
            "dissipation function R = 1/2 sum b v^2, C_v = d2R/dq_dot2",
            [c.pose],
            Output("C_v", shape, c.C_v, units_of_damping(m), "symmetric, for forces -C_v q_dot"),
        ),
        c.function(
            "loss_matrix",
            f"Imaginary part of the elastic stiffness in the {c.count}.",
            "complex stiffnesses k (1 + i eta), to first order in eta",
            [c.pose],
            Output("K_loss", shape, c.K_loss, units_of_stiffness(m), "symmetric; gravity has no part in it"),
        ),
    ]
