"""Frequency responses with the phase of exp(-i omega t), their complex conjugates: poles that grow.

The impulse response of a structure is zero before the blow, and that of a conjugate after it.  So their energies over
time distinguish them (as Bendat and Piersol, Random Data, 4th edition, 2010, section 2.1: physically realisable
systems), function by function, before any fit.

Signals that are not responses to the force can mimic this: the energy of noise in a few lines, such as drift or a
resonance excited by other sources, lies before the blow as often as after it.  Functions are conjugates only if modes
fit them as such.
"""

from __future__ import annotations

import math
from collections.abc import Sequence

import numpy as np

from pkmodes.core.base.errors import MeasurementError
from pkmodes.modaltest.identification.estimates import complex_mac
from pkmodes.modaltest.identification.frf_identification import identify_frf
from pkmodes.modaltest.signals.functions import Array, Complex, Function, derived_function

#: Excess over one half of the share of energy before the blow that marks a conjugate: its minimum, and a multiple of
#: 1/sqrt(lines).  For noise the share is one half, with a standard deviation of 0.7/sqrt(lines).
MIN_EXCESS, NOISE_FACTOR = 0.15, 2.8
#: Samples on either side of the blow that are not counted: the window of the band spreads an instantaneous response
#: over them.
GUARD_SAMPLES = 3
#: Maximum number of functions of a file that are fitted.
MAX_FITTED = 24
#: Minimum share of the power of conjugates that a fit explains: over all lines (0.5 with as much noise as response),
#: and weighted by the power of the fit (0.92 or more).  Responses to other forces fail at least one of the two.
MIN_EXPLAINED, MIN_EXPLAINED_AT_PEAKS = 0.4, 0.9
#: Minimum number of lines in the band from which the share is estimated.
MIN_LINES = 16
#: Relative difference up to which line spacings count as even.
SPACING_TOLERANCE = 0.01


def check_phase(
    functions: Sequence[Function], band: tuple[float, float], conjugate: bool, source: str
) -> tuple[tuple[Function, ...], tuple[str, ...]]:
    """Return functions with the phase of exp(+i omega t), and messages about them.

    Without `conjugate`, functions that look like conjugates are returned unchanged, with a remark, if no modes fit
    their conjugates either.

    - band: [Hz]
    - conjugate: whether conjugates, which may be only some functions of a file, are corrected; otherwise they are
      refused

    Raises MeasurementError if functions are conjugates, which modes fit, and `conjugate` is false.
    """
    shares = [
        _energy_share_before(function.abscissa, np.asarray(function.values), band) for function in functions
    ]
    lines = int(np.count_nonzero((functions[0].abscissa >= band[0]) & (functions[0].abscissa <= band[1])))
    is_conjugate = [share > _threshold(lines) for share in shares]
    majority_conjugate = bool(np.mean(shares) > (0.5 if conjugate else _threshold(lines * len(shares))))
    is_causal = [share < 1.0 - _threshold(lines) for share in shares]
    to_conjugate = [
        is_suspect or (majority_conjugate and not is_sound)
        for is_suspect, is_sound in zip(is_conjugate, is_causal, strict=True)
    ]
    if conjugate:
        corrected = (
            derived_function(function, np.conj) if is_suspect else function
            for function, is_suspect in zip(functions, to_conjugate, strict=True)
        )
        return tuple(corrected), ()
    if any(to_conjugate):
        names = [f"{function.response}/{function.reference}".removesuffix("/") for function in functions]
        suspect_names = [name for name, is_suspect in zip(names, to_conjugate, strict=True) if is_suspect]
        examples = f"{', '.join(suspect_names[:4])}{', ...' if len(suspect_names) > 4 else ''}"
        suspects = [
            function for function, is_suspect in zip(functions, to_conjugate, strict=True) if is_suspect
        ]
        if not _explained_by_modes([derived_function(function, np.conj) for function in suspects], band):
            remark = (
                f"{source}: {len(suspect_names)} of {len(names)} functions ({examples}) hold more vibration "
                "before the force than after it, and no modes fit their complex conjugates either: they are "
                "mostly not responses to this force; measure with more force or more averages"
            )
            return tuple(functions), (remark,)
        problem = (
            "expected vibrations that decay after the force, found ones that grow before it in "
            f"{len(suspect_names)} of {len(names)} functions ({examples}): these are complex conjugates, "
            "with the phase of exp(-i omega t)"
        )
        raise MeasurementError(problem, source, "write conjugate = true in the record")
    return tuple(functions), ()


def _explained_by_modes(functions: Sequence[Function], band: tuple[float, float]) -> bool:
    """Return whether modes explain most of the power of functions."""
    subset = [functions[i] for i in range(0, len(functions), math.ceil(len(functions) / MAX_FITTED))]
    f = subset[0].abscissa
    in_band = (f >= band[0]) & (f <= band[1])
    values = np.stack([np.asarray(function.values, complex) for function in subset], axis=1)
    norms = np.linalg.norm(values[in_band], axis=0)
    usable = np.isfinite(norms) & (norms > 0.0)
    try:
        estimate = identify_frf(
            f, (values[:, usable] / norms[usable])[..., None], band=band, derivative_order=2
        )
    except MeasurementError:  # too few lines or functions
        return False
    if not estimate.modes:
        return False
    # The share of the power that the fit explains at its best scale is the MAC of the two.
    measured, fit = estimate.measured.ravel(), estimate.synthesised.ravel()
    weights = np.abs(fit)
    return (
        complex_mac(measured, fit) > MIN_EXPLAINED
        and complex_mac(weights * measured, weights * fit) > MIN_EXPLAINED_AT_PEAKS
    )


def _threshold(lines: int) -> float:
    """Return the share of energy before the blow above which functions with so many lines are conjugates."""
    return 0.5 + max(MIN_EXCESS, NOISE_FACTOR / math.sqrt(max(lines, 1)))


def _energy_share_before(frequencies: Array, values: Complex, band: tuple[float, float]) -> float:
    """Return the share of an impulse response's energy that lies before its blow; 0.5 if undetermined."""
    in_band = (frequencies >= band[0]) & (frequencies <= band[1])
    f, H = frequencies[in_band], values[in_band]
    spacings = np.diff(f)
    if (
        len(f) < MIN_LINES
        or np.ptp(spacings) > SPACING_TOLERANCE * spacings.mean()
        or not np.isfinite(H).all()
    ):
        return 0.5
    h = np.abs(np.fft.ifft(np.hanning(len(H)) * H / max(np.abs(H).max(), 1e-300))) ** 2
    half_length = len(h) // 2
    energy_after, energy_before = (
        h[GUARD_SAMPLES + 1 : half_length].sum(),
        h[len(h) - half_length + 1 : len(h) - GUARD_SAMPLES].sum(),
    )
    energy = energy_before + energy_after
    return float(energy_before / energy) if energy > 0.0 else 0.5
