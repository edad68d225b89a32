"""Boards with clocks of their own in one record: a frame after blows, in closed form at the samples of each board."""

from __future__ import annotations

import json
import math
from pathlib import Path

import numpy as np
import pytest

from modaltest.campaign.structures import Identified, identify, refused
from pkmodes.loop.measured.reading import read_modes
from pkmodes.modaltest.campaign.boards import add_clock_uncertainty
from pkmodes.modaltest.identification.clocks import Delay
from pkmodes.modaltest.identification.estimates import Mode

NAMES = ("ax", "ay", "az", "bx", "by", "bz")
FREQUENCIES = np.array([31.0, 47.0, 88.0])
RATIOS = np.array([0.012, 0.009, 0.006])
SHAPES = np.array(
    [[1.0, 0.4, -0.2, 0.7, 0.3, 0.1], [0.3, 1.0, 0.2, -0.5, -0.8, 0.2], [0.2, -0.3, 1.0, -0.6, 0.4, 0.5]]
)
SECONDS = 12.0
OF_HEAD, BED = (
    "".join(
        f'[[sensor]]\nname = "{axis}"\nsetup = "{setup}"\nchannel = "{letter}{axis}"\nunit = "m/s^2"\n'
        for axis in "xyz"
    )
    for setup, letter in (("head", "a"), ("bed", "b"))
)
HEAD = f'format = 1\nchannels = {json.dumps(NAMES)}\nband = ["20 Hz", "120 Hz"]\n' + OF_HEAD + BED
RECORD = '[[record]]\npose = "P1"\nkind = "ambient"\nfiles = { head = ["head.csv"], bed = ["bed.csv"] }\n'
#: True times of blows, and the force of each on the three modes.
BLOWS = [(1.1, [1.0, 0.8, 0.6]), (4.2, [-0.7, 0.9, 0.8]), (7.0, [0.9, -1.0, 0.5]), (9.3, [1.0, 0.7, -0.7])]


def responses(times: np.ndarray, blows: list[tuple[float, list[float]]]) -> np.ndarray:
    """Return the accelerations of the frame at true times, (n, 6): sines that decay after each blow."""
    found = np.zeros((len(times), 6))
    omega = 2.0 * np.pi * FREQUENCIES
    poles = omega * (-RATIOS + 1j * np.sqrt(1.0 - RATIOS**2))
    for at, forces in blows:
        after = np.maximum(times - at, 0.0)[:, None]
        decays = np.imag(poles * np.exp(poles * after)) * (times >= at)[:, None]
        found += 0.05 * decays * forces @ SHAPES
    return found


def write(
    folder: Path,
    later: float = 0.0,
    drift: float = 0.0,
    origin: float = 0.0,
    blows_of_bed: list | None = None,
) -> None:
    """Write both files; the clock of the bed is late, and slow by the drift."""
    rng = np.random.default_rng(38)
    for name, rate, columns in (("head", 1344.0, slice(3)), ("bed", 1383.0, slice(3, 6))):
        of_bed = name == "bed"
        t = 0.01 + np.arange(round(SECONDS * rate)) / rate
        values = responses(t, blows_of_bed if of_bed and blows_of_bed is not None else BLOWS)[:, columns]
        values = values + 0.2 * rng.normal(size=values.shape)
        shown = origin + ((t - later) * (1.0 - drift) if of_bed else t)
        table = np.column_stack([shown, values])
        np.savetxt(folder / f"{name}.csv", table, "%.6f", ",", header="time,x,y,z", comments="")


def check(found: Identified) -> None:
    """Frequencies and whole shapes are those of the frame, within what their standard deviations say."""
    data = read_modes(found.file, NAMES)
    np.testing.assert_allclose(data.frequency, FREQUENCIES, rtol=3e-3)
    for row, sigma, shape in zip(data.shapes, data.shape_sigma, SHAPES, strict=True):
        assert sigma < 0.1
        np.testing.assert_allclose(row, shape, rtol=0, atol=min(4.0 * sigma, 0.1))


@pytest.mark.parametrize(
    ("clock", "written"),
    [
        ('"own"', {"later": 0.437, "drift": -4.5e-4}),
        ('{ bed = { value = "10 ms", sigma = "3 ms" } }', {"later": 0.0137, "drift": 2e-4}),
        ('{ bed = "13.7 ms" }', {"later": 0.0137}),
        ('"common"', {"origin": 1234.5}),
    ],
)
def test_boards_that_recorded_together_give_whole_shapes(
    tmp_path: Path, clock: str, written: dict[str, float]
) -> None:
    write(tmp_path, **written)
    found = identify(tmp_path, HEAD + RECORD + f"clock = {clock}\n")
    check(found)
    said = [one for one in found.record["messages"] if "is added to its times" in one]
    assert len(said) == ("drift" in written)
    if said:  # at the middle of the vibrations, somewhere in the record
        added, drift = (float(said[0].split(word)[1].split()[0]) for word in ("real, ", "and "))
        late = 1e3 * np.array([written["later"], written["later"] + written["drift"] * SECONDS])
        assert late.min() - 0.3 <= added <= late.max() + 0.3
        assert drift == pytest.approx(1e6 * written["drift"], abs=60.0)  # steps of 76 ppm are tried


