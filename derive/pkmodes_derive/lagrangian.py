r"""From kinetic and potential energy to the matrices of the small-vibration problem.

For :math:`T(q, \dot q)`, quadratic in the velocities, and :math:`V(q)`,

.. math::
    M = \frac{\partial^2 T}{\partial \dot q^2}, \qquad
    K = \frac{\partial^2 V}{\partial q^2}, \qquad
    h = \frac{d}{dt}\Big|_{\ddot q = 0} \frac{\partial T}{\partial \dot q} - \frac{\partial T}{\partial q},

so that :math:`M \ddot q + h + \nabla V = Q` (equations 33, 44, 47 and 48 of the paper).  V is a potential
energy: forces are -dV/dq and K is positive for a restoring force.  The paper uses a force function
U = -V and K = -H_U, which is the same K.
"""

from __future__ import annotations

from collections.abc import Sequence

from sympy import Add, Expr, Symbol

from pkmodes_derive.chain import Chain


def mass_matrix(kinetic: Expr, velocities: Sequence[Symbol], chain: Chain) -> list[list[Expr]]:
    """Return M = d2T/d(qdot)2."""
    return chain.hessian(kinetic, velocities)


def damping_matrix(dissipation: Expr, velocities: Sequence[Symbol], chain: Chain) -> list[list[Expr]]:
    """Return C = d2R/d(qdot)2 of a dissipation function R: the generalised forces are -dR/d(qdot)."""
    return chain.hessian(dissipation, velocities)


def gradient(potential: Expr, coordinates: Sequence[Symbol], chain: Chain) -> list[Expr]:
    """Return the gradient of V."""
    return [chain.derivative(potential, q) for q in coordinates]


def velocity_forces(
    kinetic: Expr, coordinates: Sequence[Symbol], velocities: Sequence[Symbol], chain: Chain
) -> list[Expr]:
    """Return the Coriolis and centrifugal forces h (module docstring), quadratic in the velocities."""
    forces = []
    for coordinate, velocity in zip(coordinates, velocities, strict=True):
        momentum = chain.derivative(kinetic, velocity)
        rate = Add(
            *(chain.derivative(momentum, q) * dq for q, dq in zip(coordinates, velocities, strict=True))
        )
        forces.append(rate - chain.derivative(kinetic, coordinate))
    return forces
