"""How often a diagnosis of a complete model claims a cause."""

from __future__ import annotations

import re
from dataclasses import replace

import numpy as np
import pytest
from scipy import stats

from helpers.diagnoses.frame_diagnoses import SIX, TWO, checked, drawn
from helpers.robots.small_structures import SIGMA, frame


def test_false_alarms_are_rare_and_the_refit_leaves_chi_square() -> None:
    """Of 240 data sets of the declared model, few enough are not adequate to exclude a rate of 5 % at 5 %."""
    draws = 240
    structure, found = frame(TWO), [drawn(TWO, seed) for seed in range(draws)]
    results = [checked(structure, data) for data in found]
    alarms = sum(result.verdict != "adequate" for result in results)
    assert stats.binom.cdf(alarms, draws, 0.05) < 0.05
    assert sum(result.verdict in ("effect_found", "ambiguous") for result in results) <= alarms
    # 8 rows, and nuisances that have priors: 8 degrees of freedom.  Kolmogorov's limit for p < 0.001.
    clean = [r for r in results if not r.outliers and not r.scatter]
    chi2 = np.array([8 * r.refit.chi2_per_dof for r in clean])
    assert len(clean) > 0.95 * draws
    assert stats.kstest(chi2, stats.chi2(8).cdf).statistic < 1.95 / np.sqrt(len(clean))


def test_false_alarms_are_rare_where_shapes_vote_and_shared_errors_are_recognised() -> None:
    """12 data sets each; two alarms would come by chance in 0.6 % of such tests if one in a hundred is false."""
    model, alarms = frame(SIX, only=["first floor", "brace 2"]), 0
    for seed in range(12):
        data = drawn(SIX, seed, shapes=0.02)
        alarms += checked(model, data).verdict != "adequate"
    assert alarms <= 1
    recognised = 0
    for seed in range(12):
        data = drawn(SIX, seed + 100)
        common = np.exp(0.01 * np.random.default_rng(seed).standard_normal(6))[data.pose]
        found = checked(model, replace(data, frequency=data.frequency * common))
        assert not found.effects
        assert not found.survivors
        error = re.search(r"only with an error of ([\d.]+) % that the modes of a pose share", found.reason)
        recognised += found.verdict == "unexplained" and error is not None
        assert error is None or float(error[1]) == pytest.approx(1.0, rel=0.8)
    assert recognised >= 11


def test_errors_twice_as_large_as_stated_are_not_taken_for_a_cause() -> None:
    loads = {"empty": 0.0, "2 kg": 2.0, "5 kg": 5.0, "8 kg": 8.0}
    results = [checked(frame(loads), drawn(loads, seed, stated=SIGMA / 2)) for seed in range(8)]
    assert not any(found.effects or found.survivors for found in results)
    # If the residual is called noise, the reason says that it is not the stated noise.
    told = [found for found in results if found.verdict == "unexplained"]
    assert told
    said = ("perhaps the stated sigma is too small", "measurement errors", "that the modes of a pose share")
    assert all(any(text in found.reason for text in said) for found in told)
    for found in results:
        if found.verdict == "adequate":
            assert "set aside" in found.reason
