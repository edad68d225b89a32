"""The report of ``pkmodes shaper --measured``: what shapers leave of measured modes, within their errors."""

from __future__ import annotations

from collections.abc import Sequence
from pathlib import Path
from typing import Any

from pkmodes.core.base.numbers import plain
from pkmodes.machine.shaping.measured_modes import SIGMA_RANGE, of_measured
from pkmodes.machine.shaping.measured_spectrum import MeasuredSpectrum
from pkmodes.machine.shaping.results import Choice
from pkmodes.pages.report.blocks import Cell, Column, Section, Summary, Table
from pkmodes.pages.report.firmware_lines import firmware_lines
from pkmodes.pages.report.formatting import (
    clean,
    label_cell,
    number_cell,
    plural,
    pointer,
    shorten,
    uncertain_cell,
)
from pkmodes.pages.report.page import need_report, page
from pkmodes.pages.report.sections import origin_section
from pkmodes.pages.report.shaper import (
    MAX_ACCELERATION_TITLE,
    acceleration_cell,
    note_to_sentence,
    why_recommended,
)
from pkmodes.pages.report.shaper_curves import design_of, frequency_section, spectrum_facts
from pkmodes.pages.report.sources import Source
from pkmodes.pages.report.tables import compact_table

#: The range of errors for which everything is stated.
ERROR_RANGE = f"within {SIGMA_RANGE:g} standard deviations of its frequency and damping ratio"


def measured_shaper_report(
    choice: Choice, content: dict[str, Any], sources: Sequence[Source], spectrum: MeasuredSpectrum | None
) -> str:
    """Return the report of a choice for measured modes.

    - content: the JSON of the command
    - sources: the input files as they were read
    - spectrum: over which shapers are drawn

    Returns HTML that needs no other file and no network.
    Raises MissingExtraError if the libraries of the extra ``report`` are not installed.
    """
    need_report()
    sections = [
        Section("shapers", "Shapers", [shapers_table(choice)]),
        frequency_section(choice, spectrum),
        Section("modes", "The measured modes", [modes_table(content)]),
        Section("firmware", "Lines for firmware", firmware_lines(content)),
        origin_section(sources, None),
    ]
    return page(measured_shaper_summary(choice, content), sections)


def measured_shaper_summary(choice: Choice, content: dict[str, Any]) -> Summary:
    """Return the recommended shaper, and what it leaves."""
    best = choice.best
    remaining = of_measured(choice).shares(best)
    left_keys = ("shapers", choice.recommended, "left")
    modes, poses = plural(content["modes"], "measured mode"), plural(content["poses"], "pose")
    worst = f"{plain(100.0 * remaining.worst_uncertain, 2)} %"
    reason = (
        f"The recommended shaper, for {design_of(best)}, leaves at most {worst} of the vibration in each of the "
        f"{modes} at {poses}, {ERROR_RANGE}. {why_recommended(choice)} How much each mode takes part in a "
        "movement is not in the table, so each counts in full: the share left of all of them together is no "
        "larger."
    )
    facts = [
        ("lasts", Cell(f"{plain(1e3 * best.duration, 3)} ms", best.duration)),
        (
            MAX_ACCELERATION_TITLE,
            acceleration_cell(best, pointer("shapers", choice.recommended, "max_acceleration")),
        ),
        (
            "most left of a mode as measured [%]",
            number_cell(remaining.worst, ".2g", pointer(*left_keys, "worst"), scale=100.0),
        ),
        (
            f"most left of a mode within {SIGMA_RANGE:g} \u03c3 [%]",
            number_cell(
                remaining.worst_uncertain, ".2g", pointer(*left_keys, "worst_uncertain"), scale=100.0
            ),
        ),
    ]
    return Summary(
        subject=shorten(Path(content["measured"]).name),
        kind="Shaper",
        headline=f"{best.kind} leaves at most {worst} of each measured mode",
        reason=reason,
        notes=[note_to_sentence(clean(note)) for note in content["notes"]],
        facts=[*facts, *spectrum_facts(content)],
    )


