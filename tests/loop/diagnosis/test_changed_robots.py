"""What changed on a robot between two campaigns: states of files, the command, and the values that both share."""

from __future__ import annotations

import json
from dataclasses import replace
from pathlib import Path

import jsonschema
import numpy as np
import pytest

from helpers.commands.answers import answer
from pkmodes import read_robot, updating
from pkmodes.core.base.errors import MeasurementError, PkmodesError
from pkmodes.loop.diagnosis.states.counterparts import expected_modes, pair_with_expected
from pkmodes.loop.diagnosis.states.shared_shapes import corrected_shapes
from pkmodes.loop.measured.measurements import Measurements
from pkmodes.loop.measured.same_modes import close_groups
from pkmodes.loop.measured.writing import as_csv
from pkmodes.loop.updating.changes import exchange_candidates
from pkmodes.loop.updating.measured_robot import MeasuredRobot
from pkmodes.loop.updating.reading import read_states
from pkmodes.loop.updating.shared_values import axis_deviations, changes_in_use

EXAMPLE = Path(__file__).parents[3] / "examples" / "changed_printer"
ROBOT, BEFORE, AFTER = (str(EXAMPLE / name) for name in ("robot.toml", "before.csv", "after.csv"))
ROBOTS = EXAMPLE.parents[1] / "robots"


@pytest.fixture(scope="module")
def found() -> updating.changes.Change:  # type: ignore[name-defined]
    robot = read_robot(ROBOT)
    before, after = (updating.read(file, robot=robot) for file in (BEFORE, AFTER))
    return updating.changed(robot, before, after)


def test_the_belt_that_lost_stiffness_is_named(found) -> None:  # type: ignore[no-untyped-def]
    """What the rig knows (README of the example): belt 2 has lost 5.2 %, all belts gained 0.15 %."""
    assert found.changed is True
    assert found.states == ("before", "after")
    (group,) = found.beyond.classes
    assert group.finding.members[0] == "parameter:axis.2.belt.specific_stiffness"
    assert len(group.finding.members) <= 5
    (value,) = group.finding.alternatives["parameter:axis.2.belt.specific_stiffness"]
    before = next(one.declared for one in group.corrected if one.name == value.name)
    change, sigma = value.value / before - 1.0, value.sigma / before
    assert abs(change + 0.0516) < 3.0 * sigma
    assert found.model_error > 0.015


def test_the_json_says_in_which_state_and_what_was_before(found) -> None:  # type: ignore[no-untyped-def]
    content = found.as_json()
    assert content["states"] == ["before", "after"]
    assert content["changed"] is True
    assert all(one["state"] == "after" for terms in content["beyond"]["classes"] for one in terms["members"])
    before = updating.read(BEFORE)
    lines = dict(zip(before.lines.tolist(), before.frequency.tolist(), strict=True))
    compared = [row for row in content["rows"] if row["trusted_line"] is not None]
    assert len(compared) == 33
    assert all(row["trusted_hz"] == lines[row["trusted_line"]] for row in compared)
    assert all(abs(row["frequency_hz"] / row["trusted_hz"] - 1.0) < 0.05 for row in compared)


# Files -------------------------------------------------------------------------------------------------------------


def test_states_of_one_file(tmp_path: Path) -> None:
    """A column names the state of each row, a comment that of all; both read the same as two files."""
    robot = read_robot(ROBOT)
    text = Path(BEFORE).read_text(encoding="utf-8").splitlines()
    table = [line for line in text if not line.startswith("#")]
    named = [f"{line},{state}" for state in ("May", "June") for line in table[1:]]
    both = tmp_path / "both.csv"
    both.write_text("\n".join([f"{table[0]},state", *named]) + "\n", encoding="utf-8")
    found = read_states(both, robot=robot)
    assert list(found) == ["May", "June"]
    alone = updating.read(BEFORE, robot=robot)
    for data in found.values():
        np.testing.assert_array_equal(data.frequency, alone.frequency)
        assert data.labels == alone.labels
    assert found["May"].state == "May"
    with pytest.raises(MeasurementError) as refused:
        updating.read(both, robot=robot)
    assert 'found "May", "June"' in refused.value.what
    assert "pkmodes changed" in refused.value.remedy
    commented = tmp_path / "commented.csv"
    commented.write_text("# state: May\n" + "\n".join(table) + "\n", encoding="utf-8")
    data = updating.read(commented, robot=robot)
    assert data.state == "May"
    again = tmp_path / "again.csv"
    again.write_text(as_csv(data), encoding="utf-8")
    assert updating.read(again, robot=robot).state == "May"


