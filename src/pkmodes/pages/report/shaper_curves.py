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
from pkmodes.pages.report.formatting import clean, number, pointer

if TYPE_CHECKING:
    from pkmodes.machine.shaping.results import Candidate, Choice

#: Most shapers drawn, and number of frequencies in a curve.
CURVES, DRAWN = 5, 400


def over_frequency(choice: Choice, spectrum: MeasuredSpectrum | None) -> tuple[Drawing, str]:
    """Return the figure of what shapers leave at each frequency, over a spectrum if given; and its caption.

    Where the axes are independent, it is that of the shapers for all axes together; `Choice.by_axis` has the others.
    """
    at, best = choice.ringing, choice.best
    marked_as = "common" if choice.by_axis else "recommended"
    fixed = _undominated(choice)
    f = _frequencies(choice)
    if spectrum is not None:
        spectrum = spectrum.up_to(f[-1])
    curves = []
    for candidate in fixed:
        design = f"{candidate.kind} ({design_of(candidate)}): {plain(100.0 * candidate.left.worst, 2)} %"
        remaining = 100.0 * residual(candidate.shaper, f, candidate.damping_ratio)
        curves.append(
            shapers.ShaperCurve(
                design + (f", {marked_as}" if candidate is best else ""), remaining, candidate is best
            )
        )
    ratio = f"{plain(100.0 * best.damping_ratio, 2)} %"
    caption = (
        f"What each shaper leaves of a mode at each frequency, for the damping ratio of the designs, {ratio}. The "
        f"legend has the frequencies of each design, and the most that it leaves {at.share_of}."
    )
    if len(fixed) < sum(not candidate.follows_pose for candidate in choice.candidates):
        caption += (
            f" At most {CURVES} are drawn: the {marked_as} one, and the shortest of those that no other beats in "
            "both length and what it leaves."
        )
    drawn = marked = None
    if spectrum is not None:
        above_movement = (
            spectrum.frequencies >= BAND_START * at.frequencies.min()
        )  # lower, the movement itself is higher
        before = 100.0 * np.sqrt(spectrum.density / spectrum.density[above_movement].max())
        after = before * residual(best.shaper, spectrum.frequencies, best.damping_ratio)
        drawn = shapers.Spectrum(spectrum.frequencies, before, after)
        summed = joined(list(map(clean, spectrum.directions)))
        caption += (
            f" Behind them the amplitude of the measured spectrum, the square root of its power density summed over "
            f"{summed}; and what is left of it if each frequency is a mode of its own."
        )
    if isinstance(at, MeasuredRinging):
        nominal, largest = (100.0 * share for share in at.left_of(best))
        words = f"within {SIGMA_RANGE:g} standard deviations"
        marked = shapers.MarkedModes(at.data.frequency[at.rows], nominal, largest, words)
        caption += (
            " Dots are what the recommended one leaves of the measured modes with their own damping; lines reach to "
            f"the most {words} of frequency and damping ratio."
        )
    return shapers.over_frequency(f, curves, drawn, marked), caption


def _frequencies(choice: Choice) -> NDArray[np.float64]:
    """Return the frequencies at which curves are drawn [Hz], from above 0 to beyond all modes and designs."""
    designs = [f for candidate in choice.candidates for f in candidate.frequencies]
    return np.linspace(0.0, BAND_END * max(float(choice.ringing.frequencies.max()), *designs), DRAWN + 1)[1:]


def _undominated(choice: Choice) -> list[Candidate]:
    """Return the recommended shaper and a few fixed ones that no other beats in length and remaining vibration."""
    best = choice.best
    fixed = sorted(
        (candidate for candidate in choice.candidates if not candidate.follows_pose),
        key=lambda candidate: (candidate.duration, candidate.left.worst),
    )
    least = np.inf
    chosen: list[Candidate] = []
    for candidate in fixed:
        if candidate.left.worst < least and len(chosen) < CURVES:
            chosen.append(candidate)
            least = candidate.left.worst
    return chosen if any(candidate is best for candidate in chosen) else [*chosen[: CURVES - 1], best]


def over_frequency_section(choice: Choice, spectrum: MeasuredSpectrum | None) -> Section:
    """Return the section of the figure."""
    title = "Over frequency" if spectrum is None else "Over the measured spectrum"
    pictures = []
    for axis, part in choice.parts.items():
        drawing, caption = over_frequency(part, spectrum)
        title_of_axis, begin = (f"{title}, for {axis}", f"For {axis}. ") if axis else (title, "")
        pictures.append(Picture.of(drawing, title_of_axis, begin + caption, begin + caption))
    return Section("frequency", title, pictures)


def curves_csv(choice: Choice, spectrum: MeasuredSpectrum | None) -> str:
    """Return the table of what fixed shapers leave over frequency: at the lines of a spectrum, if given."""
    f = _frequencies(choice) if spectrum is None else spectrum.frequencies
    columns = {"frequency": f}
    if spectrum is not None:
        columns["density"] = spectrum.density
    for candidate in (candidate for candidate in choice.candidates if not candidate.follows_pose):
        columns[f"left:{candidate.kind}"] = residual(candidate.shaper, f, candidate.damping_ratio)
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
            number(spectrum["peak_hz"], ".1f", pointer("spectrum", "peak_hz")),
        ),
        (
            "left of a mode there [%]",
            number(spectrum["left"], ".2g", pointer("spectrum", "left"), scale=100.0),
        ),
    ]


def design_of(candidate: Candidate) -> str:
    """Return the frequencies of a design in words."""
    return f"{joined([f'{f:.1f}' for f in candidate.frequencies])} Hz"
