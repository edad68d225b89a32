"""What is right of a pair of campaigns, and how an answer is judged."""

from __future__ import annotations

import pickle
from types import SimpleNamespace
from typing import Any

import numpy as np
import pytest

from pkmodes import updating
from pkmodes_rig.one_place import Fault, modes_of
from pkmodes_rig.one_place.changes import ALL_DRIVES
from studies.changed import Changed, cases, some_pairs
from studies.changed_cases import PairCase, measured
from studies.changed_judging import PairOutcome, judged_change, run, truths_of
from studies.one_place_cases import EVERY, declared
from studies.specimens import MACHINES as SPECIMENS

# What is right -------------------------------------------------------------------------------------------------


@pytest.mark.parametrize(
    ("machine", "effect"),
    [
        ("published", "axis_belt_stiffness"),
        ("corexy", "axis_belt_stiffness"),
        ("rotary_delta", "axis_reducer_stiffness"),
        ("hexapod", "axis_leg_stiffness"),
    ],
)
def test_softer_drives_are_an_effect_of_the_catalogue(machine: str, effect: str) -> None:
    case = PairCase("clear", 0, machine, ALL_DRIVES, seed=11)
    faults = measured(case).faults
    assert effect in truths_of(case, declared(machine), faults)[0]
    robot, p = declared(machine), SPECIMENS[machine].points[2]
    q = robot.parameters
    for fault in faults:
        _, axis, name = fault.places[0].split(".", 2)
        value = np.array(getattr(q, name.replace(".", "_")), dtype=float)
        value[int(axis) - 1] *= 1 + fault.values["change"]
        q = q._replace(**{name.replace(".", "_"): value})
    sizes = {f"{effect}.factor_{j + 1}": fault.values["change"] for j, fault in enumerate(faults)}
    by_effect = SPECIMENS[machine].rig(robot.parameters, p, {**robot.constants, **sizes})
    softer = modes_of(robot.mechanism_name, q, p)
    np.testing.assert_allclose(
        softer.frequencies[softer.rigid :], by_effect.frequencies[softer.rigid :], rtol=1e-9
    )


def test_a_joint_that_yields_on_all_axes_is_an_effect_of_the_catalogue() -> None:
    case = PairCase("sigmas", 0, "tower", "all gearboxes yield", seed=11)
    faults = measured(case).faults
    assert truths_of(case, declared("tower"), faults) == [{"gearbox_compliance": dict(faults[0].values)}]
    assert [fault.term for fault in faults] == [f"compliance:psi_{j}" for j in (1, 2, 3)]


def test_one_place_has_the_names_of_its_own_suite() -> None:
    case, robot = PairCase("clear", 0, "published", "payload"), declared("published")
    fault = Fault("mass", ("platform",), values={"mass": 0.2})
    (names,) = truths_of(case, robot, [fault])
    assert {"mass:platform", "payload"} <= set(names)
    assert truths_of(PairCase("unchanged", 0, "published"), robot, []) == []


@pytest.mark.parametrize(
    ("machine", "place", "path"),
    [
        ("asymmetric", "platform", "platform.mass"),
        ("rotary_delta", "platform", "platform.mass"),
        ("corexy", "platform", "toolhead.mass"),
        ("corexy", "gantry", "gantry.mass"),
        ("cartesian", "beam", "beam.mass"),
        ("bed_slinger", "toolhead", "toolhead.mass"),
        ("bed_slinger", "bed", "bed.mass"),
    ],
)
def test_a_mass_on_a_body_is_a_larger_declared_one(machine: str, place: str, path: str) -> None:
    """In a change, unlike in a diagnosis, values that were uncertain are suspected, too."""
    robot, p = declared(machine), EVERY[machine].points[1]
    fault = Fault("mass", (place,), values={"mass": 0.05})
    (names,) = truths_of(PairCase("clear", 0, machine, "mass"), robot, [fault])
    assert f"parameter:{path}" in names
    q, field = robot.parameters, path.replace(".", "_")
    larger = modes_of(robot.mechanism_name, q._replace(**{field: getattr(q, field) + 0.05}), p)
    np.testing.assert_allclose(
        modes_of(robot.mechanism_name, q, p, [fault]).frequencies[larger.rigid :],
        larger.frequencies[larger.rigid :],
        rtol=1e-9,
    )


# Judging -------------------------------------------------------------------------------------------------------

MASS = {"value": 0.21, "sigma": 0.02, "unit": "kg"}
RIGHT = [{"mass:platform": {"mass": 0.2}, "payload": {"mass": 0.2}}]


