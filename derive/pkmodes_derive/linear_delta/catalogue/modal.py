"""Stiffness matrix of the linear delta, alone and with the mass matrix."""

from __future__ import annotations

from pkmodes_derive.functions import Function, Output
from pkmodes_derive.linear_delta.catalogue.collected import Collected


def modal(c: Collected) -> list[Function]:
    """Stiffness matrix, alone and with the mass matrix."""
    K = Output(
        "K",
        (c.n, c.n),
        c.K,
        "N/m, N, N m",
        "symmetric; Hessian of V_el + V_g, positive for a restoring force",
    )
    M = Output("M", (c.n, c.n), c.M, c.units_M, "mass matrix")
    return [
        c.function(
            "stiffness_matrix",
            f"Stiffness matrix K in the {c.count} generalised coordinates.",
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
            details="Common intermediate values are evaluated once, which makes this the function to call "
            "for an eigenproblem.",
        ),
    ]
