"""Parameters and candidate causes of a robot: its nuisances, the catalogue of effects, and suspected values.

A declared value with a standard deviation is a nuisance, a value without one may be suspected, and a value with a
standard deviation of 0 is known.  The elements of a parameter group (``axis.span``) are suspected together, under the
path of the group.

Candidates that concern one of several equal parts are remote: a value of one axis if the file gives one for all axes,
and a compliance of the catalogue in a single joint, which has no name in the catalogue.  A compliance with a separate
value in each joint is no candidate: it is the general form against which the shared compliance is tested.  An effect
that a file may declare joint by joint, such as a frame by direction, has a named candidate for each joint.
"""

from __future__ import annotations

from collections.abc import Iterable, Mapping, Sequence
from dataclasses import replace

import numpy as np

from pkmodes.core.base.errors import PkmodesError, nearest_name, shown
from pkmodes.core.robot.layout import GRAVITY, Item, items_by_path, overrides_by_path, table_sources
from pkmodes.core.robot.parameter_groups import group_items, group_weights, groups_by_path
from pkmodes.core.robot.robot import Robot
from pkmodes.core.robot.units import with_unit
from pkmodes.core.support.covariance import Prior, priors_of
from pkmodes.core.support.words import meaning_of
from pkmodes.loop.diagnosis.problem import Assumption, Candidate, Parameter
from pkmodes.loop.sensitivity.paths import ParameterPath, paths, resolve
from pkmodes.loop.updating import frame
from pkmodes.loop.updating.joints import joints_of
from pkmodes.loop.updating.kinds import with_kinds
from pkmodes.loop.updating.load_cases import LoadCases
from pkmodes.loop.updating.usual import plausible_range, plausible_relative_change
from pkmodes_description import Effect, EffectParameter, ParameterGroup

#: Prefix of suspected values as candidates.
PREFIX = "parameter:"
#: Prefix of the paths of effects; effects as candidates have their bare names.
EFFECTS = "effects."
#: A suspected value is searched for between a third and three times the declared one: beyond that, the robot file
#: describes another machine.
SEARCH_FACTOR = 3.0


def suspects(
    robot: Robot, chosen: Sequence[str] | None = None, loads: LoadCases | None = None
) -> tuple[list[Parameter], list[Candidate], dict[str, ParameterPath]]:
    """Return the parameters of the diagnosis, its candidates, and the path of each parameter of the robot.

    - chosen: names of candidates: effects, ``parameter:<path>``, ``measurement:<what>``, or the words ``effects``,
      ``parameters`` and ``measurement`` for all of a kind.  By default all effects, every value that may be
      suspected, and the frame of the measurement.
    - loads: values set by the measurements: an effect whose constant is set becomes a candidate, and a value set at
      every pose is known

    Raises PkmodesError if a name is unknown.
    """
    loads = LoadCases.as_declared(robot, 0) if loads is None else loads
    nuisances = [path for path in _varying_values(robot) if robot.quantities[path].sigma]
    candidates = _chosen_candidates(robot, chosen, loads)
    if chosen is None:
        candidates += _single_entry_candidates(robot)
    candidates = _with_assumptions(robot, candidates, loads)
    candidates += _with_another_constant(robot, candidates)
    frame_parameters, frame_candidates = frame.suspects(robot.mechanism)
    robot_parameters = [
        name for candidate in candidates if candidate not in frame_candidates for name in candidate.parameters
    ]
    parameter_paths = [resolve(robot, name) for name in dict.fromkeys([*nuisances, *robot_parameters])]
    joints = _joints(robot) if candidates else {}
    if loads.settings:
        set_paths = {path.path for path in parameter_paths if loads.is_always_set(path)}
        parameter_paths = [path for path in parameter_paths if path.path not in set_paths]
        joints = {name: path for name, path in joints.items() if not loads.is_always_set(path)}
        candidates = _without_set_values(candidates, set_paths, chosen or ())
    parameter_paths += joints.values()
    released_names = {name for candidate in candidates for name in _single_joints_of(robot, candidate)}
    candidates += [
        Candidate(name, (path.path,), f"{name} yields", remote=True, nameable=False)
        for name, path in joints.items()
        if name not in released_names
    ]
    candidates += _general_forms(robot, candidates, joints)
    frame_names = {
        name for candidate in candidates if candidate in frame_candidates for name in candidate.parameters
    }
    priors = priors_of(robot)
    parameters = [_parameter(robot, path, priors.get(path.path, Prior())) for path in parameter_paths]
    parameters += [parameter for parameter in frame_parameters if parameter.name in frame_names]
    return parameters, with_kinds(candidates, robot.mechanism), {path.path: path for path in parameter_paths}


