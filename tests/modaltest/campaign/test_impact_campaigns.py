"""Campaigns of hammer blows: force and responses in time to rows."""

from __future__ import annotations

import json
import re
from pathlib import Path

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
from modaltest.signals.universal import dataset58b, packed
from pkmodes.loop.measured.reading import read_modes

IMPACT = HEAD + sensors("m/s^2", "g0", "m/s^2")
ONE = IMPACT + record("impact", "b.csv")
STEP, BLOW, APART = 1.0 / 2048.0, 0.003, 2.0


def write_blows(
    path: Path,
    rng: np.random.Generator,
    hits: int = 1,
    *,
    bounce: float = 0.0,
    limit: float = np.inf,
    window: float = 0.0,
    floor: int = 2,
    stiffer: float = 1.0,
) -> None:
    """Write a table of blows on a floor, two seconds apart, with noise of force and responses."""
    t = STEP * np.arange(round((hits * APART + 0.05) / STEP))
    force = np.zeros(len(t))
    for k in range(hits):
        for start, size in (
            (0.05 + k * APART, 200.0 * rng.uniform(0.7, 1.3)),
            (0.08 + k * APART, 200.0 * bounce),
        ):
            inside = (t >= start) & (t < start + BLOW)
            force[inside] += size * np.sin(np.pi * (t[inside] - start) / BLOW)
    a = accelerations(Frame.build(stiffer), STEP, force, floor)
    if window:
        a *= np.exp(-t / window)[:, None]
    a += 0.003 * a.std(axis=0) * rng.normal(size=a.shape)
    a = np.clip(a, -limit * np.abs(a).max(), limit * np.abs(a).max())
    table = np.column_stack([t, force + 0.1 * rng.normal(size=len(t)), a / [1.0, 9.80665, 1.0]])
    np.savetxt(path, table, delimiter=",", header="time,force,a1,a2,a3", comments="", fmt="%.9g")


@pytest.mark.parametrize("hits", [1, 3])
def test_blows_give_the_modes_of_the_structure(tmp_path: Path, hits: int) -> None:
    rng = np.random.default_rng(20 + hits)
    for i in range(3):
        write_blows(tmp_path / f"b{i}.csv", rng, hits)
    blows = record("impact", "b0.csv", "b1.csv", "b2.csv")
    found = identify(tmp_path, IMPACT + blows + f"hits = {hits}\n")
    data, frame = read_modes(found.file, CHANNELS), Frame.build()
    natural, shapes = frame.modes()
    np.testing.assert_allclose(data.frequency, natural, rtol=1e-3)
    np.testing.assert_allclose(data.numbers["damping"], frame.ratios, rtol=0.05)
    for row, shape in zip(data.shapes, shapes.T, strict=True):
        np.testing.assert_allclose(row, shape / shape[np.argmax(np.abs(shape))], rtol=0, atol=0.03)
    assert not [message for message in found.record["messages"] if "double" in message]


def test_double_hits_and_overloads_are_said(tmp_path: Path) -> None:
    rng = np.random.default_rng(9)
    write_blows(tmp_path / "b0.csv", rng, bounce=0.4)
    write_blows(tmp_path / "b1.csv", rng, limit=0.3)
    found = identify(tmp_path, IMPACT + record("impact", "b0.csv", "b1.csv"))
    said = " ".join(found.record["messages"])
    assert "b0.csv: blow 1 at" in said
    assert "is a double hit" in said
    assert re.search(r"b1.csv: a\d is overloaded", said)
    assert "double hit" in found.remarks


@pytest.mark.parametrize("seed", [2, 4])
def test_blows_that_the_noise_hides_give_a_file_that_can_be_read(tmp_path: Path, seed: int) -> None:
    """Responses with twelve times their own size of noise: what nothing is known of is blank, and said."""
    rng = np.random.default_rng(seed)
    for i in range(2):
        write_blows(tmp_path / f"b{i}.csv", rng, 2)
        table = np.loadtxt(tmp_path / f"b{i}.csv", delimiter=",", skiprows=1)
        table[:, 2:] += 12.0 * table[:, 2:].std(axis=0) * rng.normal(size=table[:, 2:].shape)
        np.savetxt(tmp_path / f"b{i}.csv", table, delimiter=",", header="time,force,a1,a2,a3", comments="")
    text = HEAD + sensors("m/s^2", "m/s^2", "m/s^2") + record("impact", "b0.csv", "b1.csv") + "hits = 2\n"
    found = identify(tmp_path, text)
    data = read_modes(found.file, CHANNELS)
    known = np.isfinite(data.shapes).any(axis=1)
    for mode, has in zip(found.record["modes"], known, strict=True):
        assert has != (f"the mode at {mode['frequency']:.4g} Hz has no shape" in found.remarks)
    assert not np.isfinite(data.shape_sigma[~known]).any()


