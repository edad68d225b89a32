"""Check that the description of a mechanism matches its generated code: its fields, coordinates and functions.

The functions are evaluated once for the sample robot, at any pose: only the shapes of the results count.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from math import prod
from typing import Any

import numpy as np

from pkmodes.core.base.errors import PkmodesError
from pkmodes.core.mechanism.described import Mechanism
from pkmodes.core.mechanism.generated import Generated
from pkmodes.core.mechanism.packages import package_location
from pkmodes.core.mechanism.regular import sample_parameters

Shape = tuple[int, ...]


def check_code(mechanism: Mechanism) -> None:
    """Compare a description with its code.

    Raises PkmodesError if they do not belong together.
    """
    try:
        with np.errstate(all="ignore"):
            problem = next(_problems(mechanism), "")
    except Exception as error:  # the code is not the one that was described
        problem = f"{type(error).__name__}: {error}"
    if problem:
        message = f"the description of the mechanism does not fit its code: {problem}"
        raise PkmodesError(message, package_location(mechanism.package), "generate it again")


def _problems(mechanism: Mechanism) -> Iterator[str]:
    shapes = {field: _shape(value) for field, value in mechanism.sample.items()}
    yield from _name_difference("the fields of the sample", shapes, mechanism.model.Parameters._fields)
    yield from _key_problems(mechanism, shapes)
    yield from _coordinate_problems(mechanism)
    for field, counterpart in mechanism.differences.items():
        yield from _difference(f"the shape of {field} and {counterpart}", shapes[field], shapes[counterpart])
    for scale in mechanism.scales:
        yield from _difference(
            f"the shape of {scale.field}", np.shape(np.zeros(shapes[scale.field])[scale.index]), ()
        )
    yield from _function_problems(mechanism)
    yield from _drawing_problems(mechanism)


def _shape(value: Any) -> Shape:
    array = np.asarray(value)
    if array.dtype.kind not in "iuf":
        raise TypeError(f"expected numbers in the sample, found {value!r:.60}")
    return array.shape


def _name_difference(
    subject: str, actual: Sequence[str] | dict[str, Any], expected: Sequence[str]
) -> Iterator[str]:
    if set(actual) != set(expected):
        yield f"{subject} are {', '.join(actual)}; expected {', '.join(expected)}"


def _difference(subject: str, actual: object, expected: object, verb: str = "is") -> Iterator[str]:
    if actual != expected:
        yield f"{subject} {verb} {actual}, expected {expected}"


def _key_problems(mechanism: Mechanism, shapes: dict[str, Shape]) -> Iterator[str]:
    """Check that every number of every field belongs to one key."""
    key_indices: dict[str, list[Shape]] = {"gravity": [()]}
    value_counts = {"gravity": 3}
    for table in mechanism.tables:
        # If a repeated table shares these values, the first dimension is that table's number of entries.
        count = next(
            (
                repeated_table.count
                for repeated_table in mechanism.tables
                if repeated_table.name == table.shared_by
            ),
            table.count,
        )
        leading_shape = (count,) if count else ()
        for key in table.keys:
            if key.field:
                shape = shapes[key.field]
                actual_leading_shape, entry_shape = shape[: len(leading_shape)], shape[len(leading_shape) :]
                yield from _difference(
                    f"the shape of {key.field}",
                    (*leading_shape, *key.shape),
                    (*actual_leading_shape, *entry_shape[len(key.index) :]),
                )
                np.zeros(entry_shape)[key.index]  # raises IndexError if the key's index is outside the field
                key_indices.setdefault(key.field, []).append(key.index)
                value_counts[key.field] = value_counts.get(key.field, 0) + prod((*leading_shape, *key.shape))
    yield from _name_difference("the fields of the keys", key_indices, tuple(shapes))
    for field, indices in key_indices.items():
        if len(set(indices)) < len(indices):
            yield f"the keys of {field} use an index twice"
        yield from _difference(f"the number of values of {field}", value_counts[field], prod(shapes[field]))


def _coordinate_problems(mechanism: Mechanism) -> Iterator[str]:
    effects = mechanism.effects.values()
    all_coordinates = (*mechanism.coordinates, *(q for effect in effects for q in effect.coordinates))
    for module, coordinates in (
        (mechanism.model, mechanism.coordinates),
        (mechanism.extended, all_coordinates),
    ):
        yield from _difference(
            "the order of coordinates", tuple(q.name for q in coordinates), tuple(module.COORDINATES)
        )
        yield from _difference(
            "the units of the coordinates",
            tuple(q.unit for q in coordinates),
            tuple(module.COORDINATE_UNITS),
            "are",
        )
    fields = [f"{effect.name}_{parameter.name}" for effect in effects for parameter in effect.parameters]
    yield from _name_difference("the parameters of effects", fields, mechanism.extended.Effects._fields)
    if hasattr(mechanism.model, "RIGID_MODES"):
        yield from _difference(
            "the number of rigid modes", mechanism.rigid_modes, mechanism.model.RIGID_MODES
        )


def _function_problems(mechanism: Mechanism) -> Iterator[str]:
    model, extended = _bind_sample(mechanism, mechanism.model), _bind_sample(mechanism, mechanism.extended)
    pose = np.full(len(mechanism.pose), 0.1)
    positions, jacobian = model.inverse_kinematics(pose), model.platform_jacobian(pose)
    yield from _difference(
        "the number of independent coordinates", len(mechanism.independent), len(positions)
    )
    yield from _difference(
        "the shape of the platform Jacobian", (len(pose), len(positions)), np.shape(jacobian)
    )
    motion_shape = np.shape(extended.extended_platform_motion(pose))
    platform_axes = "directions and rotations" if mechanism.rotations else "directions"
    yield from _difference(f"the number of {platform_axes}", len(mechanism.platform), motion_shape[0])
    torques = model.static_equilibrium(pose)[0]
    yield from _difference("the number of drives", len(mechanism.drives), len(torques))
    motor_motion_shape = np.shape(extended.motor_motion())
    expected_shape = (len(mechanism.drives), len(mechanism.extended.COORDINATES))
    yield from _difference("the shape of the motors' angles", expected_shape, motor_motion_shape)
    for margin in mechanism.margins:
        results = getattr(model, margin.function)(pose)
        shape = np.shape(results[margin.output] if isinstance(results, tuple) else (results,)[margin.output])
        yield from _difference(
            f"the number of names for {margin.function}", tuple(map(len, margin.names)), shape
        )
    requirements = [(model, requirement) for requirement in mechanism.requirements]
    requirements += [
        (extended, requirement)
        for effect in mechanism.effects.values()
        for requirement in effect.requirements
    ]
    for generated, requirement in requirements:
        size = np.size(getattr(generated, requirement.function)())
        yield from _difference(
            f"the number of places of {requirement.function}", len(requirement.places), size
        )


def _drawing_problems(mechanism: Mechanism) -> Iterator[str]:
    drawing, drawn = mechanism.drawing, _bind_sample(mechanism, mechanism.drawn)
    pose = np.full(len(mechanism.pose), 0.1)
    upright_vectors = (np.tile([0.0, 0.0, 1.0], drawing.uprights),) if drawing.uprights else ()
    points, motions = (
        drawn.drawing_points(pose, *upright_vectors),
        drawn.drawing_motion(pose, *upright_vectors),
    )
    yield from _difference("the number of drawn points", len(drawing.motions), len(points))
    yield from _difference(
        "the number of motions of the drawn points", max(drawing.motions) + 1, len(motions)
    )
    yield from _difference("the number of springs", len(drawing.springs), len(drawn.springs(pose)[0]))
    if drawing.uprights:
        yield from _difference(
            "the number of uprights", drawing.uprights, len(drawn.drawing_directions(pose))
        )


def _bind_sample(mechanism: Mechanism, module: Any) -> Generated:
    return Generated(module, sample_parameters(mechanism), mechanism.extended.Effects())
