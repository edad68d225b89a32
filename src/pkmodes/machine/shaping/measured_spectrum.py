"""A measured power spectrum, such as Klipper's ``resonances_*.csv``, on which shapers are plotted."""

from __future__ import annotations

from dataclasses import dataclass, replace
from os import PathLike, fspath

import numpy as np
from numpy.typing import NDArray

from pkmodes.core.base.errors import MeasurementError
from pkmodes.modaltest.signals.functions import FunctionKind
from pkmodes.modaltest.signals.reading import read_signals

Array = NDArray[np.float64]
#: Range of frequencies considered, relative to the lowest and the highest mode.
BAND_START, BAND_END = 0.5, 1.4
#: Largest relative distance of a peak from its mode, or one line spacing if that is larger; damping and the
#: excitation shift peaks.
PEAK_TOLERANCE = 0.02
#: Other things that a file may hold, each with the remedy.
UNSUITABLE_KINDS = {
    FunctionKind.TIME: (
        "signals in time",
        "give their spectrum (Klipper writes one with OUTPUT=resonances)",
    ),
    FunctionKind.FRF: (
        "frequency responses",
        "a spectrum has one column for each direction, such as psd_x",
    ),
}


@dataclass(frozen=True)
class MeasuredSpectrum:
    """A power spectral density at F frequencies above 0, the sum over the directions in a file.

    - source: the file
    - frequencies, density: ascending, (F,) [Hz]; in the unit of the file
    - directions: the columns or degrees of freedom that are summed
    """

    source: str
    frequencies: Array
    density: Array
    directions: tuple[str, ...]

    def up_to(self, highest: float) -> MeasuredSpectrum:
        """Return its part up to a frequency [Hz], of two lines at least."""
        count = max(2, int(np.searchsorted(self.frequencies, highest, side="right")))
        return replace(self, frequencies=self.frequencies[:count], density=self.density[:count])

    def highest_peak(self, mode_frequencies: Array) -> tuple[float, bool]:
        """Return the frequency of the highest line around some modes [Hz], and whether it is at one of them.

        Lines below half the lowest mode are ignored: there the spectrum shows the motion of the machine itself.
        """
        low, high = BAND_START * mode_frequencies.min(), BAND_END * mode_frequencies.max()
        inside = (self.frequencies >= low) & (self.frequencies <= high)
        if not self.density[inside].any():
            problem = f"expected a density around the modes, from {low:.4g} to {high:.4g} Hz, found none"
            raise MeasurementError(problem, self.source, "give the spectrum of a test that reaches the modes")
        peak = float(self.frequencies[inside][np.argmax(self.density[inside])])
        spacing = float(np.median(np.diff(self.frequencies)))
        return peak, bool(np.abs(mode_frequencies - peak).min() <= max(spacing, PEAK_TOLERANCE * peak))


def read_spectrum(path: str | PathLike[str]) -> MeasuredSpectrum:
    """Read a measured power spectrum.

    - path: a table with a column ``freq`` or ``frequency`` [Hz] and densities ``psd_x``, ``psd_y``, ``psd_z``, as
      Klipper writes it, or one column for each sensor; or power spectra in a universal, MATLAB or NumPy file

    Raises MeasurementError if the file cannot be read, holds something else, or its spectra cannot be summed.
    """
    source = fspath(path)
    signals = read_signals(path)
    spectra = [function for function in signals.functions if function.kind is FunctionKind.SPECTRUM]
    if not spectra:
        kinds = [function.kind for function in signals.functions]
        kind_found, remedy = next(
            (words for kind, words in UNSUITABLE_KINDS.items() if kind in kinds),
            ("none", "give another file"),
        )
        raise MeasurementError(f"expected power spectra, found {kind_found}", source, remedy)
    first = spectra[0]
    for spectrum in spectra:
        if not np.array_equal(spectrum.abscissa, first.abscissa) or spectrum.unit != first.unit:
            problem = (
                f"the spectra of {first.response} and {spectrum.response} have other frequencies or units"
            )
            raise MeasurementError(problem, source, "give spectra that can be added")
    total = np.sum([np.real(spectrum.values) for spectrum in spectra], axis=0)
    usable = (first.abscissa > 0.0) & np.isfinite(total)
    if np.count_nonzero(usable) < 2 or (total[usable] < 0.0).any() or not total[usable].any():
        problem = "expected a power spectral density that is not negative and somewhere positive, at two frequencies"
        raise MeasurementError(problem, source, "give the density itself, not its logarithm")
    names = tuple(spectrum.response for spectrum in spectra)
    return MeasuredSpectrum(source, first.abscissa[usable], total[usable], names)
