"""How pairs of campaigns are drawn, sized and measured."""

from __future__ import annotations

import pickle
from pathlib import Path
from typing import Any

import numpy as np
import pytest

from pkmodes import read_robot, updating
from pkmodes_rig.one_place import Fault, assembled, modes_of
from pkmodes_rig.one_place.changes import ALL_DRIVES, kinds_of_changes
from studies.changed import MACHINES, cases, pair, some_pairs
from studies.changed_cases import Campaign, Pair, PairCase, measured, written_to
from studies.one_place_cases import CLEAR, FAINT, declared
from studies.specimens import measurements_of
from studies.true_machines import WITHIN


def true_frequencies(
    hidden: Pair, campaign: Campaign, faults: tuple[Fault, ...] = (), drives: float = 1.0
) -> list[np.ndarray]:
    """Frequencies of the true machine where it stood, by the rig alone; values of axes are changed by hand."""
    robot = hidden.robot
    q, mechanism = robot.parameters, robot.mechanism_name
    for fault in faults:
        if fault.form == "parameter":
            _, axis, name = fault.places[0].split(".", 2)
            field = name.replace(".", "_")
            value = np.array(getattr(q, field), dtype=float)
            value[int(axis) - 1] *= 1 + fault.values["change"]
            q = q._replace(**{field: value})
    frame = robot.constants.get("frame_compliance.mass", 50.0)
    points = campaign.visit.points
    return [assembled(mechanism, q, p, faults, frame=frame).modes(drives).frequencies for p in points]


def away(campaign: Campaign, frequencies: list[np.ndarray]) -> float:
    """Mean square of the errors of the rows, in their true standard deviations."""
    errors = [(row.frequency - frequencies[row.pose][row.mode]) / row.sigma for row in campaign.rows]
    return float(np.mean(np.square(errors)))


# The cases -----------------------------------------------------------------------------------------------------


def test_two_hundred_pairs_have_every_kind_of_change_on_every_mechanism() -> None:
    every = cases(7)
    assert len(every) == len({case.label for case in every}) == 200
    assert sum(case.kind == "" for case in every) == 50
    assert {case.seed for case in every} == {7}
    for mechanism, machines in MACHINES.items():
        own = [case for case in every if case.mechanism == mechanism]
        kinds = kinds_of_changes(mechanism, declared(machines[0]).parameters)
        assert {case.kind for case in own} >= {"", *kinds}
        assert {case.machine for case in own} == set(machines)
    changed = [case for case in every if case.kind]
    for half in (
        sum(case.suite == "clear" for case in changed),
        sum(case.realistic for case in changed),
        sum(case.suite == "clear" and case.realistic for case in changed) * 2,
    ):
        assert 60 <= half <= 90


def test_a_pair_is_found_again_by_its_suite_number_and_seed() -> None:
    for case in cases(9)[::37]:
        assert pair(case.suite, case.number, 9) == case


def test_a_sample_begins_with_a_smaller_one_and_has_all_mechanisms() -> None:
    few, more = some_pairs(3, 14), some_pairs(3, 60)
    assert more[:14] == few
    assert len({case.label for case in more}) == 60
    assert {case.mechanism for case in few} == set(MACHINES)
    assert {bool(case.kind) for case in more} == {True, False}
    assert len(some_pairs(3, 1000)) == 200


# What is measured ----------------------------------------------------------------------------------------------

CASES = [
    PairCase("clear", 2, "tower", "payload", seed=11),
    PairCase("sigmas", 3, "corexy", "softer drive", seed=11),
    PairCase("clear", 4, "bed_slinger", "parameter", realistic=True, seed=11),
    PairCase("sigmas", 5, "rotary_delta", "spring between bodies", realistic=True, seed=11),
    PairCase("sigmas", 6, "hexapod", "mass", realistic=True, seed=11),
]