def _without_set_values(
    candidates: Sequence[Candidate], set_paths: set[str], chosen: Sequence[str]
) -> list[Candidate]:
    """Return the candidates without the parameters that the measurements set at every pose."""
    remaining_candidates = []
    for candidate in candidates:
        remaining = tuple(name for name in candidate.parameters if name not in set_paths)
        if not remaining and candidate.name in chosen:
            names, single = " and ".join(candidate.parameters), len(candidate.parameters) == 1
            is_known, it = ("is known", "it") if single else ("are known", "them")
            problem = f"{names} {is_known}: the measurements set {it} at every pose"
            raise PkmodesError(problem, "candidates", f"leave {candidate.name} out")
        if remaining == candidate.parameters or (remaining and not candidate.remote):
            joints = tuple(joint for joint in candidate.joints if joint.parameter in remaining)
            remaining_candidates.append(replace(candidate, parameters=remaining, joints=joints))
    return remaining_candidates


def _chosen_candidates(robot: Robot, chosen: Sequence[str] | None, loads: LoadCases) -> list[Candidate]:
    kinds = {
        "effects": _suspected_effects(robot, loads),
        "parameters": _suspected_values(robot),
        "measurement": {candidate.name: candidate for candidate in frame.suspects(robot.mechanism)[1]},
    }
    available = {name: candidate for kind in kinds.values() for name, candidate in kind.items()}
    if chosen is None:
        return list(available.values())
    if isinstance(chosen, str):
        problem = f"expected a list of names, found {shown(chosen)}"
        raise PkmodesError(problem, "candidates", f"write [{shown(chosen)}]")
    candidates: dict[str, Candidate] = {}
    for name in chosen:
        if name in kinds:
            candidates |= kinds[name]
        elif name in available:
            candidates[name] = available[name]
        else:
            candidates[name] = _requested_candidate(robot, name, [*available])
    return list(candidates.values())


def _with_assumptions(robot: Robot, candidates: Sequence[Candidate], loads: LoadCases) -> list[Candidate]:
    """Return candidates with the default values that their effects assume if the file states none."""
    assumed: dict[str, list[Assumption]] = {}
    for borrowed, lender in table_sources(robot.mechanism).items():
        default, path = items_by_path(robot.mechanism)[lender].key.default, resolve(robot, borrowed)
        if default and not {lender, borrowed} & robot.quantities.keys() and not loads.is_always_set(path):
            words = f"a {lender} of {with_unit(default, path.unit)}"
            for name in robot.mechanism.effects[borrowed.split(".")[1]].forms:
                assumed.setdefault(name, []).append(Assumption(borrowed, lender, words))
    return [replace(candidate, assumes=tuple(assumed.get(candidate.name, ()))) for candidate in candidates]