@pytest.mark.parametrize(
    ("rows", "what"),
    [
        (["P1,0,0,0.3,60,0.1,a", "P1,0,0,0.3,70,0.1,"], "expected a state in every row or in none"),
        (["# state: b", "P1,0,0,0.3,60,0.1,a"], 'expected "b", as stated for all rows, found "a"'),
        (["# state:", "P1,0,0,0.3,60,0.1,a"], "expected the name of a state, found nothing"),
    ],
)
def test_bad_states_in_a_file_are_refused(tmp_path: Path, rows: list[str], what: str) -> None:
    file = tmp_path / "modes.csv"
    file.write_text("\n".join(["pose,x,y,z,frequency,sigma,state", *rows]) + "\n", encoding="utf-8")
    with pytest.raises(MeasurementError) as refused:
        read_states(file, robot=read_robot(ROBOT))
    assert what in refused.value.what
    assert "modes.csv: line" in refused.value.where


def test_the_command_says_what_is_wrong(tmp_path: Path) -> None:
    held = tmp_path / "held.csv"
    held.write_text("# drives: held\n" + Path(AFTER).read_text(encoding="utf-8"), encoding="utf-8")
    copy = tmp_path / "copy.csv"
    copy.write_bytes(Path(BEFORE).read_bytes())
    other = tmp_path / "other"
    other.mkdir()
    (other / "before.csv").write_bytes(Path(AFTER).read_bytes())
    cases = {
        (BEFORE,): 'expected two states or more, found "before" only',
        (BEFORE, str(copy)): "have the same frequencies: they are one measurement",
        (BEFORE, str(held)): 'the motors were free in "before", and held in "held"',
        (BEFORE, str(other / "before.csv")): 'two states are called "before"',
        (ROBOT, BEFORE): "expected ROBOT.toml before MODES.csv",
        (BEFORE, str(tmp_path / "none.csv")): "none.csv",
    }
    for files, what in cases.items():
        said = answer("changed", ROBOT, *files) if files[0] != ROBOT else answer("changed", BEFORE, ROBOT)
        assert said.code == 2
        assert what in said.err, said.err
        assert "Traceback" not in said.err


def test_another_machine_is_refused() -> None:
    said = answer("changed", str(ROBOTS / "corexy-printer.toml"), BEFORE, AFTER)
    assert said.code == 2
    assert "another machine" in said.err or "expected poses with" in said.err


def test_arguments_in_python_are_checked() -> None:
    robot = read_robot(ROBOT)
    before = updating.read(BEFORE, robot=robot)
    for later in (None, [], "after.csv", {"after": "after.csv"}):
        with pytest.raises(PkmodesError) as refused:
            updating.changed(robot, before, later)  # type: ignore[arg-type]
        assert refused.value.remedy


# What both share ---------------------------------------------------------------------------------------------------


def test_masses_inertias_and_stiffnesses_of_each_axis_are_shared() -> None:
    parameters, moves = axis_deviations(read_robot(ROBOT))
    names = {p.name for p in parameters}
    assert names == moves.keys()
    assert {f"shared.axis.{j}.belt.specific_stiffness" for j in (1, 2, 3)} <= names
    assert "shared.platform.mass" in names
    assert not any("radius" in name or "length" in name or "origin" in name for name in names)
    for p in parameters:
        assert p.value == 0.0
        assert p.sigma == pytest.approx(0.03 * moves[p.name].value) or moves[p.name].value == 0.0


