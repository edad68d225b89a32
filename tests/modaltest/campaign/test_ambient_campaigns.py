"""Campaigns without a measured force: ambient vibration, and Klipper's spectra."""

from __future__ import annotations

import re
from collections.abc import Callable
from functools import partial
from pathlib import Path
from types import SimpleNamespace

import numpy as np
import pytest

from modaltest.campaign.structures import (
    CHANNELS,
    HEAD,
    Frame,
    accelerations,
    identify,
    record,
    refused,
    sensors,
)
from pkmodes.loop.measured.reading import read_modes
from pkmodes.modaltest.campaign.mode_estimates import FileFit
from pkmodes.modaltest.campaign.time_records import fit_with_bridges
from pkmodes.modaltest.identification.estimates import Estimate, Mode, Stabilisation

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
    at_random = set(np.random.default_rng(39).choice(range(40, len(rows), 40), 409, replace=False))
    for name, lost in (("a.csv", set(range(0, len(rows), 100))), ("b.csv", at_random)):
        kept = [row for i, row in enumerate(rows) if i not in lost]
        (tmp_path / name).write_text("\n".join([head, *kept]) + "\n")
    error = refused(tmp_path, HEAD + SENSORS + record("ambient", "a.csv"))
    assert "gaps of 0.977 ms split it" in error
    assert "end the band at 102 Hz or lower" in error
    narrow = HEAD.replace("200 Hz", "102 Hz") + SENSORS
    whole = identify(tmp_path, narrow + record("ambient", "whole.csv")).record["modes"]
    found = identify(tmp_path, narrow + record("ambient", "b.csv")).record
    assert any("409 gaps" in one and "409 samples are interpolated" in one for one in found["messages"])
    (said,) = (one for one in found["messages"] if "interpolating as many further samples" in one)
    assert 0.01 < float(said.split(" moves the modes by ")[1].split()[0]) < 0.5
    for one, other in zip(whole, found["modes"], strict=True):
        assert abs(one["frequency"] - other["frequency"]) < 0.2 * one["sigma"]
        assert abs(one["damping"] - other["damping"]) < 0.2 * one["sigma_damping"]


def changed(folder: Path, name: str, change: Callable[[np.ndarray], np.ndarray], seed: int = 37) -> None:
    """Write an ambient record whose table (N, 4), times and three signals, is changed."""
    write_ambient(folder / name, np.random.default_rng(seed), 20.0)
    table = change(np.loadtxt(folder / name, delimiter=",", skiprows=1))
    np.savetxt(folder / name, table, delimiter=",", header="time,a1,a2,a3", comments="", fmt="%.9g")


def stopped_at(second: float, table: np.ndarray) -> np.ndarray:
    late = table[:, 0] >= second
    table[late, 2] = table[np.argmax(late), 2]
    return table


@pytest.mark.parametrize(
    ("second", "sentence"),
    [
        (0.0, "a.csv: a2 shows nothing: all its values are equal; this file gives no shape component of it"),
        (12.0, "a.csv: a2 keeps one value from 12 s to 20 s while others go on: this file gives no shape"),
    ],
)
def test_a_sensor_that_is_silent_in_one_record_is_in_no_shape_of_it(
    tmp_path: Path, second: float, sentence: str
) -> None:
    """Its repeat and another pose have the component, as if it had been measured there alone."""
    changed(tmp_path, "a.csv", lambda table: stopped_at(second, table))
    changed(tmp_path, "b.csv", lambda table: table, seed=38)
    alone = record("ambient", "a.csv") + record("ambient", "b.csv", pose="P2")
    found = identify(tmp_path, HEAD + SENSORS + alone)
    assert sentence in found.remarks
    data = read_modes(found.file, CHANNELS)
    of = [data.shapes[data.pose == number] for number in (0, 1)]
    assert np.isnan(of[0][:, 1]).all()
    assert np.isfinite(of[0][:, [0, 2]]).all()
    assert np.isfinite(of[1]).all()
    both = read_modes(identify(tmp_path, HEAD + SENSORS + record("ambient", "a.csv", "b.csv")).file, CHANNELS)
    np.testing.assert_allclose(both.frequency, Frame.build().modes()[0], rtol=4e-3)
    for row, sigma, shape in zip(both.shapes, both.shape_sigma, Frame.build().modes()[1].T, strict=True):
        error = row - shape / shape[np.argmax(np.abs(shape))]
        assert np.abs(error).max() < 4.0 * max(sigma, 0.01)


def test_a_sensor_whose_range_was_exceeded_is_said_with_its_share(tmp_path: Path) -> None:
    def cut(table: np.ndarray) -> np.ndarray:
        limit = 2.5 * table[:, 2].std()
        table[:, 2] = np.round(np.clip(table[:, 2], -limit, limit) / limit * 127.0)
        table[:, 3] = np.round(table[:, 3] / np.abs(table[:, 3]).max() * 127.0)  # as coarse, and whole
        return table

    changed(tmp_path, "a.csv", cut)
    found = identify(tmp_path, HEAD + SENSORS + record("ambient", "a.csv"))
    overloaded = [one for one in found.record["messages"] if "overloaded" in one]
    share = 100.0 * np.mean(np.abs(np.loadtxt(tmp_path / "a.csv", delimiter=",", skiprows=1)[:, 2]) == 127.0)
    assert len(overloaded) == 1
    assert (
        f"a.csv: a2 is overloaded: {share:.2g} % of its samples are clipped at 127 and -127" in overloaded[0]
    )


