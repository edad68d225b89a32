"""Reduction of long records: frequencies far above those of interest are filtered out, then samples are dropped.

A linear-phase filter by Kaiser's window (Oppenheim and Schafer, Discrete-Time Signal Processing, 3rd edition, 2010,
section 7.5.3) and every n-th sample.  Its band of transition is wide: what it aliases stays above the frequencies of
interest, and below them it changes nothing.
"""

from __future__ import annotations

import numpy as np
from numpy.lib.stride_tricks import sliding_window_view
from scipy.signal import firwin, kaiserord

from pkmodes.modaltest.signals.functions import Array

#: Samples above which a record is reduced: shorter ones fit into the memory of any machine.
MAX_SAMPLES = 2_000_000
#: Minimum ratio of the new sampling rate to the highest frequency of interest.
MIN_RATE_RATIO = 4.0
#: Ratio of the end of the passband to that frequency; nothing is aliased into the passband.
PASSBAND_RATIO = 1.5
#: Ripple and stopband attenuation of the filter [dB].
ATTENUATION = 100.0
#: New samples computed at once.
BLOCK_SIZE = 4096


def reduction_factor(samples: int, step: float, highest: float) -> int:
    """Return how many samples of a record become one: 1 for a record that is left as it is.

    - samples: samples of the record
    - step: between its samples [s]
    - highest: highest frequency of interest [Hz]
    """
    return max(1, int(1.0 / (step * MIN_RATE_RATIO * highest))) if samples > MAX_SAMPLES else 1


def reduce_signal(signal: Array, factor: int) -> Array:
    """Return every n-th sample of a filtered signal, without a shift in time, (ceil(N / factor),).

    - signal: (N,)
    - factor: from `reduction_factor`; 1 returns the signal itself
    """
    if factor == 1:
        return signal
    # In parts of the Nyquist frequency; the new rate is 2 / factor.
    passband_end = PASSBAND_RATIO * 2.0 / (MIN_RATE_RATIO * factor)
    stopband_start = 2.0 / factor - passband_end
    count, beta = kaiserord(ATTENUATION, stopband_start - passband_end)
    taps = firwin(count | 1, 0.5 * (passband_end + stopband_start), window=("kaiser", beta))
    half, last = len(taps) // 2, len(signal) - 1
    filtered = np.empty(last // factor + 1)
    for low in range(0, len(filtered), BLOCK_SIZE):
        block = slice(low, min(low + BLOCK_SIZE, len(filtered)))
        # The first and last values continue beyond the ends, so that a constant stays constant.
        indices = np.arange(block.start * factor - half, (block.stop - 1) * factor + half + 1).clip(0, last)
        filtered[block] = sliding_window_view(signal[indices], len(taps))[::factor] @ taps
    return filtered