@pytest.mark.parametrize("case", CASES, ids=lambda case: case.label)
def test_a_pair_is_measured_again_the_same(case: PairCase) -> None:
    hidden = measured(case)
    assert hidden == measured(pickle.loads(pickle.dumps(case)))
    assert pickle.loads(pickle.dumps(hidden)) == hidden
    other = measured(PairCase(case.suite, case.number, case.machine, case.kind, case.realistic, 12))
    assert other.faults != hidden.faults
    assert other.trusted.text != hidden.trusted.text


@pytest.mark.parametrize("case", CASES, ids=lambda case: case.label)
def test_a_change_is_as_large_as_asked(case: PairCase) -> None:
    """Modes are compared in their order: these changes are small, and exchange none."""
    hidden = measured(case)
    before = true_frequencies(hidden, hidden.later, (), hidden.drives)
    after = true_frequencies(hidden, hidden.later, hidden.faults, hidden.drives)
    rigid = int(np.sum(before[0] < 1.0))
    changes = np.array([np.log(b[rigid:] / a[rigid:]) for a, b in zip(before, after, strict=True)])
    if case.suite == "clear":
        assert CLEAR[0] / WITHIN <= np.sqrt(np.mean(changes**2)) <= CLEAR[1] * WITHIN
        return
    first, second = (
        {(row.pose, row.mode): row.sigma / row.frequency for row in campaign.rows}
        for campaign in (hidden.trusted, hidden.later)
    )
    both = [
        changes[pose, mode - rigid] ** 2 / (first[same, mode] ** 2 + error**2)
        for (pose, mode), error in second.items()
        if (same := hidden.later.visit.alike[pose]) is not None and (same, mode) in first
    ]
    assert FAINT[0] / WITHIN <= np.sqrt(np.sum(both)) <= FAINT[1] * WITHIN


@pytest.mark.parametrize("suite", ["clear", "sigmas"])
@pytest.mark.parametrize("kind", [ALL_DRIVES, "all clamps yield"])
def test_what_changes_on_all_axes_is_more_than_a_temperature_can_do(suite: str, kind: str) -> None:
    """Of all temperatures, none is likely and leaves little of the change; here all modes are found."""
    hidden = measured(PairCase(suite, 1, "cartesian", kind, seed=11))
    assert len({tuple(fault.values.values()) for fault in hidden.faults}) == 1
    sigma = float(np.hypot(*hidden.sigmas))

    def vibrations(faults: tuple[Fault, ...], temperature: float) -> np.ndarray:
        each = true_frequencies(hidden, hidden.later, faults, hidden.drives * (1 + temperature))
        return np.log(np.array(each)[:, 2:])

    changed = vibrations(hidden.faults, 0.0)
    left = [
        np.hypot(np.linalg.norm(changed - vibrations((), t)) / sigma, t / 0.01)
        for t in np.linspace(-0.3, 0.1, 41)
    ]
    assert FAINT[0] / 1.3 <= min(left) <= FAINT[1] * 1.3


@pytest.mark.parametrize("case", [CASES[0], CASES[2]], ids=lambda case: case.label)
def test_the_change_is_in_the_second_campaign_only(case: PairCase) -> None:
    hidden = measured(case)
    assert away(hidden.trusted, true_frequencies(hidden, hidden.trusted)) < 2.0
    changed = true_frequencies(hidden, hidden.later, hidden.faults, hidden.drives)
    assert away(hidden.later, changed) < 2.0
    assert away(hidden.later, true_frequencies(hidden, hidden.later, (), hidden.drives)) > 5.0
    assert away(hidden.trusted, true_frequencies(hidden, hidden.trusted, hidden.faults)) > 5.0


