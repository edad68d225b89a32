"""examples/roving_hammer, tapped_printer and hexapod: the rig writes their files again; the pages name the causes."""

from __future__ import annotations

import shutil
from pathlib import Path

import numpy as np

from pkmodes.signals.functions import SignalRequest
from pkmodes.signals.reading import read_signals
from pkmodes_rig.signals import roving_hammer, tapped_hexapod, tapped_printer

EXAMPLES = Path(__file__).resolve().parents[3] / "examples"


def test_the_rig_writes_the_blows_of_the_roving_hammer_again(tmp_path: Path) -> None:
    stored = EXAMPLES / "roving_hammer"
    roving_hammer.write(tmp_path)
    assert {one.name for one in tmp_path.iterdir()} == {
        one.name for one in stored.iterdir() if one.name not in ("README.md", "campaign.toml")
    }
    assert (tmp_path / "robot.toml").read_text("utf-8") == (stored / "robot.toml").read_text("utf-8")
    for name in ("P1_x_1.uff", "P4_p_z.uff"):
        made, kept = (read_signals(folder / name, SignalRequest()).functions for folder in (tmp_path, stored))
        for one, other in zip(made, kept, strict=True):
            # Other libraries of linear algebra round otherwise; the files have single precision.
            np.testing.assert_allclose(
                one.values, other.values, rtol=0, atol=1e-5 * np.abs(other.values).max()
            )


def test_the_rig_writes_the_recordings_of_the_tapped_printer_again(tmp_path: Path) -> None:
    stored = EXAMPLES / "tapped_printer"
    shutil.copy(stored / "robot.toml", tmp_path)
    tapped_printer.write(tmp_path)
    names = sorted(one.name for one in tmp_path.glob("*.csv"))
    assert names == sorted(one.name for one in stored.glob("*.csv"))
    for name in names:
        made, kept = ((folder / name).read_text("utf-8").splitlines() for folder in (tmp_path, stored))
        assert (made[0], made[-1]) == (kept[0], kept[-1])
        one, other = (np.loadtxt(lines[1:-1], delimiter=",") for lines in (made, kept))
        apart = np.abs(one - other)
        # A value at the edge of a step may be rounded the other way elsewhere.
        assert apart.max() < 1.1 * tapped_printer.DIGIT / tapped_printer.GRAVITY
        assert (apart > 0.0).mean() < 0.01


def test_the_oracle_writes_the_functions_of_the_hexapod_again(tmp_path: Path) -> None:
    stored = EXAMPLES / "hexapod"
    poses = tapped_hexapod.POSES
    assert {f"{label}_{k}.uff" for label in poses for k in (1, 2)} == {
        one.name for one in stored.glob("*.uff")
    }
    shutil.copy(stored / "robot.toml", tmp_path)
    for name, contents in tapped_hexapod.files(tmp_path, dict(list(poses.items())[:2])):
        (tmp_path / name).write_bytes(contents)
        made, kept = (read_signals(folder / name, SignalRequest()).functions for folder in (tmp_path, stored))
        for one, other in zip(made, kept, strict=True):
            np.testing.assert_allclose(
                one.values, other.values, rtol=0, atol=1e-5 * np.abs(other.values).max()
            )