def shapers_table(choice: Choice) -> Table:
    """Return all shapers, and what each leaves."""
    keys = {"rms": "rms [%]", "worst": "worst [%]", "worst_uncertain": f"worst, {SIGMA_RANGE:g} \u03c3 [%]"}
    columns = [
        Column("shaper", numeric=False),
        Column("design [Hz]", numeric=False),
        Column("lasts [ms]"),
        *(Column(title, page_only=key == "rms") for key, title in keys.items()),
        Column("rounds [\u00b5m]"),
        Column("max_accel"),
    ]
    rows = []
    ringing = of_measured(choice)
    for i, candidate in enumerate(choice.candidates):
        is_recommended, shaper_keys, remaining = (
            i == choice.recommended,
            ("shapers", i),
            ringing.shares(candidate),
        )
        cells = [
            Cell(clean(candidate.kind) + (" *" if is_recommended else ""), strong=is_recommended),
            Cell(", ".join(f"{f:.2f}" for f in candidate.frequencies)),
            number_cell(candidate.duration, ".1f", pointer(*shaper_keys, "duration_s"), scale=1e3),
        ]
        cells += [
            number_cell(getattr(remaining, key), ".2f", pointer(*shaper_keys, "left", key), scale=100.0)
            for key in keys
        ]
        cells.append(number_cell(candidate.rounding, ".1f", pointer(*shaper_keys, "rounding_s2"), scale=1e6))
        cells.append(acceleration_cell(candidate, pointer(*shaper_keys, "max_acceleration"), unit=False))
        rows.append(cells)
    caption = (
        "What shapers leave of the measured modes: the root mean square and the largest of all as measured, and "
        f"the largest with each mode {ERROR_RANGE}. Where a shaped path turns back, it is rounded by this much "
        "for each m/s\u00b2 of acceleration; max_accel [mm/s\u00b2] is by Klipper's rule."
    )
    return Table(caption, columns, rows, note="* The recommended one.", key_columns=2)


def modes_table(content: dict[str, Any], max_modes: int | None = None) -> Table:
    """Return the measured modes with what the recommended shaper leaves of each, the largest remainders first.

    - max_modes: maximum number of modes; all by default
    """
    modes = content["measured_modes"]
    order = sorted(range(len(modes)), key=lambda i: -modes[i]["left_uncertain"])
    rows = []
    for i in order[:max_modes]:
        mode, mode_keys = modes[i], ("measured_modes", i)
        rows.append(
            [
                label_cell(mode["pose"]),
                number_cell(mode["line"], ".0f", pointer(*mode_keys, "line")),
                uncertain_cell(
                    mode["frequency_hz"],
                    mode["sigma_hz"],
                    pointer(*mode_keys, "frequency_hz"),
                    pointer(*mode_keys, "sigma_hz"),
                ),
                number_cell(mode["damping_ratio"], ".2f", pointer(*mode_keys, "damping_ratio"), scale=100.0),
                number_cell(mode["left"], ".2f", pointer(*mode_keys, "left"), scale=100.0),
                number_cell(
                    mode["left_uncertain"], ".2f", pointer(*mode_keys, "left_uncertain"), scale=100.0
                ),
            ]
        )
    columns = [Column("pose", numeric=False), Column("line"), Column("f [Hz]"), Column("damping ratio [%]")]
    columns += [Column("left [%]"), Column(f"left, {SIGMA_RANGE:g} \u03c3 [%]")]
    caption = (
        f"What the recommended shaper leaves of each measured mode: as measured, and at most {ERROR_RANGE}."
    )
    omitted = len(order) - len(rows)
    note = (
        f"{plural(omitted, 'mode')} of which less is left: the JSON and the report have them."
        if omitted
        else ""
    )
    return compact_table(caption, columns, rows, note=note)
