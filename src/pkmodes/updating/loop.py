"""Compare and diagnose a robot, and correct its file: the engine with a robot as its structure."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import replace
from os import PathLike
from pathlib import Path

from pkmodes import diagnosis
from pkmodes.diagnosis.arguments import check_measurements
from pkmodes.diagnosis.compare import Comparison
from pkmodes.diagnosis.search.additions import Progress
from pkmodes.diagnosis.update import Update
from pkmodes.diagnosis.verdict.result import Diagnosis
from pkmodes.errors import MeasurementError, PkmodesError, shown
from pkmodes.measured.measurements import Measurements
from pkmodes.measured.reading import read_measurements
from pkmodes.mechanism import Mechanism, mechanism, names
from pkmodes.model import Model
from pkmodes.robot.paths import resolve
from pkmodes.robot.robot import Robot
from pkmodes.robot.saving import Correction, save_corrected
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
        Lowest and highest frequency that was looked for [Hz], where the file does not say so.
    robot : Robot or Model, optional
        Its mechanism says which columns there may be; without one, those of any mechanism.

    Raises
    ------
    MeasurementError
        If anything in the file is wrong, it states another band, or a row lies outside the band.
    """
    if not isinstance(path, str | PathLike):
        raise PkmodesError(f"expected a path, found {shown(path)}", "read", "give the name of a CSV file")
    of = None if robot is None else _robot(robot)
    kinds = [mechanism(name) for name in names()] if of is None else [of.kind]
    found = read_measurements(
        path,
        {name: unit for kind in kinds for name, unit in channels(kind).items()},
        components=[_components(kind) for kind in kinds],
        settings={name: unit for kind in kinds for name, unit in settable(kind, of).items()},
    )
    if band is None:
        return found
    if found.band not in (None, band):
        stated = f"{found.band[0]:g} Hz to {found.band[1]:g} Hz"
        what = f"the file states the band {stated}, not {band[0]:g} Hz to {band[1]:g} Hz"
        raise MeasurementError(what, found.source, "leave the band out, or correct the file")
    return replace(found, band=band)


def _components(kind: Mechanism) -> dict[str, str]:
    """Components of a pose and their units: columns of a measurement file."""
    return {component.name: component.unit for component in kind.pose}


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
        If a pose cannot be reached, a value that is set is refused, or a coordinate, a candidate or the name of a
        prior is unknown.
    """
    robot = _robot(robot)
    check_measurements(data, "pkmodes.updating.read(path)")
    loads = check_measured(data, Model(robot))
    parameters, found, moves = suspects(robot, candidates, loads)
    if priors is not None:
        found = with_priors(robot, parameters, found, priors)
    return RobotStructure(robot, data.points, parameters, found, moves, loads)


def _robot(given: Robot | Model) -> Robot:
    """A robot, or that of a model."""
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
    """Prediction beside measurement.

    Parameters
    ----------
    robot : Robot or Model
        From `pkmodes.read_robot` or `pkmodes.load`.
    data : Measurements
        From `read`.
    """
    return diagnosis.compare(structure(robot, data, candidates=()), data)


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
        Labels of poses that take no part in any choice or fit; by default one in six.
    priors : mapping of str to float or str, optional
        How far the parameters of candidates may plausibly be from their values, as standard deviations: numbers in
        SI units, or text with a unit, ``"1 mm"`` or ``"2 %"`` of the declared value.
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
    suspected = structure(robot, data, candidates, priors)
    return diagnosis.diagnose(suspected, data, holdout=holdout, progress=progress)


def update(
    robot: Robot | Model,
    data: Measurements,
    parameters: Sequence[str] | None = None,
    *,
    holdout: Sequence[str] | None = None,
) -> Update:
    """Update the uncertain values of a robot together: a correction, and no cause.

    Parameters
    ----------
    robot : Robot or Model
        Its quantities with a sigma may change, as far as that says; `Robot.with_values` gives more of them one.
    data : Measurements
        From `read`.
    parameters : sequence of str, optional
        Dotted paths of those that may; by default all with a sigma.
    holdout : sequence of str, optional
        Labels of poses that take no part; by default one in six.

    Raises
    ------
    PkmodesError
        If a pose cannot be reached, a name is unknown, or a value has no sigma.
    """
    return diagnosis.update(structure(robot, data, candidates=()), data, parameters, holdout=holdout)


def corrections(robot: Robot, found: Diagnosis) -> Mapping[str, Correction]:
    """Changes of the robot file that a diagnosis asks for: refitted values, causes, and their uncertainty."""
    causes = {v.name for finding in found.effects for v in finding.parameters}
    changes = {}
    for value in found.corrected:
        if value.name.startswith(frame.OF_MEASUREMENT):
            continue  # a matter of the measurements: the robot is as it was
        note = "found by pkmodes diagnose" if value.name in causes else "refitted by pkmodes diagnose"
        if value.name in robot.quantities or not value.name.startswith("effects."):
            unit = "" if value.unit == "1" else f" {value.unit}"
            note = f"was {resolve(robot, value.name).value:.6g}{unit}: {note}"
        changes[value.name] = Correction(value.value, value.sigma, note)
    return changes


def save_robot(robot: Robot | Model, found: Diagnosis, target: str | Path) -> None:
    """Write the corrected robot, with comments and order of the original kept.

    Of a class of several causes the first, which names it, is written.

    Raises
    ------
    PkmodesError
        If there is nothing to correct, or the file cannot be written.
    """
    robot = _robot(robot)
    if not found.effects and found.verdict != "adequate":
        raise PkmodesError(
            f"there is no corrected robot to save: the verdict is {found.verdict}",
            str(target),
            "leave out --save-robot, or measure more",
        )
    if not Path(robot.source).is_file():
        what = f"expected a robot as a file has it, found {shown(robot.source)}"
        raise PkmodesError(what, "save_robot", "diagnose the robot of a file, or write its values into one")
    save_corrected(Path(robot.source), Path(target), corrections(robot, found))
