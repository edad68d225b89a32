"""What a standard deviation includes: what was not seen up to its limit, a default that nobody declared; and no more.

Measured is a bed slinger by hand (`bed_slinger_by_hand`).  With free motors the frequencies of its axes depend on
k (1 / m + R^2 / J) alone: stiffer belts with heavier rotors are the same machine, whatever their size.
"""

from __future__ import annotations

from collections.abc import Sequence
from pathlib import Path

import numpy as np
import pytest

from helpers.diagnoses.diagnose_command import call
from helpers.references.bed_slinger_by_hand import ROBOT, Frame, frequencies, measured
from pkmodes import Model, read_robot, updating
from pkmodes.core.robot.robot import Robot
from pkmodes.loop.diagnosis.verdict.findings import Corrected, Unseen, explain_saved_sigma
from pkmodes.loop.diagnosis.verdict.result import Diagnosis

POSES = [tuple(pose) for pose in np.random.default_rng(42).uniform(0.01, 0.22, (12, 2)).round(4)]
FACTORS = [f"effects.axis_belt_stiffness.factor_{k}" for k in (1, 2)]


@pytest.fixture
def robot(tmp_path: Path) -> Path:
    file = tmp_path / "slinger.toml"
    file.write_text(ROBOT, encoding="utf-8")
    return file


def diagnosed(robot: Path, text: str, candidates: Sequence[str] | None = None) -> tuple[Robot, Diagnosis]:
    modes = robot.parent / "modes.csv"
    modes.write_text(text, encoding="utf-8")
    declared = read_robot(robot)
    return declared, updating.diagnose(declared, updating.read(modes), candidates=candidates)


def test_the_machine_by_hand_is_the_machine_of_the_file(robot: Path) -> None:
    model = Model(read_robot(robot))
    for x, y in POSES[:3]:
        by_hand = np.sort(np.concatenate([frequencies(0, x), frequencies(1, y)]))
        assert model.frequencies([x, y])[2:] == pytest.approx(by_hand, rel=1e-9)


def test_a_candidate_without_a_limit_is_named_and_not_counted(robot: Path) -> None:
    declared, found = diagnosed(robot, measured(POSES, 7, factors=(-0.08, 0.0)))
    assert (found.verdict, [effect.name for effect in found.effects]) == (
        "effect_found",
        ["axis_belt_stiffness"],
    )
    # Heavier rotors with stiffer belts are the same machine: nothing bounds them.
    assert found.limits["gearbox_inertia.inertia"].value is None
    values = {value.name: value for value in found.corrected}
    for name, truth in zip(FACTORS, (-0.08, 0.0), strict=True):
        value = values[name]
        assert value.saved_sigma < 0.3
        assert abs(value.value - truth) < 2.0 * value.saved_sigma
        assert value.unseen is not None
        assert value.unseen.unbounded
        agent = value.unseen.unbounded.replace("parameter:", "error in ")
        expected = f"it does not allow for an undetected {agent}, which these data do not bound"
        assert expected in explain_saved_sigma(value, found.corrected)
    saved = robot.parent / "saved.toml"
    updating.save_robot(declared, found, saved)
    assert "sigma does not allow for an undetected " in saved.read_text(encoding="utf-8")
    assert (
        updating.diagnose(read_robot(saved), updating.read(robot.parent / "modes.csv")).verdict == "adequate"
    )


def test_the_command_shows_the_value_that_was_found(robot: Path) -> None:
    modes = robot.parent / "modes.csv"
    modes.write_text(measured(POSES, 7, factors=(-0.08, 0.0)), encoding="utf-8")
    code, out, err = call(robot, modes)
    assert (code, err) == (0, "")
    line = next(line for line in out.splitlines() if line.startswith("axis_belt_stiffness.factor_1"))
    value, sigma = map(float, line.split()[2::2][:2])
    assert value == pytest.approx(-0.08, abs=0.02)
    assert 0.05 < sigma < 0.3
    assert "it does not allow for an undetected " in " ".join(out.split())


def test_a_standard_deviation_is_at_most_what_is_plausible() -> None:
    value = Corrected("a", 0.1, 0.02, "1", 0.0, None, False, Unseen(5.0, "b"), plausible=1.0)
    assert value.saved_sigma == 1.0
    assert Corrected(
        "a", 0.1, 0.02, "1", 0.0, None, False, Unseen(0.3, "b"), 1.0
    ).saved_sigma == pytest.approx(np.hypot(0.02, 0.3))


@pytest.mark.parametrize("declared", [False, True])
def test_one_direction_of_a_frame_is_claimed_only_with_its_mass_declared(robot: Path, declared: bool) -> None:
    """With any mass, one further mode along y is explained by some frame, whatever it is."""
    if declared:
        robot.write_text(ROBOT + '[frame]\nmass = "50 kg"\n', encoding="utf-8")
    # The whole frame, whose mode along x the errors may hide, is another explanation.
    candidates = [
        "frame_compliance.compliance_y",
        "payload",
        "belt_mass",
        "gearbox_compliance",
        "cable_stiffness",
    ]
    _, found = diagnosed(robot, measured(POSES, 3, frames=(None, Frame(50.0, 1.07e-8))), candidates)
    if declared:
        assert [effect.name for effect in found.effects] == ["frame_compliance.compliance_y"]
    else:
        assert (found.verdict, found.rule) == ("ambiguous", "claims.default")
        assert not found.effects
        assert "a frame.mass of 50 kg, which the robot file does not declare" in found.reason


@pytest.mark.parametrize("declared", [False, True])
def test_a_value_that_rests_on_a_default_says_so_and_includes_what_is_unknown(
    robot: Path, declared: bool
) -> None:
    """A frame that yields alike in x and y: with its mass declared, its compliance is known far better."""
    if declared:
        robot.write_text(ROBOT + '[frame]\nmass = "50 kg"\n', encoding="utf-8")
    frame = Frame(50.0, 1.3e-8)
    _, found = diagnosed(robot, measured(POSES, 4, frames=(frame, frame)))
    assert (found.verdict, [effect.name for effect in found.effects]) == (
        "effect_found",
        ["frame_compliance"],
    )
    (value,) = (value for value in found.corrected if value.name == "effects.frame_compliance.compliance")
    assert abs(value.value - frame.compliance) < 3.0 * value.sigma
    default = "for a frame.mass of 50 kg, which is assumed"
    assert (default in found.reason) == (default in str(found)) == (not declared)
    assert value.unseen is not None
    assert (value.unseen.default == "a frame.mass of 50 kg") == (not declared)
    assert (value.saved_sigma > 5.0 * value.sigma) == (not declared)
