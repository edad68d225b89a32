"""The robot file corrected by a diagnosis."""

from __future__ import annotations

import math
from collections.abc import Mapping
from pathlib import Path

from pkmodes.core.base.errors import PkmodesError, shown
from pkmodes.core.base.numbers import plain
from pkmodes.core.mechanism.described import DAMPING_RATIO
from pkmodes.core.model import Model
from pkmodes.core.robot.covariance import Covariance
from pkmodes.core.robot.parameter_groups import groups_by_path
from pkmodes.core.robot.robot import Robot
from pkmodes.core.support.writing import write_file
from pkmodes.loop.diagnosis.verdict.findings import (
    Corrected,
    undetected_in_words,
    wider_than_declared_in_words,
)
from pkmodes.loop.diagnosis.verdict.result import Diagnosis
from pkmodes.loop.robot_files.saving import Correction, corrected_text, save_corrected
from pkmodes.loop.sensitivity.paths import resolve
from pkmodes.loop.updating import frame
from pkmodes.loop.updating.measured_robot import robot_of
from pkmodes.loop.updating.saved_term import change_note, robot_with_term, term_to_save


def corrections(robot: Robot, diagnosis: Diagnosis) -> Mapping[str, Correction]:
    """Return the changes of the robot file after a diagnosis: refitted values, causes, and their uncertainty.

    The standard deviations include the possible effect of candidates that the data cannot detect.  Losses found from
    the damping are among the changes; they change no other value.
    """
    causes = {
        v.name: finding.member(finding.name).assumed
        for finding in diagnosis.every_cause
        for v in finding.parameters
    }
    changes = {}
    for value in (*diagnosis.corrected, *diagnosis.damping.corrected):
        if value.name.startswith(frame.OF_MEASUREMENT):
            continue  # it concerns the measurements, not the robot
        changes[value.name] = Correction(value.value, value.saved_sigma, _note(robot, value, causes))
    return changes


def _note(robot: Robot, value: Corrected, causes: Mapping[str, str]) -> str:
    """Return the comment on a corrected value: what it was, who changed it, and what its sigma includes.

    - causes: the defaults on which the value of a cause depends, by the names of the values of all causes
    """
    unit = "" if value.unit == "1" else f" {value.unit}"
    declared = None
    if value.name in robot.quantities or not value.name.startswith(("effects.", DAMPING_RATIO)):
        # No generated number depends on the damping ratio, so that it has no parameter path.
        loss = value.name == DAMPING_RATIO
        declared = robot.damping_ratio if loss else resolve(robot, value.name).value
    note = change_note(value, declared, "found" if value.name in causes else "refitted")
    if assumed := causes.get(value.name):
        note += f", for {assumed}"
    if value.unseen is not None and value.widened:
        note += f"; sigma allows for {value.unseen.agent} (fit alone: {plain(value.sigma, 2)}{unit})"
    if clause := wider_than_declared_in_words(value):
        note += f"; {clause}"
    if value.unseen is not None and value.unseen.unbounded:
        agent = undetected_in_words(value.unseen.unbounded)
        note += f"; sigma does not allow for {agent}, which these data do not bound"
    return note


def covariance(robot: Robot, diagnosis: Diagnosis) -> Covariance | None:
    """Return the covariance of the changed values of the robot file; None if none has a sigma.

    The standard deviations are those of the fit, without the effect of unseen candidates on a value: that is part of
    the saved standard deviation of the value, but changes no frequency, since candidate and value compensate.
    A group such as ``axis.span`` has no standard deviation in a file, so it is left out.
    """
    groups = groups_by_path(robot.mechanism)
    losses = {value.name for value in diagnosis.damping.corrected}
    fitted_values = [
        (value, fit, index)
        for fit in (diagnosis, diagnosis.damping)
        for index, value in enumerate(fit.corrected)
        if not value.name.startswith(frame.OF_MEASUREMENT)
        and value.name not in groups
        and 0.0 < value.sigma < math.inf
        and (fit is diagnosis.damping or value.name not in losses)
    ]
    if not fitted_values:
        return None
    return Covariance(
        tuple(value.name for value, _, _ in fitted_values),
        tuple(
            # Frequencies depend on no loss, and ratios determine nothing else: errors of the fits are independent.
            tuple(fit.correlation[i][k] if fit is other_fit else 0.0 for _, other_fit, k in fitted_values)
            for _, fit, i in fitted_values
        ),
        tuple(value.sigma for value, _, _ in fitted_values),
    )


def widened_values(diagnosis: Diagnosis) -> list[Corrected]:
    """Return the values whose saved standard deviation is noticeably larger than that of the fit.

    Values of the measurement are left out: they are not in the robot file.
    """
    return [
        value
        for value in diagnosis.corrected
        if value.widened and not value.name.startswith(frame.OF_MEASUREMENT)
    ]


def corrected_robot(robot: Robot | Model, diagnosis: Diagnosis) -> str:
    """Return the text of the corrected robot file; comments and order of the original are kept.

    If a class has several causes, the first one, which names it, is written.  Where the verdict leaves nothing to
    correct, it is the file with what was found beyond the catalogue.

    - robot: the diagnosed robot, read from a file
    - diagnosis: from `diagnose`

    Raises PkmodesError if there is nothing to correct, or the robot was not read from a file.
    """
    if term_to_save(diagnosis) is not None:
        return robot_with_term(_robot_from_file(robot), diagnosis)
    robot = _correctable_robot(robot, diagnosis, "corrected_robot")
    return corrected_text(Path(robot.source), corrections(robot, diagnosis), covariance(robot, diagnosis))


def save_robot(robot: Robot | Model, found: Diagnosis, target: str | Path) -> None:
    """Write the corrected robot file, as `corrected_robot` returns it, or with what was found beyond the catalogue.

    A robot with a term is read where its effect, from `save_effect`, was derived.

    Parameters
    ----------
    robot : Robot or Model
        As declared, read from a file.
    found : Diagnosis
        Of this robot.
    target : path-like
        Another file; an existing one is replaced.

    Raises
    ------
    PkmodesError
        If there is nothing to correct, or the file cannot be written.
    """
    robot = robot_of(robot)
    if term_to_save(found) is not None:
        write_file(Path(target), robot_with_term(_robot_from_file(robot), found))
        return
    robot = _correctable_robot(robot, found, str(target))
    changes = corrections(robot, found)
    save_corrected(Path(robot.source), Path(target), changes, covariance(robot, found))


def _correctable_robot(robot_or_model: Robot | Model, diagnosis: Diagnosis, where: str) -> Robot:
    """Return a robot whose file a diagnosis corrects."""
    robot = robot_of(robot_or_model)
    if not diagnosis.settled:
        raise PkmodesError(
            f"there is no corrected robot to save: the verdict is {diagnosis.verdict}",
            where,
            "save a robot only where diagnosis.settled, or measure more",
        )
    return _robot_from_file(robot)


def _robot_from_file(robot_or_model: Robot | Model) -> Robot:
    robot = robot_of(robot_or_model)
    if not Path(robot.source).is_file():
        problem = f"expected a robot read from a file, found {shown(robot.source)}"
        raise PkmodesError(
            problem, "save_robot", "diagnose a robot read from a file, or write its values to one"
        )
    return robot
