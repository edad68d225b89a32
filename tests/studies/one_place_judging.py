"""What a diagnosis says of a fault at one place, judged by its JSON.

A term is right if it is the true one, or one that is the same to any measurement; which ones are the same is written
here by hand, from the energies of the mechanisms, and not by any model.
"""

from __future__ import annotations

import time
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass
from typing import Any

from pkmodes import updating
from pkmodes.core.robot.robot import Robot
from pkmodes.loop.sensitivity.paths import resolve
from pkmodes_rig.one_place import Fault
from pkmodes_rig.one_place.draws import ON_RAILS
from pkmodes_rig.one_place.faults import same_term
from studies.one_place_cases import PlaceCase, UnreachedError, declared, measured
from studies.running import Outcome
from studies.specimens import measurements_of

#: Largest class that counts as an answer.
MEMBERS = 5
#: The state of a case whose fault cannot be as large as asked: nothing is measured.
UNREACHED = "unreached"
FOUND, CLAIMED, ADEQUATE = "found", "effect_found", "adequate"

#: Parameters of a term or candidate with their true values; empty where the value is not compared.
Values = Mapping[str, float]


@dataclass(frozen=True)
class PlaceOutcome(Outcome[PlaceCase]):
    """Outcome of a case; `rule` is the one beyond the catalogue that decided, if terms were tried.

    Attributes
    ----------
    truth : tuple of str
        The true terms.
    by : str
        What named a cause: ``term``, ``catalogue``, or empty.
    status : str
        Of the search among terms; empty where there was none.
    tried : int
        Terms that were tried.
    change : float
        Root mean square of the relative changes of the frequencies that were found.
    rows : int
    """

    truth: tuple[str, ...] = ()
    by: str = ""
    status: str = ""
    tried: int = 0
    change: float = 0.0
    rows: int = 0


@dataclass(frozen=True)
class Judgement:
    """What the JSON of a diagnosis says, held against the truth; see `running.Outcome` and `PlaceOutcome`."""

    state: str
    by: str = ""
    values: tuple[tuple[str, float, float, float], ...] = ()


def run(case: PlaceCase) -> PlaceOutcome:
    """Measure, diagnose and judge a case."""
    try:
        hidden = measured(case)
    except UnreachedError:
        return PlaceOutcome(case, UNREACHED, signal=float("inf"))
    robot = declared(case.machine)
    data = measurements_of(hidden.text, robot)
    start = time.perf_counter()
    diagnosis = updating.diagnose(robot, data)
    seconds = time.perf_counter() - start
    document: dict[str, Any] = diagnosis.as_json()
    beyond = beyond_of(document)
    truths = [same(case.mechanism, robot, fault) for fault in hidden.faults]
    judgement = judged(document, truths)
    return PlaceOutcome(
        case=case,
        state=judgement.state,
        verdict=document["verdict"],
        classes=classes_of(document),
        values=judgement.values,
        signal=hidden.change,
        seconds=seconds,
        reason=beyond.get("reason") or document["reason"],
        rule=diagnosis.rule if diagnosis.beyond is None else diagnosis.beyond.rule,
        truth=tuple(fault.term for fault in hidden.faults),
        by=judgement.by,
        status=beyond.get("status", ""),
        tried=beyond.get("tried", 0),
        change=hidden.change,
        rows=hidden.rows,
    )


def beyond_of(document: Mapping[str, Any]) -> Mapping[str, Any]:
    """Return what the JSON says of terms; empty where none were tried."""
    return document.get("beyond") or {}


def classes_of(document: Mapping[str, Any]) -> tuple[tuple[str, ...], ...]:
    """Return what remains of the terms where these were tried, else of the catalogue."""
    beyond = beyond_of(document)
    if beyond.get("classes"):
        return tuple(tuple(member["term"] for member in one["members"]) for one in beyond["classes"])
    claimed = tuple(tuple(effect["class"]) for effect in document["effects"])
    return claimed or tuple(tuple(one) for one in document["survivors"])


