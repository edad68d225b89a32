"""Compare, diagnose and update a robot with the modes measured on it."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import replace

import numpy as np
from msgspec import structs

from pkmodes.core.model import Model
from pkmodes.core.robot.robot import Robot
from pkmodes.core.support.threads import one_blas_thread
from pkmodes.loop import diagnosis
from pkmodes.loop.diagnosis.compare import Comparison
from pkmodes.loop.diagnosis.search.additions import Progress
from pkmodes.loop.diagnosis.states.changes import setups_by_state
from pkmodes.loop.diagnosis.update import Update
from pkmodes.loop.diagnosis.verdict.result import Diagnosis
from pkmodes.loop.measured.measurements import Measurements
from pkmodes.loop.updating.changes import changed
from pkmodes.loop.updating.measured_robot import MeasuredRobot

#: For a robot file whose values have the errors of an earlier fit.
REFITTED_NOTE = (
    "the robot file has values with the errors of an earlier fit ([[covariance]]): if that fit had these same "
    "measurements, they count twice, and the standard deviations after this one are too small, by up to a factor of "
    "1.4"
)


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
        One row for each measured mode, in the order of the file, with the damping where it was measured.

    Raises
    ------
    PkmodesError
        If a pose cannot be reached, or a set value is refused.
    """
    measured = MeasuredRobot.of(robot, data)
    result = diagnosis.compare(measured.structure(candidates=()), measured.data)
    data, loads, rows = measured.data, measured.loads, list(result.rows)
    with_damping = np.flatnonzero(~np.isnan(data.damping))
    for c, case in enumerate(loads.cases):
        case_rows = [int(i) for i in with_damping if loads.case_index[data.pose[i]] == c]
        if not case_rows:
            continue
        model, setups = Model(case.robot), sorted({int(data.pose[i]) for i in case_rows})
        modes = model.modes(data.points[setups], drives=case.drives, fields=["damping_ratios"])
        # Partners count the most rigid modes that any setup has.
        ratios, missing_rigid_modes = modes.damping_ratios, result.rigid - modes.rigid_modes
        for i in case_rows:
            partner = rows[i].partner
            rows[i] = structs.replace(
                rows[i],
                damping=float(data.damping[i]),
                sigma_damping=float(data.damping_sigma[i]),
                predicted_damping=None
                if partner is None
                else float(ratios[setups.index(int(data.pose[i])), partner - 1 - missing_rigid_modes]),
            )
    return replace(result, rows=tuple(rows))


@one_blas_thread()
def diagnose(
    robot: Robot | Model,
    data: Measurements,
    *,
    candidates: Sequence[str] | None = None,
    holdout: Sequence[str] | None = None,
    priors: Mapping[str, float | str] | None = None,
    progress: Progress | None = None,
    terms: bool = True,
    states: Mapping[str, str] | None = None,
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
        ``"1 mm"`` or ``"2 %"`` of the declared value; beside those of the measurements.
    progress : callable, optional
        Called with a sentence at each step.
    terms : bool, optional
        Whether one thing at one place, such as a mass on one body, is tried where the candidates do not explain the
        measurements.
    states : mapping of str to str, optional
        State of the machine at each pose, by label; the first one is trusted.  The result is then what changed, as
        by `changed`.

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
    if states is not None:
        measured_robot = MeasuredRobot.of(robot, data)
        (trusted, setups), later = setups_by_state(measured_robot.data, states)
        return changed(
            measured_robot.robot,
            data.at(setups),
            {name: data.at(setups_of_state) for name, setups_of_state in later.items()},
            candidates=candidates,
            holdout=holdout,
            priors=priors,
            progress=progress,
            terms=terms,
            name=trusted,
        )
    measured = MeasuredRobot.of(robot, data).where_usable()
    structure = measured.structure(candidates, priors)
    result = diagnosis.diagnose(structure, measured.data, holdout=holdout, progress=progress, terms=terms)
    if not measured.robot.covariance or not result.corrected:
        return result
    return replace(result, notes=(*result.notes, REFITTED_NOTE))


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
    measured = MeasuredRobot.of(robot, data)
    return diagnosis.update(measured.structure(candidates=()), measured.data, parameters, holdout=holdout)
