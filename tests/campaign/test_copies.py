"""Files of equal content: no second measurement."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest

from campaign.structures import Frame, write_frf
from campaign.test_frf_campaigns import HEAD, SENSORS, F, in_units
from pkmodes.cli import run


def record(pose: str, *files: str) -> str:
    names = ", ".join(f'"{name}"' for name in files)
    return f'[[record]]\npose = "{pose}"\nkind = "frf"\nfiles = [{names}]\n'


def test_a_copy_under_another_label_is_no_revisit(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    monkeypatch.chdir(tmp_path)
    rng = np.random.default_rng(11)
    for name in ("a.csv", "b.csv"):
        write_frf(Path(name), F, in_units(Frame.build().accelerances(F)), 0.02, rng)
    Path("copy.csv").write_bytes(Path("a.csv").read_bytes())
    head = 'repeatability = "revisits"\n' + HEAD + SENSORS
    Path("c.toml").write_text(head + record("P1", "a.csv") + record("P2", "copy.csv"), encoding="utf-8")
    assert run(["identify", "c.toml", "--out", "modes.csv"]) == 2
    said = " ".join(capsys.readouterr().err.split())
    assert "expected new measurements under P1 and P2, found the same content in both" in said
    assert "a.csv, copy.csv" in said
    assert not Path("modes.csv").exists()
    Path("c.toml").write_text(head + record("P1", "a.csv") + record("P2", "b.csv"), encoding="utf-8")
    assert run(["identify", "c.toml", "--out", "modes.csv"]) == 0


def test_a_copy_among_repeats_is_said(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    monkeypatch.chdir(tmp_path)
    write_frf(Path("a.csv"), F, in_units(Frame.build().accelerances(F)), 0.02, np.random.default_rng(12))
    Path("b.csv").write_bytes(Path("a.csv").read_bytes())
    Path("c.toml").write_text(HEAD + SENSORS + record("P1", "a.csv", "b.csv"), encoding="utf-8")
    assert run(["identify", "c.toml", "--out", "modes.csv"]) == 0
    assert "P1: b.csv is a copy of a.csv" in " ".join(capsys.readouterr().err.split())
