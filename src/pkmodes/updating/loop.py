"""Compare, diagnose and update a robot, and correct its file."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import replace
from os import PathLike
from pathlib import Path

from pkmodes import diagnosis
from pkmodes.base.errors import MeasurementError, PkmodesError, shown
from pkmodes.diagnosis.arguments import check_measurements
from pkmodes.diagnosis.compare import Comparison
from pkmodes.diagnosis.search.additions import Progress
from pkmodes.diagnosis.update import Update
from pkmodes.diagnosis.verdict.result import Diagnosis
from pkmodes.diagnosis.verdict.verdicts import VERDICTS
from pkmodes.linalg.threads import one_blas_thread
from pkmodes.measured.measurements import Measurements
from pkmodes.measured.reading import read_measurements
from pkmodes.mechanism.registry import Mechanism, mechanism, names
from pkmodes.model.model import Model
from pkmodes.robot.paths import resolve
from pkmodes.robot.robot import Robot
from pkmodes.robot.saving import Correction, corrected_text, save_corrected
from pkmodes.updating import frame
from pkmodes.updating.load_cases import settable
from pkmodes.updating.poses import check_measured
from pkmodes.updating.priors import with_priors
from pkmodes.updating.structure import RobotStructure, channels
from pkmodes.updating.suspects import suspects


def read(
    path: str | Path, band: tuple[float, float] | None = None, robot: Robot | Model | None = None
) -> Measurements:
    """Read the modes measured on a robot.

    Parameters
    ----------
    path : path-like
        A CSV file with one row for each identified mode (docs/diagnosis.md, "What goes in").
    band : tuple of two floats, optional
        Lowest and highest frequency of the test [Hz], if the file does not state it.
    robot : Robot or Model, optional
        Robot whose mechanism defines the allowed columns; by default those of any mechanism.

    Returns
    -------
    Measurements
        In SI units and Hz.

    Raises
    ------
    MeasurementError
        If anything in the file is wrong, it states another band, or a row lies outside the band.
    """
    if not isinstance(path, str | PathLike):
        raise PkmodesError(f"expected a path, found {shown(path)}", "read", "give the name of a CSV file")
    of = None if robot is None else _robot(robot)
    mechanisms = [mechanism(name) for name in names()] if of is None else [of.mechanism]
    found = read_measurements(
        path,
        {name: unit for one in mechanisms for name, unit in channels(one).items()},
        components=[_components(one) for one in mechanisms],
        settings={name: unit for one in mechanisms for name, unit in settable(one, of).items()},
    )
    if band is None:
        return found
    if found.band not in (None, band):
        stated = f"{found.band[0]:g} Hz to {found.band[1]:g} Hz"
        what = f"the file states the band {stated}, not {band[0]:g} Hz to {band[1]:g} Hz"
        raise MeasurementError(what, found.source, "leave the band out, or correct the file")
    return replace(found, band=band)


def _components(mechanism: Mechanism) -> dict[str, str]:
    """Return the components of a pose and their units: columns of a measurement file."""
    return {component.name: component.unit for component in mechanism.pose}


def structure(
    robot: Robot | Model,
    data: Measurements,
    candidates: Sequence[str] | None = None,
    priors: Mapping[str, float | str] | None = None,
) -> RobotStructure:
    """Return the robot at the measured poses, with its nuisances and candidates.

    Raises
    ------
    PkmodesError
        If a pose cannot be reached, a set value is refused, or a coordinate, a candidate or the name of a prior is
        unknown.
    """
    robot = _robot(robot)
    check_measurements(data, "pkmodes.updating.read(path)")
    loads = check_measured(data, Model(robot))
    parameters, found, moves = suspects(robot, candidates, loads)
    if priors is not None:
        found = with_priors(robot, parameters, found, priors)
    return RobotStructure(robot, data.points, parameters, found, moves, loads)


def _robot(given: Robot | Model) -> Robot:
    """Return a robot, given as such or as a model."""
    if isinstance(given, Model):
        return given.robot
    if not isinstance(given, Robot):
        path = isinstance(given, str | PathLike)
        remedy = (
            f"read it: pkmodes.read_robot({shown(str(given))})" if path else "give what pkmodes.load returns"
        )
        raise PkmodesError(f"expected a robot or a model, found {shown(given)}", "robot", remedy)
    return given


def compare(robot: Robot | Model, data: Measurements) -> Comparison:
    """Compare predictions with measurements, without any fit.

    Parameters
    ----------
    robot : Robot or Model
        From `pkmodes.read_robot` or `pkmodes.load`.
    data : Measurements
        From `read`.

    Returns
    -------
    Comparison
        One row for each measured mode, in the order of the file.

    Raises
    ------
    PkmodesError
        If a pose cannot be reached, or a set value is refused.
    """
    return diagnosis.compare(structure(robot, data, candidates=()), data)


@one_blas_thread()
def diagnose(
    robot: Robot | Model,
    data: Measurements,
    *,
    candidates: Sequence[str] | None = None,
    holdout: Sequence[str] | None = None,
    priors: Mapping[str, float | str] | None = None,
    progress: Progress | None = None,
) -> Diagnosis:
    """Find what the model of a robot lacks.

    Parameters
    ----------
    robot : Robot or Model
        From `pkmodes.read_robot` or `pkmodes.load`.
    data : Measurements
        From `read`.
    candidates : sequence of str, optional
        Names of effects, ``parameter:<path>``, ``measurement:<what>``, or the words ``effects``, ``parameters`` and
        ``measurement``; by default all.
    holdout : sequence of str, optional
        Labels of held-out poses, used in no choice or fit; by default one in six.
    priors : mapping of str to float or str, optional
        Prior standard deviations of the parameters of candidates: numbers in SI units, or text with a unit,
        ``"1 mm"`` or ``"2 %"`` of the declared value.
    progress : callable, optional
        Called with a sentence at each step.

    Returns
    -------
    Diagnosis
        The verdict with its reason, the causes, and the error before and after; `save_robot` writes the corrected
        robot file.

    Raises
    ------
    PkmodesError
        If a pose cannot be reached, or a name is unknown.
    """
    suspected = structure(robot, data, candidates, priors)
    return diagnosis.diagnose(suspected, data, holdout=holdout, progress=progress)


@one_blas_thread()
def update(
    robot: Robot | Model,
    data: Measurements,
    parameters: Sequence[str] | None = None,
    *,
    holdout: Sequence[str] | None = None,
) -> Update:
    """Update the uncertain values of a robot together: a correction, not a cause.

    Parameters
    ----------
    robot : Robot or Model
        Its quantities with a sigma may change, with the sigma as a prior; `pkmodes.Robot.with_values` adds a sigma
        to others.
    data : Measurements
        From `read`.
    parameters : sequence of str, optional
        Dotted paths of those that may change; by default all with a sigma.
    holdout : sequence of str, optional
        Labels of held-out poses; by default one in six.

    Returns
    -------
    Update
        The values before and after, and the error before and after.

    Raises
    ------
    PkmodesError
        If a pose cannot be reached, a name is unknown, or a value has no sigma.
    """
    return diagnosis.update(structure(robot, data, candidates=()), data, parameters, holdout=holdout)


def corrections(robot: Robot, found: Diagnosis) -> Mapping[str, Correction]:
    """Return the changes of the robot file after a diagnosis: refitted values, causes, and their uncertainty."""
    causes = {v.name for finding in found.effects for v in finding.parameters}
    changes = {}
    for value in found.corrected:
        if value.name.startswith(frame.OF_MEASUREMENT):
            continue  # it concerns the measurements, not the robot
        note = "found by pkmodes diagnose" if value.name in causes else "refitted by pkmodes diagnose"
        if value.name in robot.quantities or not value.name.startswith("effects."):
            unit = "" if value.unit == "1" else f" {value.unit}"
            note = f"was {resolve(robot, value.name).value:.6g}{unit}: {note}"
        changes[value.name] = Correction(value.value, value.sigma, note)
    return changes


def corrected_robot(robot: Robot | Model, found: Diagnosis) -> str:
    """Return the text of the corrected robot file; comments and order of the original are kept.

    If a class has several causes, the first one, which names it, is written.

    Parameters
    ----------
    robot : Robot or Model
        The diagnosed robot, read from a file.
    found : Diagnosis
        From `diagnose`.

    Raises
    ------
    PkmodesError
        If there is nothing to correct, or the robot was not read from a file.
    """
    robot = _correctable(robot, found, "corrected_robot")
    return corrected_text(Path(robot.source), corrections(robot, found))


def save_robot(robot: Robot | Model, found: Diagnosis, target: str | Path) -> None:
    """Write the corrected robot file, as `corrected_robot` returns it.

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
    robot = _correctable(robot, found, str(target))
    save_corrected(Path(robot.source), Path(target), corrections(robot, found))


def _correctable(given: Robot | Model, found: Diagnosis, where: str) -> Robot:
    """Return a robot whose file a diagnosis corrects."""
    robot = _robot(given)
    if not VERDICTS[found.verdict].settled:
        raise PkmodesError(
            f"there is no corrected robot to save: the verdict is {found.verdict}",
            where,
            "leave out --save-robot, or measure more",
        )
    if not Path(robot.source).is_file():
        what = f"expected a robot read from a file, found {shown(robot.source)}"
        raise PkmodesError(
            what, "save_robot", "diagnose a robot read from a file, or write its values to one"
        )
    return robot
