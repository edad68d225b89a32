"""Relations between the functions of a drawing and those of the model, at a pose of a robot without effects."""

from __future__ import annotations

from collections.abc import Iterator

import numpy as np

from pkmodes.codegen.checking.consistency import Check, check_consistency
from pkmodes.codegen.checking.relations import Relation, State
from pkmodes.core.mechanism.generated import Generated
from pkmodes.core.mechanism.registry import Mechanism


def check_drawing(mechanism: Mechanism, parameters: object) -> list[Check]:
    """Check the motion of drawn points by differences of their positions, and the springs by the elastic Hessian."""
    return check_consistency(
        Generated(mechanism.model, parameters), mechanism, parameters, yielded=drawing_relations
    )


def drawing_relations(at: State) -> Iterator[Relation]:
    """Yield the relations of a drawing at one pose."""
    drawing = at.mechanism.drawing
    drawn = Generated(at.mechanism.drawn, at.parameters, at.mechanism.extended.Effects())
    # Any constant vectors serve as those that the robot leaves open.
    up = (np.tile([0.6, -0.48, 0.64], drawing.uprights),) if drawing.uprights else ()
    motion = drawn.drawing_motion(at.pose, *up)[list(drawing.motions)]
    moved = at.rate(lambda p: drawn.drawing_points(p, *up))
    yield "motion of drawn points", motion[..., at.places], moved, 0.0
    if at.generated.has("elastic_hessian"):
        stiffness, strain = drawn.springs(at.pose)
        strain = strain[:, : at.base]
        hessian = at.generated.elastic_hessian(at.pose)
        yield "springs", strain.T @ (stiffness[:, None] * strain), hessian, 0.0
