"""The reachable workspace found by itself, against brute force."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest

import pkmodes
from helpers.robots.robot_text import edited, published
from pkmodes.core.base.errors import PoseError
from pkmodes.machine.maps.workspace import DEFAULT_POSES, box_of, grid_over_workspace

ROBOTS = Path(__file__).parents[3] / "robots"


def declared(folder: Path, text: str) -> pkmodes.Model:
    (folder / "robot.toml").write_text(text, encoding="utf-8")
    return pkmodes.load(folder / "robot.toml")


def brute_force(model: pkmodes.Model, low: np.ndarray, high: np.ndarray, count: int = 61) -> np.ndarray:
    """All poses of a fine grid, twice as large as the box, that can be evaluated and are in the same assembly."""
    size = high - low
    axes = [np.linspace(a - s / 2, b + s / 2, count) for a, b, s in zip(low, high, size, strict=True)]
    points = np.stack(np.meshgrid(*axes, indexing="ij"), axis=-1).reshape(-1, len(axes))
    good = points[model.check(points).valid]
    inside = good[((good >= low) & (good <= high)).all(axis=1)]
    assert len(inside)
    if model.has_assemblies:
        good = good[model.assembly(good) == model.assembly(inside[:1])]
    return good


def expect_box(model: pkmodes.Model, part: float = 0.02) -> None:
    """The box holds every pose of the assembly that brute force finds, but for a small part of its size."""
    low, high = box_of(model)
    good = brute_force(model, low, high)
    size = high - low
    assert (good.min(axis=0) > low - part * size).all(), (low, good.min(axis=0))
    assert (good.max(axis=0) < high + part * size).all(), (high, good.max(axis=0))


@pytest.mark.parametrize(
    "robot", ["linear-delta-2022", "linear-delta-2022-identified", "clavel-delta", "corexy-printer"]
)
def test_the_box_of_supplied_robots_is_that_of_brute_force(robot: str) -> None:
    expect_box(pkmodes.load(ROBOTS / f"{robot}.toml"))


CHANGES = {
    "short links": ('length = "400 mm"', 'length = "250 mm"'),
    "rails of different length": ('limits = ["0 m", "1.2 m"]', 'limits = ["0.3 m", "0.8 m"]'),
    "a tilted rail": ("direction = [1, 0, 0]", "direction = [0.9, 0.3, 0.3]"),
    "a carriage with a length": ('length = "0 mm"', 'length = "80 mm"'),
}


@pytest.mark.parametrize("change", CHANGES)
def test_changed_robots(tmp_path: Path, change: str) -> None:
    expect_box(declared(tmp_path, edited(*CHANGES[change])))


@pytest.mark.parametrize("factor", [1e-3, 250.0])
def test_tiny_and_huge_robots_have_the_same_workspace_in_their_size(tmp_path: Path, factor: float) -> None:
    """All lengths of a robot times a factor: so is its box; 250 makes links of 100 m."""
    import re

    def scaled(match: re.Match[str]) -> str:
        return f'"{float(match[1]) * factor:.12g} {match[2]}"'

    text = re.sub(r'"(-?[\d.]+) (mm|m)"', scaled, published())
    assert text != published()
    low, high = box_of(pkmodes.load(ROBOTS / "linear-delta-2022.toml"))
    model = declared(tmp_path, text)
    small, large = box_of(model)
    np.testing.assert_allclose(np.r_[small, large] / factor, np.r_[low, high], atol=0.02)
    grid = grid_over_workspace(model)
    assert DEFAULT_POSES / 3.0 < np.prod(grid.shape) < 3.0 * DEFAULT_POSES
    assert model.check(grid.points(np.arange(np.prod(grid.shape)))).valid.mean() > 0.2


def test_one_assembly_only() -> None:
    """The platform hangs below the rails, and could be above them: only one is mapped."""
    model = pkmodes.load(ROBOTS / "linear-delta-2022.toml")
    low, high = box_of(model)
    assert high[2] <= 0.01
    lifted = model.with_values({"gravity": [0.0, 0.0, 9.81]})
    low, high = box_of(lifted)
    assert low[2] >= -0.01, "the lower one, as gravity goes"


def test_the_grid_has_round_values_and_one_step() -> None:
    grid = grid_over_workspace(pkmodes.load(ROBOTS / "linear-delta-2022.toml"))
    steps = {round(float(step), 9) for axis in grid.axes.values() for step in np.diff(axis)}
    assert len(steps) == 1
    (step,) = steps
    assert f"{step:e}"[0] in "125"
    for axis in grid.axes.values():
        np.testing.assert_allclose(axis / step, np.round(axis / step), atol=1e-9)
    assert DEFAULT_POSES / 3.0 < np.prod(grid.shape) < 3.0 * DEFAULT_POSES


def test_a_thin_workspace() -> None:
    """Carriages that move by half a millimetre only."""
    model = pkmodes.load(ROBOTS / "linear-delta-2022.toml")
    middle = model.inverse_kinematics([0.6, 0.03, -0.245])
    half = {"min": -2.5e-4, "max": 2.5e-4}
    ends = {
        f"axis.{i + 1}.limits.{end}": float(x) + by for i, x in enumerate(middle) for end, by in half.items()
    }
    thin = model.with_values(ends)
    low, high = box_of(thin)
    assert (np.abs((low + high) / 2 - [0.6, 0.03, -0.245]) < 1e-3).all()
    assert (high - low < 2e-3).all()
    assert thin.map()["valid"].sum() > 1000


def test_a_workspace_in_which_nothing_can_be_reached(tmp_path: Path) -> None:
    model = declared(tmp_path, edited('length = "400 mm"', 'length = "1 mm"'))
    with pytest.raises(PoseError, match="poses drawn can be reached") as error:
        model.map()
    assert "robot.toml" in error.value.where


def test_the_same_grid_every_time() -> None:
    model = pkmodes.load(ROBOTS / "clavel-delta.toml")
    first, again = grid_over_workspace(model), grid_over_workspace(model)
    for name, values in first.axes.items():
        np.testing.assert_array_equal(values, again.axes[name])
