"""Vibration that shapers leave."""

from __future__ import annotations

import numpy as np
from numpy.typing import ArrayLike, NDArray

from pkmodes.core.base.errors import PkmodesError
from pkmodes.machine.shaping.arguments import checked_impulses, checked_modes
from pkmodes.machine.shaping.shapers import Shaper

Array = NDArray[np.float64]


def residual(shaper: Shaper, frequencies: ArrayLike, damping_ratios: ArrayLike) -> Array:
    r"""Return the vibration that a shaper leaves of modes, relative to no shaper.

    It is the amplitude of the free vibration at the last impulse, of which each shaper has its own, over that which
    one impulse of amplitude 1 at time 0 excites, at time 0:

    .. math:: V = e^{-\zeta \omega t_n} \Big| \sum_i a_i e^{(\zeta + i \sqrt{1 - \zeta^2}) \omega t_i} \Big|

    (Singer and Seering, J. Dyn. Sys. Meas. Control 112, 1990).  So both are judged at their own last impulse.
    At t_n the unshaped vibration has decayed by :math:`e^{-\zeta \omega t_n}`: relative to what is left of it *then*,
    the shaped one is the sum alone.

    Parameters
    ----------
    shaper : Shaper
        One, or a batch with any leading axes.
    frequencies : array_like
        Undamped natural frequencies of the actual modes [Hz].  Their axes go with the leading axes of the shaper from
        the *first* on, unlike in NumPy: the one with fewer axes gets more at its end.  So shapers (N, n) take
        frequencies (N,), one mode for each shaper, or (N, m), m modes for each; a shaper (n,) takes any shape.
    damping_ratios : array_like
        Damping ratios of the actual modes, in [0, 1) [-].  They are broadcast with the frequencies as usual: from the
        last axis on.

    Returns
    -------
    ndarray, shape (...)
        In [0, 1] [-]; the shape is that of the frequencies and the leading axes of the shaper together.

    Raises
    ------
    PkmodesError
        If the shaper is none, a frequency is not positive and finite, a ratio is not in [0, 1), or the shapes do not
        go together.
    """
    f, zeta = checked_modes(frequencies, damping_ratios)
    amplitudes, delays = checked_impulses(shaper)
    mode_axes, leading = f.shape, delays.shape[:-1]
    # At most one of the two lacks axes; the other gets none, since (1,) times a negative number is ().
    padding = (1,) * (len(mode_axes) - len(leading))
    amplitudes, delays = (part.reshape(leading + padding + part.shape[-1:]) for part in (amplitudes, delays))
    padding = (1,) * (len(leading) - len(mode_axes))
    f, zeta = f.reshape(mode_axes + padding), zeta.reshape(mode_axes + padding)
    try:
        np.broadcast_shapes(f.shape, delays.shape[:-1])
    except ValueError:
        problem = f"expected frequencies for shapers {leading}, from the first axis on, found {mode_axes}"
        raise PkmodesError(problem, "frequencies", "give a frequency, or several, for each shaper") from None
    omega, root = 2.0 * np.pi * f, np.sqrt((1.0 - zeta) * (1.0 + zeta))
    # Time counts from the last impulse, where the factor in front of the sum is 1: nothing overflows.
    before = delays - delays[..., -1:]
    return np.asarray(
        np.abs((amplitudes * np.exp(((zeta + 1j * root) * omega)[..., None] * before)).sum(axis=-1))
    )


def residual_of_even(amplitudes: Array, step: Array, frequencies: Array, damping_ratios: Array) -> Array:
    """Return the same for impulses at even steps, with one exponential for all of them: for many designs at once.

    - amplitudes: amplitudes of the impulses, along the last axis, (..., n)
    - step: time between them, (...) [s]
    - frequencies, damping_ratios: frequencies [Hz] and damping ratios of the modes, broadcast with the step
    """
    root = np.sqrt((1.0 - damping_ratios) * (1.0 + damping_ratios))
    back = np.exp(-(damping_ratios + 1j * root) * (2.0 * np.pi * frequencies) * step)
    total = amplitudes[..., 0] + 0.0 * back
    for k in range(1, amplitudes.shape[-1]):
        total = total * back + amplitudes[..., k]
    return np.abs(total)
