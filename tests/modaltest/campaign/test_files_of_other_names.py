"""Campaigns of files that call their signals otherwise, count their samples, or hold several measurements."""

from __future__ import annotations

import json
from pathlib import Path

import numpy as np
import pytest
from scipy.io import wavfile

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
from pkmodes.modaltest.campaign.sensors import apply_sign
from pkmodes.modaltest.signals.reading import read_signals

STEP = 1.0 / 2048.0
ACCELEROMETERS = HEAD + sensors("m/s^2", "m/s^2", "m/s^2")


def blow(floor: int = 2, *, seconds: float = 2.0) -> tuple[np.ndarray, np.ndarray]:
    """The force of a blow of 3 ms on a floor (N,), and the accelerations of all floors (N, 3), without noise."""
    t = STEP * np.arange(round(seconds / STEP))
    force = np.where(t < 0.05, 0.0, 200.0 * np.sin(np.pi * (t - 0.05) / 0.003)) * (t < 0.053)
    return force, accelerations(Frame.build(), STEP, force, floor)


def noisy(values: np.ndarray, seed: int) -> np.ndarray:
    return values + 0.003 * values.std(axis=0) * np.random.default_rng(seed).normal(size=values.shape)


def check(file: Path) -> None:
    """The modes in a file are those of the frame."""
    data, frame = read_modes(file, CHANNELS), Frame.build()
    natural, shapes = frame.modes()
    np.testing.assert_allclose(data.frequency, natural, rtol=1e-3)
    np.testing.assert_allclose(data.damping, frame.ratios, rtol=0.05)
    for row, shape in zip(data.shapes, shapes.T, strict=True):
        np.testing.assert_allclose(row, shape / shape[np.argmax(np.abs(shape))], rtol=0, atol=0.03)


def test_a_table_in_which_nothing_has_the_names_of_the_campaign(tmp_path: Path) -> None:
    """The names of the record are those that the errors ask for, one after the other."""
    force, a = blow()
    table = np.column_stack([1e3 * STEP * np.arange(len(force)), force, noisy(a, 1)])
    names = "Elapsed [ms],Hammer [N],Ch 1,A2,a3"
    np.savetxt(tmp_path / "b.csv", table, delimiter=",", header=names, comments="", fmt="%.9g")
    campaign = ACCELEROMETERS + record("impact", "b.csv")
    error = refused(tmp_path, campaign)
    assert 'found "Elapsed [ms]", "Hammer [N]", "Ch 1", "A2", "a3" (b.csv: line 1)' in error
    assert 'names = { time = "NAME" }' in error
    error = refused(tmp_path, campaign + 'names = { time = "Elapsed" }\n')
    assert "expected a force, found none (b.csv)" in error
    assert (
        'state in the record which of "Hammer", "Ch 1", "A2", "a3" it is, names = { force = "NAME" }' in error
    )
    named = 'names = { time = "Elapsed", force = "Hammer", a1 = "Ch 1" }\n'
    check(identify(tmp_path, campaign + named).file)


MISTAKES = [
    ('names = { frce = "x" }\n', "impact", 'found "frce" (c.toml: record.1.names); did you mean "force"?'),
    ('names = { force = "x", a1 = "x" }\n', "impact", '"x" is given two names (c.toml: record.1.names)'),
    ('names = { force = "x" }\n', "modes", 'with names, found the kind "modes" (c.toml: record.1.names)'),
    (
        'names = { force = "x" }\n',
        "impact",
        'expected "x", which the record names as its force, found "time", "force", "a1"',
    ),
    ("names = { force = 1 }\n", "impact", "expected text, found an integer (c.toml: record.1.names"),
]


@pytest.mark.parametrize(("line", "kind", "message"), MISTAKES)
def test_mistakes_in_the_names_of_a_record(tmp_path: Path, line: str, kind: str, message: str) -> None:
    (tmp_path / "b.csv").write_text("time,force,a1\n0,1,2\n1,2,3\n2,5,6\n", encoding="utf-8")
    campaign = HEAD + sensors("m/s^2") + record(kind, "b.csv")
    assert message in refused(tmp_path, campaign + line)


def test_one_measurement_of_an_array_after_the_other(tmp_path: Path) -> None:
    force, a = blow()
    records = np.stack([np.column_stack([force, noisy(a, seed)]) for seed in (2, 3)], axis=2)
    np.savez(tmp_path / "hits.npz", records=records, Fs=1.0 / STEP)
    named = "names = { force = 'records_1', a1 = 'records_2', a2 = 'records_3', a3 = 'records_4' }\n"
    error = refused(tmp_path, ACCELEROMETERS + record("impact", "hits.npz") + named)
    assert 'files = ["hits.npz/1", "hits.npz/2"]' in error
    found = identify(tmp_path, ACCELEROMETERS + record("impact", "hits.npz/1", "hits.npz/2") + named)
    assert [mode["files"] for mode in found.record["modes"]] == [2, 2, 2]
    check(found.file)


