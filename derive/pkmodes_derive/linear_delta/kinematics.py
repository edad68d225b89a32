r"""Kinematics of the linear delta with rails in any position and direction.

Carriage j runs on :math:`e_j = o_j + x_j n_j`, the platform carries its joint at :math:`c_j = p + b_j`, and
the linkage between them, :math:`s_j = c_j - e_j`, keeps its length (equations 1 to 3 of the paper):

.. math:: \Phi_j = \tfrac12 \left(s_j \cdot s_j - l_{d,j}^2\right) = 0.

The implicit function theorem gives the platform Jacobian D_p = D_l^{-1} D_r (equations 12 to 15) and the
second derivatives of p that replace the time derivative of D_p in equation 49.
"""

from __future__ import annotations

from dataclasses import dataclass

from sympy import Add, Expr, Integer, Matrix, Rational, Symbol, sqrt

from pkmodes_derive import implicit
from pkmodes_derive.chain import Chain
from pkmodes_derive.linear_delta.machine import Machine
from pkmodes_derive.linear_delta.symbols import Symbols
from pkmodes_derive.vectors import cross, dot
from pkmodes_derive.vocabulary import AXES, Vector


@dataclass(frozen=True)
class Kinematics:
    """The named results; every entry is a symbol defined in `chain`.

    Attributes
    ----------
    chain : Chain
        Definitions as functions of (x, p), and the rules dp/dx = D_p, dD_p/dx = P.
    inverse : dict
        The definitions that give x from p (inverse kinematics), to be put before those of `chain`.
    r, s : tuple of vectors
        Platform joint seen from the rail's origin, and linkage vector.
    closures : list of sympy.Expr
        Phi_j.
    D_l, D_r, D_p : sympy.Matrix
        Constraint Jacobians and platform Jacobian.
    U : tuple of sympy.Matrix
        U_j = ds_j/dx, the Jacobian of linkage vector j.
    P : tuple of sympy.Matrix
        P_i = d2p_i/dx2 for i = x, y, z.
    independent : tuple of sympy.Symbol
        Coordinates that move the closures: x, then the elongations of the linkages where they are released.
    right : sympy.Matrix
        -Phi_q for all of them; its first three columns are D_r.
    D : sympy.Matrix
        dp/dq for all of them; its first three columns are D_p.
    """

    chain: Chain
    inverse: dict[Symbol, Expr]
    r: tuple[Vector, ...]
    s: tuple[Vector, ...]
    closures: list[Expr]
    rail_distance: tuple[Symbol, ...]
    D_l: Matrix
    D_r: Matrix
    adjugate: Matrix
    determinant: Symbol
    D_p: Matrix
    U: tuple[Matrix, ...]
    P: tuple[Matrix, ...]
    independent: tuple[Symbol, ...]
    right: Matrix
    D: Matrix

    @property
    def reference(self) -> dict[Symbol, Expr]:
        """Released coordinates in the reference configuration."""
        return {q: Integer(0) for q in self.independent[3:]}

    @property
    def definitions(self) -> dict[Symbol, Expr]:
        """Definitions in an order in which they can be evaluated when the pose is the input.

        The carriages follow from the pose by inverse kinematics.
        """
        r_of_p = {entry: self.chain.definitions[entry] for vector in self.r for entry in vector}
        return {**r_of_p, **self.inverse, **self.chain.definitions}


