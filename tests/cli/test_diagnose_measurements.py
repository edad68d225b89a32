"""``pkmodes diagnose`` with all kinds of measurement files."""

from __future__ import annotations

import json
from pathlib import Path

import numpy as np
import pytest

from helpers.diagnoses.diagnose_command import (
    HEADER,
    PUBLISHED,
    bare,
    call,
    csv_of,
    diagnosed,
    files,
    measured,
    refusal,
    rows_of,
)
from helpers.runs.processes import without_progress

pytestmark = pytest.mark.usefixtures("backend")


def test_labels_ends_of_lines_and_comments_do_not_matter(tmp_path: Path) -> None:
    text = measured()
    labels = {"P1": 'a, "b" [/red] :car:', "P2": "Größe_模式", "P3": "[bold]x", "P4": "P 4"}
    rows = [{**row, "pose": labels[row["pose"]]} for row in rows_of(text)]
    windows = "\ufeff# made on Monday\r\n" + csv_of(rows)
    options = ("--candidates", "payload")
    plain = diagnosed(tmp_path, PUBLISHED, text, *options, "--holdout", "P1,P2")
    other = diagnosed(
        tmp_path, PUBLISHED, windows, *options, "--holdout", '"a, ""b"" [/red] :car:", Größe_模式'
    )
    assert set(other["held_out_poses"]) == {labels["P1"], labels["P2"]}
    assert other["error"] == plain["error"]
    assert other["refitted"] == plain["refitted"]
    answer = call(*files(tmp_path, PUBLISHED, windows), *options, "--holdout", "Größe_模式")
    assert answer.code == 0
    assert "18 measured modes fitted, motors free\n" in answer.out
    assert "Held out of every choice and fit: Größe_模式." in answer.out
    refused = call(*files(tmp_path, PUBLISHED, windows), *options, "--holdout", "P1")
    refusal(refused, 'no pose is called "P1"')


def test_held_out_labels_are_printed_as_they_are_in_the_file(tmp_path: Path) -> None:
    """Not typed as our own sentences are, and not shortened as on a page."""
    labels = {"P1": "P\u20131 10\u207b\u00b3 \u03c3 \u00b5m", "P2": 24 * "label"}
    rows = [{**row, "pose": labels.get(row["pose"], row["pose"])} for row in rows_of(measured())]
    inputs = files(tmp_path, PUBLISHED, csv_of(rows))
    answer = call(*inputs, "--candidates", "payload", "--holdout", ",".join(labels.values()))
    assert (answer.code, without_progress(answer.err)) == (0, "")
    said = (
        " ".join(answer.out.split()).partition("Held out of every choice and fit: ")[2].partition(". The")[0]
    )
    assert sorted(said.split(", ")) == sorted(labels.values())


def test_few_data_of_several_kinds(tmp_path: Path) -> None:
    rows = rows_of(measured())
    lowest = {}
    for row in sorted(rows, key=lambda row: -float(row["frequency"])):
        lowest[row["pose"]] = row
    for part, expected in (
        ([row for row in rows if row["pose"] == "P2"], "adequate"),
        (rows[:2], "insufficient_data"),
        (rows[:1], "insufficient_data"),
        (list(lowest.values())[:2], "insufficient_data"),
        (
            list(lowest.values()),
            "adequate",
        ),  # the priors hold all of two of the three uncertain values but a little
    ):
        found = diagnosed(tmp_path, PUBLISHED, csv_of(bare(part)), "--candidates", "payload")
        assert found["verdict"] == expected
        assert found["held_out_poses"] == []
        if expected == "insufficient_data":
            assert "platform.mass" in found["reason"]
            assert (found["undetectable"] == ["payload"]) == (found["limits"]["payload.mass"] is None)


def test_modes_that_the_model_lacks_are_not_noise(tmp_path: Path) -> None:
    rows = [f"P{i},0.6,{i / 100},-0.24,{5000 + i},1" for i in range(5)]
    inputs = files(tmp_path, PUBLISHED, "\n".join([HEADER, *rows]) + "\n")
    found = call(*inputs, "--candidates", "payload", "--json", "-").json
    assert found["verdict"] == "unexplained"
    assert [row["line"] for row in found["unpaired"]] == [2, 3, 4, 5, 6]
    out = call(*inputs, "--candidates", "payload").out
    assert "unmatched measured modes: line 2, pose P0, 5000 Hz; line 3, pose P1, 5001 Hz;\n" in out


def test_modes_that_were_rigid_may_be_measured(tmp_path: Path) -> None:
    modes = measured(poses=3, effects={"cable_stiffness.stiffness": 4e4})
    assert len(rows_of(modes)) == 27
    inputs = files(tmp_path, PUBLISHED, modes)
    saved = tmp_path / "saved.toml"
    answer = call(*inputs, "--candidates", "cable_stiffness,payload", "--json", "-", "--save-robot", saved)
    (effect,) = answer.json["effects"]
    assert effect["name"] == "cable_stiffness"
    assert answer.json["unpaired"] == []
    stiffness = effect["parameters"]["stiffness"]
    assert abs(stiffness["value"] - 4e4) < 5 * stiffness["sigma"]
    assert diagnosed(tmp_path, saved.read_text(), modes, "--candidates", "payload")["verdict"] == "adequate"


def test_the_uncertainty_of_the_poses_counts(tmp_path: Path) -> None:
    rng, rows, moved = np.random.default_rng(1), rows_of(measured()), {}
    for row in rows:
        offset = moved.setdefault(row["pose"], rng.normal(0.0, 0.003, 3))
        for name, change in zip("xyz", offset, strict=True):
            row[name] = f"{float(row[name]) + change:.9g}"
            row[f"sigma_{name}"] = "0.003"
    options = ("--candidates", "payload")
    assert diagnosed(tmp_path, PUBLISHED, csv_of(rows), *options)["verdict"] == "adequate"
    for row in rows:
        row.update(sigma_x="", sigma_y="", sigma_z="")
    assert diagnosed(tmp_path, PUBLISHED, csv_of(rows), *options)["verdict"] == "unexplained"


def test_a_thousand_rows(tmp_path: Path) -> None:
    rows = [
        {
            **row,
            "pose": f"{row['pose']} again {k}",
            "frequency": f"{float(row['frequency']) * (1 + 1e-5 * k)}",
        }
        for k in range(42)
        for row in rows_of(measured(shapes=()))
    ]
    assert len(rows) > 1000
    inputs = files(tmp_path, PUBLISHED, csv_of(rows))
    answer = call(*inputs, "--candidates", "payload", "--json", tmp_path / "out")
    assert answer.code == 0
    assert len(json.loads((tmp_path / "out").read_text())["rows"]) == len(rows)