LOST = slice(9000, 9400)


def test_samples_that_are_missing_in_the_middle_are_said(tmp_path: Path) -> None:
    """Times that jump, though uneven or with a rate; and times as even as if none were missing, beside a rate."""
    rng = np.random.default_rng(39)
    without = partial(np.delete, obj=LOST, axis=0)

    def late(table: np.ndarray) -> np.ndarray:
        table[:, 0] += STEP * rng.uniform(0.0, 0.9, len(table))
        return without(table)

    def spread(table: np.ndarray) -> np.ndarray:
        kept = without(table)
        kept[:, 0] = np.linspace(table[0, 0], table[-1, 0], len(kept))
        return kept

    changed(tmp_path, "jump.csv", without)
    changed(tmp_path, "late.csv", late)
    changed(tmp_path, "spread.csv", spread)
    text = HEAD + SENSORS
    jump = "s is 401 times the usual one: the record is split there"
    stated = 'rate = "1024 Hz"\n'
    assert jump in identify(tmp_path, text + record("ambient", "jump.csv") + stated).remarks
    said = identify(tmp_path, text + record("ambient", "late.csv") + stated).remarks
    assert re.search(r"late.csv: the step from 8.78\d* s to 9.1\d* s is 40\d.* times the usual one", said)
    said = identify(tmp_path, text + record("ambient", "spread.csv") + stated).remarks
    assert "1004 Hz; the record states 1024 Hz: by that, 400 samples are missing" in said


def test_what_interpolating_once_more_changes_is_in_sigma() -> None:
    """Frequency and damping of one mode change by twice their standard deviations: five times the variance."""
    none = np.zeros(0, complex)

    def fit(signals: list[SimpleNamespace]) -> tuple[FileFit, tuple[str, ...]]:
        omega, damping = 2.0 * np.pi * (50.0 + signals[0].changed), 0.01 + 0.001 * signals[0].changed
        pole = omega * complex(-damping, np.sqrt(1.0 - damping**2))
        mode = Mode(pole, np.ones(1, complex), 0.05, 5e-5, 0.02, (1, 1))
        return FileFit(
            Estimate((mode,), Stabilisation(np.zeros(0, int), ()), none.real, none, none), ("a",)
        ), ()

    given = SimpleNamespace(changed=0.0, reinterpolated=SimpleNamespace(changed=0.1))
    found, said = fit_with_bridges(fit, [given], "a.csv")
    (mode,) = found.estimate.modes
    sigmas = mode.sigma_frequency, mode.sigma_damping, mode.sigma_shape
    np.testing.assert_allclose(sigmas, np.sqrt(5.0) * np.array([0.05, 5e-5, 0.02]))
    assert "moves the modes by 2 of their standard deviations" in said[0]


def test_a_record_too_long_for_memory_is_reduced_to_fewer_samples(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    """What it leaves out lies above the band: the same modes, to a small part of their standard deviations."""
    write_ambient(tmp_path / "a.csv", np.random.default_rng(33))
    text = HEAD.replace("200 Hz", "120 Hz") + SENSORS + record("ambient", "a.csv")
    whole = identify(tmp_path, text).record
    monkeypatch.setattr("pkmodes.modaltest.signals.reduction.MAX_SAMPLES", 10_000)
    fewer = identify(tmp_path, text).record
    pairs = list(zip(whole["modes"], fewer["modes"], strict=True))
    assert len(pairs) == 2
    for one, other in pairs:
        assert abs(one["frequency"] - other["frequency"]) < 0.2 * one["sigma_parts"]["fit"]
        assert abs(one["damping"] - other["damping"]) < 0.2 * one["sigma_damping"]


@pytest.mark.parametrize("repeats", [1, 4])
def test_spectra_give_frequencies_alone(tmp_path: Path, repeats: int) -> None:
    """Klipper's table: lines 1.6 Hz apart, no phase; repeats have the same lines, and average nothing of them out."""
    f = np.arange(4.8, 250.0, 1.6)
    frame = Frame.build()
    natural, _ = frame.modes()
    power = np.abs(np.einsum("fkk->fk", frame.accelerances(f))) ** 2
    rng = np.random.default_rng(37)
    for i in range(4):
        noisy = power * np.exp(0.05 * rng.normal(size=power.shape))
        np.savetxt(
            tmp_path / f"k{i}.csv",
            np.column_stack([f, noisy, noisy.sum(axis=1)]),
            delimiter=",",
            header="freq,psd_x,psd_y,psd_z,psd_xyz",
            comments="",
            fmt="%.6e",
        )
    sensor = "".join(f'[[sensor]]\nname = "{name}"\nchannel = "none"\n' for name in "xyz")
    files = [f"k{i}.csv" for i in range(repeats)]
    found = identify(tmp_path, HEAD + sensor + record("spectrum", *files))
    modes = found.record["modes"]
    assert len(modes) == 3
    for mode, expected in zip(modes, natural, strict=True):
        assert abs(mode["frequency"] - expected) < 2.0 * mode["sigma"]
        assert 1.6 / np.sqrt(12.0) <= mode["sigma_parts"]["fit"] < 0.6
        assert mode["damping"] is None
        assert mode["found_in"] is None
    data = read_modes(found.file, CHANNELS)
    assert not data.channels
    assert np.isnan(data.numbers["damping"]).all()
    assert "sigma,damping,sigma_damping,mode,sigma_shape\n" in found.file.read_text(encoding="utf-8")
