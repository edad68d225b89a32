"""Campaigns without a measured force: ambient vibration, and Klipper's spectra."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest

from campaign.structures import CHANNELS, HEAD, Frame, accelerations, identify, record, refused, sensors
from pkmodes.measured.reading import read_modes

SENSORS = sensors("m/s^2", "g0", "mm/s")
STEP = 1.0 / 1024.0


def write_ambient(path: Path, rng: np.random.Generator, seconds: float = 40.0) -> None:
    """Noise forces on all floors, a fan at 150 Hz, a sensor of velocity on the third."""
    count = round(seconds / STEP)
    frame = Frame.build()
    a = sum(accelerations(frame, STEP, rng.normal(size=count), floor) for floor in range(3))
    t = STEP * np.arange(count)
    a = a + 0.5 * np.sin(2.0 * np.pi * 150.0 * t)[:, None] * a.std(axis=0)
    spectrum = np.fft.rfft(a[:, 2])
    omega = 2.0 * np.pi * np.fft.rfftfreq(count, STEP)
    velocity = np.fft.irfft(
        np.where(omega > 6.0, spectrum / (1j * np.where(omega > 0.0, omega, 1.0)), 0.0), count
    )
    a = a + 0.02 * a.std(axis=0) * rng.normal(size=a.shape)
    table = np.column_stack([t, a[:, 0], a[:, 1] / 9.80665, 1e3 * velocity])
    np.savetxt(path, table, delimiter=",", header="time,a1,a2,a3", comments="", fmt="%.9g")


def test_ambient_records_give_the_modes_and_the_fan_is_said(tmp_path: Path) -> None:
    rng = np.random.default_rng(31)
    for i in range(2):
        write_ambient(tmp_path / f"a{i}.csv", rng)
    text = HEAD + 'tones = ["150 Hz"]\n' + SENSORS
    found = identify(tmp_path, text + record("ambient", "a0.csv", "a1.csv"))
    data, frame = read_modes(found.file, CHANNELS), Frame.build()
    natural, shapes = frame.modes()
    np.testing.assert_allclose(data.frequency, natural, rtol=4e-3)
    np.testing.assert_allclose(data.numbers["damping"], frame.ratios, rtol=0.35)
    for row, shape in zip(data.shapes, shapes.T, strict=True):
        np.testing.assert_allclose(row, shape / shape[np.argmax(np.abs(shape))], rtol=0, atol=0.06)
    assert any("150" in message for message in found.record["messages"])


def test_a_rate_prevails_over_uneven_times_and_columns_are_named_in_the_record(tmp_path: Path) -> None:
    """A logger wrote when each sample arrived, without names; the sensors were sampled evenly."""
    rng = np.random.default_rng(32)
    write_ambient(tmp_path / "a.csv", rng)
    table = np.loadtxt(tmp_path / "a.csv", delimiter=",", skiprows=1)
    table[:, 0] += STEP * rng.uniform(0.0, 0.9, len(table))
    np.savetxt(tmp_path / "raw.tsv", table, delimiter="\t", fmt="%.9g")
    text = HEAD + 'tones = ["150 Hz"]\n' + SENSORS
    named = 'columns = ["time", "a1", "a2", "a3"]\n'
    known = identify(tmp_path, text + record("ambient", "a.csv")).record["modes"]
    found = identify(tmp_path, text + record("ambient", "raw.tsv") + named + 'rate = "1024 Hz"\n').record
    assert [one["frequency"] for one in found["modes"]] == pytest.approx([one["frequency"] for one in known])
    assert any(
        "its times are uneven: the rate of the record, 1024 Hz, is used" in m for m in found["messages"]
    )
    assert "give the rate in the record" in refused(tmp_path, text + record("ambient", "raw.tsv") + named)


def test_samples_lost_now_and_then_are_bridged_where_the_band_allows_it(tmp_path: Path) -> None:
    write_ambient(tmp_path / "whole.csv", np.random.default_rng(36))
    head, *rows = (tmp_path / "whole.csv").read_text().splitlines()
    kept = [row for i, row in enumerate(rows) if i % 100]
    (tmp_path / "a.csv").write_text("\n".join([head, *kept]) + "\n")
    error = refused(tmp_path, HEAD + SENSORS + record("ambient", "a.csv"))
    assert "gaps of 0.977 ms split it" in error
    assert "end the band at 102 Hz or lower" in error
    narrow = HEAD.replace("200 Hz", "102 Hz") + SENSORS
    whole = identify(tmp_path, narrow + record("ambient", "whole.csv")).record["modes"]
    found = identify(tmp_path, narrow + record("ambient", "a.csv")).record
    assert any("409 gaps" in one and "409 samples are interpolated" in one for one in found["messages"])
    for one, other in zip(whole, found["modes"], strict=True):
        assert abs(one["frequency"] - other["frequency"]) < 0.2 * one["sigma"]
        assert abs(one["damping"] - other["damping"]) < 0.2 * one["sigma_damping"]


def test_a_record_too_long_for_memory_is_reduced_to_fewer_samples(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    """What it leaves out lies above the band: the same modes, to a small part of their standard deviations."""
    write_ambient(tmp_path / "a.csv", np.random.default_rng(33))
    text = HEAD.replace("200 Hz", "120 Hz") + SENSORS + record("ambient", "a.csv")
    whole = identify(tmp_path, text).record
    monkeypatch.setattr("pkmodes.signals.reduction.LONG", 10_000)
    fewer = identify(tmp_path, text).record
    pairs = list(zip(whole["modes"], fewer["modes"], strict=True))
    assert len(pairs) == 2
    for one, other in pairs:
        assert abs(one["frequency"] - other["frequency"]) < 0.2 * one["sigma_parts"]["fit"]
        assert abs(one["damping"] - other["damping"]) < 0.2 * one["sigma_damping"]


def test_spectra_give_frequencies_alone(tmp_path: Path) -> None:
    """Klipper's table: lines 1.6 Hz apart, no phase."""
    f = np.arange(4.8, 250.0, 1.6)
    frame = Frame.build()
    natural, _ = frame.modes()
    power = np.abs(np.einsum("fkk->fk", frame.accelerances(f))) ** 2
    table = np.column_stack([f, power, power.sum(axis=1)])
    np.savetxt(
        tmp_path / "k.csv",
        table,
        delimiter=",",
        header="freq,psd_x,psd_y,psd_z,psd_xyz",
        comments="",
        fmt="%.6e",
    )
    sensor = "".join(f'[[sensor]]\nname = "{name}"\nchannel = "none"\n' for name in "xyz")
    found = identify(tmp_path, HEAD + sensor + record("spectrum", "k.csv"))
    modes = found.record["modes"]
    assert len(modes) == 3
    for mode, expected in zip(modes, natural, strict=True):
        assert abs(mode["frequency"] - expected) < 2.0 * mode["sigma"]
        assert 0.4 <= mode["sigma_parts"]["fit"] < 0.6
        assert mode["damping"] is None
        assert mode["found_in"] is None
    data = read_modes(found.file, CHANNELS)
    assert not data.channels
    assert np.isnan(data.numbers["damping"]).all()
