"""A measured power spectrum, over which shapers are drawn: such as Klipper's ``resonances_*.csv``."""

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
BELOW, ABOVE = 0.5, 1.4
#: Largest relative distance of a peak from its mode, unless the lines are farther apart: damping and the excitation
#: shift peaks.
NEAR = 0.02
#: Other things that a file may hold, and what to do with them.
OTHERS = {
    FunctionKind.TIME: "signals in time: give their spectrum (Klipper writes one with OUTPUT=resonances)",
    FunctionKind.FRF: "frequency responses: a spectrum has one column for each direction, such as psd_x",
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

    def peak(self, modes: Array) -> tuple[float, bool]:
        """Return the frequency of the highest line around some modes [Hz], and whether it is at one of them.

        Below half the lowest mode, the spectrum of a machine that is moved has the movement itself.
        """
        low, high = BELOW * modes.min(), ABOVE * modes.max()
        inside = (self.frequencies >= low) & (self.frequencies <= high)
        if not self.density[inside].any():
            problem = f"expected a density around the modes, from {low:.4g} to {high:.4g} Hz, found none"
            raise MeasurementError(problem, self.source, "give the spectrum of a test that reaches the modes")
        peak = float(self.frequencies[inside][np.argmax(self.density[inside])])
        spacing = float(np.median(np.diff(self.frequencies)))
        return peak, bool(np.abs(modes - peak).min() <= max(spacing, NEAR * peak))


def read_spectrum(path: str | PathLike[str]) -> MeasuredSpectrum:
    """Read a measured power spectrum.

    - path: a table with a column ``freq`` or ``frequency`` [Hz] and densities ``psd_x``, ``psd_y``, ``psd_z``, as
      Klipper writes it, or one column for each sensor; or power spectra in a universal, MATLAB or NumPy file

    Raises MeasurementError if the file cannot be read, holds something else, or its spectra cannot be summed.
    """
    source = fspath(path)
    read = read_signals(path)
    spectra = [function for function in read.functions if function.kind is FunctionKind.SPECTRUM]
    if not spectra:
        kinds = [function.kind for function in read.functions]
        alternative = next((OTHERS[kind] for kind in OTHERS if kind in kinds), "none")
        kind_found, _, remedy = alternative.partition(": ")
        raise MeasurementError(
            f"expected power spectra, found {kind_found}", source, remedy or "give another file"
        )
    first = spectra[0]
    for spectrum in spectra:
        if not np.array_equal(spectrum.abscissa, first.abscissa) or spectrum.unit != first.unit:
            problem = (
                f"the spectra of {first.response} and {spectrum.response} have other frequencies or units"
            )
            raise MeasurementError(problem, source, "give spectra that can be added")
    total = np.sum([np.real(spectrum.values) for spectrum in spectra], axis=0)
    above = (first.abscissa > 0.0) & np.isfinite(total)
    if np.count_nonzero(above) < 2 or (total[above] < 0.0).any() or not total[above].any():
        problem = "expected a power spectral density that is not negative and somewhere positive, at two frequencies"
        raise MeasurementError(problem, source, "give the density itself, not its logarithm")
    names = tuple(spectrum.response for spectrum in spectra)
    return MeasuredSpectrum(source, first.abscissa[above], total[above], names)
