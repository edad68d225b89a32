"""Relations between generated functions that apply to the linear delta only."""

from __future__ import annotations

from collections.abc import Iterator

import numpy as np

from pkmodes.codegen.checking.relations import Relation, State

#: Rate of change of each free span of a belt with its carriage; the span between the pulleys does not change.
SPAN_RATES = np.array([0.0, 1.0, -1.0])


def relations(state: State) -> Iterator[Relation]:
    """Yield the relations of belts, links and pulleys at one pose."""
    g, p = state.generated, state.pose
    spans, k = g.belt_spans(p), g.belt_stiffness(p)
    D_l, D_r = g.constraint_jacobians(p)
    yield (
        "belt spans",
        state.differentiate(g.belt_spans),
        np.eye(3)[:, None, :] * SPAN_RATES[None, :, None],
        1.0,
    )
    if state.effects:  # the compliance in series with a span does not grow with its length
        (short, middle, long), (a, b, c) = np.sort(spans, axis=1).T, -np.sort(-k, axis=1).T
        yield "belt stiffness", (1 / b - 1 / a) * (long - short), (1 / c - 1 / a) * (middle - short), 0.0
    else:
        yield "belt stiffness", k * spans, np.repeat((k * spans)[:, :1], 3, axis=1), 0.0
        # Both spans of a carriage pull at it.
        yield "belt stiffness at the carriages", k[:, 1] + k[:, 2], np.diag(g.elastic_hessian(p))[:3], 0.0
    if g.has("travel_margin"):
        yield "travel margin", g.travel_margin(), spans[:, 1] + spans[:, 2], 0.0
    # Pythagoras: a link, its component perpendicular to the rail and its component along the rail.
    links, length = np.linalg.norm(D_l, axis=1), float(np.abs(D_l).max())
    yield "reach margin", (links - g.reach_margin(p)) ** 2, links**2 - np.diag(D_r) ** 2, length**2
    # Velocity of the platform end of each link: from the link's centre and rotation, and from the platform.
    D_d, D_omega = g.link_jacobians(p)
    rotation_part = np.cross(D_omega, 0.5 * D_l[:, :, None], axisa=1, axisb=1, axisc=1)
    yield "link Jacobians", D_d + rotation_part, np.broadcast_to(g.platform_jacobian(p), D_d.shape), 1.0
    if state.effects:
        return
    torques, rotations = g.static_equilibrium(p)
    pulleys = g.elastic_gradient(p, np.concatenate([np.zeros(3), rotations]))[3:].reshape(2, 3)
    largest = float(np.abs(torques).max())
    yield "static torques by axis", torques, pulleys.sum(axis=0), largest
    # Together with the relation before: one pulley of an axis carries the torque, the other carries none.
    yield "torque on one pulley only", np.abs(torques), np.abs(pulleys).max(axis=0), largest