def test_a_sound_file_of_a_hammer_and_accelerometers(tmp_path: Path) -> None:
    """At 16 bits, and the channels of full scales that the campaign does not need."""
    force, a = blow()
    parts = np.column_stack([force / (1.1 * force.max()), noisy(a, 4) / (1.1 * np.abs(a).max())])
    wavfile.write(tmp_path / "hit.wav", round(1.0 / STEP), np.round(32767 * parts).astype(np.int16))
    numbered = ACCELEROMETERS
    for k in (3, 2, 1):
        numbered = numbered.replace(f'"a{k}"', f'"{k + 1}"')
    found = identify(tmp_path, numbered + record("impact", "hit.wav"))
    check(found.file)
    assert "channel 1, which belongs to no sensor, is taken as the force" in found.remarks
    assert "its numbers are parts of full scale" in found.remarks
    without = numbered.replace('unit = "m/s^2"\n', "", 1) + record("impact", "hit.wav")
    assert "expected the unit of the sensor, found none in the file (hit.wav: 2)" in refused(
        tmp_path, without
    )
    two = HEAD + sensors("m/s^2").replace('"a1"', '"2"') + record("impact", "hit.wav")
    error = refused(tmp_path, two)
    assert (
        'expected a force, found none (hit.wav); state in the record which of "1", "2", "3", "4" it is'
        in error
    )
    single = identify(tmp_path, two + 'names = { force = "1" }\n')
    np.testing.assert_allclose(
        read_modes(single.file, CHANNELS).frequency, Frame.build().modes()[0], rtol=1e-3
    )


def test_counted_samples_have_the_rate_of_the_comments(tmp_path: Path) -> None:
    rng = np.random.default_rng(5)
    a = accelerations(Frame.build(), STEP, rng.normal(size=40 * 2048), 1)
    rows = np.column_stack([np.arange(1, len(a) + 1), noisy(a, 6)])
    comments = "# logger 7\n# Config: data_rate = 2048.0 Hz, filter = 488 Hz\nSample,a1,a2,a3"
    np.savetxt(tmp_path / "b.csv", rows, delimiter=",", header=comments, comments="", fmt="%.9g")
    found = identify(tmp_path, ACCELEROMETERS + record("ambient", "b.csv"))
    data = read_modes(found.file, CHANNELS)
    assert (np.abs(data.frequency - Frame.build().modes()[0]) < 4.0 * data.sigma).all()
    assert (data.sigma < 0.01 * data.frequency).all()
    assert 'its rate, 2048 Hz, is that of its comment "data_rate = 2048.0 Hz"' in found.remarks


def test_one_of_two_signals_with_one_label(tmp_path: Path) -> None:
    """The hammer and three accelerometers, all of which the program labelled 1:+Z."""
    force, a = blow()
    content = b""
    for signal, kind in ((force, 13), *((one, 12) for one in noisy(a, 7).T)):
        content += dataset58b(
            packed(signal, "f"), count=len(force), step=STEP, response=(1, 3), quantity=(kind, "NONE")
        )
    (tmp_path / "b.uff").write_bytes(content)
    campaign = ACCELEROMETERS + record("impact", "b.uff")
    alike = campaign.replace('"a1"', '"1:+Z"').replace('"a2"', '"2:+Z"').replace('"a3"', '"3:+Z"')
    error = refused(tmp_path, alike)
    assert 'the signal "1:+Z" occurs twice (b.uff)' in error
    assert 'choose it by its number in the file, name = "1:+Z#2"' in error
    chosen = campaign
    for k in (1, 2, 3):
        chosen = chosen.replace(f'"a{k}"', json.dumps(f"1:+Z#{k}"))
    check(identify(tmp_path, chosen).file)


def test_the_sign_of_a_numbered_label_counts_where_those_of_the_file_do(tmp_path: Path) -> None:
    force, a = blow()
    content = dataset58b(
        packed(force, "f"), count=len(force), step=STEP, response=(9, 3), quantity=(13, "NONE")
    )
    for signal in -noisy(a, 8).T:
        content += dataset58b(
            packed(signal, "f"), count=len(force), step=STEP, response=(1, -3), quantity=(12, "NONE")
        )
    (tmp_path / "b.uff").write_bytes(content)
    campaign = 'signs = "file"\n' + ACCELEROMETERS + record("impact", "b.uff")
    for k in (1, 2, 3):
        campaign = campaign.replace(f'"a{k}"', json.dumps(f"1:-Z#{k}"))
    numbered = [one for one in read_signals(tmp_path / "b.uff").functions if not one.force]
    for one, expected in zip(numbered, noisy(a, 8).T, strict=True):
        np.testing.assert_allclose(apply_sign(one).values, expected, rtol=1e-6, atol=1e-9)
    check(identify(tmp_path, campaign).file)
