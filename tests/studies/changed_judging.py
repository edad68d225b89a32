"""What is said of two campaigns, judged: whether something changed, and what."""

from __future__ import annotations

import time
from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from typing import Any

from pkmodes import updating
from pkmodes.core.robot.robot import Robot
from pkmodes.loop.measured.measurements import Measurements
from pkmodes_rig.one_place.changes import ALL_DRIVES, ALL_YIELD
from studies.changed_cases import Pair, PairCase, measured
from studies.one_place_cases import UnreachedError, declared
from studies.one_place_judging import (
    MEMBERS,
    UNREACHED,
    Judgement,
    Values,
    beyond_of,
    classes_of,
    judged,
    same,
)
from studies.running import Outcome
from studies.specimens import measurements_of

#: The state of an answer that nothing changed.
UNCHANGED = "unchanged"
#: Effects of the catalogue: the same joint of all axes yields.
EFFECTS = {
    ALL_YIELD["psi"]: "gearbox_compliance",
    ALL_YIELD["eps"]: "clamp_compliance",
    ALL_YIELD["delta"]: "link_compliance",
}
#: What makes all drives softer.
ALL_SOFTER = {
    "rotary_delta": ("parameter:reducer.stiffness", "axis_reducer_stiffness"),
    "hexapod": ("parameter:leg.stiffness", "axis_leg_stiffness"),
}
BELTS = ("parameter:belt.specific_stiffness", "parameter:belt.width", "axis_belt_stiffness")


@dataclass(frozen=True)
class PairOutcome(Outcome[PairCase]):
    """Outcome of a case.

    Attributes
    ----------
    truth : tuple of str
        The true terms, of all axes where these are changed alike.
    names : tuple of str
        All names that are right.
    by : str
        What named the change: ``term``, ``catalogue``, or empty.
    changed : bool or None
        The answer.
    change, strength, drives : float
        See `changed_cases.Pair`.
    rows : tuple of two ints
        Number of measured modes of both campaigns.
    """

    truth: tuple[str, ...] = ()
    names: tuple[str, ...] = ()
    by: str = ""
    changed: bool | None = None
    change: float = 0.0
    strength: float = 0.0
    drives: float = 1.0
    rows: tuple[int, int] = (0, 0)


def run(case: PairCase) -> PairOutcome:
    """Measure both campaigns, ask what changed, and judge the answer."""
    try:
        pair = measured(case)
    except UnreachedError:
        return PairOutcome(case, UNREACHED, signal=float("inf"))
    robot = declared(case.machine)
    trusted, later = (measurements_of(one.text, robot) for one in (pair.trusted, pair.later))
    start = time.perf_counter()
    answer = asked(robot, trusted, later)
    seconds = time.perf_counter() - start
    document: dict[str, Any] = answer.as_json()
    truths = truths_of(case, robot, pair.faults)
    judgement = judged_change(answer.changed, document, truths)
    beyond = beyond_of(document)
    return PairOutcome(
        case=case,
        state=judgement.state,
        verdict=document["verdict"],
        classes=classes_of(document),
        values=judgement.values,
        signal=pair.strength,
        seconds=seconds,
        reason=beyond.get("reason") or document["reason"],
        rule=answer.rule if answer.beyond is None else answer.beyond.rule,
        truth=tuple(fault.term for fault in pair.faults),
        names=tuple(name for names in truths for name in names),
        by=judgement.by,
        changed=answer.changed,
        **measures(pair),
    )


def asked(robot: Robot, trusted: Measurements, later: Measurements) -> Any:
    """Ask what changed."""
    return updating.changed(robot, trusted, later)


def measures(pair: Pair) -> dict[str, Any]:
    """Return what the rig knows of a pair, as fields of an outcome."""
    return {
        "change": pair.change,
        "strength": pair.strength,
        "drives": pair.drives,
        "rows": (len(pair.trusted.rows), len(pair.later.rows)),
    }


def truths_of(case: PairCase, robot: Robot, faults: Sequence[Any]) -> list[Mapping[str, Values]]:
    """Return the names that are right for what changed, with the values that can be compared; nothing for no change.

    Where several names are the same to any measurement, all are right; see `one_place_judging.same`.
    """
    if not faults:
        return []
    if case.kind in EFFECTS:
        return [{EFFECTS[case.kind]: dict(faults[0].values)}]
    if case.kind == ALL_DRIVES:
        return [{name: {} for name in ALL_SOFTER.get(case.mechanism, BELTS)}]
    return [same(case.mechanism, robot, faults[0])]


def judged_change(
    changed: bool | None, document: Mapping[str, Any], truths: Sequence[Mapping[str, Values]]
) -> Judgement:
    """Judge an answer.

    Parameters
    ----------
    changed : bool or None
        Whether something changed; None if the data do not tell.
    document : mapping
        The JSON of the answer.
    truths : sequence of mapping
        From `truths_of`.

    Returns
    -------
    Judgement
        ``unchanged``: it says that nothing changed.  ``named`` and ``wrong`` as in `one_place_judging.judged`, where
        a class of the catalogue counts as an answer, too, only if it has at most `MEMBERS`.  ``abstained`` otherwise.
    """
    if changed is False:
        return Judgement(UNCHANGED)
    judgement = judged(document, truths)
    vague = any(len(effect["alternatives"]) > MEMBERS for effect in document["effects"])
    silent = judgement.state not in ("named", "wrong")
    if silent or (judgement.state == "named" and judgement.by == "catalogue" and vague):
        return Judgement("abstained")
    return judgement
