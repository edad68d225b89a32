"""``[[edit]] add``: a mode fitted from the user's frequency, or refused with the reason; truth from closed forms."""

from __future__ import annotations

import json
from pathlib import Path

import numpy as np
import pytest

from modaltest.campaign.structures import (
    HEAD,
    Frame,
    accelerations,
    identify,
    record,
    refused,
    sensors,
    write_frf,
)
from pkmodes.modaltest.campaign.campaign import read_campaign
from pkmodes.modaltest.campaign.edits import apply_edits
from pkmodes.modaltest.campaign.results import IdentifiedMode, Parts
from pkmodes.modaltest.identification.requested_modes import RequestedModes

F = np.arange(10.0, 220.0, 0.25)
ALIKE = HEAD + sensors("m/s^2", "m/s^2", "m/s^2")
#: Natural frequencies, damping ratios and residues of a structure: the third is weak.
NATURAL, RATIOS = np.array([41.0, 97.0, 128.0, 163.0]), np.array([0.01, 0.008, 0.012, 0.009])
SHAPES = np.array([[1.0, 0.8, 0.3], [0.9, -0.4, -0.8], [0.5, 1.0, -0.7], [0.4, -1.0, 0.9]])
WEAK = 2


def accelerances(weak: float) -> np.ndarray:
    """Sum of the modes in closed form, (F, 3), the third one's residues times a factor."""
    w, n = 2.0 * np.pi * F[:, None], 2.0 * np.pi * NATURAL
    each = -(w**2) / (n**2 - w**2 + 2j * RATIOS * n * w)
    factors = np.where(np.arange(4) == WEAK, weak, 1.0)
    return (each * factors * SHAPES[:, 0]) @ SHAPES


def write_repeats(folder: Path, seed: int, weak: float, count: int = 3, noise: float = 0.03) -> str:
    rng = np.random.default_rng(seed)
    for i in range(count):
        H = accelerances(weak)
        write_frf(folder / f"r{i}.csv", F, {f"a{k + 1}": H[:, k] for k in range(3)}, noise, rng)
    return ALIKE + record("frf", *(f"r{i}.csv" for i in range(count)))


def edit(**keys: list[str]) -> str:
    return '[[edit]]\npose = "P1"\n' + "".join(
        f"{key} = {json.dumps(value)}\n" for key, value in keys.items()
    )


def near(record: dict, frequency: float) -> dict:
    (found,) = [mode for mode in record["modes"] if abs(mode["frequency"] / frequency - 1.0) < 0.01]
    return found


def test_a_mode_too_weak_to_be_found_is_fitted_from_the_given_frequency(tmp_path: Path) -> None:
    text = write_repeats(tmp_path, 11, 0.008)
    plain = identify(tmp_path, text).record
    assert [round(mode["frequency"]) for mode in plain["modes"]] == [41, 97, 163]
    found = identify(tmp_path, text + edit(add=["127.2 Hz"])).record
    assert [mode["edited"] for mode in found["modes"]] == [None, None, "added", None]
    added = found["modes"][2]
    fit = np.hypot(added["sigma_parts"]["scatter"], added["sigma_parts"]["fit"])
    assert abs(added["frequency"] - NATURAL[WEAK]) < 2.0 * fit
    assert 0.01 < fit < 1.0
    assert abs(added["damping"] - RATIOS[WEAK]) < 2.0 * added["sigma_damping"]
    assert added["files"] >= 2
    for mode, before in zip([found["modes"][i] for i in (0, 1, 3)], plain["modes"], strict=True):
        assert abs(mode["frequency"] - before["frequency"]) < 0.5 * before["sigma_parts"]["fit"]


@pytest.mark.parametrize("files", [1, 3])
def test_a_frequency_where_nothing_vibrates_is_refused(tmp_path: Path, files: int) -> None:
    """A single file is what noise imitates a mode in most easily."""
    message = refused(tmp_path, write_repeats(tmp_path, 12, 0.0, files) + edit(add=["70 Hz"]))
    assert "no mode can be added at 70 Hz" in message
    assert "(P1)" in message
    assert "c.toml: edit" in message


