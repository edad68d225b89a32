"""examples/campaign: the rig writes it again, and from its signals the hidden cause is named."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest

from pkmodes.cli import run
from pkmodes.signals.functions import SignalRequest
from pkmodes.signals.reading import read_signals
from pkmodes_rig.signals import example

FOLDER = Path(__file__).resolve().parents[3] / "examples" / "campaign"


def test_the_rig_writes_the_same_files_again(tmp_path: Path) -> None:
    example.write(tmp_path)
    written = sorted(path.name for path in tmp_path.iterdir())
    assert written == sorted(path.name for path in FOLDER.iterdir() if path.name != "README.md")
    for name in written:
        again, stored = tmp_path / name, FOLDER / name
        if name.endswith(".toml"):
            assert again.read_text(encoding="utf-8") == stored.read_text(encoding="utf-8")
        elif name in ("p1_1.uff", "p5_2.uff"):
            for one, other in zip(
                *(read_signals(path, SignalRequest()).functions for path in (again, stored)), strict=True
            ):
                scale = np.abs(other.values).max()
                # Other libraries of linear algebra round otherwise; the files have single precision.
                np.testing.assert_allclose(one.values, other.values, rtol=0, atol=1e-5 * scale)


def test_the_folder_is_small() -> None:
    sizes = [path.stat().st_size for path in FOLDER.iterdir()]
    assert sum(sizes) < 2_000_000
    assert max(sizes) < 400_000


def test_signals_lead_to_the_cause_and_to_a_robot_that_is_adequate(
    tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    modes, corrected = tmp_path / "modes.csv", tmp_path / "corrected.toml"
    assert run(["identify", str(FOLDER / "campaign.toml"), "--out", str(modes)]) == 0
    assert "p2_3.uff: blow 1" in capsys.readouterr().err
    found = ["diagnose", str(FOLDER / "robot.toml"), str(modes), "--save-robot", str(corrected)]
    assert run(found) == 0
    assert "cause: link_compliance" in capsys.readouterr().out
    assert run(["diagnose", str(corrected), str(modes)]) == 0
    assert "adequate" in capsys.readouterr().out
