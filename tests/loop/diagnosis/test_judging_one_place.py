"""How the suites of one fault at one place are drawn, sized and judged."""

from __future__ import annotations

from typing import Any

import numpy as np
import pytest

from pkmodes_rig.one_place import Fault, modes_of
from pkmodes_rig.one_place.draws import KINDS, kinds_of
from pkmodes_rig.one_place.laws import LAWS, Setting, laws_of, modes_by_law
from studies.one_place import MACHINES, OnePlace, cases
from studies.one_place_cases import CLEAR, EVERY, PlaceCase, declared, measured
from studies.one_place_judging import PlaceOutcome, classes_of, judged, same

VALUE = {"value": 63.8, "sigma": 0.9, "unit": "N*m/rad"}


def found(*terms: str, status: str = "found", **parameters: Any) -> dict[str, Any]:
    """The JSON of a diagnosis that tried terms."""
    members = [{"term": term, "parameters": parameters} for term in terms]
    beyond = {"status": status, "reason": "so it is", "tried": 214, "classes": [{"members": members}]}
    return {"verdict": "unexplained", "effects": [], "survivors": [], "beyond": beyond}


def claimed(*classes: list[str]) -> dict[str, Any]:
    """The JSON of a diagnosis with causes of the catalogue."""
    effects = [
        {"class": members, "alternatives": {name: {"effects.payload.mass": VALUE} for name in members}}
        for members in classes
    ]
    return {"verdict": "effect_found", "effects": effects, "survivors": [], "beyond": None}


TRUTH = {"spring:pulley_2_1/pulley_2_2": {"stiffness": 64.5}}


def test_a_class_of_terms_that_holds_the_true_one_is_right_in_any_order_of_its_places() -> None:
    said = judged(found("spring:pulley_2_2/pulley_2_1", "mass:link_1", stiffness=VALUE), [TRUTH])
    assert (said.state, said.by) == ("named", "term")
    assert said.values == (("spring:pulley_2_2/pulley_2_1.stiffness", 63.8, 0.9, 64.5),)


@pytest.mark.parametrize(
    ("document", "truths", "state"),
    [
        (found("mass:link_1"), [TRUTH], "wrong"),
        (found("mass:link_1"), [], "wrong"),
        (found(*TRUTH, "mass:link_1", status="several"), [TRUTH], "abstained"),
        (found(*TRUTH, *(f"mass:link_{j}" for j in range(5))), [TRUTH], "abstained"),
        (found(*TRUTH), [TRUTH, {"mass:link_1": {}}], "partly"),
        (claimed(["payload", "clamp_compliance"]), [{"mass:platform": {}, "payload": {}}], "named"),
        (claimed(["clamp_compliance"]), [TRUTH], "wrong"),
        (claimed(["payload"], ["clamp_compliance"]), [{"payload": {}}], "wrong"),
        (claimed(["clamp_compliance"]) | {"beyond": found(*TRUTH)["beyond"]}, [TRUTH], "named"),
        (found(status="none") | {"verdict": "adequate"}, [TRUTH], "adequate"),
        ({"verdict": "adequate", "effects": [], "survivors": []}, [], "adequate"),
        ({"verdict": "ambiguous", "effects": [], "survivors": [["payload"]]}, [TRUTH], "abstained"),
    ],
)
def test_states(document: dict[str, Any], truths: list[Any], state: str) -> None:
    assert judged(document, truths).state == state


def test_a_value_of_the_catalogue_is_held_against_the_truth() -> None:
    said = judged(claimed(["payload"]), [{"mass:platform": {}, "payload": {"mass": 60.0}}])
    assert said.by == "catalogue"
    assert said.values == (("payload.mass", 63.8, 0.9, 60.0),)


def test_the_classes_of_terms_come_before_those_of_the_catalogue() -> None:
    assert classes_of(found("mass:link_1", "mass:link_2")) == (("mass:link_1", "mass:link_2"),)
    assert classes_of(claimed(["payload"])) == (("payload",),)
    assert classes_of({"effects": [], "survivors": [["a"], ["b"]]}) == (("a",), ("b",))


def change(machine: str, path: str, amount: float) -> Fault:
    return Fault("parameter", (path,), values={"change": amount})