def test_an_added_mode_replaces_the_one_that_is_there(tmp_path: Path) -> None:
    text = write_repeats(tmp_path, 13, 1.0)
    plain = identify(tmp_path, text).record
    found = identify(tmp_path, text + edit(add=["97.5 Hz"])).record
    assert [mode["edited"] for mode in found["modes"]] == [None, "added", None, None]
    assert found["struck"] == []
    for mode, before in zip(found["modes"], plain["modes"], strict=True):
        # Fits end where a step changes the pole by less than a thousandth of its half bandwidth.
        assert mode["frequency"] == pytest.approx(before["frequency"], rel=1e-6)
        assert mode["damping"] == pytest.approx(before["damping"], rel=1e-3)


def test_an_added_mode_replaces_only_the_reported_one_within_one_per_cent() -> None:
    def mode(frequency: float, edit: str | None = None) -> IdentifiedMode:
        return IdentifiedMode(frequency, Parts(0.0, 0.1, 0.1), 0.01, 0.001, {}, np.nan, np.nan, None, 1, edit)

    reported = [mode(49.4), mode(49.7), mode(50.6)]
    kept, struck = apply_edits(
        reported, [mode(50.0, "added")], RequestedModes((50.6,), (50.0,)), "P1", "c.toml"
    )
    assert [(one.frequency, one.edited) for one in kept] == [(49.4, None), (50.0, "added")]
    assert struck == [50.6]


def test_what_several_edits_ask_of_one_record_adds_up(tmp_path: Path) -> None:
    text = ALIKE + record("frf", "r.csv")
    edits = edit(strike=["41 Hz"], add=["97 Hz"]) + edit(strike=["163 Hz"])
    (tmp_path / "c.toml").write_text(text + edits, encoding="utf-8")
    campaign = read_campaign(tmp_path / "c.toml")
    assert campaign.edits_of(campaign.records[0]) == RequestedModes((41.0, 163.0), (97.0,))


def test_a_mode_that_is_struck_and_added_is_fitted_again(tmp_path: Path) -> None:
    text = write_repeats(tmp_path, 14, 1.0)
    plain = identify(tmp_path, text).record
    found = identify(tmp_path, text + edit(strike=["128 Hz"], add=["128 Hz"])).record
    assert found["struck"] == [pytest.approx(near(plain, 128.0)["frequency"], rel=1e-6)]
    added = near(found, 128.0)
    assert added["edited"] == "added"
    assert added["frequency"] == pytest.approx(near(plain, 128.0)["frequency"], rel=1e-6)


def test_a_mode_that_most_files_lack_is_refused(tmp_path: Path) -> None:
    text = write_repeats(tmp_path, 15, 0.0)
    rng = np.random.default_rng(16)
    write_frf(tmp_path / "r0.csv", F, {f"a{k + 1}": accelerances(1.0)[:, k] for k in range(3)}, 0.03, rng)
    message = refused(tmp_path, text + edit(add=["128 Hz"]))
    assert "no mode can be added at 128 Hz: it is found in 1 of 3 files only (P1)" in message


def test_frequencies_outside_the_band_are_refused(tmp_path: Path) -> None:
    message = refused(tmp_path, write_repeats(tmp_path, 17, 1.0, 1) + edit(add=["210 Hz"]))
    assert "no mode can be added at 210 Hz: the band of P1 is 20 Hz to 200 Hz" in message


def test_two_frequencies_that_lead_to_one_mode_are_refused(tmp_path: Path) -> None:
    text = write_repeats(tmp_path, 18, 1.0, 1)
    message = refused(tmp_path, text + edit(add=["97 Hz", "97.4 Hz"]))
    assert "no mode can be added at 97.4 Hz" in message


def test_a_mode_of_one_setup_is_added(tmp_path: Path) -> None:
    """The second setup's sensor is at a node."""
    rng = np.random.default_rng(19)
    for i in range(2):
        H = accelerances(0.02)
        write_frf(tmp_path / f"r{i}.csv", F, {"a1": H[:, 0], "a2": H[:, 1]}, 0.03, rng)
        H = accelerances(0.0)
        write_frf(tmp_path / f"s{i}.csv", F, {"a1": H[:, 0], "a3": H[:, 2]}, 0.03, rng)
    files = 'files = { one = ["r0.csv", "r1.csv"], other = ["s0.csv", "s1.csv"] }\n'
    text = ALIKE + '[[record]]\npose = "P1"\nkind = "frf"\n' + files
    found = identify(tmp_path, text + edit(strike=[], add=["128 Hz"])).record
    added = near(found, 128.0)
    assert (added["edited"], added["files"]) == ("added", 2)


