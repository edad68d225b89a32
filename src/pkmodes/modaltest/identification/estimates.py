"""Results of modal identification: modes with the uncertainty of their fit, and the functions that are drawn.

A shape is complex, at any scale and phase.  It is turned to be as real as possible, which is the angle at which the
sum of squares of its imaginary parts is least; how close it then is to real is the modal phase collinearity (Pappa,
Elliott and Schenk, Journal of Guidance, Control, and Dynamics 16(5), 1993, without removing the mean: the origin of
a motion is known).
"""

from __future__ import annotations

import math
from collections.abc import Callable
from dataclasses import dataclass, replace

import numpy as np
from numpy.typing import NDArray

from pkmodes.core.support.mac import mac

Array = NDArray[np.float64]
Complex = NDArray[np.complex128]


@dataclass(frozen=True, eq=False)
class Mode:
    """An identified mode.

    - pole: with positive imaginary part [1/s]
    - shape: at the responses, at any scale, (S,); NaN where undetermined
    - sigma_frequency: one standard deviation from the fit [Hz]
    - sigma_damping: likewise
    - sigma_shape: one standard deviation of the real part of a component of the shape turned as real as possible,
      relative to its largest component
    - found_in: number of model orders in which it was found, and their total
    - participation: participations of the references, (R,): its product with the shape is the residue of the
      functions.  None for responses alone.
    - sigma_scale: one standard deviation of the largest residue, relative; NaN where unknown
    """

    pole: complex
    shape: Complex
    sigma_frequency: float
    sigma_damping: float
    sigma_shape: float
    found_in: tuple[int, int]
    participation: Complex | None = None
    sigma_scale: float = math.nan

    @property
    def frequency(self) -> float:
        """Undamped natural frequency |lambda| / (2 pi) [Hz]."""
        return abs(self.pole) / (2.0 * math.pi)

    @property
    def damping(self) -> float:
        """Damping ratio -Re(lambda) / |lambda|."""
        return -self.pole.real / abs(self.pole)

    @property
    def complexity(self) -> float:
        """Modal phase collinearity, from 0 to 1 (a real shape); NaN if no component is determined."""
        return collinearity(self.shape)


@dataclass(frozen=True, eq=False)
class Stabilisation:
    """Poles over model orders, for a stabilisation diagram.

    - orders: ascending, (K,)
    - poles: for each order, the poles with positive imaginary part [1/s]
    """

    orders: NDArray[np.int64]
    poles: tuple[Complex, ...]


@dataclass(frozen=True, eq=False)
class Estimate:
    """Modes of one measurement, and its functions.

    - modes: by ascending frequency
    - frequencies: frequencies of the lines inside the band, (F,) [Hz]
    - measured, synthesised: (F, S, R); NaN where not measured
    - added: for each frequency at which the user requested a mode: the mode, or why there is none
    - tones: lines without bandwidth that were found without having been stated [Hz]
    - model_error: largest fraction of the functions at a peak that the modes do not explain and that is not noise
    - spurious_frequencies: frequencies of spurious modes, which only fit such an error [Hz]
    """

    modes: tuple[Mode, ...]
    stabilisation: Stabilisation
    frequencies: Array
    measured: Complex
    synthesised: Complex
    added: tuple[Mode | str, ...] = ()
    tones: tuple[float, ...] = ()
    model_error: float = 0.0
    spurious_frequencies: tuple[float, ...] = ()

    def map_modes(self, change: Callable[[Mode], Mode]) -> Estimate:
        """Return it with `change` applied to each mode, including those the user requested."""
        added = tuple(
            candidate if isinstance(candidate, str) else change(candidate) for candidate in self.added
        )
        return replace(self, modes=tuple(map(change, self.modes)), added=added)


def complex_mac(first: Complex, second: Complex) -> float:
    """Return the modal assurance criterion of two complex shapes (S,); 0 if one of them is zero.

    References
    ----------
    Allemang and Brown, Proceedings of the 1st International Modal Analysis Conference, 1982.
    """
    if len(first) == 1:  # a shape of one component is like any other
        return float(bool(first[0] and second[0]))
    likeness = float(mac(first[None], second[None], np.ones((1, len(first)), dtype=bool)).item())
    return likeness if np.isfinite(likeness) else 0.0


def collinearity(shape: Complex) -> float:
    """Return the modal phase collinearity of a shape (S,), NaN where undetermined."""
    finite = shape[np.isfinite(shape)]
    xx, yy, xy = _moments(finite)
    total = xx + yy
    return (math.hypot(xx - yy, 2.0 * xy) / total) ** 2 if total > 0.0 else math.nan


def rotate_to_real(shape: Complex) -> Complex:
    """Return a shape (S,) rotated to be as real as possible, relative to its largest real part, which becomes 1.

    NaN where undetermined.
    """
    finite = np.isfinite(shape)
    xx, yy, xy = _moments(shape[finite])
    rotated = shape * np.exp(-0.5j * math.atan2(2.0 * xy, xx - yy))
    real_parts = rotated.real[finite]
    largest = real_parts[np.argmax(np.abs(real_parts))] if real_parts.size else 0.0
    return np.asarray(rotated / largest) if largest else np.asarray(rotated)


def _moments(values: Complex) -> tuple[float, float, float]:
    """Return the sums of x^2, y^2 and x y of the real and imaginary parts."""
    x, y = values.real, values.imag
    return float(x @ x), float(y @ y), float(x @ y)
