"""The functions that are emitted for the linear delta, each with its equation.

Nothing is derived here: the derived quantities are collected, named and described.
"""

from __future__ import annotations

from collections.abc import Sequence

from sympy import Add, Expr, Integer, Matrix, Rational, sqrt

from pkmodes_derive import lagrangian
from pkmodes_derive.functions import Argument, Function, Model, Output
from pkmodes_derive.linear_delta import energy, kinematics, rotation, statics
from pkmodes_derive.linear_delta.symbols import Symbols


def derive() -> Model:
    """Derive the linear delta from its closures and energies.

    Returns
    -------
    Model
        Functions of the platform centre p (and of velocities or displacements where they need them), for a
        robot given by the parameter fields.
    """
    sy = Symbols()
    kin = kinematics.derive(sy)
    energies = energy.derive(sy, kin)
    equilibrium = statics.derive(sy, kin.chain, energies)
    builder = _Catalogue(sy, kin, energies, equilibrium)
    return Model(
        mechanism="linear_delta",
        coordinates=tuple((q.name, sy.vocabulary[q].unit) for q in sy.coordinates),
        vocabulary=sy.vocabulary,
        fields=sy.fields,
        functions=(
            *builder.position(),
            *builder.motion(),
            *builder.gravity(),
            *builder.belts(),
            *builder.modal(),
        ),
        relations=rotation.euler_relations(sy, kin),
    )


