"""The parts of a file's fit that a report shows: a few functions, thinned to visible detail, and the poles.

A campaign may have gigabytes of functions; only what is drawn is kept.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from pkmodes.modaltest.campaign.mode_estimates import FileFit
from pkmodes.modaltest.identification.estimates import Stabilisation

Array = NDArray[np.float64]
Complex = NDArray[np.complex128]
#: Maximum number of functions of a file that are drawn.
MAX_CURVES = 4
#: Parts of the band; the lines with the lowest and the highest value of each are drawn.
BAND_PARTS = 180


@dataclass(frozen=True, eq=False)
class InspectedFunction:
    """A function of a file.

    - name: response, or response / reference
    - frequencies: (f,) [Hz]
    - measured, synthesised: (f,)
    - coherence: (f,)
    """

    name: str
    frequencies: Array
    measured: Complex
    synthesised: Complex
    coherence: Array | None


@dataclass(frozen=True, eq=False)
class Inspection:
    """What is drawn of the fit of a file.

    - setup, file: name of the file without its folder.  If files of all setups were fitted together, their common
      name, and no setup.
    - others: number of further files of the setup, or of each setup, that are not drawn
    - frequencies, total: sum of the magnitudes of all measured functions, each relative to its rms, (f,)
    - curves: functions that show the modes best; each mode appears in at least one of them as far as there is room
    - functions: number of functions from which they were chosen
    - tones: lines without bandwidth that were found [Hz]
    """

    setup: str
    file: str
    others: int
    stabilisation: Stabilisation
    frequencies: Array
    total: Array
    curves: tuple[InspectedFunction, ...]
    functions: int
    tones: tuple[float, ...]


@dataclass(frozen=True, eq=False)
class Repeats:
    """The frequencies of the modes of a setup, file by file.

    - files: names of the files that were read, without their folders
    - modes: for each mode, its frequency [Hz] by the index of the file
    """

    setup: str
    files: tuple[str, ...]
    modes: tuple[Mapping[int, float], ...]


def inspect_fit(setup: str, file: str, further_files: int, fit: FileFit) -> Inspection:
    """Return what is drawn of the fit of one of several files."""
    estimate = fit.estimate
    f, (F, S, R) = estimate.frequencies, estimate.measured.shape
    columns = [
        (s, r)
        for s in range(S)
        for r in range(R)
        if np.isfinite(estimate.measured[:, s, r]).all() and estimate.measured[:, s, r].any()
    ]
    magnitudes = {column: np.abs(estimate.measured[:, column[0], column[1]]) for column in columns}
    total = np.zeros(F)
    for magnitude in magnitudes.values():
        total += magnitude / np.sqrt(np.mean(magnitude**2))
    modes = [*estimate.modes, *(mode for mode in estimate.added if not isinstance(mode, str))]
    mode_lines = [int(np.argmin(np.abs(f - mode.frequency))) for mode in modes]
    heights = np.array(
        [magnitude[mode_lines] / np.sqrt(np.mean(magnitude**2)) for magnitude in magnitudes.values()]
    )
    curves = []
    for s, r in (columns[k] for k in _select_functions(heights)):
        measured = estimate.measured[:, s, r]
        curve_lines = thin_indices(np.abs(measured))
        curves.append(
            InspectedFunction(
                fit.responses[s] + (f" / {fit.references[r]}" if fit.references else ""),
                f[curve_lines],
                measured[curve_lines],
                estimate.synthesised[curve_lines, s, r],
                None if fit.coherence is None else fit.coherence[curve_lines, s, r],
            )
        )
    total_lines = thin_indices(total)
    return Inspection(
        setup,
        file,
        further_files,
        estimate.stabilisation,
        f[total_lines],
        total[total_lines],
        tuple(curves),
        len(columns),
        estimate.tones,
    )


def _select_functions(heights: Array) -> list[int]:
    """Return the functions that together show the modes best, in ascending order.

    Greedy: each step takes the function that most raises the modes above the best of those already chosen.

    - heights: magnitude of each function at each mode, relative to its rms, (functions, modes)
    """
    best, selected = np.zeros(heights.shape[1:]), list[int]()
    for _ in range(min(MAX_CURVES, len(heights))):
        gain = np.log1p(np.maximum(heights, best)).sum(axis=1)
        gain[selected] = -1.0
        k = int(gain.argmax())
        selected.append(k)
        best = np.maximum(best, heights[k])
    return sorted(selected)


def thin_indices(values: Array) -> NDArray[np.int64]:
    """Return the indices of the values (F,) that are drawn: the lowest and the highest of each of many parts."""
    if len(values) <= 2 * BAND_PARTS:
        return np.arange(len(values))
    indices = {0, len(values) - 1}
    for part in np.array_split(np.arange(len(values)), BAND_PARTS):
        indices |= {int(part[values[part].argmin()]), int(part[values[part].argmax()])}
    return np.array(sorted(indices))
