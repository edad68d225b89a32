"""Checks of measurements against a robot: pose components, shape coordinates, and reachability."""

from __future__ import annotations

import numpy as np

from pkmodes.base.errors import MeasurementError, PoseError, nearest, shown
from pkmodes.measured.measurements import Measurements
from pkmodes.mechanism.poses import LARGE, check_poses, placed
from pkmodes.mechanism.registry import Mechanism
from pkmodes.model.model import Model
from pkmodes.updating.load_cases import LoadCases, load_cases, of_columns
from pkmodes.updating.structure import channels

#: Factors for lengths in another unit than stated, and the remedy.
OTHER_LENGTHS = {
    1e-3: "the numbers look like millimetres: write {0} in the header",
    1e3: "the numbers look like metres, but the header says otherwise: write {1} there",
}


def check_measured(measurements: Measurements, model: Model) -> LoadCases:
    """Refuse measurements that the robot cannot have.

    Returns
    -------
    LoadCases
        Values set at the poses.

    Raises
    ------
    MeasurementError
        If the poses have other components than the mechanism's, a shape component is not a coordinate of the robot, a
        set value is refused, or a pose cannot be evaluated: for the first such pose, with the line of its first row.
    """
    if not measurements.labels:
        return LoadCases.none(model.robot, 0)
    mechanism = model.mechanism
    names = tuple(component.name for component in mechanism.pose)
    if measurements.components != names:
        what = f"expected poses with {_listed(names)}, found {_listed(measurements.components)}"
        raise MeasurementError(what, measurements.source, f"give the pose components of {model.robot.source}")
    known = channels(mechanism)
    for name in measurements.channels:
        if name not in known:
            what = f"{shown(name)} is not a coordinate of {model.robot.source}"
            raise MeasurementError(what, measurements.source, nearest(name, known))
    loads = load_cases(model.robot, measurements)
    _check_reachable(measurements, model, names, loads)
    return loads


def _check_reachable(
    measurements: Measurements, model: Model, names: tuple[str, ...], loads: LoadCases
) -> None:
    mechanism, parameters = model.mechanism, model.robot.parameters
    valid = np.ones(len(measurements.points), dtype=bool)
    for c, case in enumerate(loads.cases):
        rows = np.flatnonzero(loads.of == c)
        points = measurements.points[rows]
        valid[rows] = check_poses(points, mechanism, case.robot.parameters, "nan", model.max_condition).valid
    if valid.all():
        return
    first = int(np.argmin(valid))
    line = measurements.lines[int(np.argmax(measurements.pose == first))]
    where = f"{measurements.source}: line {line}, columns {_listed(names)}"
    if (bad := int((~valid).sum())) > 1:
        where += f", the first of {bad} bad poses"
    for factor, remedy in OTHER_LENGTHS.items():
        scaled = measurements.points * np.where(_lengths(mechanism), factor, 1.0)
        reached = check_poses(scaled, mechanism, parameters, "nan", model.max_condition).valid
        large = np.abs(measurements.points[:, _lengths(mechanism)]).max(initial=0.0) >= LARGE
        if reached.all() and not valid.any() and (factor > 1.0 or large):
            columns = ",".join(
                f"{name} [mm]" if length else name
                for name, length in zip(names, _lengths(mechanism), strict=True)
            )
            what = f"no pose can be reached, but all can if multiplied by {factor:g}"
            raise MeasurementError(what, where, remedy.format(columns, ",".join(names)))
    load = measurements.load(first)
    robot, remedy = loads.cases[loads.of[first]].robot, f"check the row and {model.robot.source}"
    if check_poses(measurements.points[first], mechanism, parameters, "nan", model.max_condition).valid.all():
        where = where.replace(
            f"columns {_listed(names)}", of_columns(load)
        )  # as declared, the robot reaches it
        remedy = "check the set values"
    try:
        check_poses(measurements.points[first], mechanism, robot.parameters, "raise", model.max_condition)
    except PoseError as error:
        label, place = shown(measurements.labels[first]), placed(mechanism, measurements.points[first])
        raise MeasurementError(
            f"pose {label} at {place} cannot be reached{' with the set values' if load else ''}: {error.what}",
            where,
            f"{error.remedy}; {remedy}",
        ) from None


def _lengths(mechanism: Mechanism) -> list[bool]:
    return [component.unit == "m" for component in mechanism.pose]


def _listed(names: tuple[str, ...]) -> str:
    """Join names as in a sentence: x, y and z."""
    return " and ".join([", ".join(names[:-1]), *names[-1:]]) if len(names) > 1 else "".join(names)
