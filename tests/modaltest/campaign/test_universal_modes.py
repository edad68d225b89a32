"""Dataset 55 of universal files: modes by sensor, in the numbers of the real parser case."""

from __future__ import annotations

import csv
from pathlib import Path

import numpy as np
import pytest

from pkmodes.cli import run
from pkmodes.loop.measured.reading import read_modes

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


THREE = 'format = 1\nchannels = ["a", "b", "c"]\nband = ["1 Hz", "400 Hz"]\n' + "".join(
    f'[[sensor]]\nname = "{k}:+X"\nchannel = "{name}"\n' for k, name in ((1, "a"), (2, "b"), (3, "c"))
)


def test_nodes_that_are_zero_in_every_mode_were_not_measured(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    """Node 3 is 0 in both modes; node 1 in one of them, which is a node of vibration."""
    monkeypatch.chdir(tmp_path)
    modes = dataset(20.0, 0.02, {1: 0.0, 2: 0.5, 3: 0.0}), dataset(50.0, 0.01, {1: 1.0, 2: -0.75, 3: 0.0})
    Path("m.uff").write_text("".join(modes), encoding="ascii")
    Path("c.toml").write_text(THREE + RECORD, encoding="utf-8")
    assert run(["identify", "c.toml", "--out", "modes.csv"]) == 0
    data = read_modes("modes.csv", ("a", "b", "c"))
    shapes = dict(zip(data.channels, data.shapes.T, strict=True))
    np.testing.assert_allclose(shapes["a"], [0.0, 1.0])
    np.testing.assert_allclose(shapes["b"], [1.0, -0.75])
    assert np.isnan(shapes.get("c", np.nan)).all()
    assert "3:+X is 0 in every mode: taken as not measured" in capsys.readouterr().err


def test_on_a_platform_only_the_sensors_that_measured_count(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    """Two sensors along x and one that measured nothing: with it, the mean along x would be two thirds."""
    monkeypatch.chdir(tmp_path)
    robot = Path(__file__).parents[3] / "robots/linear-delta-2022.toml"
    sensors = "".join(f'[[sensor]]\nname = "{k}:+X"\nchannel = "p_x"\n' for k in (1, 2, 3))
    sensors += '[[sensor]]\nname = "4:+X"\nchannel = "p_y"\n'
    at = 'at = { x = "600 mm", y = "0 mm", z = "-245 mm" }\n'
    head = f'format = 1\nrobot = "{robot.as_posix()}"\nband = ["1 Hz", "400 Hz"]\n'
    shapes = {1: 1.0, 2: 1.0, 3: 0.0, 4: 0.5}, {1: 0.5, 2: 0.5, 3: 0.0, 4: -1.0}
    Path("m.uff").write_text(
        dataset(20.0, 0.02, shapes[0]) + dataset(50.0, 0.01, shapes[1]), encoding="ascii"
    )
    Path("c.toml").write_text(head + sensors + RECORD + at, encoding="utf-8")
    assert run(["identify", "c.toml", "--out", "modes.csv"]) == 0
    with Path("modes.csv").open(encoding="utf-8", newline="") as file:
        rows = list(csv.DictReader(line for line in file if not line.startswith("#")))
    found = [[float(row["shape:p_x"]), float(row["shape:p_y"])] for row in rows]
    np.testing.assert_allclose(found, [[1.0, 0.5], [-0.5, 1.0]])
