"""Two measurements compared: a change of all modes by one factor is told apart from changes of single modes."""

from __future__ import annotations

from collections import Counter
from pathlib import Path

import numpy as np
import pytest
from scipy.stats import chi2, norm

from helpers.runs.processes import ROOT
from pkmodes.cli import run
from pkmodes.loop.measured.compared import compare_measurements
from pkmodes.loop.measured.comparison import MeasurementsCompared
from pkmodes.loop.measured.measurements import Measurements
from pkmodes.loop.measured.significance import SIGNIFICANCE_LEVEL

F = np.linspace(40.0, 200.0, 9)
SIGMA = 0.002


def compared(
    factors: np.ndarray, f: np.ndarray = F, sigma: np.ndarray | float = SIGMA
) -> MeasurementsCompared:
    first, second = (
        Measurements.from_rows(["P1"] * len(f), each, sigma * each, mode=range(1, len(f) + 1))
        for each in (f, f * factors)
    )
    return compare_measurements(first, second)


def own(result: MeasurementsCompared) -> list[str]:
    return [pair.mode for pair in result.pairs if pair.own_change]


def test_one_factor_of_all_is_their_weighted_mean() -> None:
    sigma = np.linspace(0.001, 0.004, 9)
    noise = np.array([1.0, -1.0, 0.5, -0.5, 0.0, 0.3, -0.3, 1.0, -1.0]) * sigma
    result = compared(0.98 * np.exp(noise), sigma=sigma)
    weights = 1.0 / (2.0 * sigma**2)
    mean = np.log(0.98) + (weights * noise).sum() / weights.sum()
    left = (weights * (np.log(0.98) + noise - mean) ** 2).sum()
    assert (result.changed, own(result)) == ("common", [])
    assert result.common.relative == pytest.approx(np.expm1(mean))
    assert result.common.sigmas == pytest.approx(mean * np.sqrt(weights.sum()))
    assert result.common.residual_chi2 == pytest.approx(left)
    assert result.common.residual_p_value == pytest.approx(chi2.sf(left, 8))
    assert result.common.pairs == 9


@pytest.mark.parametrize("factor", [1.0, 0.98, 1.05])
def test_a_mode_that_changed_by_itself_is_named_beside_the_factor_of_the_others(factor: float) -> None:
    factors = np.full(9, factor)
    factors[[2, 6]] *= [0.97, 1.02]
    result = compared(factors)
    assert result.changed == ("single" if factor == 1.0 else "common_and_single")
    assert own(result) == ["3", "7"]
    assert result.common.relative == pytest.approx(factor - 1.0, abs=1e-12)
    assert result.common.pairs == 7
    assert [result.pairs[k].beyond_common for k in (2, 6)] == pytest.approx([-0.03, 0.02])
    # The error of a mode and that of the mean of the seven others add up.
    errors = SIGMA * np.sqrt(2.0) * np.sqrt(1.0 + 1.0 / 7.0)
    assert result.pairs[2].beyond_common_sigmas == pytest.approx(np.log(0.97) / errors)


def test_what_single_modes_did_beyond_the_mean_of_all_has_unit_variance() -> None:
    """The mean follows each of the modes that it is of: their residuals are smaller than their errors."""
    rng = np.random.default_rng(20261204)
    beyond = np.array(
        [
            [pair.beyond_common_sigmas for pair in compared(np.exp(errors), F[:3]).pairs]
            for errors in SIGMA * np.sqrt(2.0) * rng.normal(size=(400, 3))
        ],
        dtype=float,
    )
    assert np.isnan(beyond).any(axis=1).sum() <= 4 + 3.0 * 2.0  # where no factor is that of most modes
    assert np.nanmean(beyond**2) == pytest.approx(1.0, abs=4.0 * np.sqrt(1.0 / 400.0))


def test_factors_that_all_differ_have_nothing_in_common() -> None:
    """A softer spring moves every mode by another factor; that some are alike is no change of all."""
    result = compared(1.0 - np.array([3.0, 3.02, 2.98, 3.01, 3.0, 2.0, 1.0, 0.0, 4.0]) / 100.0)
    assert (result.changed, result.common.relative, result.common.pairs) == ("single", None, 0)
    assert own(result) == ["1", "2", "3", "4", "5", "6", "7", "9"]
    two = compared(np.array([1.0, 0.9]), F[:2])
    assert (two.changed, two.common.relative, own(two)) == ("single", None, ["2"])
    assert compared(np.array([0.9]), F[:1]).common is None


def test_a_factor_is_found_that_no_single_mode_shows() -> None:
    result = compared(np.full(9, 1.0 - 2.0 * SIGMA * np.sqrt(2.0)))
    assert not any(pair.differs for pair in result.pairs)
    assert (result.changed, result.common.sigmas) == ("common", pytest.approx(-6.0, abs=0.05))


def test_what_would_have_counted_is_what_counts() -> None:
    """One mode that changed by a little more, or a little less, than is said."""
    least = compared(np.full(9, 1.0 + 1e-9)).pairs[4].noticeable
    assert least == pytest.approx(norm.isf(SIGNIFICANCE_LEVEL / 18.0) * SIGMA * np.sqrt(2.0))
    for more, names in ((1.01, ["5"]), (0.99, [])):
        factors = np.ones(9)
        factors[4] += more * least
        # Its error grows with its frequency, which is not known before.
        error = np.hypot(1.0, factors[4]) / np.sqrt(2.0)
        factors[4] = 1.0 + more * least * error
        assert own(compared(factors)) == names