def test_a_sensor_that_a_board_lacks_is_refused_or_said(tmp_path: Path) -> None:
    write(tmp_path, later=0.437)
    table = np.loadtxt(tmp_path / "bed.csv", delimiter=",", skiprows=1)[:, :3]
    np.savetxt(tmp_path / "bed.csv", table, "%.6f", ",", header="time,x,y", comments="")
    text = HEAD + RECORD + 'clock = "own"\n'
    said = refused(tmp_path, text)
    assert 'expected the sensor "z of bed" in a file, found "x", "y" in those of P1' in said
    (tmp_path / "more").mkdir()
    write(tmp_path / "more", later=0.437)
    whole = RECORD.replace("P1", "P2").replace("head.csv", "more/head.csv").replace("bed.csv", "more/bed.csv")
    found = identify(tmp_path, text + whole + 'clock = "own"\n')
    assert read_modes(found.file, NAMES).shapes.shape == (6, 6)
    assert 'P1: none of its files has the sensor "z of bed" of the campaign' in found.remarks


def test_boards_that_felt_other_blows_are_identified_alone(tmp_path: Path) -> None:
    others = [
        (0.7, [0.5, -1.0, 0.9]),
        (3.3, [1.0, 0.6, -0.8]),
        (7.7, [-0.8, 0.6, 1.0]),
        (10.1, [0.4, 1.0, 0.9]),
    ]
    write(tmp_path, blows_of_bed=others)
    found = identify(tmp_path, HEAD + RECORD + 'clock = "own"\n')
    data = read_modes(found.file, NAMES[:3])  # no columns of the bed
    np.testing.assert_allclose(data.frequency, FREQUENCIES, rtol=3e-3)
    for row, shape in zip(data.shapes, SHAPES[:, :3], strict=True):
        np.testing.assert_allclose(row, shape / np.abs(shape).max(), rtol=0, atol=0.1)
    assert "identified alone, with no phase between them" in found.remarks


def test_a_common_clock_that_is_none_is_said_and_gives_no_signs(tmp_path: Path) -> None:
    write(tmp_path, later=0.007, origin=1234.5)
    found = identify(tmp_path, HEAD + RECORD + 'clock = "common"\n')
    read_modes(found.file, NAMES[:3])
    said = found.remarks.split("the vibrations that it is ")[1].split()[0]
    assert float(said) == pytest.approx(7.0, abs=0.2)
    assert "no components of bed" in found.remarks


def test_what_a_clock_is_known_to_enters_sigma_until_the_sign_is_lost() -> None:
    """At 20 Hz 3 ms turn a shape by 22 degrees, at 45 Hz by 49: twice that is more than a quarter turn."""
    delays = {"bed": Delay(0.0, 0.0, 0.0, np.array([10.0, 100.0]), np.full(2, 3e-3))}
    for frequency, lost in ((20.0, []), (45.0, ["bed"])):
        shape = np.array([1.0 + 0j, 0.6, -0.5])
        mode = Mode(2j * np.pi * frequency, shape, 0.1, 0.001, 0.01, (10, 20))
        found, unsigned = add_clock_uncertainty(mode, {"bed": slice(1, 3)}, delays)
        assert unsigned == lost
        np.testing.assert_array_equal(np.isnan(found.shape), [False, bool(lost), bool(lost)])
        turned = np.array([1.0, 0.6, -0.5]) * np.exp(
            1j * np.array([0, 1, 1]) * 2.0 * np.pi * frequency * 3e-3
        )
        angles = np.linspace(-math.pi / 2, math.pi / 2, 20001)
        real = min(
            (turned * np.exp(1j * angle) for angle in angles), key=lambda one: float(np.sum(one.imag**2))
        ).real
        expected = 0.01 if lost else float(np.hypot(0.01, np.abs(real / real[0] - shape.real).max()))
        assert found.sigma_shape == pytest.approx(expected, abs=1e-4)


def test_clocks_that_mean_nothing_are_refused(subtests: pytest.Subtests, tmp_path: Path) -> None:
    for name in ("head", "bed", "more"):
        (tmp_path / f"{name}.csv").write_text(
            "time,x,y,z\n" + "".join(f"{k / 1e3},{k % 7},1,2\n" for k in range(999))
        )
    own = 'clock = "own"\n'
    for before, after, expected in [
        (own, 'clock = "later"\n', 'expected "common", "own", or a table of bed, found "later"'),
        (own, 'clock = { head = "0 ms" }\n', 'a table of bed, found "head"'),
        (own, 'clock = { bed = "3 m" }\n', "record.1.clock.bed"),
        (own, 'clock = "common"\n', "counted from the first sample"),
        (
            own,
            'clock = { bed = { value = "9 s", sigma = "1 ms" } }\n',
            "expected files that were recorded together",
        ),
        ('bed = ["bed.csv"]', 'bed = ["bed.csv", "more.csv"]', 'found "ambient" and 1 of "head", 2 of "bed"'),
        ('kind = "ambient"', 'kind = "impact"', "expected the kind ambient"),
        ('"120 Hz"', '"300 Hz"', "expected a band up to a quarter of the sampling rate, 250 Hz"),
        (BED, "", "give each [[sensor]] its own: setup"),
    ]:
        text = (HEAD + RECORD + own).replace(before, after)
        text = text if after else text.replace('setup = "head"\n', "")
        with subtests.test(after):
            assert expected in refused(tmp_path, text)