def _with_another_constant(robot: Robot, candidates: Sequence[Candidate]) -> list[Candidate]:
    """Return effects combined with a wrong constant, such as the mass of a moving frame: alone they would not fit."""
    with_constants = []
    for borrowed, lender in table_sources(robot.mechanism).items():
        _, name, constant = borrowed.split(".")
        declared = robot.quantities.get(lender)
        if declared is not None and declared.sigma is not None:
            continue
        forms = robot.mechanism.effects[name].forms
        for candidate in (candidate for candidate in candidates if candidate.name in forms):
            sentence = f"{candidate.sentence}, and its {constant} differs from the declared one"
            with_constants.append(
                Candidate(
                    f"{candidate.name} with another {lender}",
                    (*candidate.parameters, borrowed),
                    sentence,
                    remote=True,
                    nameable=False,
                )
            )
    return with_constants


def _varying_values(robot: Robot) -> list[str]:
    """Return the declared values on which the robot depends, without shared ones that every entry overrides."""
    varying = set(paths(robot))
    varying -= {
        borrowed for borrowed, lender in table_sources(robot.mechanism).items() if lender in robot.quantities
    }
    return [path for path in robot.quantities if path in varying]


def _requested_candidate(robot: Robot, name: str, available: list[str]) -> Candidate:
    """Return a candidate that is not suspected by default, such as a value of one axis."""
    path = name.removeprefix(PREFIX)
    effects = robot.mechanism.effects
    effect = name.removeprefix(EFFECTS).partition(".")[0]
    if effect in effects and name in effects[effect].forms:
        form = effects[effect].forms[name]
        refuse_declared(f"the effect {name}", _sigmas(robot, _parameter_paths(effects[effect], form)))
        excluding = " and ".join(p for p in _excluded_paths(effects[effect], form) if p in robot.quantities)
        if excluding:
            problem = f"{name} is not suspected: the robot file declares {excluding} in its place"
            raise PkmodesError(problem, "candidates", f"leave {name} out, or remove {excluding}")
    if name.startswith(EFFECTS) and effect in effects:
        raise PkmodesError(f"unknown candidate {shown(name)}", "candidates", f'did you mean "{effect}"?')
    if name == path or path not in paths(robot):
        losses = [effect.name for effect in effects.values() if effect.dissipates]
        suggestions = [*available, *losses, *(f"{PREFIX}{p}" for p in paths(robot))]
        remedy = nearest_name(name, suggestions, "use the names in docs/explanation/diagnosis.md")
        raise PkmodesError(f"unknown candidate {shown(name)}", "candidates", remedy)
    group, item = groups_by_path(robot.mechanism).get(path), items_by_path(robot.mechanism).get(path)
    refuse_declared(
        path, _sigmas(robot, [path, *(_element_paths(robot, group) if group is not None else ())])
    )
    shared = item.shared if item is not None else ""
    if (
        path not in robot.quantities
        and shared in robot.quantities
        and robot.quantities[shared].sigma is not None
    ):
        state = "refitted for all together" if robot.quantities[shared].sigma else "known exactly"
        raise PkmodesError(
            f"{shared} is {state}: the robot file gives a sigma",
            "candidates",
            f"to suspect {path}, declare it in the robot file without a sigma",
        )
    resolve(robot, path)
    return Candidate(name, (path,), _wrong_value_sentence(robot, path))


def _sigmas(robot: Robot, declared: Sequence[str]) -> list[float | None]:
    """Return the standard deviations of those values that the robot file gives."""
    return [quantity.sigma for path in declared if (quantity := robot.quantities.get(path)) is not None]


def refuse_declared(subject: str, sigmas: Sequence[float | None]) -> None:
    """Refuse a candidate that has a value with a standard deviation.

    Raises PkmodesError.
    """
    stated = [sigma for sigma in sigmas if sigma is not None]
    if stated:
        state = "refitted already" if any(stated) else "known exactly"
        raise PkmodesError(
            f"{subject} is {state}: the robot file gives a sigma",
            "candidates",
            "leave it out, or remove the sigma",
        )


def _element_paths(robot: Robot, group: ParameterGroup) -> list[str]:
    """Return the paths of the elements of a whole."""
    return [number.path for item in group_items(robot.mechanism, group) for number in item.numbers]