class _Catalogue:
    """Collects the derived quantities; one method for each chapter of the generated module."""

    def __init__(
        self, sy: Symbols, kin: kinematics.Kinematics, energies: energy.Energies, equilibrium: statics.Statics
    ) -> None:
        self.sy, self.kin, self.energies, self.equilibrium = sy, kin, energies, equilibrium
        # In the code the pose is the input: the carriages follow from it by inverse kinematics.
        r_of_p = {entry: kin.chain.definitions[entry] for vector in kin.r for entry in vector}
        self.definitions = {**r_of_p, **kin.inverse, **kin.chain.definitions}
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
        self.M = _block(lagrangian.mass_matrix(energies.T_ss + energies.T_t, sy.velocities, kin.chain))
        self.K_el = _block(lagrangian.stiffness_matrix(energies.V_el, sy.displacements, kin.chain))
        self.K_g = _block(lagrangian.stiffness_matrix(energies.V_g, sy.x, kin.chain))
        # Both potentials in the same nine coordinates: the gravitational one depends on the carriages only.
        self.K = tuple(
            self.K_el[9 * k + m] + (self.K_g[3 * k + m] if k < 3 and m < 3 else 0)
            for k in range(9)
            for m in range(9)
        )

    def function(
        self,
        name: str,
        summary: str,
        source: str,
        arguments: Sequence[Argument],
        *outputs: Output,
        details: str = "",
    ) -> Function:
        return Function(name, summary, source, tuple(arguments), outputs, self.definitions, details)

    def position(self) -> list[Function]:
        """Positions and the limits of the workspace."""
        sy, kin = self.sy, self.kin
        definitions, p = kinematics.direct(sy)
        adjugate_norm2 = Add(*(entry**2 for entry in kin.adjugate))
        jacobian_norm2 = Add(*(entry**2 for entry in kin.D_l))
        return [
            self.function(
                "inverse_kinematics",
                "Carriage positions that put the platform centre at p.",
                "equations 1 to 3: rail j meets the sphere of radius l_d around platform joint j",
                [self.pose],
                Output("x", (3,), sy.x, "m", "carriage positions x_1, x_2, x_3"),
                details="Not a number where a platform joint is farther from its rail than the link is long "
                "(see `reach_margin`).",
            ),
            Function(
                "direct_kinematics",
                "Platform centre for given carriage positions.",
                "equation 3: intersection of three spheres",
                (
                    self.carriages,
                    Argument(
                        "assembly",
                        (sy.assembly,),
                        "1",
                        "assembly branch, +1 or -1: the sign of det D_l at the wanted platform centre",
                        scalar=True,
                    ),
                ),
                (Output("p", (3,), p, "m", "platform centre in the base frame"),),
                definitions,
                "Not a number where the three spheres do not meet.",
            ),
            self.function(
                "reach_margin",
                "How much farther each platform joint could be from its rail.",
                "closure of equation 2: a pose is reachable where every margin is at least zero",
                [self.pose],
                Output(
                    "margin",
                    (3,),
                    tuple(length - sqrt(w2) for length, w2 in zip(sy.l_d, kin.rail_distance, strict=True)),
                    "m",
                    "link length minus distance of the platform joint from its rail, for each axis",
                ),
            ),
            self.function(
                "belt_spans",
                "Free lengths of the belt spans.",
                "equations 35 to 37; a carriage is within its limits where its two spans are positive",
                [self.pose],
                Output(
                    "l_f",
                    (3, 3),
                    tuple(span for axis in self.energies.spans for span in axis),
                    "m",
                    "free length l_f[j-1, k-1]: k = 1 between the pulleys, 2 carriage to pulley 2, "
                    "3 carriage to pulley 1",
                ),
            ),
            self.function(
                "constraint_jacobians",
                "Constraint Jacobians D_l and D_r of D_l p_dot = D_r x_dot.",
                "equations 14 and 15",
                [self.pose],
                Output(
                    "D_l", (3, 3), tuple(kin.D_l), "m", "row j: linkage vector c_j - e_j in the base frame"
                ),
                Output(
                    "D_r",
                    (3, 3),
                    tuple(kin.D_r),
                    "m",
                    "diagonal: component of the linkage vector along rail j",
                ),
            ),
            self.function(
                "jacobian_condition",
                "Assembly branch and condition number of D_l in the Frobenius norm.",
                "equation 15; |D_l| |D_l^-1|, between once and three times the condition number in the 2-norm",
                [self.pose],
                Output(
                    "determinant", (), (kin.determinant,), "m^3", "det D_l; its sign is the assembly branch"
                ),
                Output(
                    "condition",
                    (),
                    (sqrt(jacobian_norm2 * adjugate_norm2 / kin.determinant**2),),
                    "1",
                    "Frobenius condition number, at least 3",
                ),
            ),
        ]

    def motion(self) -> list[Function]:
        """Velocities, accelerations and kinetic energy."""
        sy, kin, energies = self.sy, self.kin, self.energies
        D_d = [_midpoint_jacobian(sy, kin, j) for j in range(3)]
        D_omega = [rotation.angular_jacobian(sy, kin, j) for j in range(3)]
        return [
            self.function(
                "platform_jacobian",
                "Platform Jacobian D_p = D_l^-1 D_r.",
                "equation 15",
                [self.pose],
                Output("D_p", (3, 3), tuple(kin.D_p), "1", "dp_i/dx_k, base frame"),
            ),
            self.function(
                "platform_jacobian_rate",
                "Time derivative of the platform Jacobian.",
                "equation 17",
                [self.pose, self.x_dot],
                Output(
                    "D_p_dot", (3, 3), _flat(energies.D_p_dot), "1/s", "d(D_p)/dt while the carriages move"
                ),
            ),
            self.function(
                "platform_second_derivatives",
                "Second derivatives of the platform centre by the carriage positions.",
                "equation 49, by the implicit function theorem to second order",
                [self.pose],
                Output("P", (3, 3, 3), _flat(map(tuple, kin.P)), "1/m", "d2p_i/dx_k dx_l as P[i, k, l]"),
            ),
            self.function(
                "link_jacobians",
                "Jacobians of the linkages: centre of mass and angular velocity.",
                "equations 16 and 23; the angular velocity without spin about the rod, which carries no energy",
                [self.pose],
                Output(
                    "D_d",
                    (3, 3, 3),
                    _flat(map(tuple, D_d)),
                    "1",
                    "velocity of the centre of linkage j by x_dot",
                ),
                Output(
                    "D_omega",
                    (3, 3, 3),
                    _flat(map(tuple, D_omega)),
                    "1/m",
                    "angular velocity of linkage j by x_dot",
                ),
            ),
            self.function(
                "kinetic_energy",
                "Kinetic energies of the structure and of the transmissions.",
                "equations 24 and 28",
                [self.pose, self.q_dot],
                Output("T_ss", (), (energies.T_ss,), "J", "carriages, linkages and platform"),
                Output("T_t", (), (energies.T_t,), "J", "pulleys and motors"),
            ),
            self.function(
                "mass_matrix",
                "Mass matrix M in the nine generalised coordinates.",
                "equations 24, 30 and 33",
                [self.pose],
                Output("M", (9, 9), self.M, "kg, kg m^2", "symmetric; M_ss (3 by 3) and the diagonal M_t"),
            ),
            self.function(
                "velocity_forces",
                "Coriolis and centrifugal forces h of M_ss x_ddot + h + grad V = Q.",
                "Lagrange's equations, equation 47 without its linearisation",
                [self.pose, self.x_dot],
                Output(
                    "h",
                    (3,),
                    tuple(lagrangian.velocity_forces(energies.T_ss, sy.x, sy.velocities[:3], kin.chain)),
                    "N",
                    "generalised forces on the carriages; the pulleys have none",
                ),
            ),
        ]

    def gravity(self) -> list[Function]:
        """Gravitational potential energy and its derivatives by the carriage positions."""
        return [
            self.function(
                "gravity_potential",
                "Gravitational potential energy V_g, the force function U_g with opposite sign.",
                "equation 26, for gravity in any direction; the carriages' weight included",
                [self.pose],
                Output("V_g", (), (self.energies.V_g,), "J", "zero at the origin of the base frame"),
            ),
            self.function(
                "gravity_gradient",
                "Gradient of the gravitational potential energy by the carriage positions.",
                "equation 27",
                [self.pose],
                Output("G", (3,), tuple(self.equilibrium.gravity_gradient), "N", "dV_g/dx_k"),
            ),
            self.function(
                "gravity_hessian",
                "Hessian of the gravitational potential energy by the carriage positions.",
                "section 4 and equation 49",
                [self.pose],
                Output("H_g", (3, 3), self.K_g, "N/m", "d2V_g/dx_k dx_l, symmetric"),
            ),
        ]

    def belts(self) -> list[Function]:
        """Belts: stiffness, elastic potential energy and static equilibrium."""
        sy, energies = self.sy, self.energies
        return [
            self.function(
                "belt_stiffness",
                "Stiffnesses of the belt spans.",
                "equations 34 to 37",
                [self.pose],
                Output(
                    "k",
                    (3, 3),
                    _flat(energies.belt_stiffness),
                    "N/m",
                    "k[j-1, k-1], the spans in the order of `belt_spans`",
                ),
            ),
            self.function(
                "elastic_potential",
                "Elastic potential energy V_el of the belts, the force function U_el with opposite sign.",
                "equation 38, summed over the axes",
                [self.pose, self.delta_q],
                Output("V_el", (), (energies.V_el,), "J", "zero in the reference configuration"),
            ),
            self.function(
                "elastic_gradient",
                "Gradient of the elastic potential energy.",
                "equation 38 differentiated",
                [self.pose, self.delta_q],
                Output(
                    "E",
                    (9,),
                    tuple(lagrangian.gradient(energies.V_el, sy.displacements, self.kin.chain)),
                    "N, N m",
                    "dV_el/dq",
                ),
            ),
            self.function(
                "elastic_hessian",
                "Hessian of the elastic potential energy.",
                "equation 38 differentiated twice",
                [self.pose],
                Output(
                    "H_el", (9, 9), self.K_el, "N/m, N, N m", "d2V_el/dq2, symmetric, three zero eigenvalues"
                ),
            ),
            self.function(
                "static_equilibrium",
                "Torques and pulley rotations that hold the pose.",
                "equation 44, solved for the carriages fixed at the pose",
                [self.pose],
                Output(
                    "tau_st",
                    (3,),
                    self.equilibrium.torques,
                    "N m",
                    "torques on the driven pulleys, positive with theta",
                ),
                Output(
                    "theta_st",
                    (6,),
                    self.equilibrium.rotations,
                    "rad",
                    "rotations from the unstrained belts, in the order of the coordinates theta",
                ),
            ),
        ]

    def modal(self) -> list[Function]:
        """Stiffness matrix, alone and with the mass matrix."""
        K = Output(
            "K",
            (9, 9),
            self.K,
            "N/m, N, N m",
            "symmetric; Hessian of V_el + V_g, positive for a restoring force",
        )
        M = Output("M", (9, 9), self.M, "kg, kg m^2", "mass matrix")
        return [
            self.function(
                "stiffness_matrix",
                "Stiffness matrix K in the nine generalised coordinates.",
                "equations 46 and 48: K = -H_U",
                [self.pose],
                K,
            ),
            self.function(
                "modal_matrices",
                "Mass and stiffness matrices of M q_ddot + K q = 0, evaluated together.",
                "equation 48",
                [self.pose],
                M,
                K,
                details="Common intermediate values are evaluated once, which makes this the function to call "
                "for an eigenproblem.",
            ),
        ]


def _midpoint_jacobian(sy: Symbols, kin: kinematics.Kinematics, j: int) -> Matrix:
    """Equation 16 with W_c = W_t: the centre of mass is midway."""
    return Matrix(
        3, 3, lambda m, k: (kin.D_p[m, k] + (sy.n[j][m] if j == k else Integer(0))) * Rational(1, 2)
    )


def _block(rows: Sequence[Sequence[Expr]]) -> tuple[Expr, ...]:
    return tuple(entry for row in rows for entry in row)


def _flat(rows: object) -> tuple[Expr, ...]:
    return tuple(entry for row in rows for entry in row)