def judged(document: Mapping[str, Any], truths: Sequence[Mapping[str, Values]]) -> Judgement:
    """Judge a diagnosis.

    Parameters
    ----------
    document : mapping
        Its JSON.
    truths : sequence of mapping
        From `same`: for each fault the names that are right, with their values; empty where no term is right.

    Returns
    -------
    Judgement
        ``named``: the class that was found among the terms, of at most `MEMBERS`, or each class that the catalogue
        claims, has a right name.  ``partly``: that of one of several faults.  ``wrong``: a claim without.
        ``abstained`` and ``adequate`` otherwise.
    """
    beyond = beyond_of(document)
    if beyond.get("status") == FOUND:
        members = {
            member["term"]: member["parameters"] for one in beyond["classes"] for member in one["members"]
        }
        if len(members) <= MEMBERS:
            return _held(members, truths, "term")
    if document["verdict"] == CLAIMED:
        each = [_held(effect["alternatives"], truths, "catalogue") for effect in document["effects"]]
        return next((one for one in each if one.state == "wrong"), each[0])
    return Judgement("adequate" if document["verdict"] == ADEQUATE else "abstained")


def _held(members: Mapping[str, Any], truths: Sequence[Mapping[str, Values]], by: str) -> Judgement:
    """Hold a class against the truth: names with their parameters."""
    for truth in truths:
        right = [(name, true) for name in members for true in truth if same_term(name, true)]
        if right:
            values = [v for name, true in right for v in _compared(name, members[name], truth[true])]
            return Judgement("named" if len(truths) == 1 else "partly", by, tuple(values[:1]))
    return Judgement("wrong", by)


def _compared(
    name: str, fitted: Mapping[str, Any], true: Values
) -> Iterator[tuple[str, float, float, float]]:
    """Yield estimates with their standard deviations and the true values; a parameter goes by its last name."""
    for parameter, value in true.items():
        for path, entry in fitted.items():
            own = path == parameter or path.rpartition(".")[2] == parameter
            if own and entry["value"] is not None and entry["sigma"]:
                yield f"{name}.{parameter}", entry["value"], entry["sigma"], value


# What is the same ----------------------------------------------------------------------------------------------


def same(mechanism: str, robot: Robot, fault: Fault) -> dict[str, Values]:
    """Return the names that are right for a fault, with the true values of their parameters.

    The values of names other than the true one are only given where they do not depend on an uncertain value.
    """
    if fault.form == "parameter":
        (path,) = fault.places
        value = resolve(robot, path).value * (1 + fault.values["change"])
        certain = {path: value} if not _uncertain(robot, path) else {}
        return {fault.term: certain, **{name: {} for name in _same_values(mechanism, robot, path)}}
    return {fault.term: fault.values, **dict(_same_terms(mechanism, robot, fault))}


def _uncertain(robot: Robot, path: str) -> bool:
    """Return whether a value of one axis is a table's value with a standard deviation."""
    table = path.split(".", 2)[2]
    return table in robot.quantities and bool(robot.quantities[table].sigma)