def _parameter_paths(effect: Effect, parameters: Iterable[EffectParameter]) -> list[str]:
    return [f"{EFFECTS}{effect.name}.{p.name}" for p in parameters]


def _excluded_paths(effect: Effect, form: Iterable[EffectParameter]) -> list[str]:
    """Return the paths that a robot file cannot have together with some parameters."""
    return [path for p in form for path in _parameter_paths(effect, effect.excluded(p.name))]


def _single_joints_of(robot: Robot, candidate: Candidate) -> list[str]:
    """Return the single joints that a candidate of the catalogue releases, by the names of their own candidates."""
    effect = robot.mechanism.effects.get(candidate.name.partition(".")[0])
    form = () if effect is None or candidate.name == effect.name else effect.forms.get(candidate.name, ())
    return [_joint_name(effect.name, name) for p in form for name in p.releases] if effect is not None else []


def _suspected_effects(robot: Robot, loads: LoadCases) -> dict[str, Candidate]:
    """Return the effects that the file does not declare, or declares without a standard deviation."""
    candidates = {}
    robots = (robot, *(case.robot for case in loads.cases))
    values_of = [{**variant.constants, **variant.effects} for variant in robots]
    nonzero = {path for values in values_of for path, value in values.items() if value}
    for effect in robot.mechanism.conservative_effects.values():
        # A parameter has no effect if the constant that multiplies it, such as a tension, is given nowhere.
        constants = [p.name for p in effect.parameters if not p.fitted and p.greater_than is not None]
        absent = [name for name in constants if f"{effect.name}.{name}" not in nonzero]
        for name, form in effect.forms.items():
            paths = _parameter_paths(effect, form)
            suspected = all(sigma is None for sigma in _sigmas(robot, paths))
            declared = any(path in robot.quantities for path in _excluded_paths(effect, form))
            if suspected and not absent and not declared:
                effect_name = "" if name == effect.name else effect.name
                sentence = effect.sentence if not effect_name else f"{effect.sentence}: {form[0].description}"
                joints = joints_of(robot.mechanism, paths, form, PREFIX)
                candidates[name] = Candidate(name, tuple(paths), sentence, part_of=effect_name, joints=joints)
    return candidates


def _suspected_values(robot: Robot) -> dict[str, Candidate]:
    """Return the candidates of values without a standard deviation; groups in place of their elements."""
    element_paths = {
        element for group in robot.mechanism.parameter_groups for element in _element_paths(robot, group)
    }
    suspected, item_at = [], items_by_path(robot.mechanism)
    for path in _varying_values(robot):
        item, quantity = item_at.get(path), robot.quantities[path]
        if item is None or not item.key.suspected or quantity.sigma is not None or path in element_paths:
            continue
        if item.key is not GRAVITY or quantity.value != 0.0:  # a gravity component of 0 is exact
            suspected.append(path)
    for group in robot.mechanism.parameter_groups:
        is_free = all(robot.quantities[element].sigma is None for element in _element_paths(robot, group))
        if is_free and group_weights(robot, group):
            suspected.append(group.path)
    is_local = {path: any(part.isdigit() for part in path.split(".")) for path in suspected}
    candidates = [
        Candidate(f"{PREFIX}{path}", (path,), _wrong_value_sentence(robot, path), local=is_local[path])
        for path in suspected
    ]
    return {candidate.name: candidate for candidate in candidates}


def _wrong_value_sentence(robot: Robot, path: str) -> str:
    """Return the sentence of a suspected value, in the words of the mechanism's description."""
    words = meaning_of(robot.mechanism, path).partition(",")[0]
    return f"the declared {words or f'value of {path}'} is wrong"


