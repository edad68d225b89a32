"""Frequency responses with the opposite sign of phase: refused as what they are, and mended if asked."""

from __future__ import annotations

from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest

from campaign.structures import HEAD, Frame, identify, record, refused, write_frf
from campaign.test_frf_campaigns import SENSORS, F, in_units
from campaign.test_universal_quotients import CAMPAIGN, STEP, accelerances, has_the_modes_of_the_frame
from signals.universal import frf58

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


@pytest.mark.parametrize("key", ["conjugate", "invert"])
def test_keys_of_frequency_responses_are_refused_elsewhere(tmp_path: Path, key: str) -> None:
    said = refused(tmp_path, TABLE.replace('"frf"', '"impact"') + f"{key} = true\n")
    assert f'expected the kind frf with {key}, found "impact" (c.toml: record.1.{key})' in said
