"""Two robots compared: what they declare, and by how much each frequency changes."""

from __future__ import annotations

import itertools
import json
from pathlib import Path

import numpy as np
import pytest

import pkmodes
from helpers.robots.robot_text import PUBLISHED, published
from pkmodes.cli import run
from pkmodes.core.base.errors import PkmodesError, PoseError
from pkmodes.loop.robot_files.differences import differences
from pkmodes.machine.maps.robots_compared import (
    FrequencyChanges,
    ModeChange,
    compare_frequencies,
    incomparable_modes_sentence,
    largest_difference_sentence,
    mode_changes,
)
from pkmodes.machine.maps.workspace import grid_over_workspace, grid_over_workspaces

ROBOTS = Path(__file__).resolve().parents[3] / "robots"


@pytest.fixture(scope="module")
def poses(model: pkmodes.Model) -> np.ndarray:
    """Poses of which some are out of reach."""
    rng = np.random.default_rng(11)
    return rng.uniform([0.2, -0.15, -0.3], [1.0, 0.15, -0.15], (60, 3))


def read(folder: Path, text: str, name: str = "other.toml") -> pkmodes.Model:
    path = folder / name
    path.write_text(text, encoding="utf-8")
    return pkmodes.load(path)


def test_belts_stiffer_by_21_per_cent_raise_every_frequency_by_10(poses: np.ndarray) -> None:
    """Without gravity all of the stiffness is that of the belts: f goes with its square root, shapes stay."""
    light = pkmodes.load(PUBLISHED).with_values({f"gravity.{name}": 0.0 for name in "xyz"})
    stiff = light.with_values(
        {"belt.specific_stiffness": 1.21 * light.robot.quantities["belt.specific_stiffness"].value}
    )
    for drives in ("free", "held"):
        changes = compare_frequencies(light, stiff, poses, drives)
        valid = light.check(poses).valid
        assert 0 < valid.sum() < len(poses)
        assert changes.counts.as_json() == {
            "both": valid.sum(),
            "first_only": 0,
            "second_only": 0,
            "none": len(poses) - valid.sum(),
        }
        for mode in mode_changes(changes):
            assert mode.poses == valid.sum()
            assert (mode.low, mode.median, mode.high) == pytest.approx((0.1, 0.1, 0.1), abs=1e-9)
            assert (mode.partner, mode.exchanged) == (mode.mode, 0.0)
            assert mode.mac == pytest.approx(1.0, abs=1e-9)


def test_modes_keep_the_partner_of_most_similar_shape(model: pkmodes.Model, poses: np.ndarray) -> None:
    """Against all permutations, with the MAC written out from mass matrix and shapes."""
    other = model.with_values({"platform.mass": 0.6, "axis.2.belt.width": 0.005})
    changes = compare_frequencies(model, other, poses)
    exchanged = unlike = 0
    for i in np.flatnonzero(model.check(poses).valid):
        M = model.matrices(poses[i])[0]
        phi, psi = (one.modes(poses[i]).shapes[3:] for one in (model, other))
        f, g = (one.modes(poses[i]).frequencies[3:] for one in (model, other))
        mac = np.array([[(a @ M @ b) ** 2 / (a @ M @ a) / (b @ M @ b) for b in psi] for a in phi])
        best = max(itertools.permutations(range(6)), key=lambda order: mac[range(6), order].sum())
        alike = mac[range(6), best] >= 0.5
        assert changes.partner[i].tolist() == np.where(alike, best, -1).tolist()
        np.testing.assert_allclose(
            changes.relative[i], np.where(alike, g[list(best)] / f - 1.0, np.nan), atol=1e-9
        )
        np.testing.assert_allclose(changes.mac[i], np.where(alike, mac[range(6), best], np.nan), atol=1e-6)
        unlike += 6 - int(alike.sum())
        exchanged += list(best) != list(range(6))
    assert exchanged > 3, "otherwise numbers alone would do"
    assert unlike > 0, "otherwise every pair would be alike"


