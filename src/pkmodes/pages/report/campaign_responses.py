"""Measured frequency responses of a campaign over those of the model, before and after its correction."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from typing import TYPE_CHECKING, NamedTuple

import numpy as np
from numpy.typing import NDArray

from pkmodes.core.base.errors import PkmodesError
from pkmodes.core.base.numbers import plain
from pkmodes.core.mechanism.described import DAMPING_RATIO
from pkmodes.core.model import Model
from pkmodes.core.support.ordering import listed
from pkmodes.machine.response.campaign_responses import RESPONSE_KINDS, RecordResponse, record_response
from pkmodes.machine.response.frequency_response import frequency_response
from pkmodes.machine.response.ports import FORCE, MOMENT
from pkmodes.pages.plots.responses import responses
from pkmodes.pages.report.blocks import Block, Picture
from pkmodes.pages.report.formatting import clean
from pkmodes.pages.report.measured_view import shown_robot

if TYPE_CHECKING:
    from pkmodes.core.robot.robot import Robot
    from pkmodes.loop.diagnosis.verdict.result import Diagnosis
    from pkmodes.loop.diagnosis.verdict.rows import Row
    from pkmodes.modaltest.campaign.campaign import Campaign, Record

Complex = NDArray[np.complex128]
#: Number of frequencies at which the models are evaluated, and maximum number of channels drawn at a pose.
FREQUENCY_COUNT, MAX_CHANNELS = 600, 4
#: Damping ratio with which a robot without losses is drawn where none was measured.
USUAL_RATIO = 0.01
#: Maximum number of names in an error.
MAX_NAMES = 8


class Accelerances(NamedTuple):
    """Responses of a model to the forces of a record, by channel, and their units."""

    values: dict[str, Complex]
    units: dict[str, str]


def measured_responses(result: Diagnosis, robot: Robot, campaign: Campaign) -> list[Block]:
    """Return the measured accelerances at the poses where the model is worst, over those of the model.

    These are the pose with the largest difference of a frequency from that of the robot as declared, and the pose
    with the largest one from that of the robot as corrected.

    - result: of measurements that `pkmodes identify` made from the campaign

    Raises PkmodesError if no record of the campaign has frequency response functions at a pose of the result, or its
    forces have no place.
    Raises MeasurementError if one of its files is faulty.
    """
    records = {record.pose: record for record in campaign.records if record.kind in RESPONSE_KINDS}
    rows = [row for row in result.rows if row.pose in records and row.before is not None and not row.outlier]
    if not rows:
        expected = f"expected frequency response functions at {listed(_poses(result.rows), MAX_NAMES)}"
        problem = f"{expected}, found those at {listed(list(records), MAX_NAMES)}"
        if not records:
            problem = "expected records of frequency response functions, found none"
        remedy = "give the campaign that pkmodes identify made the measurement file from"
        raise PkmodesError(problem, campaign.source, remedy)
    final = shown_robot(result, robot).robot
    corrected = None if final is robot else final
    reasons: dict[str, list[str]] = {_worst(rows, lambda row: row.before): ["as declared"]}
    if corrected is not None:
        remaining = _worst(rows, lambda row: row.after if row.after is not None else row.refit)
        reasons.setdefault(remaining, []).append("as corrected")
    ratios = [row.damping for row in result.rows if row.damping]
    ratio = float(np.median(ratios)) if ratios else USUAL_RATIO
    blocks: list[Block] = []
    for pose, states in reasons.items():
        blocks.append(_picture(records[pose], campaign, robot, corrected, ratio, bool(ratios), states))
    return blocks


def _poses(rows: Sequence[Row]) -> list[str]:
    return list(dict.fromkeys(row.pose for row in rows))


def _worst(rows: Sequence[Row], predicted: Callable[[Row], float | None]) -> str:
    """Return the label of the pose with the largest relative difference of a frequency."""
    values = [(predicted(row) or row.measured) / row.measured for row in rows]
    return rows[int(np.abs(np.subtract(values, 1.0)).argmax())].pose


def _picture(
    record: Record,
    campaign: Campaign,
    declared: Robot,
    corrected: Robot | None,
    ratio: float,
    is_measured: bool,
    states: Sequence[str],
) -> Picture:
    """Return the responses at the pose of a record.

    - ratio, is_measured: damping ratio of a robot without losses, and whether it is that of measured modes
    - states: of the robot whose largest error of a frequency is at this pose
    """
    measured = record_response(campaign, record)
    low, high = record.band
    inside = (measured.frequencies >= low) & (measured.frequencies <= high)
    f = np.linspace(low, high, FREQUENCY_COUNT)
    robots = {"as declared": declared} | ({} if corrected is None else {"as corrected": corrected})
    drawn = {name: accelerances(robot, record, measured, f, ratio) for name, robot in robots.items()}
    before, model = drawn["as declared"], drawn.get("as corrected", drawn["as declared"])
    largest = {name: float(np.abs(measured.channels[name][inside]).max(initial=0.0)) for name in model.values}
    strongest = max(model.values, key=lambda name: largest[name])
    alike = [name for name in model.values if model.units[name] == model.units[strongest]]
    chosen = sorted(sorted(alike, key=lambda name: -largest[name])[:MAX_CHANNELS], key=alike.index)
    drawing = responses(
        f,
        {name: model.values[name] for name in chosen},
        model.units,
        (measured.frequencies, measured.channels),
        before=None if corrected is None else before.values,
    )
    shown = ", ".join(map(clean, chosen))
    caption = f"Acceleration per force of {shown} at {clean(record.pose)}"
    if len(chosen) < len(model.values):
        caption += f", the largest of {len(model.values)}"
    caption += ": broad lines are measured, "
    caption += (
        "thin ones the robot as declared."
        if corrected is None
        else "dashed ones the robot as declared (before), thin ones as corrected (after)."
    )
    caption += f" The largest error of a frequency of the robot {' and '.join(states)} is at this pose."
    lossless = [name for name, robot in robots.items() if not robot.dissipates]
    if lossless:
        subject = f"The robot {lossless[0]} has" if len(lossless) == 1 else "Both have"
        source = "the median of the measured ones" if is_measured else "which is assumed"
        caption += (
            f" {subject} no losses in the file, and here a damping ratio of {plain(100.0 * ratio, 2)} %, "
        )
        caption += f"{source}."
    text = f"Measured acceleration per force at {clean(record.pose)}, and that of the model."
    return Picture.from_drawing(drawing, f"Responses at {clean(record.pose)}", text, caption)


def accelerances(
    robot: Robot, record: Record, measured: RecordResponse, f: NDArray[np.float64], ratio: float
) -> Accelerances:
    """Return the accelerances of a robot in the channels that were measured; those of an oblique force add up.

    - f: (F,) [Hz]
    - ratio: damping ratio of a robot without losses

    Raises PkmodesError if no force acts on the moving body.
    """
    settings = dict(record.settings) | ({} if robot.dissipates else {DAMPING_RATIO: ratio})
    model = Model(robot.with_values(settings) if settings else robot)
    forces = {
        name: weights
        for name, weights in measured.excitations.items()
        if all(into.startswith((FORCE, MOMENT)) for into in weights)
    }
    if not forces:
        channels = listed(
            sorted({into for weights in measured.excitations.values() for into in weights}), MAX_NAMES
        )
        problem = f"expected a force on the {robot.mechanism.moving_body()}, found forces along {channels}"
        raise PkmodesError(
            problem, record.pose, "leave the campaign out, or measure with such a force as well"
        )
    inputs = list(dict.fromkeys(into for weights in forces.values() for into in weights))
    pairs = [(name, *name.rpartition("/")[::2]) for name in measured.channels]
    pairs = [(name, output, force) for name, output, force in pairs if force in forces]
    outputs = list(dict.fromkeys(output for _, output, _ in pairs))
    point = [record.point[component.name] for component in robot.mechanism.pose]
    found = frequency_response(
        model, point, f, inputs, outputs, drives=record.drives, quantity="acceleration"
    )
    values, units = dict[str, Complex](), dict[str, str]()
    for name, output, force in pairs:
        o = outputs.index(output)
        columns = {inputs.index(into): weight for into, weight in forces[force].items()}
        values[name] = found.values[:, o, list(columns)] @ np.array(list(columns.values()))
        units[name] = found.units[o][next(iter(columns))]
    return Accelerances(values, units)
