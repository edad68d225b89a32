"""A mode as an animated GIF."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest
from matplotlib.colors import to_hex
from PIL import Image

import pkmodes
from pkmodes.cli import run
from pkmodes.pages.plots import animation as module
from pkmodes.pages.plots.animation import FRAME_COUNT, animation
from pkmodes.pages.plots.style import VERMILLION
from pkmodes.pages.view import scene
from pkmodes.pages.view.camera import camera

POSES = {
    "linear-delta-2022": "0.6,0,-0.245",
    "clavel-delta": "0,0,-0.6",
    "corexy-printer": "0.15,0.2",
}


@pytest.mark.parametrize("robot", POSES)
def test_the_picture_moves_and_returns_to_rest(robot: str, tmp_path: Path) -> None:
    target = tmp_path / "mode.gif"
    command = ["show", f"robots/{robot}.toml", f"--pose={POSES[robot]}", "--mode", "2", "--out", str(target)]
    assert run(command) == 0
    frames = []
    with Image.open(target) as image:
        assert image.format == "GIF"
        assert image.n_frames == FRAME_COUNT
        for k in range(FRAME_COUNT):
            image.seek(k)
            frames.append(np.asarray(image.convert("RGB")).astype(int))
    moved = [int((np.abs(frame - frames[0]) > 40).any(axis=-1).sum()) for frame in frames]
    assert moved[FRAME_COUNT // 4] > 200  # pixels
    assert moved[3 * FRAME_COUNT // 4] > 200
    assert moved[FRAME_COUNT // 2] < moved[FRAME_COUNT // 4] / 10
    assert target.stat().st_size < 500_000
    if robot == "corexy-printer":  # the mode asked for, and the same at every run
        still = scene(pkmodes.load(f"robots/{robot}.toml"), [0.15, 0.2])
        assert target.read_bytes() == animation(still, still.rigid_modes + 1) != animation(still)


def test_a_mode_that_does_not_exist_is_refused(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    target = tmp_path / "mode.gif"
    command = ["show", "robots/corexy-printer.toml", "--pose=0.15,0.2", "--mode", "3", "--out", str(target)]
    assert run(command) == 2
    assert "expected a vibration mode up to 2, found 3 (--mode)" in capsys.readouterr().err
    assert not target.exists()


@pytest.mark.parametrize(("robot", "mode"), [("linear-delta-2022", 2), ("corexy-printer", 1)])
def test_points_and_wheels_move_as_the_mode_by_the_amplitude(
    robot: str, mode: int, monkeypatch: pytest.MonkeyPatch
) -> None:
    """Every frame shows the mode times the sine of the phase; the largest displacement, of rims too, is 5 %."""
    model = pkmodes.load(f"robots/{robot}.toml")
    pose = [float(value) for value in POSES[robot].split(",")]
    still, modes = scene(model, pose), model.modes(pose)
    index = modes.rigid_modes + mode - 1
    drawn = []
    monkeypatch.setattr(
        module,
        "_draw_elements",
        lambda _axes, _scene, points, _mode, turned: drawn.append((points, turned)),
    )
    animation(still, index, 0.05)
    assert len(drawn) == FRAME_COUNT
    points = np.array([one @ camera(still) for one, _ in drawn])  # turned back from the view
    turned = np.array([angles for _, angles in drawn])
    np.testing.assert_allclose(points[0], still.points[0], atol=1e-12)
    phase = np.sin(2.0 * np.pi * np.arange(FRAME_COUNT) / FRAME_COUNT)
    quarter = FRAME_COUNT // 4
    moved = points - points[0]
    np.testing.assert_allclose(moved, phase[:, None, None] * moved[quarter], atol=1e-12)
    np.testing.assert_allclose(turned, phase[:, None] * turned[quarter], atol=1e-12)
    # Platform and wheels in proportion to the shape of the model.
    rows = ["xyz".index(name) for name in still.directions]
    factor = (
        moved[quarter, 0, rows] @ modes.platform_shapes[index] / (modes.platform_shapes[index] ** 2).sum()
    )
    np.testing.assert_allclose(moved[quarter, 0, rows], factor * modes.platform_shapes[index], atol=1e-12)
    rims = []
    for element, angle in zip(still.elements, turned[quarter], strict=True):
        shape = modes.shapes[index, model.coordinates.index(element.turns)] if element.turns else 0.0
        assert angle == pytest.approx(factor * shape, abs=1e-12)
        if element.shape == "wheel":
            rims.append(
                abs(angle) * np.linalg.norm(np.diff(still.points[0, list(element.points[:2])], axis=0))
            )
    largest = max(np.linalg.norm(moved[quarter], axis=-1).max(), *rims)
    assert largest == pytest.approx(0.05 * still.size)


@pytest.mark.parametrize("robot", POSES)
def test_the_view_is_from_the_front_and_above_and_not_mirrored(robot: str) -> None:
    pose = [float(value) for value in POSES[robot].split(",")]
    right, up, towards = module.camera(scene(pkmodes.load(f"robots/{robot}.toml"), pose))
    np.testing.assert_allclose(np.cross(right, up), towards, atol=1e-12)
    np.testing.assert_allclose(
        [right[2], np.linalg.norm(right), np.linalg.norm(up)], [0.0, 1.0, 1.0], atol=1e-12
    )
    assert up[2] > 0.0
    assert towards[2] > 0.0
    assert right[0] > 0.0, "x points to the right"


def test_belts_with_the_most_energy_are_orange() -> None:
    still = scene(pkmodes.load("robots/corexy-printer.toml"), [0.15, 0.2])
    shares = still.shares[0, still.rigid_modes]
    belts = [element for element in still.elements if element.spring >= 0]
    most = next(element for element in belts if element.spring == int(shares.argmax()))
    assert to_hex(module._element_colour(most, shares, float(shares.max()))) == VERMILLION
    assert to_hex(module._element_colour(most, 0.0 * shares, 1.0)) == module.PALE_GREY
    assert (
        module._element_colour(next(e for e in still.elements if e.spring < 0), shares, 1.0)
        == module.STEEL_GREY
    )
