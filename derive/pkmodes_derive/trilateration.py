"""Direct kinematics of a delta: the platform centre lies on three spheres (equation 3)."""

from __future__ import annotations

from collections.abc import Sequence

from sympy import Expr, Rational, Symbol, sqrt

from pkmodes_derive.functions import Argument, Output
from pkmodes_derive.machine import Extra, Machine
from pkmodes_derive.vectors import cross, dot


def spheres(m: Machine, centres: Sequence[Sequence[Expr]], lengths: Sequence[Symbol]) -> Extra:
    """Intersect three spheres around S_j = e_j - b_j, with the link lengths as radii.

    With S_1 as origin, alpha = S_2 - S_1 and beta = S_3 - S_1, the two intersections lie on either side of
    the plane of the centres; `assembly` selects the side and equals the sign of det D_l there.

    Parameters
    ----------
    centres : sequence of vectors
        S_j as functions of the independent coordinates.
    """
    v = m.vocabulary
    assembly = v.declare(
        "assembly", "1", "assembly branch: +1 or -1, the sign of det D_l", r"\operatorname{sgn}\det D_l"
    )
    S = m.vectors("S", "m", "centre of sphere {j}, on which the platform centre lies", "S_{j}")
    alpha = v.vector("alpha", "m", "vector from sphere centre 1 to sphere centre 2", r"\alpha")
    beta = v.vector("beta", "m", "vector from sphere centre 1 to sphere centre 3", r"\beta")
    nu = v.vector("nu", "m^2", "normal to the plane of the sphere centres", r"\nu")
    nu2 = v.declare("nu2", "m^4", "squared length of nu", r"|\nu|^2")
    what = "scalar product of p - S_1 with the vector from sphere centre 1 to sphere centre {j}"
    power = [v.declare("h_{j}", "m^2", what, "h_{j}", j=j) for j in (2, 3)]
    foot = v.vector("q", "m", "projection of p onto the plane of the sphere centres, relative to S_1", "q")
    definitions: dict[Symbol, Expr] = {}
    for sphere, centre in zip(S, centres, strict=True):
        definitions.update(zip(sphere, centre, strict=True))
    for edge, j in ((alpha, 1), (beta, 2)):
        definitions.update((edge[i], S[j][i] - S[0][i]) for i in range(3))
    definitions.update(zip(nu, cross(alpha, beta), strict=True))
    definitions[nu2] = dot(nu, nu)
    for name, edge, j in ((power[0], alpha, 1), (power[1], beta, 2)):
        definitions[name] = (dot(edge, edge) + lengths[0] ** 2 - lengths[j] ** 2) * Rational(1, 2)
    beta_nu, nu_alpha = cross(beta, nu), cross(nu, alpha)
    for i in range(3):
        definitions[foot[i]] = (power[0] * beta_nu[i] + power[1] * nu_alpha[i]) / nu2
    height = assembly * sqrt((lengths[0] ** 2 - dot(foot, foot)) / nu2)
    p = tuple(S[0][i] + foot[i] + height * nu[i] for i in range(3))
    side = "assembly branch, +1 or -1: the sign of det D_l at the desired platform centre"
    return Extra(
        "direct_kinematics",
        f"{m.pose_is.capitalize()} for given {m.independent_are}.",
        "equation 3: intersection of three spheres",
        (Output("p", (3,), p, "m", m.pose_is),),
        "NaN if the three spheres do not intersect.",
        (m.independent_argument, Argument("assembly", (assembly,), "1", side, scalar=True)),
        definitions,
    )