def derive(machine: Machine) -> Kinematics:
    """Derive the kinematics; the derivative rules for p and D_p are left in the returned chain."""
    sy = machine.sy
    chain, v = Chain(), sy.vocabulary
    elongation = [[c.position for c in axis] for axis in machine.elongation]
    independent = (*sy.x, *(q for axis in elongation for q in axis))
    reference = {q: Integer(0) for q in independent[3:]}

    r = v.vectors_per_axis("r", "m", "platform joint {j} seen from the origin of rail {j}", "r_{j}")
    s = v.vectors_per_axis("s", "m", "linkage vector {j}, from carriage to platform joint", "s_{j}")
    for j in range(3):
        for m in range(3):
            chain.define(r[j][m], sy.p[m] + sy.b[j][m] - sy.o[j][m])
    inverse, rail_distance = _inverse(sy, r)
    for j in range(3):
        for m in range(3):
            chain.define(s[j][m], r[j][m] - sy.x[j] * sy.n[j][m])
    closures = [(dot(s[j], s[j]) - Add(sy.l_d[j], *elongation[j]) ** 2) * Rational(1, 2) for j in range(3)]

    D_l, right = implicit.first_order(closures, independent, sy.p, chain)
    right = right.xreplace(reference)  # released coordinates are zero in the reference configuration
    D_r = Matrix.zeros(3, 3)
    for j, name in enumerate(
        v.per_axis("D_r", "m", "entry of D_r for axis {j}: linkage vector along the rail", "(D_r)_{{{j}{j}}}")
    ):
        right[j, j] = D_r[j, j] = chain.define(name, right[j, j])
    adjugate, determinant = _adjugate(sy, chain, D_l)

    D = Matrix.zeros(3, len(independent))
    for m, axis in enumerate(AXES):
        for k, q in enumerate(independent):
            if k < 3:
                name = v.declare(
                    "D_p_{i}_{k}",
                    "1",
                    "platform Jacobian, dp_{i}/dx_{k}",
                    "(D_p)_{{{i}{k}}}",
                    i=axis,
                    k=k + 1,
                )
            else:
                name = v.declare(
                    "D_delta_{i}_{k}",
                    "1",
                    "platform Jacobian, dp_{i}/ddelta_{k}",
                    r"(D_\delta)_{{{i}{k}}}",
                    i=axis,
                    k=k - 2,
                )
            column = implicit.solve_3x3(adjugate, determinant, tuple(right[:, k]))
            D[m, k] = chain.define(name, column[m])
            chain.rule(sy.p[m], q, name)
    D_p = D[:, :3]

    U = tuple(_linkage_jacobian(sy, chain, s[j], independent, j) for j in range(3))
    P = _second_derivatives(sy, chain, closures, D_p, adjugate, determinant)
    return Kinematics(
        chain,
        inverse,
        r,
        s,
        closures,
        rail_distance,
        D_l,
        D_r,
        adjugate,
        determinant,
        D_p,
        U,
        P,
        independent,
        right,
        D,
    )


def _inverse(sy: Symbols, r: tuple[Vector, ...]) -> tuple[dict[Symbol, Expr], tuple[Symbol, ...]]:
    """Intersect rail j with the sphere of radius l_d around platform joint j (section 2.2, after figure 4)."""
    v, definitions = sy.vocabulary, {}
    along = v.per_axis("a", "m", "coordinate of platform joint {j} along rail {j}", "a_{j}")
    across = v.vectors_per_axis("w", "m", "vector from rail {j} square to platform joint {j}", "w_{j}")
    distance2 = v.per_axis("w2", "m^2", "squared distance of platform joint {j} from rail {j}", r"|w_{j}|^2")
    for j in range(3):
        definitions[along[j]] = dot(sy.n[j], r[j])
        for m in range(3):
            definitions[across[j][m]] = r[j][m] - along[j] * sy.n[j][m]
        definitions[distance2[j]] = dot(across[j], across[j])
        definitions[sy.x[j]] = along[j] + sy.branch[j] * sqrt(sy.l_d[j] ** 2 - distance2[j])
    return definitions, distance2


def _adjugate(sy: Symbols, chain: Chain, D_l: Matrix) -> tuple[Matrix, Symbol]:
    v = sy.vocabulary
    adjugate = Matrix.zeros(3, 3)
    for j in range(3):
        for m, axis in enumerate(AXES):
            name = v.declare(
                "A_{i}_{j}", "m^2", "adjugate of D_l, entry {i}, {j}", "A_{{{i}{j}}}", i=axis, j=j + 1
            )
            adjugate[m, j] = chain.define(name, implicit.cofactor(D_l, j, m))
    determinant = v.declare("det_D_l", "m^3", "determinant of D_l", r"\det D_l")
    chain.define(determinant, Add(*(D_l[0, m] * adjugate[m, 0] for m in range(3))))
    return adjugate, determinant


def _linkage_jacobian(
    sy: Symbols, chain: Chain, s: Vector, independent: tuple[Symbol, ...], j: int
) -> Matrix:
    U = Matrix.zeros(3, len(independent))
    for m, axis in enumerate(AXES):
        for k, q in enumerate(independent):
            U[m, k] = chain.derivative(s[m], q)
            if k < 3:  # along an elongation the linkage vector moves with the platform: no name of its own
                name = sy.vocabulary.declare(
                    "U_{j}_{i}_{k}",
                    "1",
                    "derivative of linkage vector {j}, component {i}, by x_{k}",
                    "(U_{j})_{{{i}{k}}}",
                    j=j + 1,
                    i=axis,
                    k=k + 1,
                )
                U[m, k] = chain.define(name, U[m, k])
    for m in range(3):
        for k, q in enumerate(independent):
            chain.rule(s[m], q, U[m, k])
    return U


