"""The report of ``pkmodes identify``: the modes of a campaign, and for each record the fits that they come from."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import replace
from typing import Any

import numpy as np

from pkmodes.core.robot.report_fields import head_of
from pkmodes.core.support.motors import motors_in_words
from pkmodes.core.support.ordering import listed
from pkmodes.modaltest.campaign.campaign import Campaign
from pkmodes.modaltest.campaign.identify import MIN_COLLINEARITY
from pkmodes.modaltest.campaign.results import Identification, IdentifiedMode, RecordResult
from pkmodes.pages.plots import identified_modes
from pkmodes.pages.report.blocks import Block, Cell, Column, Picture, Section, Summary
from pkmodes.pages.report.formatting import (
    clean,
    frequency_cell,
    number_cell,
    percent_text,
    plural,
    pointer,
    shorten,
)
from pkmodes.pages.report.identified_record import KIND_TITLES, auto_macs, record_section
from pkmodes.pages.report.page import need_report, page
from pkmodes.pages.report.sections import origin_section
from pkmodes.pages.report.sources import Source
from pkmodes.pages.report.tables import compact_table

#: Maximum number of places named in a header note.
MAX_PLACES_NAMED = 8
#: MAC between two modes above which the sensors hardly tell them apart.
MAX_DISTINCT_MAC = 0.8
#: Share of the model orders below which a mode that was found in them is weak.
MIN_ORDER_SHARE = 0.25
#: Relative standard deviation of a damping ratio above which the page mentions it.
MAX_DAMPING_UNCERTAINTY = 0.5


def identification_report(
    identified: Identification, campaign: Campaign, content: Mapping[str, Any], sources: Sequence[Source]
) -> str:
    """Return the report of an identification.

    - identified: with what is drawn of the fits
    - content: the JSON of the command
    - sources: the campaign file and the robot file as they were read

    Returns HTML that needs no other file and no network.
    Raises MissingExtraError if the libraries of the extra ``report`` are not installed.
    """
    need_report()
    sections = [Section("records", "Records", _record_blocks(identified, content))]
    sections += [
        replace(record_section(i, result, campaign, content["records"][i]), folded=True)
        for i, result in enumerate(identified.records)
    ]
    repeatability = number_cell(identified.repeatability, ".2g", pointer("repeatability"), scale=100.0)
    sections.append(
        replace(origin_section(sources, None, [("repeatability [%]", [repeatability])]), folded=True)
    )
    return page(_summary(identified, campaign), sections)


def _summary(identified: Identification, campaign: Campaign) -> Summary:
    modes = [mode for result in identified.records for mode in result.modes]
    modes_text = plural(len(modes), "mode")
    poses_text = plural(sum(not result.is_left_out for result in identified.records), "pose")
    points_to_check = _points_to_check(identified)
    sentences = [
        f"{sentence_start} {listed(places_to_check, MAX_PLACES_NAMED)}."
        for sentence_start, places_to_check in points_to_check
    ]
    notes = [clean(note) for note in (*sentences, *identified.messages)]
    # A mode or a pose in several sentences is one point.
    places = {place for _, places_to_check in points_to_check for place in places_to_check}
    point_count = len(places) + len(identified.messages)
    # Where the modes come from, and what limits their accuracy.
    files = sum(
        sum(map(len, result.record.setups.values())) - len(result.left_out) for result in identified.records
    )
    part_names = {
        "repeatability": "the repeatability of the pose",
        "scatter": "the scatter of the repeats",
        "fit": "what the fit leaves open",
    }
    largest_parts = [
        max(("scatter", "fit", "repeatability"), key=lambda part: getattr(mode.parts, part)) for mode in modes
    ]
    dominant = max(part_names, key=largest_parts.count)
    dominant_count = largest_parts.count(dominant)
    share = (
        "every mode" if dominant_count == len(modes) else f"{dominant_count} of {plural(len(modes), 'mode')}"
    )
    reason = (
        f"From {plural(files, 'file')}. The largest part of a frequency's standard deviation is "
        f"{part_names[dominant]} in {share}."
    )
    subject = "Structure" if campaign.model is None else shorten(campaign.model.robot.name)
    if campaign.model is not None:
        drives = [result.record.drives for result in identified.records]
        subject += f", {motors_in_words(campaign.model.robot, drives)}"
    return Summary(
        subject=subject,
        kind="Identification",
        headline=f"{modes_text} at {poses_text}"
        + (f", {plural(point_count, 'point')} to check" if point_count else ""),
        reason=reason,
        tone="open" if notes else "good",
        notes=notes,
        facts=_accuracy_facts(identified, modes),
        head=head_of(campaign.report, {} if campaign.model is None else campaign.model.robot.report),
    )


def _accuracy_facts(identified: Identification, modes: Sequence[IdentifiedMode]) -> list[tuple[str, Cell]]:
    """Return how many modes there are, and how accurate they are."""
    relative_sigmas = np.array([mode.sigma / mode.frequency for mode in modes])
    relative_damping_sigmas = np.array(
        [mode.sigma_damping / mode.damping for mode in modes if mode.damping > 0.0]
    )
    relative_damping_sigmas = relative_damping_sigmas[np.isfinite(relative_damping_sigmas)]
    repeatability_pointer = pointer("repeatability")
    facts = [
        ("modes", Cell(str(len(modes)), len(modes))),
        (
            "median \u03c3 of a frequency",
            Cell(percent_text(float(np.median(relative_sigmas))), float(np.median(relative_sigmas))),
        ),
        (
            "largest \u03c3 of a frequency",
            Cell(percent_text(float(relative_sigmas.max())), float(relative_sigmas.max())),
        ),
        (
            "repeatability, a part of every \u03c3",
            Cell(percent_text(identified.repeatability), identified.repeatability, repeatability_pointer),
        ),
    ]
    if relative_damping_sigmas.size:
        median_damping_sigma = float(np.median(relative_damping_sigmas))
        facts.append(
            (
                "median relative \u03c3 of a damping ratio",
                Cell(percent_text(median_damping_sigma), median_damping_sigma),
            )
        )
    return facts


def _points_to_check(identified: Identification) -> list[tuple[str, list[str]]]:
    """Return the points to check: the beginning of each sentence, and the modes or poses that it lists."""
    similar_modes = [
        f"{result.record.pose} ({result.modes[i].frequency:.4g} and {result.modes[k].frequency:.4g} Hz)"
        for result in identified.records
        for i, k in np.argwhere(np.triu(np.nan_to_num(auto_macs(result.modes)) > MAX_DISTINCT_MAC, 1))
    ]
    poses_with_faulty_files = [result.record.pose for result in identified.records for _ in result.left_out]
    points = [
        (f"{plural(len(poses_with_faulty_files), 'faulty file')} left out:", poses_with_faulty_files),
        (
            "No file could be used at",
            [result.record.pose for result in identified.records if result.is_left_out],
        ),
        (
            "No mode was found at",
            [result.record.pose for result in identified.records if not (result.modes or result.is_left_out)],
        ),
        ("Added by the campaign:", _select_modes(identified, lambda mode, _: mode.edited is not None)),
        (
            "Struck out by the campaign:",
            [f"{result.record.pose} ({f:.4g} Hz)" for result in identified.records for f in result.struck],
        ),
        (
            f"Complex shapes (modal phase collinearity below {MIN_COLLINEARITY:g}):",
            _select_modes(identified, lambda mode, _: mode.complexity < MIN_COLLINEARITY),
        ),
        (
            f"Weak modes, found in fewer than {100.0 * MIN_ORDER_SHARE:g} % of the model orders:",
            _select_modes(
                identified,
                lambda mode, _: (
                    mode.found_in is not None and mode.found_in[0] < MIN_ORDER_SHARE * mode.found_in[1]
                ),
            ),
        ),
        (
            "Found in only some of the files:",
            _select_modes(identified, lambda mode, result: mode.files < _file_count(result)),
        ),
        (
            f"Damping known to no better than {100.0 * MAX_DAMPING_UNCERTAINTY:g} %:",
            _select_modes(
                identified, lambda mode, _: mode.sigma_damping > MAX_DAMPING_UNCERTAINTY * mode.damping
            ),
        ),
        (f"Modes that the sensors hardly tell apart (MAC above {MAX_DISTINCT_MAC:g}):", similar_modes),
        (
            "Messages on the signals, in the section of each pose:",
            [result.record.pose for result in identified.records if result.messages],
        ),
        (
            "A single file, so that the scatter of repeats is unknown:",
            [
                result.record.pose
                for result in identified.records
                if result.repeats and all(len(repeat.files) == 1 for repeat in result.repeats)
            ],
        ),
    ]
    return [
        (sentence_start, places_to_check) for sentence_start, places_to_check in points if places_to_check
    ]


def _select_modes(identified: Identification, predicate: Any) -> list[str]:
    return [
        f"{result.record.pose} ({mode.frequency:.4g} Hz)"
        for result in identified.records
        for mode in result.modes
        if predicate(mode, result)
    ]


def _file_count(result: RecordResult) -> int:
    return sum(len(repeat.files) for repeat in result.repeats)


def _record_blocks(identified: Identification, content: Mapping[str, Any]) -> list[Block]:
    """Return all records in a table, and their frequencies in a figure if there are several."""
    rows = []
    for i, result in enumerate(identified.records):
        last = len(result.modes) - 1
        rows.append(
            [
                Cell(shorten(result.record.pose)),
                Cell(KIND_TITLES.get(result.record.kind, result.record.kind)),
                number_cell(len(result.modes), ".0f"),
                _frequency_cell(i, result, 0),
                _frequency_cell(i, result, last),
                number_cell(_file_count(result), ".0f"),
                number_cell(len(result.left_out), ".0f"),
                number_cell(len(content["records"][i]["messages"]), ".0f"),
                number_cell(lowest_coherence(result), ".2f"),
            ]
        )
    columns = [
        *(Column("pose", False), Column("kind", False), Column("modes")),
        *(Column("lowest [Hz]"), Column("highest [Hz]")),
        *(Column("files"), Column("left out"), Column("messages"), Column("coherence")),
    ]
    caption = "Records."
    if all(lowest_coherence(result) is None for result in identified.records):
        rows, columns = [row[:-1] for row in rows], columns[:-1]
    else:
        caption = (
            "Records. The coherence is the lowest of the modes, each in the drawn function of its record that shows "
            "it best; far below 1, noise or a nonlinear machine drowns the mode."
        )
    blocks: list[Block] = []
    if len(identified.records) > 1:
        labels = [result.record.pose for result in identified.records]
        modes = [
            (i, mode.frequency, mode.edited is not None)
            for i, result in enumerate(identified.records)
            for mode in result.modes
        ]
        struck = [(i, f) for i, result in enumerate(identified.records) for f in result.struck]
        blocks.append(
            Picture.from_drawing(
                identified_modes.frequencies_by_pose(labels, modes, struck),
                "Frequencies at each pose",
                f"{plural(len(modes), 'mode')} at {plural(len(labels), 'pose')}.",
                "Frequencies at each pose. Their standard deviations are smaller than the marks. A mode that its "
                "neighbours lack was hidden there, or is not a mode.",
            )
        )
    return [*blocks, compact_table(caption, columns, rows)]


def lowest_coherence(result: RecordResult) -> float | None:
    """Return the lowest coherence at a mode of a record, of each mode in the drawn function with the highest there.

    None where the files of the record have no coherence.
    """
    curves = [
        curve
        for inspection in result.inspections
        for curve in inspection.curves
        if curve.coherence is not None
    ]
    lowest: float | None = None
    for mode in result.modes:
        coherences = [
            float(curve.coherence[int(np.argmin(np.abs(curve.frequencies - mode.frequency)))])
            for curve in curves
            if curve.coherence is not None and curve.frequencies[0] <= mode.frequency <= curve.frequencies[-1]
        ]
        finite = [value for value in coherences if np.isfinite(value)]
        if finite:
            lowest = max(finite) if lowest is None else min(lowest, max(finite))
    return lowest


def _frequency_cell(record_index: int, result: RecordResult, mode_index: int) -> Cell:
    """Return the frequency of a mode of a record, nothing if it has none."""
    if not result.modes:
        return number_cell(None)
    return frequency_cell(
        result.modes[mode_index].frequency, pointer("records", record_index, "modes", mode_index, "frequency")
    )