def test_false_claims_of_any_kind_are_rare() -> None:
    """1,000 measurements in which nothing changed: each kind of claim at its level, any of them in about 2 %."""
    rng = np.random.default_rng(20261130)
    claims = Counter(
        compare_measurements(
            *(
                Measurements.from_rows(["A"] * 6, f, SIGMA * F[:6])
                for f in F[:6] * (1.0 + SIGMA * rng.normal(size=(2, 6)))
            )
        ).changed
        for _ in range(1000)
    )
    assert claims["single"] + claims["common_and_single"] <= 10 + 3.0 * np.sqrt(10.0)
    assert claims["common"] + claims["common_and_single"] <= 5 + 3.0 * np.sqrt(5.0)
    assert 1000 - claims["nothing"] <= 20 + 3.0 * np.sqrt(20.0)


#: Natural frequencies f2 to f4 [Hz] of the three-storey structure of Los Alamos, its baseline and with two of four
#: columns of the second storey at half thickness: Figueiredo and others, LA-14393, 2009, doi:10.2172/961604, table 4.
BASELINE, SOFTER = (30.7, 54.2, 70.7), (28.6, 54.2, 62.2)


def test_a_softer_storey_of_a_real_structure(
    tmp_path: Path, capsys: pytest.CaptureFixture[str], monkeypatch: pytest.MonkeyPatch
) -> None:
    """Mode 4 lost 12 %, mode 3 has its node there, and the 7 % of mode 2 are hidden by its errors of 3 %."""
    monkeypatch.chdir(tmp_path)
    for name, frequencies in {"before": BASELINE, "after": SOFTER}.items():
        rows = [
            f"P1,{mode},{f},{sigma * f}"
            for mode, f, sigma in zip((2, 3, 4), frequencies, (0.03, 0.006, 0.006), strict=True)
        ]
        Path(f"{name}.csv").write_text("\n".join(["pose,mode,frequency,sigma", *rows, ""]), encoding="utf-8")
    assert run(["compare", "before.csv", "after.csv"]) == 0
    text = " ".join(capsys.readouterr().out.split())
    sigmas = (70.7 - 62.2) / np.hypot(0.006 * 70.7, 0.006 * 62.2)
    assert f"1 of 3 modes changed: 70.7 Hz at P1 by -12 % ({sigmas:.0f} sigma)" in text
    assert (
        "No common change is significant: the mean over the 2 modes that agree is -0.272 % (0.3 sigma)."
        in text
    )
    assert (
        "No mode has a shape at 3 or more channels of both files: shapes do not show where anything changed."
        in text
    )


def test_headlines(
    tmp_path: Path, capsys: pytest.CaptureFixture[str], monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.chdir(tmp_path)

    def headline(*frequencies: float) -> str:
        for name, values in {"a": (50.0, 60.0, 80.0, 95.0), "b": frequencies}.items():
            rows = "".join(f"P,{f},0.1\n" for f in values)
            Path(f"{name}.csv").write_text(f"pose,frequency,sigma\n{rows}", encoding="utf-8")
        assert run(["compare", "a.csv", "b.csv"]) == 0
        return " ".join(capsys.readouterr().out.split("median")[0].split())

    unchanged = headline(50.0, 60.0, 80.1, 95.0)
    assert "No mode changed by more than the errors Smallest detectable change: 0.45 %" in unchanged
    f = np.array([50.0, 60.0, 80.0, 95.0])
    sigmas = -np.log(0.98) * np.sqrt((f**2).sum() / (0.1**2 * (1.0 + 0.98**-2)))
    assert f"All 4 modes changed by one factor: -2 % ({sigmas:.0f} sigma)" in headline(*0.98 * f)
    both = headline(49.0, 58.8, 78.4, 100.0)
    assert "3 of 4 modes changed by one factor, -2 % (" in both
    assert "; beyond it 95 Hz at P by +7.41 % (" in both
    assert "No mode has a partner" in headline(5.0, 6.0)
    assert "; 1 mode without a partner" in headline(50.0, 60.0, 80.1)


def test_one_belt_of_a_printer_is_not_told_as_one_factor(capsys: pytest.CaptureFixture[str]) -> None:
    """One belt of three lost 5 %: the modes change by 0 to 2.6 %, and many by about as little."""
    before, after = (
        str(ROOT / "examples" / "changed_printer" / f"{name}.csv") for name in ("before", "after")
    )
    assert run(["compare", before, after]) == 0
    text = " ".join(capsys.readouterr().out.split("median")[0].split())
    assert (
        "13 of 33 modes changed, each by a factor of its own (-2.58 % to -1.13 %), most of all 237.52 Hz"
        in text
    )
    assert "18 of the 33 modes agree with a common change of -0.395 % (" in text
    assert "pkmodes changed, with the robot file, looks for it" in text
    assert "changed by one factor" not in text