def _same_terms(mechanism: str, robot: Robot, fault: Fault) -> Iterator[tuple[str, Values]]:
    """Yield other names for a term that is no value of an axis."""
    place, direction = fault.places[0], fault.direction
    stem, _, which = place.partition("_")
    axis = f"{'belt_path' if mechanism == 'corexy' else 'axis'}.{which.partition('_')[0]}"
    amount = fault.values.get("mass", fault.values.get("inertia", 0.0))
    if fault.form == "mass":
        if place in ("platform", "bed"):
            yield "payload", {"mass": amount}
        if (mechanism, place) in _VALUE_OF:
            yield f"parameter:{_VALUE_OF[mechanism, place]}", {}
        for path in _MORE_OF.get((mechanism, stem), ()):
            yield f"parameter:{axis}.{path}", {}
        if mechanism in ON_RAILS and stem == "pulley" and _driven(robot, place):
            yield from ((f"parameter:{axis}.{path}", {}) for path in ("motor.inertia", "motor.gear_ratio"))
        if mechanism in _ONE_MODE and stem == "pulley":
            yield from ((name, {}) for name in _of_one_mode(mechanism, which))
        if (mechanism, place) in _BODY_OF:
            yield from ((name, {}) for name in _of_one_mode(mechanism, _BODY_OF[mechanism, place]))
    elif mechanism == "linear_delta" and fault.form == "spring" and _half_as_far(robot, fault):
        # Where no carriage moves, the middle of each link moves half as far as the platform.
        k = fault.values["stiffness"]
        yield f"spring:platform.{direction}", {"stiffness": k / 4}
        for link in (f"link_{j}" for j in (1, 2, 3) if _across(robot, j, direction)):
            yield from (
                (f"spring:{ends}.{direction}", dict(fault.values)) for ends in (link, f"platform/{link}")
            )
    elif fault.form == "spring" and len(fault.places) == 1:
        if place == "platform" and not direction:
            yield "cable_stiffness", {"stiffness": fault.values["stiffness"]}
        # The beam and the tool head have the same y.
        if (place, direction) in (("gantry", ""), ("beam", "")):
            yield "spring:platform.y", dict(fault.values)
        if mechanism in ("corexy", "cartesian") and (place, direction) == ("platform", "y"):
            yield f"spring:{'gantry' if mechanism == 'corexy' else 'beam'}", dict(fault.values)
    elif fault.form == "spring" and mechanism in ON_RAILS and direction in ("x", "y", "z"):
        # A carriage does not move across its rail: a spring to it is one to ground.
        other = fault.places[1]
        carriage = place == "platform" and other.startswith("carriage_")
        if carriage and _across(robot, int(other.rpartition("_")[2]), direction):
            yield f"spring:platform.{direction}", dict(fault.values)
    elif fault.form == "compliance" and stem == "u":
        yield f"frame_compliance.compliance_{which}", {}


def _across(robot: Robot, j: int, direction: str) -> bool:
    """Return whether the rail of axis j is perpendicular to a direction of the base frame."""
    return bool(robot.parameters.direction[j - 1]["xyz".index(direction)] == 0.0)


def _half_as_far(robot: Robot, fault: Fault) -> bool:
    """Return whether a spring to ground, or to the platform, is at a link whose carriage cannot move that way."""
    *others, last = fault.places
    stem, _, number = last.partition("_")
    links = stem == "link" and others in ([], ["platform"]) and fault.direction in ("x", "y", "z")
    return links and _across(robot, int(number), fault.direction)


def _driven(robot: Robot, place: str) -> bool:
    j, k = (int(number) - 1 for number in place.split("_")[1:])
    return bool(robot.parameters.drive[j, k])


