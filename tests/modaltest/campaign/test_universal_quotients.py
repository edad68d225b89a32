"""Frequency responses of universal files by their units, above and below: the modes of a structure known to NumPy."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest

from modaltest.campaign.structures import CHANNELS, HEAD, Frame, identify, record, refused
from modaltest.signals.universal import dataset, frf58
from pkmodes.loop.measured.reading import read_modes

STEP = 0.25
F = STEP * np.arange(881)
S = 2j * np.pi * np.where(F > 0.0, F, 1.0)  # the line at 0 Hz is outside the band
SENSORS = "".join(f'[[sensor]]\nname = "{k}:+Z"\nchannel = "floor_{k}"\n' for k in (1, 2, 3))
CAMPAIGN = HEAD + SENSORS + record("frf", "r.uff")
INCH, POUND = 0.0254, 4.4482216152605
ENGLISH = dataset(
    164,
    f"{3:10d}{'pounds':20}{2:10d}\n{1 / INCH:25.17E}{1 / POUND:25.17E}{1.0:25.17E}\n{0.0:25.17E}\n".encode(),
)


def noisy(H: np.ndarray, seed: int = 1) -> np.ndarray:
    rng = np.random.default_rng(seed)
    size = 0.005 * np.sqrt((np.abs(H) ** 2).mean(axis=0))
    return np.asarray(H + size * (rng.normal(size=H.shape) + 1j * rng.normal(size=H.shape)))


def accelerances() -> np.ndarray:
    """Of the three floors per force on the third, (F, 3), with noise."""
    return noisy(Frame.build().accelerances(np.where(F > 0.0, F, 1e-3))[:, :, 2])


def has_the_modes_of_the_frame(file: Path, *, shapes: bool = True) -> None:
    data = read_modes(file, CHANNELS)
    natural, expected = Frame.build().modes()
    np.testing.assert_allclose(data.frequency, natural, rtol=3e-4)
    np.testing.assert_allclose(data.numbers["damping"], Frame.build().ratios, rtol=0.03)
    if shapes:
        for row, shape in zip(data.shapes, expected.T, strict=True):
            np.testing.assert_allclose(row, shape / shape[np.argmax(np.abs(shape))], rtol=0, atol=0.02)


def test_motions_and_forces_of_several_units_and_kinds_in_one_file_stay_right(tmp_path: Path) -> None:
    """Inch and lbf by dataset 164, an acceleration and a velocity by their types, and one with the label g/N."""
    H = accelerances()
    content = ENGLISH
    content += frf58(H[:, 0] / INCH * POUND, STEP, response=(1, 3), reference=(3, 3))
    content += frf58(H[:, 1] / 9.80665, STEP, response=(2, 3), reference=(3, 3), above=(12, "g/N"))
    content += frf58(H[:, 2] / S / INCH * POUND, STEP, response=(3, 3), reference=(3, 3), above=(11, "NONE"))
    (tmp_path / "r.uff").write_bytes(content)
    has_the_modes_of_the_frame(identify(tmp_path, CAMPAIGN).file)


def test_forces_of_several_units_give_the_shape_of_a_roving_hammer(tmp_path: Path) -> None:
    H = accelerances()
    below = [(1.0, (13, "N")), (POUND, (13, "lbf")), (1e3, (13, "kN"))]
    parts = [
        frf58(H[:, k] * factor, STEP, response=(3, 3), reference=(k + 1, 3), below=label)
        for k, (factor, label) in enumerate(below)
    ]
    (tmp_path / "r.uff").write_bytes(b"".join(parts))
    forces = "".join(f'[[force]]\nname = "{k}:+Z"\nchannel = "floor_{k}"\n' for k in (1, 2, 3))
    sensor = '[[sensor]]\nname = "3:+Z"\nchannel = "floor_3"\n'
    has_the_modes_of_the_frame(identify(tmp_path, HEAD + sensor + forces + record("frf", "r.uff")).file)


def test_lines_outside_the_band_need_no_numbers(tmp_path: Path) -> None:
    H = accelerances()
    H[F < 10.0] = np.nan
    H[-1] = np.inf
    (tmp_path / "r.uff").write_bytes(b"".join(frf58(H[:, k], STEP, response=(k + 1, 3)) for k in range(3)))
    has_the_modes_of_the_frame(identify(tmp_path, CAMPAIGN).file)
    spectrum = b"".join(frf58(H[:, k], STEP, response=(k + 1, 3), function=9) for k in range(3))
    (tmp_path / "r.uff").write_bytes(spectrum)
    modes = identify(tmp_path, CAMPAIGN.replace('"frf"', '"spectrum"')).record["modes"]
    np.testing.assert_allclose([one["frequency"] for one in modes], Frame.build().modes()[0], rtol=5e-3)


@pytest.mark.parametrize(
    ("above", "below"), [((12, "NONE"), (12, "NONE")), ((12, "g"), (0, "g")), ((12, "g/g"), (0, "NONE"))]
)
def test_a_transmissibility_is_refused(
    tmp_path: Path, above: tuple[int, str], below: tuple[int, str]
) -> None:
    H = accelerances()
    ratio = H[:, 1] / H[:, 0]
    (tmp_path / "r.uff").write_bytes(frf58(ratio, STEP, response=(2, 3), above=above, below=below))
    said = refused(tmp_path, CAMPAIGN)
    assert "a transmissibility, whose poles are not modes (r.uff: 2:+Z/1:+Z)" in said
    assert "measure the force" in said


def test_functions_of_other_types_are_named_where_none_is_left(tmp_path: Path) -> None:
    H = accelerances()
    parts = [frf58(H[:, k], STEP, response=(k + 1, 3), function=5) for k in range(3)]
    (tmp_path / "r.uff").write_bytes(b"".join(parts) + frf58(H[:, 0], STEP, function=12))
    said = refused(tmp_path, CAMPAIGN)
    assert "found 0 other functions; skipped: function type 5 is a transmissibility" in said
    assert "(3 datasets); function type 12 is a spectrum without averages (r.uff)" in said


@pytest.mark.parametrize(
    ("unit", "above", "said"),
    [
        ("m/s", (12, "NONE"), 'the campaign says "m/s" of this sensor, and the file "m/s^2"'),
        ("g0", (12, "m/s^2"), 'the campaign says "g0" of this sensor, and the file "m/s^2"'),
        ("m/s^2", (12, "V"), 'the campaign says "m/s^2" of this sensor, and the file "V"'),
        ("m/s^2", (12, "m/s^2"), ""),
        ("g0", (12, "g"), ""),
        ("g0", (12, "NONE"), ""),  # the type alone says acceleration, and no unit
        ("rad/s^2", (12, "NONE"), ""),
        ("rad/s", (12, "NONE"), 'the campaign says "rad/s" of this sensor, and the file "m/s^2"'),
        ("rad/s^2", (12, "m/s^2"), 'the campaign says "rad/s^2" of this sensor, and the file "m/s^2"'),
        ('V"\nsensitivity = "100 mV/g', (12, "V"), ""),
        ('V"\nsensitivity = "100 mV/g', (12, "NONE"), ""),
        ('V"\nsensitivity = "100 mV/g', (12, "g"), 'the campaign says "100 mV/g" of this sensor'),
    ],
)
def test_a_unit_that_contradicts_the_campaign_is_refused_with_both(
    tmp_path: Path, unit: str, above: tuple[int, str], said: str
) -> None:
    H = accelerances()
    labels = [above, (12, "NONE"), (12, "NONE")]
    parts = [frf58(H[:, k], STEP, response=(k + 1, 3), above=labels[k]) for k in range(3)]
    (tmp_path / "r.uff").write_bytes(b"".join(parts))
    campaign = CAMPAIGN.replace('channel = "floor_1"', f'channel = "floor_1"\nunit = "{unit}"')
    if said:
        assert said in refused(tmp_path, campaign)
    else:
        has_the_modes_of_the_frame(identify(tmp_path, campaign).file, shapes=False)


@pytest.mark.parametrize(
    ("power", "above", "below", "word"),
    [
        (0, (13, "NONE"), (12, "NONE"), "a dynamic mass"),
        (1, (13, "N/(m/s)"), (0, "NONE"), "a mechanical impedance"),
        (2, (13, "N"), (8, "m"), "a dynamic stiffness"),
    ],
)
def test_the_inverse_is_refused_with_its_word_and_inverted_if_asked(
    tmp_path: Path, power: int, above: tuple[int, str], below: tuple[int, str], word: str
) -> None:
    inverse = S[:, None] ** power / accelerances()
    parts = [frf58(inverse[:, k], STEP, response=(k + 1, 3), above=above, below=below) for k in range(3)]
    (tmp_path / "r.uff").write_bytes(b"".join(parts))
    said = refused(tmp_path, CAMPAIGN)
    assert f", {word} (r.uff: 1:+Z/1:+Z)" in said
    assert "invert = true" in said
    wrong = CAMPAIGN.replace('channel = "floor_1"', 'channel = "floor_1"\nunit = "m/s^2"')
    assert f'{word}, and the campaign says "m/s^2"' in refused(tmp_path, wrong)
    has_the_modes_of_the_frame(identify(tmp_path, CAMPAIGN + "invert = true\n").file)


def test_what_cannot_be_inverted_is_refused(tmp_path: Path) -> None:
    H = accelerances()
    (tmp_path / "r.uff").write_bytes(b"".join(frf58(H[:, k], STEP, response=(k + 1, 3)) for k in range(3)))
    said = refused(tmp_path, CAMPAIGN + "invert = true\n")
    assert "expected a force over a motion, as invert says, found m/s^2 over N" in said
    square = b"".join(
        frf58(
            1.0 / H[:, i], STEP, response=(i + 1, 3), reference=(k + 1, 3), above=(13, "N"), below=(12, "g")
        )
        for i in range(2)
        for k in range(2)
    )
    (tmp_path / "r.uff").write_bytes(square)
    assert "cannot invert the functions of 2 sensors and 2 references" in refused(
        tmp_path, CAMPAIGN + "invert = true\n"
    )
