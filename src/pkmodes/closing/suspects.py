"""Parameters and candidate causes of a robot: its nuisances, the catalogue of effects, and suspected values.

A declared value with a standard deviation is a nuisance, one without may be suspected, and one with a standard
deviation of 0 is known.  Limits and platform joints are suspected as wholes, under ``axis.span`` and
``axis.joint_radius``.

What concerns a single axis is remote: a value of one axis where the file gives one for all, and, outside the
catalogue, a compliance of the catalogue in one joint alone, which has no name there.  A compliance of the catalogue
with another value in each joint is no candidate either, but stands against the one that they share.
"""

from __future__ import annotations

import difflib
import re
from collections.abc import Mapping, Sequence

import numpy as np

from pkmodes.closing import frame
from pkmodes.diagnosis.problem import Candidate, Parameter
from pkmodes.errors import PkmodesError, shown
from pkmodes.mechanism import mechanism
from pkmodes.robot.effects import CATALOGUE, Effect
from pkmodes.robot.robot import Robot
from pkmodes.sensitivity.paths import ParameterPath, paths, resolve

#: How a suspected value is called as a candidate.
PREFIX = "parameter:"
#: How paths of effects begin; as candidates they go by their names alone.
EFFECTS = "effects."
#: A suspected value is looked for between a third and three times what is declared: beyond that the robot file
#: describes another machine.
FACTOR = 3.0
#: Quantities that are suspected as wholes, and the vectors that they stand for.
WHOLES = {"axis.span": "limits", "axis.joint_radius": "joint"}
#: Quantities that may have either sign, or be zero.
SIGNED = ("gravity.", ".origin.", ".joint.", ".limits.")


def suspects(
    robot: Robot, chosen: Sequence[str] | None = None
) -> tuple[list[Parameter], list[Candidate], dict[str, ParameterPath]]:
    """Parameters of the diagnosis, its candidates, and what moves each parameter of the robot.

    Parameters
    ----------
    robot : Robot
    chosen : sequence of str, optional
        Names of candidates: effects, ``parameter:<path>``, ``measurement:<what>``, or the words ``effects``,
        ``parameters`` and ``measurement`` for all of a kind.  By default all effects, every value that may be
        suspected, and the frame of the measurement.

    Raises
    ------
    PkmodesError
        If a name is unknown.
    """
    nuisances = [path for path in _varying(robot) if robot.quantities[path].sigma]
    candidates = _chosen(robot, chosen)
    if chosen is None:
        candidates += _of_one_axis(robot)
    candidates += _with_another_frame(robot, candidates)
    of_frame, frames = frame.suspects(mechanism(robot.mechanism))
    of_robot = [name for candidate in candidates if candidate not in frames for name in candidate.parameters]
    names = dict.fromkeys([*nuisances, *of_robot])
    joints = _joints(robot) if candidates else {}
    moves = [*(resolve(robot, name) for name in names), *joints.values()]
    candidates += [
        Candidate(name, (move.path,), f"{name} yields", remote=True, nameable=False)
        for name, move in joints.items()
    ]
    candidates += _unlike(candidates, joints)
    suspected = {name for candidate in candidates if candidate in frames for name in candidate.parameters}
    parameters = [_parameter(robot, move) for move in moves]
    parameters += [parameter for parameter in of_frame if parameter.name in suspected]
    return parameters, candidates, {move.path: move for move in moves}


def _chosen(robot: Robot, chosen: Sequence[str] | None) -> list[Candidate]:
    kinds = {
        "effects": _effects(robot),
        "parameters": _suspected(robot),
        "measurement": {
            candidate.name: candidate for candidate in frame.suspects(mechanism(robot.mechanism))[1]
        },
    }
    every = {name: candidate for kind in kinds.values() for name, candidate in kind.items()}
    if chosen is None:
        return list(every.values())
    if isinstance(chosen, str):
        what = f"expected a list of names, found {shown(chosen)}"
        raise PkmodesError(what, "candidates", f"write [{shown(chosen)}]")
    found: dict[str, Candidate] = {}
    for name in chosen:
        if name in kinds:
            found |= kinds[name]
        elif name in every:
            found[name] = every[name]
        else:
            found[name] = _asked_for(robot, name, [*every])
    return list(found.values())