@pytest.mark.parametrize("machine", ["cartesian", "published", "hexapod"])
def test_another_temperature_is_common_to_all_drives(machine: str) -> None:
    field = "leg_stiffness" if machine == "hexapod" else "belt_specific_stiffness"
    every = (measured(PairCase("unchanged", number, machine, seed=11)) for number in range(20))
    hidden = next(one for one in every if abs(one.drives - 1) > 0.012)
    assert hidden.faults == ()
    assert hidden.change == hidden.strength == 0.0
    robot, points = hidden.robot, hidden.later.visit.points
    stiffness = np.array(getattr(robot.parameters, field))

    def at_another(drives: Any) -> list[np.ndarray]:
        q = robot.parameters._replace(**{field: stiffness * drives})
        return [modes_of(robot.mechanism_name, q, p).frequencies for p in points]

    one_alone = np.where(np.arange(len(stiffness)) == 0, hidden.drives, 1.0)
    assert away(hidden.later, at_another(hidden.drives)) < 2.0
    assert away(hidden.later, at_another(one_alone)) > 3.0
    assert away(hidden.trusted, at_another(1.0)) < 2.0


def test_temperatures_of_days_vary_by_a_percent() -> None:
    drives = [measured(PairCase("unchanged", number, "bed_slinger", seed=11)).drives for number in range(40)]
    assert 0.007 < np.std(drives) < 0.013
    assert abs(np.mean(drives) - 1.0) < 0.005


@pytest.mark.parametrize("machine", ["published", "hexapod", "cartesian"])
def test_masses_inertias_and_stiffnesses_are_wrong_and_nothing_else(machine: str) -> None:
    hidden, robot = measured(PairCase("unchanged", 0, machine, seed=11)), declared(machine)
    uncertain = {path.replace(".", "_") for path, quantity in robot.quantities.items() if quantity.sigma}
    factors = []
    for name, value in robot.parameters._asdict().items():
        true, usual = np.asarray(getattr(hidden.robot.parameters, name)), np.asarray(value)
        if not name.endswith(("mass", "inertia", "stiffness")):
            assert np.array_equal(true, usual), name
        elif name not in uncertain:
            factors += list(np.ravel(true / usual))
    assert np.abs(np.array(factors) - 1).max() <= 0.03
    assert len(set(factors)) == len(factors)
    if len(factors) > 5:
        assert np.abs(np.array(factors) - 1).max() > 0.015


@pytest.mark.parametrize("machine", ["asymmetric", "hexapod"])
def test_a_realistic_second_campaign_has_other_poses_sensors_and_errors(machine: str) -> None:
    robot = declared(machine)
    some = [measured(PairCase("unchanged", number, machine, realistic=True, seed=11)) for number in range(6)]
    heads = [[hidden.trusted.text, hidden.later.text] for hidden in some]
    columns = [
        [next(line for line in text.split("\n") if line.startswith("pose")) for text in texts]
        for texts in heads
    ]
    assert sum(first != second for first, second in columns) >= 5
    stated = []
    for hidden in some:
        first, second = hidden.trusted.visit, hidden.later.visit
        repeated = [(i, j) for i, j in enumerate(second.alike) if j is not None]
        assert 9 <= len(repeated) <= 11
        assert 1 <= second.alike.count(None) <= 3
        assert [j for _, j in repeated] != sorted(j for _, j in repeated)
        gaps = np.array([second.points[i] - first.points[j] for i, j in repeated])
        assert 3e-5 < np.std(gaps[:, :3]) < 2e-4
        stated.append(bool(np.array_equal(second.stated, second.points)))
        assert hidden.sigmas[1] != hidden.sigmas[0]
        for campaign in (hidden.trusted, hidden.later):
            assert len(measurements_of(campaign.text, robot).frequency) == len(campaign.rows)
    assert set(stated) == {True, False}


def test_a_pair_can_be_written_as_files_for_the_command_line(tmp_path: Path) -> None:
    case = PairCase("clear", 0, "cartesian", "payload", seed=11)
    hidden = written_to(case, tmp_path / "pair")
    robot = read_robot(tmp_path / "pair/robot.toml")
    assert robot.quantities == declared("cartesian").quantities
    for name, campaign in (("trusted", hidden.trusted), ("later", hidden.later)):
        data = updating.read(tmp_path / f"pair/{name}.csv", robot=robot)
        assert len(data.frequency) == len(campaign.rows)
    assert hidden == measured(case)
