"""What the laboratory of the rig records: excitation, sensors, analyser, and files that the reader takes."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest

from pkmodes.signals.functions import FunctionKind, SignalRequest
from pkmodes.signals.reading import read_signals
from pkmodes_rig.engine import TrueModes
from pkmodes_rig.signals import adxl345, excitation
from pkmodes_rig.signals.analyser import averaged
from pkmodes_rig.signals.files import FORMATS
from pkmodes_rig.signals.integration import responses
from pkmodes_rig.signals.sensors import Room, Sensor, heard, sampled
from pkmodes_rig.signals.small_motion import Losses, small_motion

STEP = 1.0 / 4096.0


def test_a_blow_has_the_impulse_of_half_a_sine() -> None:
    force = excitation.half_sines(1e-5, 20_000, [0.05, 0.1], [40.0, 10.0], 0.003)
    assert force.sum() * 1e-5 == pytest.approx(2.0 / np.pi * 0.003 * 50.0, rel=1e-4)
    assert force.max() == pytest.approx(40.0, rel=1e-4)


def test_a_sweep_passes_every_frequency_at_its_time_with_its_acceleration() -> None:
    a = excitation.sweep(1e-4, 5.0, 130.0, 1.0, 0.075)
    assert len(a) == 1_250_000
    around = slice(550_000, 560_000)  # 55 to 56 s: 60 to 61 Hz
    assert np.sum(np.diff(np.sign(a[around])) > 0) == pytest.approx(60.5, abs=1.0)
    assert np.abs(a[around]).max() == pytest.approx(0.075 * 61.0, rel=1e-2)


def test_ambient_forces_are_as_strong_as_stated() -> None:
    force = excitation.broadband(np.random.default_rng(0), STEP, 400_000, [2.0, 0.5], 400.0)
    # A Butterworth filter of order n is equivalent to an ideal one of pi/(2 n) / sin(pi/(2 n)) times its cut-off.
    wide = 400.0 * np.pi / 8.0 / np.sin(np.pi / 8.0)
    np.testing.assert_allclose(force.var(axis=0), wide * np.array([2.0, 0.5]), rtol=0.03)


def test_the_noise_of_a_sensor_has_the_stated_density() -> None:
    rng = np.random.default_rng(4)
    found = heard(np.zeros((100_000, 2)), 1.0 / 1024.0, [Sensor("a"), Sensor("b")], Room(1e-4), rng)
    np.testing.assert_allclose(found.var(axis=0), 1e-4 * 512.0, rtol=0.02)
    quiet = heard(np.zeros((10_240, 1)), 1.0 / 1024.0, [Sensor("a")], Room(0.0, 0.1, 0.2, 87.0), rng)
    lines = np.abs(np.fft.rfft(quiet[:, 0]))
    assert set(np.sort(np.argsort(lines)[-4:])) == {500, 870, 1000, 1500}  # of 0.1 Hz: mains and the fan


def test_what_is_above_half_the_rate_does_not_come_back() -> None:
    t = STEP * np.arange(8192)
    assert np.abs(sampled(np.sin(2.0 * np.pi * 1000.0 * t))[100:-100]).max() < 0.01  # would be 24 Hz
    kept = sampled(np.sin(2.0 * np.pi * 200.0 * t))[100:-100]
    np.testing.assert_allclose(kept, np.sin(2.0 * np.pi * 200.0 * t[::4])[100:-100], atol=0.01)


def test_functions_and_coherence_of_one_mass() -> None:
    """One mass on a spring: the accelerance in closed form, and a coherence that noise lowers as it should."""
    frequency, ratio, mass, noise, averages = 40.0, 0.02, 2.0, 1e-3, 40
    modes = TrueModes(np.array([frequency]), 0, {"x": np.array([mass**-0.5])}, np.eye(1), np.eye(1), ("x",))
    machine = small_motion(modes, Losses(ratio))
    rng, block = np.random.default_rng(8), round(2.0 / STEP)
    force = np.concatenate(
        [np.tile(excitation.multisine(rng, STEP, block, (10.0, 200.0), 3.0), 2) for _ in range(averages)]
    )
    motion = responses(machine, STEP, force[:, None], machine.rows(["x"]), machine.rows(["x"]))
    room = Room(noise)
    made = averaged(STEP, force, heard(motion, STEP, [Sensor("x")], room, rng), block, 180.0)
    inside = made.frequencies >= 10.0
    f = made.frequencies[inside]
    omega, natural = 2.0 * np.pi * f, 2.0 * np.pi * frequency
    H = -(omega**2) / mass / (natural**2 - omega**2 + 2j * ratio * natural * omega)
    density = 3.0**2 / 190.0
    of_noise = np.sqrt(noise / (density * averages))
    error = (made.values[inside, 0, 0] - H) / of_noise
    assert np.sqrt(np.mean(np.abs(error) ** 2)) == pytest.approx(1.0, abs=0.1)
    coherent = 1.0 / (1.0 + noise / (np.abs(H) ** 2 * density))
    low = f < 20.0  # where noise matters
    assert made.coherence[inside, 0, 0][low].mean() == pytest.approx(coherent[low].mean(), abs=0.01)


@pytest.mark.parametrize("name", list(FORMATS))
def test_files_hold_what_was_written(name: str, tmp_path: Path) -> None:
    style, rng = FORMATS[name], np.random.default_rng(2)
    force, motion = rng.standard_normal(512), rng.standard_normal((512, 2))
    path = tmp_path / f"signals{style.suffix}"
    style.write_times(path, 1.0 / 512.0, force, motion)
    read = read_signals(path, SignalRequest())
    signals = {one.response: one for one in read.functions if one.kind is FunctionKind.TIME}
    for i in range(2):
        one = signals[style.sensor(i)]
        np.testing.assert_allclose(one.values, motion[:, i], rtol=1e-6, atol=1e-6)
        np.testing.assert_allclose(one.abscissa, np.arange(512) / 512.0, rtol=1e-5, atol=1e-9)
    (acting,) = [one for one in read.functions if one.force]
    np.testing.assert_allclose(acting.values, force, rtol=1e-6, atol=1e-6)

    made = averaged(1.0 / 512.0, force, motion, 128, 200.0)
    path = tmp_path / f"functions{style.suffix}"
    style.write_functions(path, made)
    functions = [one for one in read_signals(path, SignalRequest()).functions if one.kind is FunctionKind.FRF]
    assert {one.response for one in functions} == {style.sensor(0), style.sensor(1)}
    for one in functions:
        i = 0 if one.response == style.sensor(0) else 1
        np.testing.assert_allclose(one.values, made.values[:, i, 0], rtol=1e-5, atol=1e-6)
        np.testing.assert_allclose(one.abscissa, made.frequencies, rtol=1e-5)


def test_the_chip_has_its_rate_its_steps_and_its_gap(tmp_path: Path) -> None:
    chip = adxl345.Chip(3260.0, 0.2)
    motion = np.zeros((40_960, 3))
    motion[:, 0] = 3.0 * np.sin(2.0 * np.pi * 60.0 * STEP * np.arange(len(motion)))
    rng = np.random.default_rng(3)
    made = adxl345.record(chip, STEP, motion, rng, dropped=(4.0, 24))
    steps = np.diff(made.times)
    assert np.median(steps) == pytest.approx(1.0 / 3260.0, abs=1e-6)
    assert np.sum(steps > 0.005) == 1
    assert steps.max() == pytest.approx(25.0 / 3260.0, abs=2e-6)
    counts = made.accelerations / chip.step
    np.testing.assert_allclose(counts, np.round(counts), atol=1e-9)
    at_rest = made.accelerations[:, 1].std()
    assert at_rest == pytest.approx(np.hypot(0.2, 0.074 / np.sqrt(12.0)), rel=0.03)

    adxl345.write_raw(tmp_path / "raw.csv", made)
    read = read_signals(tmp_path / "raw.csv", SignalRequest())
    assert {one.response for one in read.functions} == {"accel_x", "accel_y", "accel_z"}
    np.testing.assert_allclose(read.functions[0].abscissa - 100.0, made.times, atol=2e-6)

    f, power = adxl345.spectrum(made)
    assert f[1] == pytest.approx(3260.0 / 2048.0, rel=2e-2)
    assert f[np.argmax(power[1:, 0]) + 1] == pytest.approx(60.0, abs=1.6)
    assert power[:, 1].sum() * f[1] == pytest.approx(made.accelerations[:, 1].var(), rel=0.05)