#: Values of one axis of which a larger one is more of a body: they enter the energies nowhere else, or only through
#: the weight of a hexapod's leg, whose stiffness is a ten-thousandth of what can be measured.
_MORE_OF = {
    ("linear_delta", "carriage"): ("carriage.mass",),
    ("linear_delta", "link"): ("link.mass",),
    ("hexaglide", "carriage"): ("carriage.mass",),
    ("hexaglide", "link"): ("link.mass",),
    ("rotary_delta", "arm"): ("arm.inertia",),
    ("rotary_delta", "link"): ("link.mass",),
    ("rotary_delta", "motor"): ("motor.inertia", "motor.gear_ratio"),
    ("hexapod", "leg"): ("leg.base_mass", "leg.base_inertia", "leg.base_center"),
    ("hexapod", "rod"): ("leg.rod_mass",),
    ("hexapod", "motor"): ("motor.inertia", "motor.travel"),
    # The angle of a pulley is not measured: only inertia / radius^2 enters the modes.
    ("corexy", "pulley"): ("motor.inertia", "motor.gear_ratio", "pulley.inertia", "pulley.radius"),
}
#: Values of one axis that enter the energies only together.
_TOGETHER = {
    "linear_delta": (
        ("belt.width", "belt.specific_stiffness", "axis_belt_stiffness"),
        ("motor.inertia", "motor.gear_ratio"),
    ),
    "rotary_delta": (
        ("reducer.stiffness", "axis_reducer_stiffness"),
        ("motor.inertia", "motor.gear_ratio"),
    ),
    "hexapod": (
        ("leg.stiffness", "axis_leg_stiffness"),
        ("leg.base_mass", "leg.base_inertia", "leg.base_center"),
        ("motor.inertia", "motor.travel"),
    ),
    "corexy": (
        ("belt.width", "belt.specific_stiffness", "axis_belt_stiffness"),
        ("motor.inertia", "motor.gear_ratio", "pulley.inertia", "pulley.radius"),
    ),
}
#: Printers each of whose belts has one mode alone: all that multiplies its frequency by a number is the same.
_ONE_MODE = ("cartesian", "bed_slinger")
_OF_ONE_MODE = (
    *("belt.width", "belt.specific_stiffness", "motor.inertia", "motor.gear_ratio"),
    *("pulley.inertia", "pulley.radius"),
)
#: Bodies that only one belt moves, with its number.
_BODY_OF = {("cartesian", "beam"): "2", ("bed_slinger", "toolhead"): "1", ("bed_slinger", "bed"): "2"}


#: The declared masses of bodies; the platform of a machine with six legs has its mass at another point.
_VALUE_OF = {
    **{(mechanism, "platform"): "platform.mass" for mechanism in ("linear_delta", "rotary_delta")},
    **{(mechanism, "platform"): "toolhead.mass" for mechanism in ("corexy", "cartesian")},
    ("corexy", "gantry"): "gantry.mass",
    ("cartesian", "beam"): "beam.mass",
    ("bed_slinger", "toolhead"): "toolhead.mass",
    ("bed_slinger", "bed"): "bed.mass",
}


def _of_one_mode(mechanism: str, axis: str) -> Iterator[str]:
    """Yield what multiplies the frequency of the only mode of one belt of a printer."""
    yield from (f"parameter:axis.{axis}.{value}" for value in _OF_ONE_MODE)
    yield f"mass:pulley_{axis}"
    yield "axis_belt_stiffness"
    bodies = [place for (printer, place), own in _BODY_OF.items() if (printer, own) == (mechanism, axis)]
    yield from (f"mass:{place}" for place in bodies)
    yield from (f"parameter:{_VALUE_OF[mechanism, place]}" for place in bodies)
    if "bed" in bodies:
        yield "payload"


def _same_values(mechanism: str, robot: Robot, path: str) -> Iterator[str]:
    """Yield other names for a value of one axis."""
    table, axis, value = path.split(".", 2)
    if mechanism in _ONE_MODE and value in _OF_ONE_MODE:
        yield from _of_one_mode(mechanism, axis)
        return
    alike = "linear_delta" if mechanism == "hexaglide" else mechanism
    for group in _TOGETHER.get(alike, ()):
        if value in group:
            for other in group:
                yield other if "." not in other else f"parameter:{table}.{axis}.{other}"
    for (kind, stem), values in _MORE_OF.items():
        if kind == mechanism and value in values:
            yield f"mass:{stem}_{axis}"
    if mechanism in ON_RAILS and value.startswith("motor."):
        driven = 1 if robot.parameters.drive[int(axis) - 1, 0] else 2
        yield f"mass:pulley_{axis}_{driven}"
    if value == "reducer.stiffness":
        yield f"spring:arm_{axis}/motor_{axis}"