def _second_derivatives(
    sy: Symbols, chain: Chain, closures: list[Expr], D_p: Matrix, adjugate: Matrix, determinant: Expr
) -> tuple[Matrix, ...]:
    v, P = sy.vocabulary, tuple(Matrix.zeros(3, 3) for _ in AXES)
    for k in range(3):
        for m in range(k, 3):
            forcing = implicit.second_order_forcing(closures, sy.x[k], sy.x[m], chain, jacobian=tuple(D_p))
            names = []
            for j in range(3):
                names.append(
                    v.declare(
                        "f_{j}_{k}{l}",
                        "1",
                        "right-hand side of closure {j} differentiated by x_{k} and x_{l}",
                        "(f_{j})_{{{k}{l}}}",
                        j=j + 1,
                        k=k + 1,
                        l=m + 1,
                    )
                )
                chain.define(names[j], forcing[j])
            solution = implicit.solve_3x3(adjugate, determinant, names)
            for i, axis in enumerate(AXES):
                name = v.declare(
                    "P_{i}_{k}{l}",
                    "1/m",
                    "second derivative of p_{i} by x_{k} and x_{l}",
                    "(P_{i})_{{{k}{l}}}",
                    i=axis,
                    k=k + 1,
                    l=m + 1,
                )
                P[i][k, m] = P[i][m, k] = chain.define(name, solution[i])
                chain.rule(D_p[i, k], sy.x[m], name)
                if m != k:
                    chain.rule(D_p[i, m], sy.x[k], name)
    return P


def direct(sy: Symbols) -> tuple[dict[Symbol, Expr], tuple[Expr, Expr, Expr]]:
    """Direct kinematics: intersect three spheres of radius l_d around S_j = e_j - b_j (equation 3).

    With S_1 as origin, alpha = S_2 - S_1 and beta = S_3 - S_1, the two intersections lie on either side of
    the plane of the centres; `assembly` is the side, and equals the sign of det D_l there.
    """
    v, definitions = sy.vocabulary, {}
    S = v.vectors_per_axis("S", "m", "centre of sphere {j}, on which the platform centre lies", "S_{j}")
    alpha = v.vector("alpha", "m", "vector between the sphere centres 1 and 2", r"\alpha")
    beta = v.vector("beta", "m", "vector between the sphere centres 1 and 3", r"\beta")
    nu = v.vector("nu", "m^2", "normal of the plane of the sphere centres", r"\nu")
    nu2 = v.declare("nu2", "m^4", "squared length of the normal", r"|\nu|^2")
    power = [
        v.declare(
            "h_{j}",
            "m^2",
            "product of p - S_1 with the vector between sphere centres 1 and {j}",
            "h_{j}",
            j=j,
        )
        for j in (2, 3)
    ]
    foot = v.vector("q", "m", "foot of the perpendicular on the plane of the centres, seen from S_1", "q")
    for j in range(3):
        for m in range(3):
            definitions[S[j][m]] = sy.o[j][m] + sy.x[j] * sy.n[j][m] - sy.b[j][m]
    for edge, j in ((alpha, 1), (beta, 2)):
        for m in range(3):
            definitions[edge[m]] = S[j][m] - S[0][m]
    definitions.update(zip(nu, cross(alpha, beta), strict=True))
    definitions[nu2] = dot(nu, nu)
    for name, edge, j in ((power[0], alpha, 1), (power[1], beta, 2)):
        definitions[name] = (dot(edge, edge) + sy.l_d[0] ** 2 - sy.l_d[j] ** 2) * Rational(1, 2)
    beta_nu, nu_alpha = cross(beta, nu), cross(nu, alpha)
    for m in range(3):
        definitions[foot[m]] = (power[0] * beta_nu[m] + power[1] * nu_alpha[m]) / nu2
    height = sy.assembly * sqrt((sy.l_d[0] ** 2 - dot(foot, foot)) / nu2)
    x, y, z = (S[0][m] + foot[m] + height * nu[m] for m in range(3))
    return definitions, (x, y, z)