def test_a_mode_of_impacts_is_added(tmp_path: Path) -> None:
    """The second floor's sensor alone, on which the third mode is weak: struck and added."""
    frame, rng, step = Frame.build(), np.random.default_rng(20), 1.0 / 2048.0
    t = step * np.arange(8192)
    force = np.where(t < 0.003, np.sin(np.pi * t / 0.003), 0.0)
    for i in range(2):
        a = accelerations(frame, step, force, 2)
        a = a + 0.005 * a.std(axis=0) * rng.normal(size=a.shape)
        table = np.column_stack([t, force, a])
        np.savetxt(tmp_path / f"h{i}.csv", table, delimiter=",", header="time,force,a1,a2,a3", comments="")
    text = ALIKE + record("impact", "h0.csv", "h1.csv")
    natural = frame.modes()[0][1]
    found = identify(
        tmp_path, text + edit(strike=[f"{natural:.6g} Hz"], add=[f"{1.004 * natural:.6g} Hz"])
    ).record
    added = near(found, natural)
    assert added["edited"] == "added"
    assert added["frequency"] == pytest.approx(natural, rel=1e-3)
    assert len(found["struck"]) == 1


def test_a_mode_of_responses_alone_is_added_or_refused(tmp_path: Path) -> None:
    frame, rng, step = Frame.build(), np.random.default_rng(21), 1.0 / 512.0
    count = round(40.0 / step)
    a = sum(accelerations(frame, step, rng.normal(size=count), floor) for floor in range(3))
    a = a + 0.05 * a.std(axis=0) * rng.normal(size=a.shape)
    table = np.column_stack([step * np.arange(count), a])
    np.savetxt(tmp_path / "a.csv", table, delimiter=",", header="time,a1,a2,a3", comments="", fmt="%.9g")
    text = ALIKE + record("ambient", "a.csv")
    plain, natural = identify(tmp_path, text).record, frame.modes()[0]
    wanted = f"{1.005 * natural[1]:.6g} Hz"
    for edits in (edit(add=[wanted]), edit(strike=[wanted], add=[wanted])):
        found = identify(tmp_path, text + edits).record
        assert [mode["edited"] for mode in found["modes"]] == [None, "added", None]
        before, added = plain["modes"][1], found["modes"][1]
        assert added["frequency"] == pytest.approx(
            before["frequency"], abs=0.1 * before["sigma_parts"]["fit"]
        )
        assert added["sigma_parts"]["fit"] == pytest.approx(before["sigma_parts"]["fit"], rel=0.1)
    assert "no mode can be added at 170 Hz" in refused(tmp_path, text + edit(add=["170 Hz"]))


def test_a_peak_of_a_spectrum_is_added_or_refused(tmp_path: Path) -> None:
    """A peak too low beside the strongest to be taken for a mode."""
    f = np.arange(10.0, 220.0, 1.6)
    power = sum(
        height / (1.0 + ((f - at) / 1.5) ** 2) for at, height in ((60.3, 1.0), (120.4, 8e-4), (170.2, 0.5))
    )
    power = power + 4e-4
    np.savetxt(
        tmp_path / "k.csv", np.column_stack([f, power]), delimiter=",", header="freq,psd_x", comments=""
    )
    sensor = '[[sensor]]\nname = "x"\nchannel = "none"\n'
    text = HEAD + sensor + record("spectrum", "k.csv")
    assert [round(mode["frequency"]) for mode in identify(tmp_path, text).record["modes"]] == [60, 170]
    found = identify(tmp_path, text + edit(add=["119 Hz"])).record
    added = near(found, 120.4)
    assert added["edited"] == "added"
    assert abs(added["frequency"] - 120.4) < 2.0 * added["sigma_parts"]["fit"]
    message = refused(tmp_path, text + edit(add=["90 Hz"]))
    assert "no mode can be added at 90 Hz: the spectrum has no peak within 3 % of it (P1)" in message
