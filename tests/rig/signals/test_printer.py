"""The printer of examples/printer: its files, the peaks that they give, and what these can tell."""

from __future__ import annotations

import shutil
import tomllib
from pathlib import Path

import numpy as np
import pytest

import pkmodes
from pkmodes import updating
from pkmodes.campaign.campaign import read_campaign
from pkmodes.campaign.identify import identify
from pkmodes.core.robot.reading import robot_from_document
from pkmodes.measured.measurements import Measurements
from pkmodes_rig.signals.adxl345 import Chip, write_raw
from pkmodes_rig.signals.printer import POSES, SERVO, Machine, ResonanceTest, printer, swept, write
from pkmodes_rig.signals.small_motion import Truth
from pkmodes_rig.signals.visits import Visit

EXAMPLE = Path(__file__).parents[3] / "examples/printer"
FURTHER = ((0.06, 0.24), (0.24, 0.06), (0.15, 0.06), (0.15, 0.24))


def machine() -> Machine:
    document = tomllib.loads((EXAMPLE / "robot.toml").read_text(encoding="utf-8"))
    return printer(robot_from_document(document, "robot.toml").parameters)


def truth(place: tuple[float, float]) -> Truth:
    return machine().at(Visit(np.array(place), np.zeros(2))).truth


def test_the_stored_spectra_are_those_of_the_rig(tmp_path: Path) -> None:
    shutil.copy(EXAMPLE / "robot.toml", tmp_path)
    write(tmp_path)
    names = sorted(path.name for path in EXAMPLE.glob("*.csv"))
    assert names == sorted(path.name for path in tmp_path.glob("*.csv"))
    for name in names:
        stored, made = (
            np.loadtxt(folder / name, delimiter=",", skiprows=1) for folder in (EXAMPLE, tmp_path)
        )
        # Four digits are written; the last one may be rounded the other way on another machine.
        np.testing.assert_allclose(made, stored, rtol=2e-3)


def test_spectra_give_the_two_resonances_within_their_errors() -> None:
    found = identify(read_campaign(EXAMPLE / "campaign.toml"))
    for record, place in zip(found.records, POSES.values(), strict=True):
        true = truth(place).frequencies[:2]
        assert len(record.modes) == 2
        for mode, frequency in zip(record.modes, true, strict=True):
            assert abs(mode.frequency - frequency) < 2.0 * mode.sigma
            assert mode.sigma < 0.7  # lines 1.6 Hz apart, of which 0.29 at least is not known
            assert mode.files == 4


def test_refitted_motors_absorb_the_clamps() -> None:
    """The verdict of the tutorial: adequate, although the motors are as declared and the clamps are not."""
    found = identify(read_campaign(EXAMPLE / "campaign.toml"))
    diagnosis = updating.diagnose(pkmodes.load(EXAMPLE / "robot.toml"), found.measurements)
    assert diagnosis.verdict == "adequate"
    (servo,) = (one for one in diagnosis.refitted if one.name == f"effects.{SERVO}")
    assert 15.0 - servo.after > 3.0 * servo.sigma  # the truth is 15 N m/rad


@pytest.mark.parametrize(
    ("modes", "places", "servo", "verdict"),
    [
        (2, 3, "50 %", "adequate"),
        (2, 7, "50 %", "adequate"),
        (2, 7, "5 %", "ambiguous"),
        (4, 3, "50 %", "effect_found"),
        (4, 7, "50 %", "effect_found"),
        (4, 3, "5 %", "effect_found"),
    ],
)
def test_what_tells_the_clamps_from_the_motors(
    modes: int, places: int, servo: str, verdict: str, tmp_path: Path
) -> None:
    """The table of docs/how-to/printer-signals.md."""
    text = (
        (EXAMPLE / "robot.toml").read_text(encoding="utf-8").replace('sigma = "50 %"', f'sigma = "{servo}"')
    )
    (tmp_path / "robot.toml").write_text(text, encoding="utf-8")
    rng = np.random.default_rng(1)
    rows = []
    for place in [*POSES.values(), *FURTHER][:places]:
        true = truth(place)
        for k in range(modes):
            moved = np.array([true.shapes[f"p_{axis}"][k].real for axis in "xy"])
            frequency = true.frequencies[k]
            noisy = frequency * (1.0 + 0.002 * rng.normal())
            rows.append((str(place), noisy, 0.002 * frequency, place, moved / np.abs(moved).max()))
    labels, frequencies, sigmas, points, shapes = zip(*rows, strict=True)
    data = Measurements.from_rows(
        labels,
        frequencies,
        sigmas,
        points=np.array(points),
        components={"x": "m", "y": "m"},
        band=(20.0, 320.0 if modes == 4 else 100.0),
        shapes={f"p_{axis}": np.array(shapes)[:, i] for i, axis in enumerate("xy")},
        shape_sigma=[0.02] * len(rows),
    )
    found = updating.diagnose(pkmodes.load(tmp_path / "robot.toml"), data)
    assert found.verdict == verdict
    if verdict == "effect_found":
        assert [effect.name for effect in found.effects] == ["clamp_compliance"]


def test_raw_data_give_frequencies_damping_and_directions(tmp_path: Path) -> None:
    """Two sweeps, read with the times of the chip, whose rate is not the nominal one."""
    rng = np.random.default_rng(5)
    chip, place = Chip(rate=3251.0, noise=0.2), POSES["centre"]
    for axis in "xy":
        recording = swept(machine(), Visit(np.array(place), np.zeros(2)), ResonanceTest(axis), chip, rng)
        write_raw(tmp_path / f"{axis}.csv", recording)
    sensors = "".join(
        f'[[sensor]]\nname = "accel_{axis}"\nchannel = "p_{axis}"\nunit = "mm/s^2"\n' for axis in "xy"
    )
    (tmp_path / "campaign.toml").write_text(
        f'format = 1\nrobot = "{EXAMPLE}/robot.toml"\nband = ["20 Hz", "100 Hz"]\n{sensors}'
        '[[record]]\npose = "centre"\nat = { x = "150 mm", y = "150 mm" }\nkind = "ambient"\n'
        'files = { x = ["x.csv"], y = ["y.csv"] }\n',
        encoding="utf-8",
    )
    (record,) = identify(read_campaign(tmp_path / "campaign.toml")).records
    true = truth(place)
    assert len(record.modes) == 2
    for k, mode in enumerate(record.modes):
        assert mode.frequency == pytest.approx(true.frequencies[k], rel=5e-4)
        assert mode.damping == pytest.approx(true.ratios[k], rel=0.02)
        moved = np.array([true.shapes[f"p_{axis}"][k].real for axis in "xy"])
        found = np.array([mode.shape[f"p_{axis}"] for axis in "xy"])
        assert (moved @ found) ** 2 / (moved @ moved) / (found @ found) > 0.999
