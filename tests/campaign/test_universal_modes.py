"""Dataset 55 of universal files: modes by sensor, in the numbers of the real parser case."""

from __future__ import annotations

import csv
from pathlib import Path

import numpy as np
import pytest

from pkmodes.cli import run
from pkmodes.measured.reading import read_modes

CHANNELS = ("floor_1", "floor_2")
HEAD = 'format = 1\nchannels = ["floor_1", "floor_2"]\nband = ["1 Hz", "400 Hz"]\n'
RECORD = '[[record]]\npose = "P1"\nkind = "modes"\nfiles = ["m.uff"]\n'
SENSORS = "".join(f'[[sensor]]\nname = "{k}:+X"\nchannel = "floor_{k}"\n' for k in (1, 2))


def dataset(frequency: float, damping: float, shape: dict[int, float]) -> str:
    """A normal mode with three components at each node, laid out as the format says."""
    lines = ["    -1", "    55", *["NONE"] * 5]
    lines.append(
        "".join(f"{n:10d}" for n in (1, 2, 2, 8, 2, 3))
    )  # modal, normal mode, displacement, real, 3 values
    lines.append("".join(f"{n:10d}" for n in (2, 4, 1, 1)))
    lines.append("".join(f"{x:13.5e}" for x in (frequency, 1.0, damping, 0.0)))
    for node, value in shape.items():
        lines += [f"{node:10d}", "".join(f"{x:13.5e}" for x in (value, 0.0, 0.0))]
    return "\n".join([*lines, "    -1", ""])


def test_modes_have_the_shapes_of_the_campaigns_sensors(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.chdir(tmp_path)
    text = dataset(20.0, 0.02, {1: 0.25, 2: 0.5, 3: 9.0}) + dataset(50.0, 0.0, {1: 1.0, 2: -0.75, 3: 9.0})
    Path("m.uff").write_text(text, encoding="ascii")
    Path("c.toml").write_text(HEAD + SENSORS + RECORD, encoding="utf-8")
    assert run(["identify", "c.toml", "--out", "modes.csv"]) == 0
    data = read_modes("modes.csv", CHANNELS)
    np.testing.assert_allclose(data.frequency, [20.0, 50.0])
    np.testing.assert_allclose(data.numbers["damping"], [0.02, np.nan])  # 0 of dataset 55 is blank
    np.testing.assert_allclose(data.shapes, [[0.5, 1.0], [1.0, -0.75]])
    with Path("modes.csv").open(encoding="utf-8", newline="") as file:
        rows = list(csv.DictReader(line for line in file if not line.startswith("#")))
    unknown = [(row["damping"], row["sigma_damping"], row["sigma_shape"]) for row in rows]
    assert unknown == [
        ("0.02", "", ""),
        ("", "", ""),
    ]  # there, and blank: the program that wrote m.uff knew no more


@pytest.mark.parametrize(
    ("text", "message"),
    [
        (
            dataset(20.0, 1.5, {1: 1.0, 2: 0.5}),
            "expected a damping ratio of at least 0 and below 1, found 1.5 (m.uff: mode",
        ),
        (dataset(20.0, 0.01, {1: 0.0, 2: 0.0}), "found components up to 0 (m.uff: mode at 20 Hz)"),
        (dataset(20.0, 0.01, {1: 1.0, 2: 0.5})[:-40], "m.uff"),
    ],
)
def test_modes_that_cannot_be_are_refused(
    tmp_path: Path,
    monkeypatch: pytest.MonkeyPatch,
    capsys: pytest.CaptureFixture[str],
    text: str,
    message: str,
) -> None:
    monkeypatch.chdir(tmp_path)
    Path("m.uff").write_text(text, encoding="ascii")
    Path("c.toml").write_text(HEAD + SENSORS + RECORD, encoding="utf-8")
    assert run(["identify", "c.toml", "--out", "modes.csv"]) == 2
    assert message in " ".join(capsys.readouterr().err.split())
    assert not Path("modes.csv").exists()