def _single_entry_candidates(robot: Robot) -> list[Candidate]:
    """Return the values of single axes for which the file gives one shared value without a sigma."""
    candidates, all_paths = [], paths(robot)
    for path in all_paths:
        item = items_by_path(robot.mechanism).get(path)
        if item is not None and item.shared in all_paths and path not in robot.quantities:
            following = [
                taker
                for taker in overrides_by_path(robot.mechanism)[item.shared]
                if taker.path not in robot.quantities
            ]
            if robot.quantities[item.shared].sigma is None and len(following) > 1:
                sentence = f"the value of {path} differs from that of the other axes"
                candidates.append(Candidate(f"{PREFIX}{path}", (path,), sentence, remote=True))
    return candidates


def _joints(robot: Robot) -> dict[str, ParameterPath]:
    """Return compliances in single joints; those of the catalogue are in all joints of their kind."""
    joints = {}
    for effect in robot.mechanism.effects.values():
        name, unit = f"{effect.name}.{effect.parameters[0].name}", effect.parameters[0].unit
        for q in effect.coordinates if len(effect.coordinates) > 1 else ():
            releasing = _parameter_paths(effect, (p for p in effect.parameters if q.name in p.releases))
            if 0.0 in _sigmas(robot, releasing):  # known exactly
                continue
            slot = (f"{name}.{q.name}", ())
            path = ParameterPath(f"{EFFECTS}{name}.{q.name}", 0.0, unit, {slot: 1.0})
            joints[_joint_name(effect.name, q.name)] = path
    return joints


def _joint_name(effect: str, coordinate: str) -> str:
    return f"{effect} of {coordinate} alone"


def _general_forms(
    robot: Robot, candidates: Sequence[Candidate], joints: Mapping[str, ParameterPath]
) -> list[Candidate]:
    """Return the general forms of candidate compliances, with a separate value in each joint."""
    general = []
    effects = robot.mechanism.effects
    for name in [candidate.name for candidate in candidates if candidate.name in effects]:
        released = [
            joint for q in effects[name].coordinates if (joint := _joint_name(name, q.name)) in joints
        ]
        if len(released) > 1:
            parameters = tuple(joints[joint].path for joint in released)
            general_name = f"{name} with a separate value in each joint"
            general.append(Candidate(general_name, parameters, general_of=name))
    return general


def _parameter(robot: Robot, path: ParameterPath, prior: Prior) -> Parameter:
    sigma = prior.sigma
    item = items_by_path(robot.mechanism).get(path.path)
    lower, upper = -np.inf, np.inf
    value_range = None
    if path.path.startswith(EFFECTS):
        _, effect, name, *_ = path.path.split(".")
        lower_limit = next(
            p.greater_than for p in robot.mechanism.effects[effect].parameters if p.name == name
        )
        lower = -np.inf if lower_limit is None else lower_limit
        if sigma is None and lower == -1.0 and path.unit == "1":
            value_range = plausible_relative_change(path.value)
    elif item is None or not item.key.signed:
        lower = 0.0
        if sigma is None and path.value > 0.0:
            lower, upper = path.value / SEARCH_FACTOR, path.value * SEARCH_FACTOR
    elif sigma is None:
        # The largest plausible deviation of an element is that of a vector that is wrong by a factor of three.
        largest_deviation = (SEARCH_FACTOR - 1.0) * _largest_element(robot, item) or np.inf
        lower, upper = path.value - largest_deviation, path.value + largest_deviation
    unit = path.unit.replace(" ", "*")
    if sigma is None and not path.path.startswith(EFFECTS):
        value_range = plausible_range(
            item, path.value, path.unit, 0.0 if item is None else _largest_element(robot, item)
        )
    return Parameter(
        path.path, path.value, unit, sigma, lower, upper, usual=value_range, correlated=prior.correlated
    )


def _largest_element(robot: Robot, item: Item) -> float:
    """Return the largest element of a vector."""
    elements = [robot.quantities[n.path].value for n in item.numbers if n.path in robot.quantities]
    return max(map(abs, elements), default=0.0)
