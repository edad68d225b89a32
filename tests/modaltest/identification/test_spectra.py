"""Frequencies from averaged spectra with lines far apart, against the modes that they were computed from."""

from __future__ import annotations

import numpy as np
import pytest
from scipy.signal import welch

from pkmodes.core.base.errors import MeasurementError
from pkmodes.modaltest.identification.spectra import identify_spectrum
from pkmodes_rig.structures.driven import Array, Structure, ambient, random_structure, structure, sweep

BAND = (10.0, 120.0)


def of_sweep(system: Structure, rng: np.random.Generator) -> tuple[Array, Array]:
    """As Klipper does: windows of half a second or more at 3200 Hz, lines 1.5625 Hz apart."""
    f, power = welch(sweep(system, rng), 3200.0, nperseg=2048, axis=0)
    return np.asarray(f), np.asarray(power)


def test_the_peaks_of_a_sweep_are_within_their_sigma() -> None:
    inside, total, false = 0, 0, 0
    for seed in (9800, 9801, 9802):
        rng = np.random.default_rng(seed)
        f0 = np.sort(rng.uniform(20, 110, 3))
        while (np.diff(f0) < 12).any():
            f0 = np.sort(rng.uniform(20, 110, 3))
        system = structure(f0, np.array([0.03, 0.02, 0.03]), rng)
        f, power = of_sweep(system, rng)
        estimate, _ = identify_spectrum(f, power[:, :3], band=BAND)
        total += 3
        for mode in estimate.modes:
            near = f0[np.argmin(np.abs(f0 - mode.frequency))]
            inside += abs(mode.frequency - near) < 2 * mode.sigma_frequency
            false += abs(mode.frequency - near) > 2.0
    assert inside >= 0.65 * total  # a weak mode between strong ones has no peak
    assert false == 0


def test_nothing_but_a_frequency_is_claimed() -> None:
    rng = np.random.default_rng(9810)
    f, power = of_sweep(random_structure(rng), rng)
    estimate, _ = identify_spectrum(f, power, band=BAND)
    assert estimate.modes
    for mode in estimate.modes:
        assert mode.sigma_frequency >= 0.25 * (f[1] - f[0])
        assert mode.damping == 0.0
        assert np.isnan([mode.sigma_damping, mode.sigma_shape]).all()
        assert np.isnan(mode.shape).all()
    assert estimate.measured.shape == estimate.synthesised.shape


def test_modes_closer_than_a_line_are_one_row() -> None:
    f = np.arange(0.0, 200.0, 1.5625)
    power = sum(1.0 / (1.0 + ((f - f0) / 1.5) ** 2) for f0 in (60.0, 61.0)) + 1e-3
    estimate, _ = identify_spectrum(f, power[:, None], band=BAND)
    (mode,) = estimate.modes
    assert mode.frequency == pytest.approx(60.5, abs=0.4)


@pytest.mark.parametrize("slope", [0, 2, 4])
def test_a_peak_between_lines_is_placed_between_them(slope: int) -> None:
    """Driven with an acceleration proportional to the frequency, exactly; driven otherwise, within sigma."""
    f = np.arange(0.0, 200.0, 1.5625)
    resonance = 60.2**4 / np.abs(60.2**2 - f**2 + 2j * 0.03 * 60.2 * f) ** 2
    power = (f / 60.2) ** slope * resonance + 1e-6
    (mode,) = identify_spectrum(f, power[:, None], band=BAND)[0].modes
    error = abs(mode.frequency - 60.2 * np.sqrt(1 - 0.03**2))
    assert error < (0.01 if slope == 2 else mode.sigma_frequency)
    assert mode.sigma_frequency < 0.6


def test_too_few_lines_are_refused() -> None:
    f = np.arange(0.0, 200.0, 1.5625)
    with pytest.raises(MeasurementError, match="eight"):
        identify_spectrum(f, np.ones((len(f), 1)), band=(20.0, 25.0))


@pytest.mark.parametrize("window", ["hann", "boxcar"])
def test_the_spectrum_of_a_single_record_is_refused(window: str) -> None:
    """Its lines are exponentially distributed: any of them may be a peak."""
    rng = np.random.default_rng(9820)
    signals = ambient(random_structure(rng), rng)[:, :3]
    for pieces, refused in ((1, True), (8, False)):
        f, power = welch(signals, 1000.0, window=window, nperseg=len(signals) // pieces, noverlap=0, axis=0)
        if refused:
            with pytest.raises(MeasurementError, match="expected an averaged spectrum"):
                identify_spectrum(f, power, band=BAND)
        else:
            identify_spectrum(f, power, band=BAND)