def test_the_damping_of_a_window_is_taken_off(tmp_path: Path) -> None:
    write_blows(tmp_path / "b.csv", np.random.default_rng(4), window=0.4)
    found = identify(tmp_path, ONE + 'exponential = "0.4 s"\n')
    np.testing.assert_allclose(
        read_modes(found.file, CHANNELS).numbers["damping"], Frame.build().ratios, rtol=0.1
    )


SENSOR = '[[sensor]]\nname = "a3"\nchannel = "none"\nunit = "m/s^2"\n'


def roving(*, repeats: int, named: str = "force") -> str:
    """A sensor that stays, and a hammer that hits a floor in each setup."""
    forces = "".join(
        f'[[force]]\nname = "{named}"\nchannel = "floor_{k}"\nsetup = "at {k}"\n' for k in (1, 2, 3)
    )
    files = ", ".join(f'"at {k}" = {json.dumps([f"b{k}{i}.csv" for i in range(repeats)])}' for k in (1, 2, 3))
    return HEAD + SENSOR + forces + f'[[record]]\npose = "P1"\nkind = "impact"\nfiles = {{ {files} }}\n'


@pytest.mark.parametrize("repeats", [1, 3])
def test_a_hammer_that_roves_in_time_gives_the_shapes_at_its_points(tmp_path: Path, repeats: int) -> None:
    rng = np.random.default_rng(30)
    for k in (1, 2, 3):
        for i in range(repeats):
            write_blows(tmp_path / f"b{k}{i}.csv", rng, floor=k - 1)
    found = identify(tmp_path, roving(repeats=repeats))
    data, frame = read_modes(found.file, CHANNELS), Frame.build()
    natural, shapes = frame.modes()
    np.testing.assert_allclose(data.frequency, natural, rtol=1e-3)
    np.testing.assert_allclose(data.numbers["damping"], frame.ratios, rtol=0.05)
    for row, sigma, shape in zip(data.shapes, data.shape_sigma, shapes.T, strict=True):
        error = row - shape / shape[np.argmax(np.abs(shape))]
        np.testing.assert_allclose(error, 0.0, rtol=0, atol=0.03)
        assert np.abs(error).max() < 4.0 * sigma < 0.1
    assert "share no sensor" not in found.remarks


def test_a_sensor_that_is_silent_at_one_point_is_no_reference_of_the_others(tmp_path: Path) -> None:
    rng = np.random.default_rng(33)
    for k in (1, 2, 3):
        write_blows(tmp_path / f"b{k}0.csv", rng, floor=k - 1)
    table = np.loadtxt(tmp_path / "b20.csv", delimiter=",", skiprows=1)
    table[:, 3] = 0.37
    np.savetxt(
        tmp_path / "b20.csv", table, delimiter=",", header="time,force,a1,a2,a3", comments="", fmt="%.9g"
    )
    found = identify(tmp_path, roving(repeats=1).replace(SENSOR, SENSOR + SENSOR.replace("a3", "a2")))
    assert "b20.csv: a2 shows nothing" in found.remarks
    for row, shape in zip(read_modes(found.file, CHANNELS).shapes, Frame.build().modes()[1].T, strict=True):
        np.testing.assert_allclose(row, shape / shape[np.argmax(np.abs(shape))], rtol=0, atol=0.03)


