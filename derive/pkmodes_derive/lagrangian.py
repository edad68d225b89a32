r"""From kinetic and potential energy to the matrices of the small-vibration problem.

For :math:`T(q, \dot q)`, quadratic in the velocities, and :math:`V(q)`,

.. math::
    M = \frac{\partial^2 T}{\partial \dot q^2}, \qquad
    K = \frac{\partial^2 V}{\partial q^2}, \qquad
    h = \frac{d}{dt}\Big|_{\ddot q = 0} \frac{\partial T}{\partial \dot q} - \frac{\partial T}{\partial q},

so that :math:`M \ddot q + h + \nabla V = Q` (equations 33, 44, 47 and 48 of the paper).  V is a potential
energy: forces are -dV/dq and K is positive for a restoring force.  The paper uses a force function
U = -V and K = -H_U, which is the same K.

Of a platform that turns the twist :math:`t = (v, \omega) = D \dot q` is not the rate of coordinates.  With momenta
:math:`\pi = \partial T/\partial t` and the vectors w that are fixed in the platform (`turning`),

.. math::
    h_k = D_k \cdot z + \frac{d}{dt} \frac{\partial T}{\partial \dot q_k} - \frac{\partial T}{\partial q_k}, \qquad
    z_v = \dot\pi_v - \frac{\partial T}{\partial p}, \quad
    z_\omega = \dot\pi_\omega - \omega \times \pi_\omega - \sum_w w \times \frac{\partial T}{\partial w},

with partial derivatives of T(t, p, w, q, q_dot) (Boltzmann and Hamel's equations).
"""

from __future__ import annotations

from collections.abc import Callable, Sequence

from sympy import Add, Expr, Integer, Matrix, Symbol

from pkmodes_derive.chain import Chain
from pkmodes_derive.turning import Turning
from pkmodes_derive.vectors import cross
from pkmodes_derive.vocabulary import AXES

#: A symbol by which values are differentiated along a motion.
TIME = Symbol("time", real=True)


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


def velocity_forces_of_twist(
    kinetic: Expr,
    coordinates: Sequence[Symbol],
    velocities: Sequence[Symbol],
    twist: Sequence[Symbol],
    platform: Sequence[Symbol],
    D: Matrix,
    turning: Turning,
    moving: Chain,
    name: Callable[[str, int, Expr], Expr],
) -> list[Expr]:
    """Return the Coriolis and centrifugal forces h for a platform that turns (module docstring).

    Parameters
    ----------
    kinetic : sympy.Expr
        T in the twist, the vectors fixed in the platform, the coordinates and their rates.
    platform : sequence of sympy.Symbol
        Position and small rotations of the platform, in the order of the twist.
    D : sympy.Matrix
        Twist per unit of each rate.
    moving : Chain
        Definitions without rules, but those for the derivatives with respect to the symbol `TIME` at q_ddot = 0.
    name : callable
        ``name(what, i, expression)`` names component i of "momentum" or "force".
    """
    held_symbols = (*twist, *turning.symbols)
    momenta = [
        name("momentum", i, moving.derivative(kinetic, t, hold=held_symbols)) for i, t in enumerate(twist)
    ]
    force = [moving.derivative(momentum, TIME) for momentum in momenta]
    first = len(twist) - len(turning.axes)
    for i, p in enumerate(platform[:first]):
        force[i] -= moving.derivative(kinetic, p, hold=held_symbols)
    moment = cross(turning.spatial(turning.rates), turning.spatial(momenta[first:]))
    gyroscopic = [-component for component in moment]
    for vector in turning.fixed:
        gradient = [
            moving.derivative(kinetic, w, hold=held_symbols) if w.is_Symbol else Integer(0) for w in vector
        ]
        if any(gradient):
            for i, component in enumerate(cross(vector, gradient)):
                gyroscopic[i] -= component
    for i, axis in enumerate(turning.axes, start=first):
        force[i] += gyroscopic[AXES.index(axis)]
    force = [name("force", i, component) for i, component in enumerate(force)]
    forces = []
    for k, (q, rate) in enumerate(zip(coordinates, velocities, strict=True)):
        own_rate = moving.derivative(moving.derivative(kinetic, rate, hold=held_symbols), TIME)
        platform_part = Add(*(D[i, k] * component for i, component in enumerate(force)))
        forces.append(platform_part + own_rate - moving.derivative(kinetic, q, hold=held_symbols))
    return forces