@pytest.mark.parametrize(
    ("machine", "fault", "other"),
    [
        ("published", Fault("mass", ("carriage_2",), values={"mass": 0.3}), "axis.2.carriage.mass"),
        ("published", Fault("mass", ("pulley_1_1",), values={"inertia": 1e-4}), "axis.1.motor.inertia"),
        ("hexaglide", Fault("mass", ("link_5",), values={"mass": 0.05}), "axis.5.link.mass"),
        ("rotary_delta", Fault("mass", ("arm_3",), values={"inertia": 1e-3}), "axis.3.arm.inertia"),
        ("hexapod", Fault("mass", ("leg_2",), values={"mass": 0.2}), "axis.2.leg.base_inertia"),
        ("corexy", Fault("mass", ("pulley_2",), values={"inertia": 1e-6}), "belt_path.2.pulley.inertia"),
        ("bed_slinger", Fault("mass", ("bed",), values={"mass": 0.1}), "axis.2.motor.inertia"),
        (
            "rotary_delta",
            Fault("spring", ("arm_1", "motor_1"), "", {"stiffness": 900.0}),
            "axis.1.reducer.stiffness",
        ),
    ],
)
def test_what_is_called_the_same_gives_the_same_modes(machine: str, fault: Fault, other: str) -> None:
    """Some change of the other value has the frequencies of the fault at all poses."""
    robot, mechanism = declared(machine), declared(machine).mechanism_name
    q, points = robot.parameters, EVERY[machine].points[:2]
    names = same(mechanism, robot, fault)
    inverse = f"parameter:{other}" in names or fault.term in same(
        mechanism, robot, change(machine, other, 0.1)
    )
    assert inverse

    def vibrations(faults: list[Fault], parameters: Any = q) -> np.ndarray:
        each = [modes_of(mechanism, parameters, p, faults) for p in points]
        return np.concatenate([np.log(one.frequencies[one.rigid :]) for one in each])

    wanted, plain = vibrations([fault]), vibrations([])
    field = other.split(".", 2)[2].replace(".", "_")
    place = int(other.split(".")[1]) - 1

    def changed(factor: float) -> np.ndarray:
        value = np.array(getattr(q, field), dtype=float)
        value[place] *= factor
        return vibrations([], q._replace(**{field: value}))

    low, high = 1e-3, 1e3
    rising = float(np.sum(changed(1.1) - plain)) > 0
    for _ in range(60):
        factor = float(np.sqrt(low * high))
        less = float(np.sum(changed(factor) - wanted)) < 0
        low, high = (factor, high) if less == rising else (low, factor)
    assert np.abs(wanted - plain).max() > 1e-4
    # a hexapod's leg differs in its weight alone
    assert np.abs(changed(factor) - wanted).max() < (1e-5 if machine == "hexapod" else 1e-9)


@pytest.mark.parametrize(
    ("machine", "places", "direction", "count"),
    [
        ("published", ("platform", "link_3"), "z", 6),
        ("published", ("link_1",), "y", 6),
        ("published", ("platform", "carriage_2"), "z", 1),
    ],
)
def test_springs_that_are_called_the_same_give_the_same_modes(
    machine: str, places: tuple[str, ...], direction: str, count: int
) -> None:
    fault = Fault("spring", places, direction, {"stiffness": 4e4})
    robot, (p, *_) = declared(machine), EVERY[machine].points
    q = robot.parameters
    wanted = modes_of("linear_delta", q, p, [fault])
    others = {name: v for name, v in same("linear_delta", robot, fault).items() if name != fault.term}
    assert len(others) == count
    for name, values in others.items():
        ends, _, along = name.removeprefix("spring:").partition(".")
        alike = modes_of("linear_delta", q, p, [Fault("spring", tuple(ends.split("/")), along, dict(values))])
        np.testing.assert_allclose(
            alike.frequencies[alike.rigid :], wanted.frequencies[wanted.rigid :], rtol=1e-9
        )


def test_every_kind_of_fault_and_every_law_is_there() -> None:
    every = list(cases())
    assert len(every) >= 500
    assert len({case.label for case in every}) == len(every)
    assert {case.kind for case in every} == {*KINDS, *LAWS, ""}
    assert len(LAWS) == 12
    for name, machines in MACHINES.items():
        own = [case for case in every if case.mechanism == name]
        kinds = (*kinds_of(name, declared(machines[0]).parameters), *laws_of(name), "")
        assert {case.kind for case in own} == set(kinds)
        for kind in kinds:
            laboratories = {case.realistic for case in own if case.kind == kind}
            assert laboratories == {True, False} or len([c for c in own if c.kind == kind]) == 1


@pytest.mark.parametrize(
    ("machine", "kind"),
    [
        ("tower", "spring between bodies"),
        ("hexapod", "mount"),
        ("corexy", "resonator"),
        ("published", "parameter"),
    ],
)
def test_a_fault_is_as_large_as_asked_and_measured_again_the_same(machine: str, kind: str) -> None:
    case = PlaceCase("clear", 3, machine, kind, seed=11)
    one, again = measured(case), measured(case)
    assert one == again
    (fault,) = one.faults
    assert CLEAR[0] / 1.06 < one.change < 10 * CLEAR[1]  # with what the uncertain values could have done
    assert fault.term in same(case.mechanism, declared(machine), fault)
    assert one.text.count("\n") > 20


@pytest.mark.parametrize("law", [law for law in LAWS if law != "two faults"])
def test_a_law_of_no_size_changes_nothing_and_a_larger_one_more(law: str) -> None:
    robot, points = declared("asymmetric"), EVERY["asymmetric"].points[:4]
    setting = Setting("linear_delta", robot.parameters, points, 50.0, 3)
    plain = [modes_of("linear_delta", robot.parameters, p).frequencies[3:] for p in points]
    sizes = {"gyroscopic": 300.0, "dashpot": 600.0}

    def changed(size: float) -> float:
        modes = modes_by_law(law, setting, size * sizes.get(law, 0.02))
        return max(float(np.abs(m.frequencies[3:] / f - 1).max()) for m, f in zip(modes, plain, strict=True))

    assert changed(0.0) < 1e-9
    assert 1e-4 < changed(0.5) < changed(1.0)


def test_tables_can_be_made_of_any_outcomes() -> None:
    some = [case for case in cases() if case.number in (0, 1)]
    states = ("named", "wrong", "abstained", "adequate", "partly", "failed")
    values = (("a.mass", 1.0, 0.1, 1.2),)
    outcomes = [
        PlaceOutcome(case, states[i % len(states)], classes=(("a",),), values=values, truth=("a",))
        for i, case in enumerate(some)
    ]
    tables, facts = OnePlace().tables(outcomes), OnePlace().facts(outcomes)
    assert ("all", "value within 3 sigma >= 95 %") in {row[:2] for row in tables["requirements"].rows}
    assert facts["cases of the suites"] == len(list(cases())) > len(outcomes)
