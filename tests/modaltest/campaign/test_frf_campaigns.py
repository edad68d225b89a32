"""Campaigns of frequency response functions of a structure whose modes NumPy gives: files to rows."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest

from modaltest.campaign.structures import CHANNELS, HEAD, Frame, identify, record, refused, sensors, write_frf
from pkmodes.loop.measured.reading import read_modes

F = np.arange(10.0, 220.0, 0.25)
SENSORS = sensors("m/s^2", "g0", "mm/s")


def in_units(H: np.ndarray) -> dict[str, np.ndarray]:
    """Responses to a force on the third floor, in the units of the sensors."""
    velocity = H[:, 2, 2] / (2j * np.pi * F)
    return {"a1": H[:, 0, 2], "a2": H[:, 1, 2] / 9.80665, "a3": 1e3 * velocity}


def test_repeats_of_responses_in_several_units_give_the_modes_of_the_structure(tmp_path: Path) -> None:
    frame, rng = Frame.build(), np.random.default_rng(5)
    for i in range(4):
        write_frf(tmp_path / f"r{i}.csv", F, in_units(frame.accelerances(F)), 0.02, rng)
    found = identify(tmp_path, HEAD + SENSORS + record("frf", *(f"r{i}.csv" for i in range(4))))
    data = read_modes(found.file, CHANNELS)
    natural, shapes = frame.modes()
    np.testing.assert_allclose(data.frequency, natural, rtol=3e-4)
    np.testing.assert_allclose(data.numbers["damping"], frame.ratios, rtol=0.03)
    for row, shape in zip(data.shapes, shapes.T, strict=True):
        expected = shape / shape[np.argmax(np.abs(shape))]
        np.testing.assert_allclose(row, expected, rtol=0, atol=0.02)
    modes = found.record["modes"]
    for mode, f in zip(modes, natural, strict=True):
        parts = mode["sigma_parts"]
        assert abs(mode["frequency"] - f) < 4.0 * np.hypot(parts["scatter"], parts["fit"])
        assert 0.0 < np.hypot(parts["scatter"], parts["fit"]) < 5e-4 * f
        assert mode["files"] == 4
        assert mode["complexity"] > 0.99
        count, of = mode["found_in"]
        assert 0 < count <= of
    assert (data.shape_sigma > 0.0).all()
    assert (data.numbers["damping_sigma"] < 0.1 * frame.ratios).all()


def test_a_single_file_gets_its_sigma_from_the_fit(tmp_path: Path) -> None:
    frame = Frame.build()
    write_frf(tmp_path / "r.csv", F, in_units(frame.accelerances(F)), 0.05, np.random.default_rng(6))
    found = identify(tmp_path, HEAD + SENSORS + record("frf", "r.csv")).record
    assert any("a single file" in message for message in found["messages"])
    for mode, f in zip(found["modes"], frame.modes()[0], strict=True):
        assert mode["sigma_parts"]["scatter"] == 0.0
        assert 0.0 < mode["sigma_parts"]["fit"] < 1e-3 * f
        assert abs(mode["frequency"] - f) < 4.0 * mode["sigma_parts"]["fit"]


def test_setups_are_joined_by_the_sensors_that_they_share(tmp_path: Path) -> None:
    frame, rng = Frame.build(), np.random.default_rng(7)
    H = frame.accelerances(F)
    write_frf(tmp_path / "s.csv", F, {"ref": H[:, 2, 2], "moving": H[:, 0, 2]}, 0.01, rng)
    write_frf(tmp_path / "t.csv", F, {"ref": 3.0 * H[:, 2, 2], "moving": 3.0 * H[:, 1, 2]}, 0.01, rng)
    moving = "".join(
        f'[[sensor]]\nname = "{name}"\nchannel = "{channel}"\nunit = "m/s^2"\n{setup}'
        for name, channel, setup in (
            ("ref", "floor_3", ""),
            ("moving", "floor_1", 'setup = "low"\n'),
            ("moving", "floor_2", 'setup = "high"\n'),
        )
    )
    setups = '[[record]]\npose = "P1"\nkind = "frf"\nfiles = { low = ["s.csv"], high = ["t.csv"] }\n'
    data = read_modes(identify(tmp_path, HEAD + moving + setups).file, CHANNELS)
    natural, shapes = frame.modes()
    np.testing.assert_allclose(data.frequency, natural, rtol=3e-4)
    for row, shape in zip(data.shapes, shapes.T, strict=True):
        np.testing.assert_allclose(row, shape / shape[np.argmax(np.abs(shape))], rtol=0, atol=0.02)


def test_a_machine_that_warms_between_setups_has_each_mode_once_and_it_is_said(tmp_path: Path) -> None:
    """The springs of the second setup are 2.5 % softer, which is 1.26 % in frequency."""
    frame, rng = Frame.build(), np.random.default_rng(38)
    for name, factor in (("cold", 1.0), ("warm", 0.975), ("again", 1.0)):
        write_frf(tmp_path / f"{name}.csv", F, in_units(frame.accelerances(F, factor)), 0.01, rng)
    setups = '[[record]]\npose = "P1"\nkind = "frf"\nfiles = {{ a = ["cold.csv"], b = ["{}.csv"] }}\n'
    found = identify(tmp_path, HEAD + SENSORS + setups.format("warm"))
    pairs = list(zip(frame.modes()[0], frame.modes(0.975)[0], strict=True))
    for mode, (high, low) in zip(found.record["modes"], pairs, strict=True):
        assert mode["frequency"] == pytest.approx(0.5 * (high + low), rel=1e-3)
        assert mode["sigma_parts"]["scatter"] == pytest.approx(0.5 * (high - low), rel=0.05)
    assert "the setups a, b differ by more than their standard deviations" in found.remarks
    again = identify(tmp_path, HEAD + SENSORS + setups.format("again"))
    assert len(again.record["modes"]) == 3
    assert "differ by more" not in again.remarks


@pytest.mark.parametrize("roves", ["hammer", "sensor"])
def test_setups_without_a_common_sensor_are_joined_by_what_stays(tmp_path: Path, roves: str) -> None:
    """A file for each point: of a hammer whose sensor stays, or of a sensor whose hammer stays at reference 9."""
    frame, rng = Frame.build(), np.random.default_rng(11)
    H = frame.accelerances(F)
    for k in range(3):
        name = f"acc/{k + 1}" if roves == "hammer" else "acc/9"
        for i in range(2):
            write_frf(
                tmp_path / f"s{k}{i}.csv",
                F,
                {name: H[:, 2, k] if roves == "hammer" else H[:, k, 2]},
                0.01,
                rng,
            )
    sensor = '[[sensor]]\nname = "acc"\nunit = "m/s^2"\nchannel = '
    places = sensor + '"none"\n' if roves == "hammer" else ""
    for k in (1, 2, 3):
        if roves == "hammer":
            places += f'[[force]]\nname = "{k}"\nchannel = "floor_{k}"\nsetup = "s{k}"\n'
        else:
            places += f'{sensor}"floor_{k}"\nsetup = "s{k}"\n'
    files = ", ".join(f's{k + 1} = ["s{k}0.csv", "s{k}1.csv"]' for k in range(3))
    record = f'[[record]]\npose = "P1"\nkind = "frf"\nfiles = {{ {files} }}\n'
    data = read_modes(identify(tmp_path, HEAD + places + record).file, CHANNELS)
    natural, shapes = frame.modes()
    np.testing.assert_allclose(data.frequency, natural, rtol=3e-4)
    for row, shape in zip(data.shapes, shapes.T, strict=True):
        np.testing.assert_allclose(row, shape / shape[np.argmax(np.abs(shape))], rtol=0, atol=0.02)
    assert (data.shape_sigma > 0.0).all()


def test_a_roving_hammer_gives_the_shape_at_its_blows(tmp_path: Path) -> None:
    """One sensor; the sign in the name of a reference is only a name, the campaign says what positive means."""
    frame, rng = Frame.build(), np.random.default_rng(8)
    H = frame.accelerances(F)
    functions = {f"acc/{k + 1}:-X": -H[:, 2, k] for k in range(3)}
    write_frf(tmp_path / "r.csv", F, functions, 0.01, rng)
    forces = "".join(f'[[force]]\nname = "{k}:+X"\nchannel = "floor_{k}"\n' for k in (1, 2, 3))
    sensor = '[[sensor]]\nname = "acc"\nchannel = "none"\nunit = "m/s^2"\n'
    data = read_modes(identify(tmp_path, HEAD + sensor + forces + record("frf", "r.csv")).file, CHANNELS)
    natural, shapes = frame.modes()
    np.testing.assert_allclose(data.frequency, natural, rtol=3e-4)
    for row, shape in zip(data.shapes, shapes.T, strict=True):
        np.testing.assert_allclose(row, shape / shape[np.argmax(np.abs(shape))], rtol=0, atol=0.02)


def test_the_damping_of_a_window_is_taken_off(tmp_path: Path) -> None:
    """A window exp(-t/tau) on impulse responses moves every pole by -1/tau: so do responses of that damping."""
    frame = Frame.build()
    natural, shapes = frame.modes()
    tau = 0.2
    omega = 2.0 * np.pi * natural
    poles = -frame.ratios * omega + 1j * omega * np.sqrt(1.0 - frame.ratios**2) - 1.0 / tau
    s = 2j * np.pi * F[:, None]
    terms = shapes[2] ** 2 / (2j * poles.imag)
    receptance = (terms / (s - poles) - terms / (s - poles.conj())).sum(axis=1)
    write_frf(tmp_path / "r.csv", F, {"a1": receptance}, 0.01, np.random.default_rng(9))
    sensor = '[[sensor]]\nname = "a1"\nchannel = "floor_3"\nunit = "m"\n'
    found = identify(tmp_path, HEAD + sensor + record("frf", "r.csv") + f'exponential = "{tau} s"\n')
    data = read_modes(found.file, CHANNELS)
    fits = np.array([mode["sigma_parts"]["fit"] for mode in found.record["modes"]])
    assert (fits < 5e-3 * natural).all()
    assert (np.abs(data.frequency - natural) < 4.0 * fits).all()
    np.testing.assert_allclose(data.numbers["damping"], frame.ratios, rtol=0.1)
    assert 1.0 / tau > 0.2 * (frame.ratios * 2.0 * np.pi * natural).max()  # it would have shown


@pytest.mark.parametrize(
    ("change", "message"),
    [
        (('unit = "m/s^2"\n', ""), "expected the unit of the sensor, found none in the file (r.csv: a1)"),
        (
            ('"200 Hz"', '"300 Hz"'),
            "expected frequencies up to the end of the band, 300 Hz, found 219.75 Hz (r.csv)",
        ),
        (('"200 Hz"', '"21 Hz"'), "(r.csv: the band)"),
        (
            ('name = "a', 'name = "b'),  # every sensor
            'expected a sensor of the campaign, found "a1", "a2", "a3" (r.csv); did you mean "b1"?',
        ),
        (("[[sensor]]", 'tones = ["0.1 Hz"]\n[[sensor]]'), "lines beside the tones, found 0 (r.csv: tones)"),
        (
            ('"20 Hz"', '"1 Hz"'),
            "expected frequencies from the beginning of the band, 1 Hz, found 10 Hz (r.csv)",
        ),
    ],
)
def test_what_does_not_fit_the_campaign_is_refused(
    tmp_path: Path, change: tuple[str, str], message: str
) -> None:
    write_frf(tmp_path / "r.csv", F, in_units(Frame.build().accelerances(F)), 0.02, np.random.default_rng(5))
    text = HEAD + SENSORS + record("frf", "r.csv")
    assert change[0] in text
    times = 1 if change[0] == "[[sensor]]" else -1
    assert message in refused(tmp_path, text.replace(*change, times))


def test_dead_sensors_and_modes_beside_tones_are_said(tmp_path: Path) -> None:
    frame = Frame.build()
    H = in_units(frame.accelerances(F))
    H["a2"] = 0.0 * H["a2"]
    write_frf(tmp_path / "r.csv", F, H, 0.02, np.random.default_rng(5))
    natural = frame.modes()[0]
    text = HEAD + f'tones = ["{0.5 * natural[0] * 1.004:.4f} Hz"]\n' + SENSORS
    found = identify(tmp_path, text + record("frf", "r.csv"))
    said = found.record["messages"]
    assert any("a2 shows nothing" in message for message in said)
    beside = f"the mode at {natural[0]:.4g} Hz lies beside the tone at {1.004 * natural[0]:.4g} Hz"
    assert any(beside in message for message in said)
    assert read_modes(found.file, CHANNELS).channels == ("floor_1", "floor_3")


@pytest.mark.parametrize("factor", [1e100, 1e-100])
def test_numbers_that_no_machine_has_are_refused(tmp_path: Path, factor: float) -> None:
    H = {name: factor * values for name, values in in_units(Frame.build().accelerances(F)).items()}
    write_frf(tmp_path / "r.csv", F, H, 0.0, np.random.default_rng(5))
    said = refused(tmp_path, HEAD + SENSORS + record("frf", "r.csv"))
    assert "in SI units of moderate size" in said
