"""Changes of a robot between campaigns of modal measurements, of which the first is trusted."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping, Sequence
from dataclasses import replace
from functools import partial

import numpy as np

from pkmodes.core.base.errors import MeasurementError, PkmodesError, shown
from pkmodes.core.model import Model
from pkmodes.core.robot.layout import Slot
from pkmodes.core.robot.robot import Robot
from pkmodes.core.support.threads import one_blas_thread
from pkmodes.loop.diagnosis.fit.hypothesis import parallel_parameters
from pkmodes.loop.diagnosis.problem import Candidate, Parameter, Structure
from pkmodes.loop.diagnosis.search.additions import Progress
from pkmodes.loop.diagnosis.states.changes import TrustedState, with_known_values
from pkmodes.loop.diagnosis.states.result import Change, merge_changes
from pkmodes.loop.diagnosis.states.words import candidate_as_change
from pkmodes.loop.diagnosis.verdict.verdicts import AMBIGUOUS
from pkmodes.loop.measured.measurements import Measurements
from pkmodes.loop.sensitivity.paths import ParameterPath, resolve
from pkmodes.loop.updating.candidates import EFFECTS, PREFIX
from pkmodes.loop.updating.joints import joints_of
from pkmodes.loop.updating.measured_robot import MeasuredRobot
from pkmodes.loop.updating.robot_structure import RobotStructure
from pkmodes.loop.updating.shared_values import axis_deviations, changes_in_use, with_prior_of_one_machine

#: Default names of the states; several later ones are numbered.
BEFORE, AFTER = "before", "after"
#: Standard deviation of the relative change of stiffness from day to day, as with temperature, shared by all
#: transmissions of a kind.
DAY_TO_DAY_SIGMA = 0.015
#: Odds of an exchanged or moved part relative to a change in use.
EXCHANGE_ODDS = 0.1
#: The stiffness of the equal parts of a transmission.
STIFFNESS = "stiffness"


@one_blas_thread()
def changed(
    model: Robot | Model,
    trusted: Measurements,
    later: Measurements | Mapping[str, Measurements] | Sequence[Measurements],
    *,
    candidates: Sequence[str] | None = None,
    holdout: Sequence[str] | None = None,
    priors: Mapping[str, float | str] | None = None,
    progress: Progress | None = None,
    terms: bool = True,
    name: str = "",
) -> Change:
    """Find what changed on a robot since a trusted campaign.

    Uncertain values of the robot are fitted to the trusted campaign, and the error that the model then has there is
    subtracted from the later one: differences are compared with differences.  The stiffness that all belts, legs or
    reducers share may differ by 1.5 % from one day to another.

    Parameters
    ----------
    model : Robot or Model
        From `pkmodes.read_robot` or `pkmodes.load`.
    trusted : Measurements
        From `read`.
    later : Measurements, sequence or mapping of these
        One campaign, or several, each compared with the trusted one.  The keys of a mapping name the states.
    candidates : sequence of str, optional
        What may have changed, as in `diagnose`; by default everything.
    holdout : sequence of str, optional
        Labels of held-out poses of the later campaigns; by default one in six.
    priors : mapping of str to float or str, optional
        As in `diagnose`.
    progress : callable, optional
        Called with a sentence at each step.
    terms : bool, optional
        Whether one thing at one place is tried where the candidates do not explain the difference.
    name : str, optional
        Name of the trusted state, if its measurements name none.

    Returns
    -------
    Change
        A diagnosis of the difference, with ``states``, and ``changed``: True, False, or None where the data do not
        tell.

    Raises
    ------
    PkmodesError
        If a pose cannot be reached, a name is unknown, or the campaigns have no mode in common, the same rows, or
        motors in different states.
    """
    names, campaigns = _named_campaigns(trusted, later, name)
    first = MeasuredRobot.of(model, trusted)
    deviations = axis_deviations(first.robot)
    trusted_state = TrustedState.of(
        names[0], _with_parameters(first.structure(candidates=()), deviations), trusted
    )
    values = trusted_state.values
    # No value of the baseline is uncertain: any may have changed.
    uncertain = {path for path, quantity in first.robot.quantities.items() if quantity.sigma}
    without_sigma = {path: {"sigma": None} for path in uncertain - values.keys()}
    fitted = {path: {"value": values[path], "sigma": None} for path in uncertain & values.keys()}
    baseline = first.robot.with_values({**without_sigma, **fitted})
    changes = {}
    for name, data in zip(names[1:], campaigns, strict=True):
        measured = MeasuredRobot.of(baseline, data).where_usable()
        if progress is not None and len(campaigns) > 1:
            progress(f"comparing {name} with {names[0]}")
        measured_structure = _with_parameters(measured.structure(candidates, priors), deviations)
        # Values of the trusted state that are in no candidate.
        in_candidates = {p.name for p in measured_structure.parameters}
        missing_paths = {path: resolve(baseline, path) for path in values if path not in in_candidates}
        parameters = [Parameter(name, path.value, path.unit) for name, path in missing_paths.items()]
        structure = with_known_values(
            _with_parameters(measured_structure, (parameters, missing_paths)), values
        )
        diagnose_change = partial(
            trusted_state.diagnose_change,
            name,
            data=measured.data,
            holdout=None
            if holdout is None
            else [label for label in holdout if label in measured.data.labels],
            progress=progress,
            terms=terms,
        )
        changes[name] = _explained_change(
            diagnose_change, _with_daily_variation(structure), everything=candidates is not None
        )
    return merge_changes(names[0], changes)


def _explained_change(
    diagnose_change: Callable[[Structure], Change], structure: RobotStructure, *, everything: bool
) -> Change:
    """Return what changed: something that changes in use, or a part that was exchanged or moved.

    A change of such a part is less likely: it is named only in a class of explanations, or if nothing else explains.
    """
    robot = structure.robot
    candidates_in_use = [
        with_prior_of_one_machine(candidate)
        for candidate in structure.candidates
        if everything or changes_in_use(robot, candidate)
    ]
    first = diagnose_change(structure.extended([], {}, candidates_in_use))
    settled = first.changed is False or first.verdict == AMBIGUOUS.word
    if everything or (settled and not first.explained):
        return first
    exchanges = list(exchange_candidates(structure))
    second = diagnose_change(structure.extended([], {}, [*candidates_in_use, *exchanges]))
    if not second.claimed & {part.name for part in exchanges}:
        return first
    if first.explained:
        return second
    note = "nothing that changes in use explains this: only a part that was exchanged or moved does"
    return replace(second, notes=(note, *second.notes))


def exchange_candidates(structure: RobotStructure) -> Iterator[Candidate]:
    """Yield the candidates that need an exchanged or moved part, except those that act like a change in use."""
    robot = structure.robot
    single = [candidate for candidate in structure.candidates if len(candidate.parameters) == 1]
    indices = {p.name: i for i, p in enumerate(structure.parameters)}
    values = np.array([p.value for p in structure.parameters])
    rates = structure.predict(values, [indices[candidate.parameters[0]] for candidate in single]).rates
    is_in_use = np.array([changes_in_use(robot, candidate) for candidate in single])
    equivalent_names = {
        single[i].name for i in np.flatnonzero(parallel_parameters(rates)[:, is_in_use].any(axis=1))
    }
    for candidate in structure.candidates:
        if not changes_in_use(robot, candidate) and candidate.name not in equivalent_names:
            yield replace(with_prior_of_one_machine(candidate), odds=EXCHANGE_ODDS)


def _with_parameters(
    structure: RobotStructure, additions: tuple[Sequence[Parameter], Mapping[str, ParameterPath]]
) -> RobotStructure:
    """Return a structure with further parameters and their paths, and the same candidates."""
    return structure.extended(*additions, structure.candidates)


def _named_campaigns(
    trusted: Measurements,
    later: Measurements | Mapping[str, Measurements] | Sequence[Measurements],
    trusted_name: str,
) -> tuple[list[str], list[Measurements]]:
    """Return the names of the states, the trusted one first, and the later campaigns."""
    if isinstance(later, Measurements):
        later = [later]
    if not isinstance(later, Mapping | Sequence) or isinstance(later, str) or not later:
        problem = f"expected measurements, found {shown(later)}"
        raise PkmodesError(problem, "later", "give those of one state, or a list or mapping of several")
    data = list(later.values()) if isinstance(later, Mapping) else list(later)
    for argument, measurements in {
        "trusted": trusted,
        **{f"later {i + 1}": campaign_data for i, campaign_data in enumerate(data)},
    }.items():
        if not isinstance(measurements, Measurements):
            problem = f"expected measurements, found {shown(measurements)}"
            raise PkmodesError(problem, argument, "read them with pkmodes.loop.updating.read(path)")
    first = trusted_name or trusted.state or BEFORE
    if isinstance(later, Mapping):
        names = list(map(str, later))
    else:
        single_names = [campaign.state or AFTER for campaign in data]
        numbered_names = [campaign.state or f"{AFTER} {i + 1}" for i, campaign in enumerate(data)]
        names = single_names if len(data) == 1 else numbered_names
    for i, name in enumerate(names):
        if name in (first, *names[:i]):
            problem = f"two states are called {shown(name)}"
            raise MeasurementError(problem, data[i].source, "give each state another name")
    return [first, *names], data


def _with_daily_variation(structure: RobotStructure) -> RobotStructure:
    """Return a structure in which all transmissions of a kind may differ by the day-to-day variation."""
    mechanism, common_paths = structure.robot.mechanism, dict[str, ParameterPath]()
    for effect in mechanism.conservative_effects.values():
        names = [f"{EFFECTS}{effect.name}.{p.name}" for p in effect.parameters]
        joints = joints_of(mechanism, names, effect.parameters, PREFIX)
        if not joints or joints[0].quantity.split()[-1] != STIFFNESS:
            continue
        part_name = joints[0].words.rpartition(" ")[0]
        name = f"day.{part_name.replace(' ', '_')}_{STIFFNESS}"
        slots: dict[Slot, float] = {(path.removeprefix(EFFECTS), ()): 1.0 for path in names}
        common_paths[name] = ParameterPath(name, 0.0, "1", slots)
    parameters = [Parameter(name, 0.0, "1", DAY_TO_DAY_SIGMA, lower=-0.5, upper=1.0) for name in common_paths]
    return structure.extended(
        parameters, common_paths, [candidate_as_change(candidate) for candidate in structure.candidates]
    )