def test_differences_are_those_to_one_partner() -> None:
    """A mode that has another partner at one pose of ten does not take the frequency of that one into its range."""
    relative = np.array([0.01] * 18 + [3.5] * 2)[:, None]
    partner = np.array([0] * 18 + [1] * 2)[:, None]
    valid = np.ones(20, dtype=bool)
    changes = FrequencyChanges(
        np.zeros((20, 3)), valid, valid, np.ones((20, 1)), relative, partner, np.ones((20, 1)), second_modes=2
    )
    (mode,) = mode_changes(changes)
    assert (mode.poses, mode.partner, mode.exchanged) == (18, 1, pytest.approx(0.1))
    assert (mode.low, mode.median, mode.high) == pytest.approx((0.01, 0.01, 0.01))


def test_modes_that_an_effect_adds_have_no_partner(model: pkmodes.Model, poses: np.ndarray) -> None:
    """Position loops turn the three rigid modes into vibrations below the six others."""
    tied = model.with_values({"effects.servo_stiffness.stiffness": 1.0})
    changes = compare_frequencies(model, tied, poses)
    assert (changes.modes, changes.second_modes) == (6, 9)
    assert [mode.partner for mode in mode_changes(changes)] == [4, 5, 6, 7, 8, 9]
    back = mode_changes(compare_frequencies(tied, model, poses))
    assert [mode.partner for mode in back] == [None, None, None, 1, 2, 3, 4, 5, 6]
    assert back[0].poses == 0
    assert back[0].median is back[0].exchanged is back[0].mac is None


def test_poses_that_only_one_of_them_reaches_are_counted(tmp_path: Path, model: pkmodes.Model) -> None:
    shorter = read(tmp_path, published().replace('"1.2 m"', '"1 m"'))
    grid = grid_over_workspaces([model, shorter], 2_000)
    points = grid.points(np.arange(np.prod(grid.shape)))
    changes = compare_frequencies(model, shorter, points)
    first, second = model.check(points).valid, shorter.check(points).valid
    assert changes.counts.both == (first & second).sum() > 100
    assert changes.counts.first_only == (first & ~second).sum() > 100
    assert np.isnan(changes.relative[~(first & second)]).all()
    assert np.isfinite(changes.relative[first & second]).any(axis=0).all()
    alone = grid_over_workspace(model, 2_000)
    assert all(grid.axes[name][0] <= alone.axes[name][0] + 0.05 for name in "xyz")
    with pytest.raises(PoseError, match="both robots can reach"):
        compare_frequencies(model, shorter, np.array([[9.0, 9.0, 9.0]]))


def test_values_effects_and_choices_that_differ_are_named(tmp_path: Path, model: pkmodes.Model) -> None:
    text = published().replace('mass = "1.5 kg"', 'mass = { value = "1.8 kg", sigma = "2 %" }')
    text = text.replace("branch = 1", "branch = -1", 1)
    text += '\n[effects.payload]\nmass = "0.35 kg"\n[usable]\nx = ["300 mm", "900 mm"]\n'
    other = read(tmp_path, text)
    found = differences(model.robot, other.robot)
    by_path = {value.path: value for value in found.values}
    mass = by_path["platform.mass"]
    assert (mass.first, mass.second, mass.unit) == (1.5, 1.8, "kg")
    assert (mass.first_sigma, mass.second_sigma) == (None, pytest.approx(0.036))
    assert mass.relative == pytest.approx(0.2)
    payload = by_path["effects.payload.mass"]
    assert (payload.first, payload.second, payload.relative) == (None, 0.35, None)
    assert (by_path["usable.x.min"].second, by_path["usable.x.max"].second) == (0.3, 0.9)
    assert by_path.keys() == {"platform.mass", "effects.payload.mass", "usable.x.min", "usable.x.max"}
    assert (found.added, found.removed) == (("payload",), ())
    assert [(one.path, one.first, one.second) for one in found.choices] == [("axis.1.branch", "1", "-1")]
    back = differences(other.robot, model.robot)
    assert (back.added, back.removed) == ((), ("payload",))
    assert differences(model.robot, model.robot).values == ()


