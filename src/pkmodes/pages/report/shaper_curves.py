"""What fixed shapers leave of a mode at each frequency, over a measured spectrum if there is one."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

import numpy as np
from numpy.typing import NDArray

from pkmodes.core.base.numbers import plain
from pkmodes.core.support.ordering import joined
from pkmodes.machine.shaping.measured_modes import SIGMA_RANGE, MeasuredRinging
from pkmodes.machine.shaping.measured_spectrum import BAND_END, BAND_START, MeasuredSpectrum
from pkmodes.machine.shaping.residual_vibration import residual
from pkmodes.pages.plots import shapers
from pkmodes.pages.plots.drawing import Drawing
from pkmodes.pages.report.blocks import Cell, Picture, Section
from pkmodes.pages.report.formatting import clean, number_cell, pointer

if TYPE_CHECKING:
    from pkmodes.machine.shaping.results import Candidate, Choice

#: Maximum number of shapers drawn, and the number of frequencies in a curve.
MAX_CURVES, CURVE_POINTS = 5, 400


def frequency_figure(choice: Choice, spectrum: MeasuredSpectrum | None) -> tuple[Drawing, str]:
    """Return the figure of what shapers leave at each frequency, over a spectrum if given; and its caption.

    Where the axes are independent, it is that of the shapers for all axes together; `Choice.by_axis` has the others.
    """
    ringing, best = choice.ringing, choice.best
    best_label = "common" if choice.by_axis else "recommended"
    drawn_shapers = _undominated(choice)
    frequencies = _curve_frequencies(choice)
    if spectrum is not None:
        spectrum = spectrum.up_to(frequencies[-1])
    curves = []
    for candidate in drawn_shapers:
        design = f"{candidate.kind} ({design_of(candidate)}): {plain(100.0 * candidate.left.worst, 2)} %"
        remaining = 100.0 * residual(candidate.shaper, frequencies, candidate.damping_ratio)
        curves.append(
            shapers.ShaperCurve(
                design + (f", {best_label}" if candidate is best else ""), remaining, candidate is best
            )
        )
    ratio = f"{plain(100.0 * best.damping_ratio, 2)} %"
    caption = (
        f"What each shaper leaves of a mode at each frequency, for the damping ratio of the designs, {ratio}. The "
        f"legend has the frequencies of each design, and the most that it leaves {ringing.share_of}."
    )
    if len(drawn_shapers) < sum(not candidate.follows_pose for candidate in choice.candidates):
        caption += (
            f" At most {MAX_CURVES} are drawn: the {best_label} one, and the shortest of those that no other "
            "beats in both length and what it leaves."
        )
    drawn_spectrum = marked_modes = None
    if spectrum is not None:
        # At lower frequencies the movement itself has the higher density.
        above_movement = spectrum.frequencies >= BAND_START * ringing.frequencies.min()
        before = 100.0 * np.sqrt(spectrum.density / spectrum.density[above_movement].max())
        after = before * residual(best.shaper, spectrum.frequencies, best.damping_ratio)
        drawn_spectrum = shapers.Spectrum(spectrum.frequencies, before, after)
        directions = joined(list(map(clean, spectrum.directions)))
        caption += (
            " Behind them the amplitude of the measured spectrum, the square root of its power density summed "
            f"over {directions}; and what is left of it if each frequency is a mode of its own."
        )
    if isinstance(ringing, MeasuredRinging):
        nominal, largest = (100.0 * share for share in ringing.left_of(best))
        error_range = f"within {SIGMA_RANGE:g} standard deviations"
        marked_modes = shapers.MarkedModes(
            ringing.data.frequency[ringing.rows], nominal, largest, error_range
        )
        caption += (
            " Dots are what the recommended one leaves of the measured modes with their own damping; lines reach "
            f"to the most {error_range} of frequency and damping ratio."
        )
    return shapers.over_frequency(frequencies, curves, drawn_spectrum, marked_modes), caption


def _curve_frequencies(choice: Choice) -> NDArray[np.float64]:
    """Return the frequencies at which curves are drawn [Hz], from above 0 to beyond all modes and designs."""
    designs = [frequency for candidate in choice.candidates for frequency in candidate.frequencies]
    return np.linspace(
        0.0, BAND_END * max(float(choice.ringing.frequencies.max()), *designs), CURVE_POINTS + 1
    )[1:]


def _undominated(choice: Choice) -> list[Candidate]:
    """Return the recommended shaper and a few fixed ones that no other beats in length and remaining vibration."""
    best = choice.best
    fixed = sorted(
        (candidate for candidate in choice.candidates if not candidate.follows_pose),
        key=lambda candidate: (candidate.duration, candidate.left.worst),
    )
    smallest_residual = np.inf
    undominated: list[Candidate] = []
    for candidate in fixed:
        if candidate.left.worst < smallest_residual and len(undominated) < MAX_CURVES:
            undominated.append(candidate)
            smallest_residual = candidate.left.worst
    return (
        undominated
        if any(candidate is best for candidate in undominated)
        else [*undominated[: MAX_CURVES - 1], best]
    )


def frequency_section(choice: Choice, spectrum: MeasuredSpectrum | None) -> Section:
    """Return the section of the figure."""
    title = "Over frequency" if spectrum is None else "Over the measured spectrum"
    pictures = []
    for axis, part in choice.parts.items():
        drawing, caption = frequency_figure(part, spectrum)
        title_of_axis, caption_start = (f"{title}, for {axis}", f"For {axis}. ") if axis else (title, "")
        pictures.append(
            Picture.from_drawing(drawing, title_of_axis, caption_start + caption, caption_start + caption)
        )
    return Section("frequency", title, pictures)


def curves_csv(choice: Choice, spectrum: MeasuredSpectrum | None) -> str:
    """Return the table of what fixed shapers leave over frequency: at the lines of a spectrum, if given."""
    frequencies = _curve_frequencies(choice) if spectrum is None else spectrum.frequencies
    columns = {"frequency": frequencies}
    if spectrum is not None:
        columns["density"] = spectrum.density
    for candidate in (candidate for candidate in choice.candidates if not candidate.follows_pose):
        columns[f"left:{candidate.kind}"] = residual(candidate.shaper, frequencies, candidate.damping_ratio)
    rows = np.column_stack(list(columns.values())).tolist()
    return "".join(f"{','.join(map(str, cells))}\n" for cells in [list(columns), *rows])


def spectrum_facts(content: dict[str, Any]) -> list[tuple[str, Cell]]:
    """Return what the recommended shaper does to the highest peak of a spectrum; empty without one."""
    spectrum = content["spectrum"]
    if spectrum is None:
        return []
    return [
        (
            "highest peak of the spectrum [Hz]",
            number_cell(spectrum["peak_hz"], ".1f", pointer("spectrum", "peak_hz")),
        ),
        (
            "left of a mode there [%]",
            number_cell(spectrum["left"], ".2g", pointer("spectrum", "left"), scale=100.0),
        ),
    ]


def design_of(candidate: Candidate) -> str:
    """Return the frequencies of a design in words."""
    return f"{joined([f'{f:.1f}' for f in candidate.frequencies])} Hz"
