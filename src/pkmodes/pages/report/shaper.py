"""The report of ``pkmodes shaper``: what shapers leave of the vibration, where, and how certain that is."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace
from typing import TYPE_CHECKING, Any

import numpy as np

from pkmodes.core.base.numbers import plain, range_text
from pkmodes.core.robot.report_fields import head_of
from pkmodes.core.robot.units import DISPLAY_UNITS
from pkmodes.core.support.ordering import joined
from pkmodes.machine.shaping.firmware import version_name
from pkmodes.machine.shaping.settings import append_unit
from pkmodes.pages.report.blocks import Cell, Column, Facts, Section, Summary, Table
from pkmodes.pages.report.firmware_lines import firmware_lines, schedule_lines
from pkmodes.pages.report.formatting import (
    clean,
    group_thousands,
    number_cell,
    pointer,
    shorten,
    signed_cell,
    to_sentence,
)
from pkmodes.pages.report.page import need_report, page
from pkmodes.pages.report.sections import origin_section
from pkmodes.pages.report.shaper_curves import design_of, frequency_section, spectrum_facts
from pkmodes.pages.report.shaper_pictures import (
    frequency_error_picture,
    percent_or_nothing,
    workspace_picture,
)
from pkmodes.pages.report.shaper_schedule import schedule_blocks
from pkmodes.pages.report.sources import Source, known_sources

if TYPE_CHECKING:
    from pkmodes.core.model import Model
    from pkmodes.machine.shaping.measured_spectrum import MeasuredSpectrum
    from pkmodes.machine.shaping.results import Candidate, Choice

#: Title of the largest acceleration that Klipper suggests.
MAX_ACCELERATION_TITLE = "largest acceleration by Klipper's rule, for corners smoothed by 0.12 mm"


def shaper_report(
    model: Model,
    choice: Choice,
    content: dict[str, Any],
    sources: Sequence[Source] | None = None,
    spectrum: MeasuredSpectrum | None = None,
) -> str:
    """Return the report of a choice.

    - content: the JSON of the command
    - sources: the input files as they were read; by default the robot file as it is now
    - spectrum: over which shapers are drawn

    Returns HTML that needs no other file and no network.
    Raises MissingExtraError if the libraries of the extra ``report`` are not installed.
    """
    need_report()
    sources = known_sources([("robot file", model.robot.source)]) if sources is None else sources
    parts = choice.parts.items()
    # Where axes are independent, the table of one shaper for all of them is folded.
    *axis_tables, common_table = shapers_tables(choice)
    sections = [
        Section("shapers", "Shapers", axis_tables or [common_table]),
        *([Section("schedule", "Schedule", table)] if (table := schedule_blocks(choice)) else []),
        *(
            [Section("together", "One shaper for all axes", [common_table], folded=True)]
            if axis_tables
            else []
        ),
        Section("machine", "The machine", [machine_facts(model, choice, content)], folded=True),
        Section(
            "workspace", "Over the workspace", [workspace_picture(model, part, axis) for axis, part in parts]
        ),
        *([] if spectrum is None else [frequency_section(choice, spectrum)]),
        Section(
            "errors",
            "Where frequencies differ from the model's",
            [frequency_error_picture(part, axis) for axis, part in parts],
            folded=True,
        ),
        *_line_sections(content),
        replace(origin_section(sources, model.mechanism), folded=True),
    ]
    return page(shaper_summary(model, choice, content), sections)


def _line_sections(content: dict[str, Any]) -> list[Section]:
    """Return the lines for firmware; those without a schedule are folded where there is one."""
    without_schedule, scheduled = firmware_lines(content), schedule_lines(content)
    if not scheduled:
        return [Section("firmware", "Lines for firmware", without_schedule)]
    return [
        Section("firmware", "Lines for firmware, without the schedule", without_schedule, folded=True),
        Section("schedule-lines", "Lines for the schedule", scheduled),
    ]


def shaper_summary(model: Model, choice: Choice, content: dict[str, Any]) -> Summary:
    """Return the recommended shaper, or that of each axis, and what it leaves at the worst pose."""
    parts = choice.parts
    worst = max(part.best.left_at_pose.worst for part in parts.values())
    if choice.by_axis:
        shapers = [f"{part.best.kind} on {axis} ({design_of(part.best)})" for axis, part in parts.items()]
        headline = (
            f"{joined(shapers)} leave up to {_vibration_share(worst)} at the worst {choice.ringing.point_is}"
        )
        reason = "The recommended fixed shapers: the axes are independent, so each has its own. " + " ".join(
            f"On {axis}, {part.best.kind} {_reason_in_words(part)}" for axis, part in parts.items()
        )
    else:
        headline = f"{choice.best.kind} leaves up to {_vibration_share(worst)} at the worst {choice.ringing.point_is}"
        reason = f"The recommended fixed shaper, for {design_of(choice.best)}. It {_reason_in_words(choice)}"
    facts = []
    for axis_index, (axis, part) in enumerate(parts.items()):
        best, axis_prefix = part.best, f"{axis}: " if axis else ""
        choice_keys = ("axes", axis_index) if axis else ()
        shaper_keys = (*choice_keys, "shapers", part.recommended)
        largest_pointer, pose_pointer = (
            pointer(*shaper_keys, key, "worst") for key in ("left", "left_at_pose")
        )
        facts += [
            (
                f"{axis_prefix}lasts",
                Cell(
                    f"{plain(1e3 * best.duration, 3)} ms", best.duration, pointer(*shaper_keys, "duration_s")
                ),
            ),
            (
                f"{axis_prefix}left at the worst {part.ringing.point_is}, of the vibration there",
                Cell(percent_or_nothing(best.left_at_pose.worst), best.left_at_pose.worst, pose_pointer),
            ),
            (
                f"{axis_prefix}largest vibration left, of the largest without",
                Cell(percent_or_nothing(best.left.worst), best.left.worst, largest_pointer),
            ),
            (
                f"{axis_prefix}{MAX_ACCELERATION_TITLE}",
                acceleration_cell(best, pointer(*shaper_keys, "max_acceleration")),
            ),
        ]
    if not choice.by_axis:
        facts.append(
            (
                "largest vibration without, for a step of 1 m/s\u00b2",
                Cell(
                    f"{plain(1e6 * choice.unshaped.worst, 3)} \u00b5m",
                    choice.unshaped.worst,
                    pointer("unshaped", "worst"),
                ),
            )
        )
    return Summary(
        subject=f"{shorten(content['robot'])}, {choice.ringing.motors}",
        kind="Shaper",
        headline=headline,
        reason=reason,
        notes=[note_to_sentence(clean(note)) for note in content["notes"]],
        facts=[*facts, *spectrum_facts(content)],
        head=head_of(model.robot.report),
    )


def acceleration_cell(candidate: Candidate, json_pointer: str = "", *, unit: bool = True) -> Cell:
    """Return the largest acceleration that Klipper would suggest in mm/s^2, rounded as Klipper does.

    Klipper gives 0 where its speed in corners alone smooths them by more than it allows: it suggests none.
    """
    value = candidate.max_acceleration
    if value is None:
        return number_cell(None)
    if value == 0.0:
        return Cell("none" if not unit else "none: corners are smoothed by more at any", value, json_pointer)
    step = 100 if value >= 1.0 else 1
    text = group_thousands(step * round(1e3 * value / step))
    return Cell(f"{text} mm/s\u00b2" if unit else text, value, json_pointer)


def _reason_in_words(choice: Choice) -> str:
    """Return what the recommended shaper leaves of the largest vibration, and why it is recommended."""
    share = percent_or_nothing(choice.best.left.worst)
    return f"leaves at most {share} of the largest vibration without a shaper. {why_recommended(choice)}"


def why_recommended(choice: Choice) -> str:
    """Return why the recommended shaper is recommended."""
    limit, length = choice.left, choice.length
    length_clause = "" if length is None else f" that lasts at most {1e3 * length:.4g} ms"
    firmware_clause = "" if choice.firmware is None else f" of {version_name(choice.firmware)}"
    share = f"{plain(100.0 * limit, 3)} %"  # of what the sentence before says
    if choice.best.left.worst <= limit:
        return f"It is the shortest fixed one{firmware_clause}{length_clause} that leaves at most {share}."
    return f"No fixed one{firmware_clause}{length_clause} leaves at most {share}; this one leaves least."


def note_to_sentence(text: str) -> str:
    """Return a note as a sentence; a name at its beginning keeps its small letter."""
    capitalised = to_sentence(text)
    return capitalised if text.partition(" ")[0].isalpha() else text[:1] + capitalised[1:]


def _vibration_share(share: float) -> str:
    """Return a share of the vibration for a headline."""
    return f"{plain(100.0 * share, 2)} % of the vibration"


def machine_facts(model: Model, choice: Choice, content: dict[str, Any]) -> Facts:
    """Return the poses and the modes that count."""
    ringing = choice.ringing
    entries = [("poses", [Cell(group_thousands(content["poses"]), content["poses"], pointer("poses"))])]
    rms = number_cell(choice.unshaped.rms, ".3g", pointer("unshaped", "rms"), scale=1e6)
    entries.append(("rms vibration without a shaper, for a step of 1 m/s\u00b2 [\u00b5m]", [rms]))
    # In the units of the poses below it.
    components = zip(model.mechanism.pose, choice.unshaped.pose.tolist(), strict=True)
    component_texts = [
        f"{component.name} = {value * DISPLAY_UNITS[component.unit][1] + 0.0:.5g} {DISPLAY_UNITS[component.unit][0]}"
        for component, value in components
    ]
    pose_cells = [signed_cell(", ".join(component_texts))]
    if choice.unshaped.setting is not None:
        pose_cells[0] = Cell(
            f"{pose_cells[0].text},", plain_text=f"{pose_cells[0].plain_text or pose_cells[0].text},"
        )
        pose_cells.append(Cell(clean(choice.unshaped.setting)))
    entries.append(("largest without a shaper at", pose_cells))
    for path, symbol in ringing.settings[0].units.items() if ringing.settings else ():
        values = np.array([setting.values[path] for setting in ringing.settings])
        count = len(set(values.tolist()))
        extent = append_unit(range_text(values, ".4g"), symbol) + (f" ({count} values)" if count > 1 else "")
        entries.append((clean(path), [signed_cell(extent)]))
    for i, component in enumerate(model.mechanism.pose):
        unit, factor = DISPLAY_UNITS[component.unit]
        entries.append(
            (component.name, [signed_cell(f"{range_text(ringing.poses[:, i] * factor, '.5g')} {unit}")])
        )
    for mode_index in range(ringing.frequencies.shape[1]):
        text = f"{range_text(ringing.frequencies[:, mode_index], '.1f')} Hz"
        cells = [Cell(text)]
        if ringing.spread is not None:
            sigma = float(np.median(ringing.spread[:, mode_index] * ringing.frequencies[:, mode_index]))
            cells = [Cell(f"{text},"), Cell(f"standard deviation {plain(sigma, 2)} Hz (median)", sigma)]
        entries.append((f"mode {mode_index + 1}", cells))
    return Facts(entries)


def shapers_tables(choice: Choice) -> list[Table]:
    """Return all shapers with what each leaves: for each independent axis, and last for all axes together."""
    tables = [shapers_table(part, axis, i) for i, (axis, part) in enumerate(choice.by_axis.items())]
    return [*tables, shapers_table(choice, has_recommendation=not tables)]


def shapers_table(
    choice: Choice, axis: str = "", index: int = 0, *, has_recommendation: bool = True
) -> Table:
    """Return shapers, and what each leaves.

    - axis, index: that for which they are, and its number; empty for all
    - has_recommendation: whether one of them is recommended
    """
    keys = {"rms": "rms [%]", "worst": "worst [%]", "rms_uncertain": "rms, uncertain [%]"}
    uncertain = any(candidate.left.rms_uncertain is not None for candidate in choice.candidates)
    if not uncertain:
        del keys["rms_uncertain"]
    columns = [
        Column("shaper", numeric=False),
        Column("design [Hz]", numeric=False),
        Column("lasts [ms]"),
        *(Column(title) for title in keys.values()),
        Column("largest [%]"),
        Column("max_accel"),
    ]
    rows = []
    for i, candidate in enumerate(choice.candidates):
        is_recommended = has_recommendation and i == choice.recommended
        shaper_keys = (*(("axes", index) if axis else ()), "shapers", i)
        cells = [
            Cell(clean(candidate.kind) + (" *" if is_recommended else ""), strong=is_recommended),
            Cell(
                f"of the {choice.ringing.point_is}"
                if candidate.follows_pose
                else ", ".join(f"{f:.2f}" for f in candidate.frequencies)
            ),
            number_cell(candidate.duration, ".1f", pointer(*shaper_keys, "duration_s"), scale=1e3),
        ]
        cells += [
            number_cell(
                getattr(candidate.left_at_pose, key),
                ".2f",
                pointer(*shaper_keys, "left_at_pose", key),
                scale=100.0,
            )
            for key in keys
        ]
        cells.append(
            number_cell(candidate.left.worst, ".2f", pointer(*shaper_keys, "left", "worst"), scale=100.0)
        )
        cells.append(acceleration_cell(candidate, pointer(*shaper_keys, "max_acceleration"), unit=False))
        rows.append(cells)
    point_is, points_are = choice.ringing.point_is, choice.ringing.points_are
    axes_clause = f" along {axis}" if axis else "" if has_recommendation else ", with one shaper for all axes"
    caption = (
        f"What shapers leave{axes_clause}, of the vibration without a shaper at the same {point_is}: the root mean "
        f"square over the {points_are}, and the largest value"
    )
    if uncertain:
        caption += (
            "; the root mean square with frequencies spread by the standard deviations of the robot file"
        )
    caption += (
        ". The last share is of the largest vibration anywhere, and decides. max_accel [mm/s\u00b2] is by "
        "Klipper's rule."
    )
    note = "* The recommended one." if has_recommendation else ""
    if any(candidate.follows_pose for candidate in choice.candidates):
        note += (
            f" Those of the {point_is} are judged at rest and for the model as it is: a move, and frequencies "
            "that differ from the model's, add to what they leave."
        )
    return Table(caption, columns, rows, note=note.strip(), key_columns=2)