def nothing(verdict: str = "adequate") -> dict[str, Any]:
    return {"verdict": verdict, "reason": "so it is", "effects": [], "survivors": [], "beyond": None}


def claim(*members: str) -> dict[str, Any]:
    alternatives = {name: {f"effects.{name}.mass": MASS} for name in members}
    return nothing("effect_found") | {"effects": [{"class": list(members), "alternatives": alternatives}]}


def term(*members: str, status: str = "found") -> dict[str, Any]:
    classes = [{"members": [{"term": name, "parameters": {"mass": MASS}} for name in members]}]
    beyond = {"status": status, "reason": "so it is", "tried": 99, "classes": classes}
    return nothing("unexplained") | {"beyond": beyond}


OTHERS = [f"mass:link_{j}" for j in range(1, 6)]


@pytest.mark.parametrize(
    ("changed", "document", "truths", "state", "by"),
    [
        (True, claim("payload", "clamp_compliance"), RIGHT, "named", "catalogue"),
        (True, term("mass:platform", "mass:link_1"), RIGHT, "named", "term"),
        (True, claim("clamp_compliance"), RIGHT, "wrong", "catalogue"),
        (True, claim(*OTHERS, "clamp_compliance"), RIGHT, "wrong", "catalogue"),
        (True, claim("payload", *OTHERS), RIGHT, "abstained", ""),
        (True, term("mass:platform", *OTHERS), RIGHT, "abstained", ""),
        (True, term("mass:link_2"), RIGHT, "wrong", "term"),
        (True, nothing("unexplained"), RIGHT, "abstained", ""),
        (None, nothing(), RIGHT, "abstained", ""),
        (None, term("mass:platform", "mass:link_1", status="several"), RIGHT, "abstained", ""),
        (False, nothing(), RIGHT, "unchanged", ""),
        (False, nothing(), [], "unchanged", ""),
        (None, nothing("insufficient_data"), [], "abstained", ""),
        (True, nothing("unexplained"), [], "abstained", ""),
        (True, claim("payload"), [], "wrong", "catalogue"),
        (True, term("mass:platform"), [], "wrong", "term"),
    ],
)
def test_states(
    changed: bool | None, document: dict[str, Any], truths: list[Any], state: str, by: str
) -> None:
    judgement = judged_change(changed, document, truths)
    assert (judgement.state, judgement.by) == (state, by)
    if state == "named":
        assert judgement.values[0][1:] == (0.21, 0.02, 0.2)


@pytest.mark.parametrize(
    ("document", "state"), [(claim("payload"), "named"), (claim("link_compliance"), "wrong")]
)
def test_a_case_is_measured_asked_about_and_judged(
    document: dict[str, Any], state: str, monkeypatch: pytest.MonkeyPatch
) -> None:
    case = PairCase("sigmas", 2, "tower", "payload", realistic=True, seed=11)
    hidden, given = measured(case), []

    def changed(robot: Any, trusted: Any, later: Any) -> Any:
        given.append((robot, len(trusted.frequency), len(later.frequency)))
        return SimpleNamespace(changed=True, rule="claims.found", beyond=None, as_json=lambda: document)

    monkeypatch.setattr(updating, "changed", changed)
    outcome = run(case)
    assert given == [(declared("tower"), len(hidden.trusted.rows), len(hidden.later.rows))]
    assert outcome.state == state
    assert outcome.truth == ("mass:platform",)
    assert "payload" in outcome.names
    assert (outcome.strength, outcome.drives) == (hidden.strength, hidden.drives)
    assert pickle.loads(pickle.dumps(outcome)) == outcome


def test_tables_can_be_made_of_any_outcomes() -> None:
    states = ("named", "wrong", "abstained", "unchanged", "failed", "unreached")
    values = (("payload.mass", 0.21, 0.02, 0.2),)
    outcomes = [
        PairOutcome(case, states[i % 6], classes=(("payload",),), values=values, names=("payload",))
        for i, case in enumerate(some_pairs(1, 60))
    ]
    tables, facts = Changed().tables(outcomes), Changed().facts(outcomes)
    assert ("all", "value within 3 sigma >= 95 %") in {row[:2] for row in tables["requirements"].rows}
    silent = sum(o.case.kind != "" and o.state in ("abstained", "unchanged") for o in outcomes)
    assert (facts["changes that were not named"], facts["what changed is among what remains"]) == (
        silent,
        silent,
    )
    assert facts["cases of the suites"] == len(cases())
    assert facts["none large enough"] == sum(o.state == "unreached" for o in outcomes) > 0
    assert len(tables["cases"].rows) == sum(o.state != "unreached" for o in outcomes)