def _with_another_frame(robot: Robot, candidates: Sequence[Candidate]) -> list[Candidate]:
    """A moving frame whose declared mass is wrong: its compliance alone would not fit."""
    mass = robot.quantities.get("frame.mass")
    name = "frame_compliance"
    if (mass is not None and mass.sigma is not None) or name not in {c.name for c in candidates}:
        return []
    parameters = (f"effects.{name}.compliance", f"effects.{name}.mass")
    sentence = "the frame yields, and its mass is not the declared one"
    return [Candidate(f"{name} with another frame.mass", parameters, sentence, remote=True, nameable=False)]


def _varying(robot: Robot) -> list[str]:
    """Declared values that the robot depends on: not those that every axis overrides, the frame's mass once."""
    known = set(paths(robot))
    if "frame.mass" in robot.quantities:
        known.discard("effects.frame_compliance.mass")
    return [path for path in robot.quantities if path in known]


def _asked_for(robot: Robot, name: str, known: list[str]) -> Candidate:
    """A candidate that is not suspected by default, such as the belt of one axis."""
    path = name.removeprefix(PREFIX)
    if name in CATALOGUE:
        _refuse_declared(robot, f"the effect {name}", _declared_parameters(robot, CATALOGUE[name]))
    effect = name.removeprefix(EFFECTS).partition(".")[0]
    if name.startswith(EFFECTS) and effect in CATALOGUE:
        raise PkmodesError(f"unknown candidate {shown(name)}", "candidates", f'did you mean "{effect}"?')
    if name == path or path not in paths(robot):
        nearest = difflib.get_close_matches(name, [*known, *(f"{PREFIX}{p}" for p in paths(robot))], n=1)
        remedy = f'did you mean "{nearest[0]}"?' if nearest else "use the names in docs/diagnosis.md"
        raise PkmodesError(f"unknown candidate {shown(name)}", "candidates", remedy)
    _refuse_declared(robot, path, [path, *_elements(robot, path)])
    shared = re.sub(r"^axis\.[123]\.", "", path)
    if (
        path not in robot.quantities
        and shared in robot.quantities
        and robot.quantities[shared].sigma is not None
    ):
        state = "refitted for all axes together" if robot.quantities[shared].sigma else "known exactly"
        raise PkmodesError(
            f"{shared} is {state}: the robot file gives a sigma",
            "candidates",
            f"declare {path} in the robot file, without a sigma, to have it suspected",
        )
    resolve(robot, path)
    return Candidate(name, (path,), f"the declared value of {path} is wrong")


def _refuse_declared(robot: Robot, what: str, declared: Sequence[str]) -> None:
    """Refuse a candidate with a value that has a standard deviation."""
    sigmas = [quantity.sigma for path in declared if (quantity := robot.quantities.get(path)) is not None]
    given = [sigma for sigma in sigmas if sigma is not None]
    if given:
        state = "refitted already" if any(given) else "known exactly"
        raise PkmodesError(
            f"{what} is {state}: the robot file gives a sigma",
            "candidates",
            "leave it out, or remove the sigma",
        )


def _elements(robot: Robot, whole: str) -> list[str]:
    """Paths of the elements of a whole."""
    return [path for path in robot.quantities if whole in WHOLES and f".{WHOLES[whole]}." in path]


def _declared_parameters(robot: Robot, effect: Effect) -> list[str]:
    names = [f"effects.{effect.name}.{p.name}" for p in effect.parameters if p.fitted]
    return [name for name in names if name in robot.quantities]