def test_parts_that_act_like_what_changes_in_use_are_no_candidates() -> None:
    """A wider belt is a stiffer one; a larger pulley also turns more slowly."""
    robot = read_robot(ROBOT)
    known = robot.with_values(
        {path: {"sigma": None} for path, value in robot.quantities.items() if value.sigma}
    )
    structure = MeasuredRobot.of(known, updating.read(BEFORE, robot=known)).structure()
    parts = {one.name: one.odds for one in exchange_candidates(structure)}
    assert "parameter:axis.2.belt.width" not in parts
    assert "parameter:axis.2.belt.specific_stiffness" not in parts
    assert parts["parameter:axis.2.pulley.radius"] == 0.1
    assert parts["parameter:axis.2.pulley.inertia"] == 0.1


def test_lengths_and_ratios_do_not_change_in_use() -> None:
    from pkmodes.loop.diagnosis.problem import Candidate

    robot = read_robot(ROBOT)
    for name, changes in {
        "parameter:axis.2.belt.specific_stiffness": True,
        "parameter:carriage.mass": True,
        "gearbox_compliance": True,
        "measurement:offset.x": True,
        "parameter:axis.1.pulley.radius": False,
        "parameter:motor.gear_ratio": False,
        "parameter:axis.1.origin.x": False,
        "parameter:axis.span": False,
        "parameter:belt.width": False,
    }.items():
        assert changes_in_use(robot, Candidate(name, ())) is changes, name


# The same modes in both --------------------------------------------------------------------------------------------


def one_setup(frequency: list[float], shapes: list[list[float]] | None = None) -> Measurements:
    columns = None if shapes is None else {f"c{k}": column for k, column in enumerate(np.array(shapes).T)}
    return Measurements.from_rows(
        ["P1"] * len(frequency), frequency, [0.002 * f for f in frequency], shapes=columns
    )


def test_modes_are_paired_with_what_was_measured_before() -> None:
    """The model has modes at 50, 60 and 100 Hz; the trusted state the first two, at 52 and 57 Hz."""
    trusted = one_setup([52.0, 57.0])
    expected = expected_modes(
        np.log([50.0, 60.0, 100.0]), 0.02, np.zeros((3, 0)), trusted, (), np.array([0, 1]), 0
    )
    assert expected.trusted_row.tolist() == [0, 1, -1]
    later = one_setup([51.5, 56.8, 101.0])
    pairs = pair_with_expected(expected, later, np.arange(3), np.zeros(0))
    assert sorted(pairs) == [(0, 0), (1, 1), (2, 2)]


def test_a_mode_missed_before_is_not_taken_for_another() -> None:
    """86.5 Hz were measured before; 66.5 Hz, a mode of the model that was missed then, is not that one."""
    trusted = one_setup([86.5])
    expected = expected_modes(np.log([66.0, 86.0]), 0.02, np.zeros((2, 0)), trusted, (), np.array([1]), 0)
    (pair,) = pair_with_expected(expected, one_setup([66.5]), np.arange(1), np.zeros(0))
    assert pair == (0, 0)
    assert expected.trusted_row[0] == -1


def test_close_modes_are_paired_by_their_order_whatever_their_shapes() -> None:
    """0.4 % apart: any change rotates them into each other, so that shapes do not tell which is which."""
    axes = [[1.0, 0.0, 0.1], [0.0, 1.0, 0.1]]
    trusted, later = one_setup([100.0, 100.4], axes), one_setup([99.0, 99.5], axes[::-1])
    shapes = np.array(axes)
    channels = ("c0", "c1", "c2")
    expected = expected_modes(np.log([100.0, 100.4]), 0.02, shapes, trusted, channels, np.array([0, 1]), 0)
    pairs = pair_with_expected(expected, later, np.arange(2), np.ones(3))
    assert sorted(pairs) == [(0, 0), (1, 1)]
    assert close_groups(np.log([100.0, 150.0, 100.4]), np.full(3, 1e-4)).tolist() == [
        0,
        1,
        0,
    ]


