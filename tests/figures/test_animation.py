"""A mode as an animated GIF."""

from __future__ import annotations

from io import BytesIO
from pathlib import Path

import numpy as np
import pytest
from PIL import Image

import pkmodes
from pkmodes.cli import run
from pkmodes.plots.animation import FRAMES, animation
from pkmodes.view import scene

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
        assert image.n_frames == FRAMES
        for k in range(FRAMES):
            image.seek(k)
            frames.append(np.asarray(image.convert("RGB")).astype(int))
    moved = [int((np.abs(frame - frames[0]) > 40).any(axis=-1).sum()) for frame in frames]
    assert moved[FRAMES // 4] > 200  # pixels
    assert moved[3 * FRAMES // 4] > 200
    assert moved[FRAMES // 2] < moved[FRAMES // 4] / 10
    assert target.stat().st_size < 500_000


def test_it_is_the_same_at_every_run() -> None:
    still = scene(pkmodes.load("robots/corexy-printer.toml"), [0.15, 0.2])
    first = animation(still)
    assert first == animation(still)
    assert first != animation(still, still.rigid_modes + 1)
    with Image.open(BytesIO(first)) as image:
        assert image.format == "GIF"


def test_a_mode_that_does_not_exist_is_refused(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    target = tmp_path / "mode.gif"
    command = ["show", "robots/corexy-printer.toml", "--pose=0.15,0.2", "--mode", "3", "--out", str(target)]
    assert run(command) == 2
    assert "expected a vibration mode up to 2, found 3 (--mode)" in capsys.readouterr().err
    assert not target.exists()