def _effects(robot: Robot) -> dict[str, Candidate]:
    """Effects that the file does not declare, and those that it declares without a standard deviation."""
    found = {}
    for effect in CATALOGUE.values():
        names = [f"effects.{effect.name}.{p.name}" for p in effect.parameters if p.fitted]
        if all(robot.quantities[name].sigma is None for name in _declared_parameters(robot, effect)):
            found[effect.name] = Candidate(effect.name, tuple(names), effect.sentence)
    return found


def _suspected(robot: Robot) -> dict[str, Candidate]:
    """Values without a standard deviation; limits and joints as wholes, the effects under their own names."""
    others = ("effects.", "frame.")
    parts = [element for whole in WHOLES for element in _elements(robot, whole)]
    found = [
        path
        for path in _varying(robot)
        if robot.quantities[path].sigma is None
        and not path.startswith(others)
        and path not in parts
        and not (path.startswith("gravity.") and robot.quantities[path].value == 0.0)  # nobody measures it
    ]
    for whole in WHOLES:
        present = robot.parameters.joint.any(axis=1).all() or whole != "axis.joint_radius"
        if present and all(robot.quantities[element].sigma is None for element in _elements(robot, whole)):
            found.append(whole)
    return {
        f"{PREFIX}{path}": Candidate(f"{PREFIX}{path}", (path,), f"the declared value of {path} is wrong")
        for path in found
    }


def _of_one_axis(robot: Robot) -> list[Candidate]:
    """Values that the file gives for several axes, of one of them alone; not where a sigma says that it is known."""
    found, known = [], paths(robot)
    for path in known:
        shared = re.sub(r"^axis\.[123]\.", "", path)
        if shared != path and path not in robot.quantities and shared in known:
            following = [j for j in "123" if f"axis.{j}.{shared}" not in robot.quantities]
            if robot.quantities[shared].sigma is None and len(following) > 1:
                sentence = f"the value of {path} is not that of the other axes"
                found.append(Candidate(f"{PREFIX}{path}", (path,), sentence, remote=True))
    return found


def _joints(robot: Robot) -> dict[str, ParameterPath]:
    """Compliances in single joints: those of the catalogue are in all joints of their kind."""
    found = {}
    for effect in CATALOGUE.values():
        name, unit = f"{effect.name}.{effect.parameters[0].name}", effect.parameters[0].unit
        declared = robot.quantities.get(f"effects.{name}")
        for q in effect.coordinates if declared is None or declared.sigma != 0.0 else ():
            slot = (f"{name}.{q}", ())
            found[f"{effect.name} of {q} alone"] = ParameterPath(
                f"effects.{name}.{q}", 0.0, unit, {slot: 1.0}
            )
    return found


def _unlike(candidates: Sequence[Candidate], joints: Mapping[str, ParameterPath]) -> list[Candidate]:
    """Compliances with another value in each joint, for those candidates that give all joints the same."""
    found = []
    for name in [candidate.name for candidate in candidates if candidate.name in CATALOGUE]:
        each = [joint for q in CATALOGUE[name].coordinates if (joint := f"{name} of {q} alone") in joints]
        if len(each) > 1:
            parameters = tuple(joints[joint].path for joint in each)
            what = f"{name} with another value in each joint"
            found.append(Candidate(what, parameters, general_of=name))
    return found


def _parameter(robot: Robot, move: ParameterPath) -> Parameter:
    quantity = robot.quantities.get(move.path)
    sigma = quantity.sigma if quantity is not None and quantity.sigma else None
    lower, upper = -np.inf, np.inf
    if move.path.startswith("effects."):
        _, effect, name, *_ = move.path.split(".")
        lower = next(p.greater_than for p in CATALOGUE[effect].parameters if p.name == name)
    elif not any(part in f".{move.path}" for part in SIGNED):
        lower = 0.0
        if sigma is None and move.value > 0.0:
            lower, upper = move.value / FACTOR, move.value * FACTOR
    return Parameter(move.path, move.value, move.unit.replace(" ", "*"), sigma, lower, upper)