def test_points_hit_on_a_changed_machine_are_fitted_one_by_one(tmp_path: Path) -> None:
    """Where its frequencies fell by 0.75 %; with 0.2 % the functions are those of one, and half of it is in sigma."""
    rng = np.random.default_rng(32)
    text = roving(repeats=1).replace("band =", 'repeatability = "0.01 %"\nband =')
    for last, said in ((1.0, ""), (0.996, "0.2 %"), (0.985, "0.75 %")):
        for k in (1, 2, 3):
            write_blows(tmp_path / f"b{k}0.csv", rng, floor=k - 1, stiffer=last if k == 3 else 1.0)
        found = identify(tmp_path, text)
        for change, then in (
            ("0.2 %", "half of it is in sigma"),
            ("0.75 %", "each point is fitted by itself"),
        ):
            sentence = f"differ by {change} between the points that were hit: {then}"
            assert (sentence in found.remarks) is (said == change)
        if said != "0.75 %":
            assert len(found.record["modes"]) == 3
        if said == "0.2 %":
            data = read_modes(found.file, CHANNELS)
            assert (data.sigma > 0.00098 * data.frequency).all()
            assert (data.sigma < 0.0012 * data.frequency).all()


def test_the_degree_of_freedom_of_a_force_says_which_point_was_hit(tmp_path: Path) -> None:
    """In universal files, with the signs and units of each: one setup after the other, one sensor."""
    rng, scale = np.random.default_rng(31), {1: (1.0, "N"), 2: (1.0 / 4.4482216152605, "lbf"), 3: (1.0, "N")}
    for k, (factor, unit) in scale.items():
        write_blows(tmp_path / "b.csv", rng, floor=k - 1)
        _, force, _, _, a3 = np.loadtxt(tmp_path / "b.csv", delimiter=",", skiprows=1).T
        point = (
            k,
            -3 if k == 2 else 3,
        )  # hit against Z: the hammer shows a push, the structure moves the other way
        content = b"".join(
            dataset58b(
                packed(each, "d"), ordinate=4, count=len(force), step=STEP, response=dof, quantity=quantity
            )
            for each, dof, quantity in (
                (factor * force, point, (13, unit)),
                (-a3 if k == 2 else a3, (3, 3), (12, "m/s^2")),
            )
        )
        (tmp_path / f"b{k}.uff").write_bytes(content)
    sensor = '[[sensor]]\nname = "3:+Z"\nchannel = "floor_3"\n'
    forces = "".join(f'[[force]]\nname = "{k}:+Z"\nchannel = "floor_{k}"\n' for k in (1, 2, 3))
    files = ", ".join(f'"at {k}" = ["b{k}.uff"]' for k in (1, 2, 3))
    text = 'signs = "file"\n' + HEAD + sensor + forces
    text += f'[[record]]\npose = "P1"\nkind = "impact"\nfiles = {{ {files} }}\n'
    data = read_modes(identify(tmp_path, text).file, CHANNELS)
    for row, shape in zip(data.shapes, Frame.build().modes()[1].T, strict=True):
        np.testing.assert_allclose(row, shape / shape[np.argmax(np.abs(shape))], rtol=0, atol=0.03)
    other = refused(tmp_path, text.replace('name = "2:+Z"\nchannel', 'name = "7:+Z"\nchannel'))
    assert 'expected a force of the campaign, "1:+Z", "7:+Z", "3:+Z", found "2:-Z" (b2.uff)' in other


@pytest.mark.parametrize(
    ("keys", "message"),
    [
        ("hits = 4\n", "expected 4 blows, found"),
        (
            'band = ["20 Hz", "1200 Hz"]\n',
            "expected a band below half the sampling rate, 1024 Hz, found 1200 Hz (b.csv)",
        ),
    ],
)
def test_wrong_records_are_refused(tmp_path: Path, keys: str, message: str) -> None:
    write_blows(tmp_path / "b.csv", np.random.default_rng(4))
    assert message in refused(tmp_path, ONE + keys)


@pytest.mark.parametrize(
    ("columns", "rows", "second", "message"),
    [
        ([], None, "hammer", "expected a force, found none (b.csv)"),
        ([1], None, "force", "expected blows, found a constant force (b.csv)"),
        ([2, 3, 4], None, "force", "expected signals, found only constant ones: a1, a2, a3 (b.csv)"),
        ([], 20, "force", "expected at least 2 periods of 20 Hz"),
    ],
)
def test_records_without_blows_or_signals_are_refused(
    tmp_path: Path,
    columns: list[int],
    rows: int | None,
    second: str,
    message: str,
) -> None:
    file = tmp_path / "b.csv"
    write_blows(file, np.random.default_rng(4))
    table = np.loadtxt(file, delimiter=",", skiprows=1)
    table[:, columns] = 0.0
    np.savetxt(file, table[:rows], delimiter=",", header=f"time,{second},a1,a2,a3", comments="")
    assert message in refused(tmp_path, ONE)
