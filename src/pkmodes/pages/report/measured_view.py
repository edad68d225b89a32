"""The scene of a measured robot: the model with which a result ends, and the measured modes beside it."""

from __future__ import annotations

import tomllib
from collections.abc import Sequence
from dataclasses import replace
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from pkmodes.core.base.errors import PkmodesError
from pkmodes.core.model import Model
from pkmodes.core.robot.reading import robot_from_document
from pkmodes.core.robot.robot import Robot
from pkmodes.core.support.ordering import natural_order
from pkmodes.loop.diagnosis.compare import ComparedRow, Comparison
from pkmodes.loop.diagnosis.match.predicted import PartnerPredictions
from pkmodes.loop.diagnosis.states.result import Change
from pkmodes.loop.diagnosis.verdict.result import Diagnosis
from pkmodes.loop.diagnosis.verdict.rows import Row
from pkmodes.loop.measured.measurements import Measurements
from pkmodes.loop.updating import frame
from pkmodes.loop.updating.channels import channels
from pkmodes.loop.updating.corrected_robot import corrected_robot
from pkmodes.loop.updating.load_cases import settable_paths
from pkmodes.pages.view import Scene
from pkmodes.pages.view.evaluating import scene_of
from pkmodes.pages.view.measured_modes import Channel, MeasuredMode

Array = NDArray[np.float64]
#: Maximum number of poses of a measurement that are shown.
MAX_POSES = 60


class ShownRobot(NamedTuple):
    """The robot that is shown, which model it is, its predictions of the measured modes, and the measuring frame."""

    robot: Robot
    model_in_words: str
    predicted: PartnerPredictions | None
    frame: dict[str, float]


def shown_robot(result: Diagnosis | Comparison, robot: Robot) -> ShownRobot:
    """Return the robot with which a result ends: corrected if a diagnosis is settled, otherwise as declared."""
    if isinstance(result, Comparison):
        return ShownRobot(robot, "as declared", result.stage, {})
    stages = result.stages
    declared = ShownRobot(robot, "as declared", None if stages is None else stages.before, {})
    if not result.settled or isinstance(result, Change):  # what changed is no correction of the file
        return declared
    try:
        corrected = robot_from_document(tomllib.loads(corrected_robot(robot, result)), robot.source)
    except PkmodesError:  # nothing to correct, or a cause that no robot file can hold
        return declared
    frame_values = {
        value.name: value.value for value in result.corrected if value.name.startswith(frame.OF_MEASUREMENT)
    }
    if result.effects:
        causes = " and ".join(effect.sentence or effect.name for effect in result.effects)
        with_causes = f"with the cause{'s' * (len(result.effects) > 1)}: {causes}"
        return ShownRobot(corrected, with_causes, None if stages is None else stages.after, frame_values)
    return ShownRobot(
        corrected,
        "with its uncertain values refitted",
        None if stages is None else stages.refit,
        frame_values,
    )


def measured_scene(
    result: Diagnosis | Comparison, shown: ShownRobot, data: Measurements, drives: str
) -> Scene | None:
    """Return the scene at the measured poses with their labels and measured modes.

    - shown: from `shown_robot`
    - drives: what the motors do, "free" or "held": poses at which they did otherwise are left out

    Returns None if no pose can be shown.
    Raises PkmodesError if the robot cannot be evaluated with the values that are set at a pose.
    """
    points = frame.true_points(shown.robot.mechanism, data.points, shown.frame)
    loads = [tuple(sorted(data.load(i).items())) for i in range(len(data.labels))]
    models: dict[tuple[tuple[str, float], ...], Model] = {}
    for load in loads:
        if load not in models:
            models[load] = Model(shown.robot.with_values(dict(load)) if load else shown.robot)
    shown_poses = [
        i
        for i, load in enumerate(loads)
        if data.drives[i] == drives and bool(models[load].check(points[i]).valid)
    ][:MAX_POSES]
    if not shown_poses:
        return None
    # In the order of tables and figures.
    shown_poses = [shown_poses[k] for k in natural_order([data.labels[i] for i in shown_poses])]
    scene = scene_of([models[loads[i]] for i in shown_poses], points[shown_poses], drives=drives)
    path_units, channel_units = settable_paths(shown.robot.mechanism), channels(shown.robot.mechanism)
    labels = []
    for i in shown_poses:  # with the values that are set there
        set_values = [
            f"{path.split('.')[-1]} {value:g} {path_units.get(path, '')}".rstrip()
            for path, value in data.load(i).items()
        ]
        labels.append(data.labels[i] + (f" ({', '.join(set_values)})" if set_values else ""))
    return replace(
        scene,
        labels=tuple(labels),
        what=shown.model_in_words,
        measured=_measured_modes(result, shown, data, {pose: k for k, pose in enumerate(shown_poses)}, scene),
        channels=tuple(Channel(name, channel_units.get(name, "1")) for name in data.channels),
    )


def _measured_modes(
    result: Diagnosis | Comparison,
    shown: ShownRobot,
    data: Measurements,
    scene_poses: dict[int, int],
    scene: Scene,
) -> tuple[MeasuredMode, ...]:
    modes = []
    rows: Sequence[Row | ComparedRow] = result.rows
    for row, (measured, pose) in enumerate(zip(rows, data.pose.tolist(), strict=True)):
        if pose not in scene_poses:
            continue
        partner = 0 if shown.predicted is None else int(shown.predicted.partner_mode[row])
        mode = scene.rigid_modes + partner - 1
        mac = None if shown.predicted is None else float(shown.predicted.partner_mac[row])
        modes.append(
            MeasuredMode(
                pose=scene_poses[pose],
                mode=mode if partner > 0 and mode < scene.frequencies.shape[1] else None,
                name=measured.mode,
                frequency=measured.measured,
                sigma=measured.sigma,
                mac=mac,
                shape=tuple(data.shapes[row].tolist()),
            )
        )
    return tuple(modes)