def test_the_change_of_a_shape_is_that_of_two_measurements() -> None:
    """The model's shape plus the difference of both, whatever their scales and signs."""
    mode = np.array([1.0, 0.5, -0.2])
    wrong, change = np.array([0.05, -0.03, 0.02]), np.array([0.0, 0.1, 0.0])
    before, after = -3.0 * (mode + wrong), 0.7 * (mode + wrong + change)
    trusted, later = (
        Measurements.from_rows(
            ["P1"], [50.0], [0.1], shapes={f"c{k}": [x] for k, x in enumerate(shape)}, shape_sigma=0.02
        )
        for shape in (before, after)
    )
    shapes, sigma = corrected_shapes(trusted, later, np.array([0]), mode[None], np.ones(3))
    # To first order: the scales of least squares take off what is along the shape itself.
    along = mode @ change / (mode @ mode)
    np.testing.assert_allclose(shapes[0], mode + change - along * mode, atol=0.02)
    assert sigma[0] == pytest.approx(np.sqrt(2.0) * 0.02, rel=0.15)
    same, _ = corrected_shapes(trusted, trusted, np.array([0]), mode[None], np.ones(3))
    np.testing.assert_allclose(same[0], mode, atol=1e-12)
    alone, own = corrected_shapes(trusted, later, np.array([-1]), mode[None], np.ones(3))
    np.testing.assert_array_equal(alone, later.shapes)
    np.testing.assert_array_equal(own, later.shape_sigma)
    # Where the sensors stand, the mode of the model does not move.
    still, _ = corrected_shapes(trusted, later, np.array([0]), np.zeros((1, 3)), np.ones(3))
    assert np.isnan(still).all()


def test_several_later_states_have_one_page_and_each_its_result(tmp_path: Path) -> None:
    """The third campaign is the first one, each frequency 0.1 % higher or lower in turn."""
    again = tmp_path / "again.csv"
    data = updating.read(BEFORE, robot=read_robot(ROBOT))
    factors = 1.0 + 1e-3 * np.where(np.arange(len(data.frequency)) % 2, 1.0, -1.0)
    numbers = {**data.numbers, "frequency": data.frequency * factors}
    again.write_text(as_csv(replace(data, numbers=numbers, state="again")), encoding="utf-8")
    page, out = tmp_path / "page.html", tmp_path / "out.json"
    asked = ["--candidates", "axis_belt_stiffness", "--no-beyond", "--json", str(out), "--report", str(page)]
    assert answer("changed", ROBOT, BEFORE, AFTER, str(again), *asked).code == 0
    content = json.loads(out.read_text(encoding="utf-8"))
    schema = EXAMPLE.parents[1] / "docs" / "schemas" / "changed.schema.json"
    jsonschema.validate(content, json.loads(schema.read_text(encoding="utf-8")))
    assert content["states"] == ["before", "after", "again"]
    assert content["by_state"].keys() == {"after", "again"}
    assert content["by_state"]["again"]["changed"] is False
    assert content["changed"] is True
    assert len(content["rows"]) == 48 + len(data.frequency)
    text = page.read_text(encoding="utf-8")
    assert "again: nothing changed beyond the errors of both" in text


def test_the_command_answers_in_words_and_json(tmp_path: Path) -> None:
    """Several later states, each by itself, and the exit code that was asked for."""
    out = tmp_path / "out.json"
    said = answer(
        "changed",
        ROBOT,
        BEFORE,
        AFTER,
        "--candidates",
        "payload",
        "--no-beyond",
        "--json",
        str(out),
        "--fail-on",
        "any",
    )
    content = json.loads(out.read_text(encoding="utf-8"))
    assert said.code == (content["verdict"] != "adequate")
    assert content["changed"] is not False
    assert "before → after" in said.out or "before -> after" in said.out
