"""Design of shapers for modes."""

from __future__ import annotations

from typing import NamedTuple

import numpy as np
from numpy.typing import ArrayLike, NDArray

from pkmodes.core.base.errors import PkmodesError
from pkmodes.machine.shaping.arguments import checked_modes
from pkmodes.machine.shaping.kinds import factors
from pkmodes_description.shapers import Kind

Array = NDArray[np.float64]


class Shaper(NamedTuple):
    """Impulses with which a command is convolved; one shaper, or a batch of them.

    Attributes
    ----------
    amplitudes : ndarray, shape (..., n)
        Positive, with the sum 1 [-].
    delays : ndarray, shape (..., n)
        Ascending, the first 0 [s].  Two impulses of a product may coincide.
    """

    amplitudes: Array
    delays: Array

    @property
    def durations(self) -> Array:
        """Delays of the last impulses, shape (...) [s]: how much longer a shaped command takes."""
        return np.asarray(self.delays)[..., -1]


def shaper(kind: str, frequencies: ArrayLike, damping_ratios: ArrayLike) -> Shaper:
    """Design shapers for modes.

    Parameters
    ----------
    kind : str
        One of ``KINDS``, or factors joined by ``*``, such as "zv*zv*ei": one shaper for several modes, the
        convolution of the shapers for each of them.
    frequencies : array_like, shape (...); (..., k) for a product of k factors
        Undamped natural frequencies [Hz].  Factor j of a product is for the mode at index j of the last axis.
    damping_ratios : array_like
        Damping ratios in [0, 1) [-].  They are broadcast with the frequencies.

    Returns
    -------
    Shaper
        Amplitudes and delays (..., n) for n impulses; of a product, n is the product of the numbers of its factors.
        Coinciding impulses are not merged, so that all shapers of a batch have the same n.

    Raises
    ------
    PkmodesError
        If the kind is unknown (the message suggests the nearest), a frequency is not positive and finite, a ratio is
        not in [0, 1), or a product has not one frequency for each factor.

    Examples
    --------
    >>> from pkmodes.machine.shaping import shaper
    >>> amplitudes, delays = shaper("zvd", 50.0, 0.0)
    >>> print(amplitudes, delays)
    [0.25 0.5  0.25] [0.   0.01 0.02]
    """
    kinds = factors(kind)
    f, zeta = checked_modes(frequencies, damping_ratios)
    if len(kinds) == 1:
        return _single(kinds[0], f, zeta)
    shape = np.shape(
        frequencies
    )  # a single frequency is not repeated for all factors: it would be an oversight
    if shape[-1:] != (len(kinds),):
        problem = (
            f"expected a last axis of {len(kinds)} frequencies, one for each factor of {kind}, found {shape}"
        )
        raise PkmodesError(problem, "frequencies", "give a frequency for each factor")
    first, *further = (_single(factor, f[..., j], zeta[..., j]) for j, factor in enumerate(kinds))
    for design in further:
        first = _convolved(first, design)
    return first


def _single(kind: Kind, f: Array, zeta: Array) -> Shaper:
    """Return the shapers of one kind for modes of shape (...)."""
    below, above = (1.0 - zeta)[..., None], (1.0 + zeta)[..., None]
    root = np.sqrt(below * above)
    periods = kind.step * np.arange(len(kind.weights))
    amplitudes = np.array(kind.weights) * np.exp(-2.0 * np.pi * zeta[..., None] / root * periods)
    amplitudes /= amplitudes.sum(axis=-1, keepdims=True)
    return Shaper(amplitudes, periods / (f[..., None] * root))


def _convolved(first: Shaper, second: Shaper) -> Shaper:
    """Return the convolution of shapers with the same leading axes, its impulses sorted by delay."""
    shape = (*first.delays.shape[:-1], -1)
    delays = (first.delays[..., :, None] + second.delays[..., None, :]).reshape(shape)
    amplitudes = (first.amplitudes[..., :, None] * second.amplitudes[..., None, :]).reshape(shape)
    order = np.argsort(delays, axis=-1, kind="stable")
    return Shaper(np.take_along_axis(amplitudes, order, -1), np.take_along_axis(delays, order, -1))