def test_a_value_of_one_axis_is_compared_with_the_shared_one(model: pkmodes.Model) -> None:
    own = model.with_values({"axis.2.belt.width": "12 mm"})
    for robots, values in (((model, own), (0.015, 0.012)), ((own, model), (0.012, 0.015))):
        (value,) = differences(*(one.robot for one in robots)).values
        assert value.path == "axis.2.belt.width"
        assert (value.first, value.second) == pytest.approx(values)
    # Where every axis has its own, the shared value of the other robot is theirs.
    every = model.with_values({f"axis.{j}.belt.width": 0.015 for j in (1, 2, 3)})
    assert differences(model.robot, every.robot).values == ()


def test_robots_of_different_mechanisms_are_refused(model: pkmodes.Model) -> None:
    printer = pkmodes.load(ROBOTS / "corexy-printer.toml")
    for call in (
        lambda: differences(model.robot, printer.robot),
        lambda: compare_frequencies(model, printer, np.zeros((1, 3))),
    ):
        with pytest.raises(PkmodesError, match="one mechanism, found linear_delta and corexy"):
            call()


def change(mode: int, median: float, exchanged: float, mac: float) -> ModeChange:
    return ModeChange(mode, 100, median, median - 0.01, median + 0.01, mode, exchanged, mac)


def test_what_leads_is_the_largest_difference_of_a_mode_that_keeps_its_partner() -> None:
    """The difference of a mode that exchanges, or whose shape is another, is that of several motions."""
    kept, small = change(1, -0.031, 0.0, 0.99), change(2, 0.012, 0.1, 0.8)
    exchanged, unlike = change(3, -0.36, 0.11, 0.99), change(4, 0.5, 0.0, 0.79)
    assert largest_difference_sentence([kept, small]) == "Mode 1 changes most: -3.10 % in the median"
    assert incomparable_modes_sentence([kept, small]) == ""
    found = largest_difference_sentence([small, exchanged, unlike])
    assert found == "Mode 2 changes most, of the modes that can be followed: +1.20 % in the median"
    said = incomparable_modes_sentence([kept, small, exchanged, unlike])
    assert said == (
        "modes 3 and 4 cannot be followed: at 11 % of the poses mode 3 has another partner, or none (at most 10 % is "
        "allowed); mode 4 differs in shape: the median MAC is 0.79 (at least 0.8 is needed)"
    )
    assert (
        largest_difference_sentence([exchanged])
        == "No mode can be followed from the first robot to the second"
    )
    assert "shape" not in incomparable_modes_sentence([exchanged])
    assert incomparable_modes_sentence([unlike]).startswith("mode 4 cannot be followed: it differs in shape")
    others = [change(5, 0.1, 0.5, 0.9), change(6, 0.1, 0.2, 0.7)]
    assert incomparable_modes_sentence(others).startswith(
        "modes 5 and 6 cannot be followed: at 20 to 50 % of the poses they have another partner"
    )
    assert largest_difference_sentence([change(1, 4.9e-5, 0.0, 1.0)]) == "No frequency changes"
    nothing = ModeChange(5, 0, None, None, None, None, None, None)
    assert largest_difference_sentence([kept, nothing]).startswith(
        "Mode 1 changes most, of the modes that can be followed"
    )
    assert (
        incomparable_modes_sentence([kept, nothing]) == ""
    )  # it has no partner at all, which another note says


def test_the_terminal_leads_with_what_can_be_compared(capsys: pytest.CaptureFixture[str]) -> None:
    """Between these two deltas modes cross within a small part of the plane."""
    second = str(PUBLISHED.with_name("linear-delta-2022-identified.toml"))
    grid = ("--grid", "x=0.7:0.9:5,y=-0.05:0.05:3,z=-0.245")
    assert run(["compare", str(PUBLISHED), second, *grid, "--json", "-"]) == 0
    found = json.loads(capsys.readouterr().out)
    assert all(mode["exchanged"] > 0.1 for mode in found["modes"])
    assert run(["compare", str(PUBLISHED), second, *grid]) == 0
    said = " ".join(capsys.readouterr().out.split("\n  ")[0].split())
    assert said.endswith(", motors free: No mode can be followed from the first robot to the second")
    assert found["notes"][0].startswith("modes 1, 2, 3, 4, 5 and 6 cannot be followed")
