"""Frequency responses with the opposite sign of phase: refused as what they are, and mended if asked."""

from __future__ import annotations

from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest

from modaltest.campaign.structures import HEAD, Frame, identify, record, refused, sensors, write_frf
from modaltest.campaign.test_frf_campaigns import SENSORS, F, in_units
from modaltest.campaign.test_universal_quotients import (
    CAMPAIGN,
    STEP,
    accelerances,
    has_the_modes_of_the_frame,
)
from modaltest.signals.universal import frf58

TABLE = HEAD + SENSORS + record("frf", "r.csv")


@pytest.mark.parametrize("conjugates", [(0, 1, 2), (1,)])
def test_conjugates_also_of_a_mixed_file(tmp_path: Path, conjugates: tuple[int, ...]) -> None:
    H = accelerances()
    H[:, conjugates] = H[:, conjugates].conj()
    (tmp_path / "r.uff").write_bytes(b"".join(frf58(H[:, k], STEP, response=(k + 1, 3)) for k in range(3)))
    said = refused(tmp_path, CAMPAIGN)
    names = ", ".join(f"{k + 1}:+Z/1:+Z" for k in conjugates)
    assert f"in {len(conjugates)} of 3 functions ({names}): these are complex conjugates" in said
    assert "(r.uff); write conjugate = true in the record" in said
    has_the_modes_of_the_frame(identify(tmp_path, CAMPAIGN + "conjugate = true\n").file)


def test_what_is_no_conjugate_is_left_as_it_is(tmp_path: Path) -> None:
    H = accelerances()
    (tmp_path / "r.uff").write_bytes(b"".join(frf58(H[:, k], STEP, response=(k + 1, 3)) for k in range(3)))
    has_the_modes_of_the_frame(identify(tmp_path, CAMPAIGN + "conjugate = true\n").file)


@pytest.mark.parametrize(("ratio", "noise"), [(2e-3, 0.01), (0.15, 0.05), (0.01, 1.0)])
def test_no_causal_function_is_taken_for_a_conjugate(tmp_path: Path, ratio: float, noise: float) -> None:
    """Decays as long as the lines resolve, decays within a period, and as much noise as signal."""
    frame = replace(Frame.build(), ratios=np.full(3, ratio))
    for seed in range(3):
        H = in_units(frame.accelerances(F))
        write_frf(tmp_path / "r.csv", F, H, noise, np.random.default_rng(seed))
        identify(tmp_path, TABLE)
        write_frf(
            tmp_path / "r.csv", F, {k: h.conj() for k, h in H.items()}, noise, np.random.default_rng(seed)
        )
        mended = identify(tmp_path, TABLE + "conjugate = true\n").record["modes"]
        found = np.array([mode["frequency"] for mode in mended])
        if ratio < 0.1:  # higher damping leaves nothing to tell by in one of the functions
            np.testing.assert_allclose(found[:1], frame.modes()[0][:1], rtol=2e-3)


def of_other_forces(seed: int, averages: int = 4) -> dict[str, np.ndarray]:
    """H1 of a force on the third floor, while forces on all floors that nobody measures make most of the vibration.

    The spectra of the forces are independent at each line and average.
    """
    rng = np.random.default_rng(seed)
    H = Frame.build().accelerances(F)
    own, others = rng.normal(size=(2, averages, len(F))), rng.normal(size=(2, averages, len(F), 3))
    X, Z = own[0] + 1j * own[1], others[0] + 1j * others[1]
    Y = 0.05 * H[:, :, 2] * X[:, :, None] + np.einsum("fij,afj->afi", H, Z)
    h1 = (X.conj()[:, :, None] * Y).sum(axis=0) / (np.abs(X) ** 2).sum(axis=0)[:, None]
    return {f"a{k + 1}": h1[:, k] for k in range(3)}


OTHERS = HEAD + sensors("m/s^2", "m/s^2", "m/s^2") + record("frf", "r.csv")
#: Of 150 files, two with more than 65 % of the vibration before the force; one resonance of the first stands out.
EARLY = (60, 138)


@pytest.mark.parametrize("seed", EARLY)
def test_what_other_forces_make_is_no_conjugate(tmp_path: Path, seed: int) -> None:
    write_frf(tmp_path / "r.csv", F, of_other_forces(seed), 0.0, np.random.default_rng(seed))
    if seed == EARLY[0]:
        told = identify(tmp_path, OTHERS).remarks
        assert "hold more vibration before the force than after it" in told
        assert "mostly not responses to this force" in told
    else:
        told = refused(tmp_path, OTHERS)
        assert "expected modes, found none" in told
    assert "conjugate = true" not in told


@pytest.mark.parametrize("seed", [60, 86])
def test_noisy_conjugates_are_still_said_to_be(tmp_path: Path, seed: int) -> None:
    """As much noise as response."""
    H = {k: h.conj() for k, h in in_units(Frame.build().accelerances(F)).items()}
    write_frf(tmp_path / "r.csv", F, H, 1.0, np.random.default_rng(seed))
    assert "write conjugate = true in the record" in refused(tmp_path, TABLE)


@pytest.mark.parametrize("key", ["conjugate", "invert"])
def test_keys_of_frequency_responses_are_refused_elsewhere(tmp_path: Path, key: str) -> None:
    said = refused(tmp_path, TABLE.replace('"frf"', '"impact"') + f"{key} = true\n")
    assert f'expected the kind frf with {key}, found "impact" (c.toml: record.1.{key})' in said
