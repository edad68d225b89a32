"""Files of equal content: no second measurement."""

from __future__ import annotations

from pathlib import Path

import numpy as np

from modaltest.campaign.structures import HEAD, Frame, identify, record, refused, write_frf
from modaltest.campaign.test_frf_campaigns import SENSORS, F, in_units


def test_a_copy_under_another_label_is_no_revisit(tmp_path: Path) -> None:
    rng = np.random.default_rng(11)
    for name in ("a.csv", "b.csv"):
        write_frf(tmp_path / name, F, in_units(Frame.build().accelerances(F)), 0.02, rng)
    (tmp_path / "copy.csv").write_bytes((tmp_path / "a.csv").read_bytes())
    first = 'repeatability = "revisits"\n' + HEAD + SENSORS + record("frf", "a.csv")
    said = refused(tmp_path, first + record("frf", "copy.csv", pose="P2"))
    assert "expected new measurements under P1 and P2, found the same content in both" in said
    assert "a.csv, copy.csv" in said
    identify(tmp_path, first + record("frf", "b.csv", pose="P2"))


def test_a_copy_among_repeats_is_said(tmp_path: Path) -> None:
    write_frf(tmp_path / "a.csv", F, in_units(Frame.build().accelerances(F)), 0.02, np.random.default_rng(12))
    (tmp_path / "b.csv").write_bytes((tmp_path / "a.csv").read_bytes())
    found = identify(tmp_path, HEAD + SENSORS + record("frf", "a.csv", "b.csv"))
    assert "P1: b.csv is a copy of a.csv" in found.remarks
