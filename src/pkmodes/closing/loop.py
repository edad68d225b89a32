"""Compare and diagnose a robot, and correct its file: the engine with a robot as its structure."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from pathlib import Path

from pkmodes import diagnosis
from pkmodes.closing import frame
from pkmodes.closing.structure import CHANNELS, RobotStructure
from pkmodes.closing.suspects import suspects
from pkmodes.diagnosis.compare import Comparison
from pkmodes.diagnosis.search.additions import Progress
from pkmodes.diagnosis.verdict.result import Diagnosis
from pkmodes.errors import PkmodesError
from pkmodes.measured.measurements import Measurements
from pkmodes.measured.reading import check_reachable, read_measurements
from pkmodes.model import Model
from pkmodes.robot.robot import Robot
from pkmodes.robot.saving import Correction, save_corrected
from pkmodes.sensitivity.paths import resolve


def read(path: str | Path) -> Measurements:
    """Read the modes measured on a robot (formats.md, section 3)."""
    return read_measurements(path, CHANNELS)


def structure(robot: Robot, data: Measurements, candidates: Sequence[str] | None = None) -> RobotStructure:
    """Return the robot at the measured poses, with its nuisances and candidates.

    Raises
    ------
    PkmodesError
        If a pose cannot be reached, or a candidate is unknown.
    """
    check_reachable(data, Model(robot))
    return RobotStructure(robot, data.points, *suspects(robot, candidates))


def compare(robot: Robot, data: Measurements) -> Comparison:
    """Prediction beside measurement.

    Parameters
    ----------
    robot : Robot
        From `pkmodes.read_robot`.
    data : Measurements
        From `read`.
    """
    return diagnosis.compare(structure(robot, data, candidates=()), data)


def diagnose(
    robot: Robot,
    data: Measurements,
    *,
    candidates: Sequence[str] | None = None,
    holdout: Sequence[str] | None = None,
    progress: Progress | None = None,
) -> Diagnosis:
    """Find what the model of a robot lacks.

    Parameters
    ----------
    robot : Robot
        From `pkmodes.read_robot`.
    data : Measurements
        From `read`.
    candidates : sequence of str, optional
        Names of effects, ``parameter:<path>``, or ``effects`` and ``parameters``; by default all.
    holdout : sequence of str, optional
        Labels of poses that take no part in any choice or fit; by default one in six.
    progress : callable, optional
        Called with a sentence at each step.

    Returns
    -------
    Diagnosis

    Raises
    ------
    PkmodesError
        If a pose cannot be reached, or a name is unknown.
    """
    return diagnosis.diagnose(structure(robot, data, candidates), data, holdout=holdout, progress=progress)


def corrections(robot: Robot, found: Diagnosis) -> Mapping[str, Correction]:
    """Changes of the robot file that a diagnosis asks for: refitted values, causes, and their uncertainty."""
    causes = {v.name for finding in found.effects for v in finding.parameters}
    changes = {}
    for value in found.corrected:
        if value.name in frame.PARAMETERS:
            continue  # a matter of the measurements: the robot is as it was
        note = "found by pkmodes diagnose" if value.name in causes else "refitted by pkmodes diagnose"
        if value.name in robot.quantities or not value.name.startswith("effects."):
            unit = "" if value.unit == "1" else f" {value.unit}"
            note = f"was {resolve(robot, value.name).value:.6g}{unit}: {note}"
        changes[value.name] = Correction(value.value, value.sigma, note)
    return changes


def save_robot(robot: Robot, found: Diagnosis, target: str | Path) -> None:
    """Write the corrected robot, with comments and order of the original kept.

    Raises
    ------
    PkmodesError
        If there is nothing to correct, or the file cannot be written.
    """
    if not found.effects and found.verdict != "adequate":
        raise PkmodesError(
            f"there is no corrected robot to save: the verdict is {found.verdict}",
            str(target),
            "leave out --save-robot, or measure more",
        )
    save_corrected(Path(robot.source), Path(target), corrections(robot, found))
