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
from pkmodes.pages.report.formatting import clean, hertz, number, per_cent, plural, pointer, shortened
from pkmodes.pages.report.identified_record import SHOWN, auto_macs, record_section
from pkmodes.pages.report.page import need_report, page
from pkmodes.pages.report.sections import origin
from pkmodes.pages.report.sources import Source
from pkmodes.pages.report.tables import table

#: Most places named in a header note.
PLACES = 8
#: MAC between two modes above which the sensors hardly tell them apart.
ALIKE = 0.8
#: Share of the model orders below which a mode that was found in them is weak.
FEW = 0.25
#: Relative standard deviation of a damping ratio above which the page mentions it.
UNCERTAIN = 0.5


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
    sections = [Section("records", "Records", _overview(identified, content))]
    sections += [
        replace(record_section(i, result, campaign, content["records"][i]), folded=True)
        for i, result in enumerate(identified.records)
    ]
    repeatability = number(identified.repeatability, ".2g", pointer("repeatability"), scale=100.0)
    sections.append(replace(origin(sources, None, [("repeatability [%]", [repeatability])]), folded=True))
    return page(_summary(identified, campaign), sections)


def _summary(identified: Identification, campaign: Campaign) -> Summary:
    modes = [mode for result in identified.records for mode in result.modes]
    count, poses = (
        plural(len(modes), "mode"),
        plural(sum(not result.is_left_out for result in identified.records), "pose"),
    )
    attention = _attention(identified)
    sentences = [f"{beginning} {listed(places, PLACES)}." for beginning, places in attention]
    notes = [clean(note) for note in (*sentences, *identified.messages)]
    # A sentence that lists several modes or poses counts as that many points.
    points = sum(len(places) for _, places in attention) + len(identified.messages)
    # Where the modes come from, and what limits their accuracy.
    files = sum(_files(result) for result in identified.records)
    names = {
        "repeatability": "the repeatability of the pose",
        "scatter": "the scatter of the repeats",
        "fit": "what the fit leaves open",
    }
    largest = [
        max(("scatter", "fit", "repeatability"), key=lambda part: getattr(mode.parts, part)) for mode in modes
    ]
    dominant = max(names, key=largest.count)
    leading = largest.count(dominant)
    share = "every mode" if leading == len(modes) else f"{leading} of {plural(len(modes), 'mode')}"
    with_messages = [result.record.pose for result in identified.records if result.messages]
    reason = (
        f"From {plural(files, 'file')}. The largest part of a frequency's standard deviation is {names[dominant]} in "
        f"{share}."
    )
    if with_messages:
        places = listed(with_messages, PLACES)
        have, its = ("has", "its section") if len(with_messages) == 1 else ("have", "their sections")
        reason += f" {places} {have} messages of the signals, in {its}."
    subject = "Structure" if campaign.model is None else shortened(campaign.model.robot.name)
    if campaign.model is not None:
        drives = [result.record.drives for result in identified.records]
        subject += f", {motors_in_words(campaign.model.robot, drives)}"
    return Summary(
        subject=subject,
        kind="Identification",
        headline=f"{count} at {poses}" + (f", {plural(points, 'point')} to check" if points else ""),
        reason=reason,
        tone="open" if notes else "good",
        notes=notes,
        facts=_facts(identified, modes),
        head=head_of(campaign.report, {} if campaign.model is None else campaign.model.robot.report),
    )


def _facts(identified: Identification, modes: Sequence[IdentifiedMode]) -> list[tuple[str, Cell]]:
    """Return how many modes there are, and how accurate they are."""
    relative = np.array([mode.sigma / mode.frequency for mode in modes])
    damped = np.array([mode.sigma_damping / mode.damping for mode in modes if mode.damping > 0.0])
    damped = damped[np.isfinite(damped)]
    at = pointer("repeatability")
    facts = [
        ("modes", Cell(str(len(modes)), len(modes))),
        (
            "median \u03c3 of a frequency",
            Cell(per_cent(float(np.median(relative))), float(np.median(relative))),
        ),
        ("largest \u03c3 of a frequency", Cell(per_cent(float(relative.max())), float(relative.max()))),
        (
            "repeatability, a part of every \u03c3",
            Cell(per_cent(identified.repeatability), identified.repeatability, at),
        ),
    ]
    if damped.size:
        middle = float(np.median(damped))
        facts.append(("median relative \u03c3 of a damping ratio", Cell(per_cent(middle), middle)))
    return facts


def _attention(identified: Identification) -> list[tuple[str, list[str]]]:
    """Return the points to check: the beginning of each sentence, and the modes or poses that it lists."""
    alike = [
        f"{result.record.pose} ({result.modes[i].frequency:.4g} and {result.modes[k].frequency:.4g} Hz)"
        for result in identified.records
        for i, k in np.argwhere(np.triu(np.nan_to_num(auto_macs(result.modes)) > ALIKE, 1))
    ]
    omitted = [result.record.pose for result in identified.records for _ in result.left_out]
    points = [
        (f"{plural(len(omitted), 'faulty file')} left out:", omitted),
        (
            "No file could be used at",
            [result.record.pose for result in identified.records if result.is_left_out],
        ),
        (
            "No mode was found at",
            [result.record.pose for result in identified.records if not (result.modes or result.is_left_out)],
        ),
        ("Added by the campaign:", _modes_with(identified, lambda mode, _: mode.edited is not None)),
        (
            "Struck out by the campaign:",
            [f"{result.record.pose} ({f:.4g} Hz)" for result in identified.records for f in result.struck],
        ),
        (
            f"Complex shapes (modal phase collinearity below {MIN_COLLINEARITY:g}):",
            _modes_with(identified, lambda mode, _: mode.complexity < MIN_COLLINEARITY),
        ),
        (
            f"Weak modes, found in fewer than {100.0 * FEW:g} % of the model orders:",
            _modes_with(
                identified,
                lambda mode, _: mode.found_in is not None and mode.found_in[0] < FEW * mode.found_in[1],
            ),
        ),
        (
            "Found in only some of the files:",
            _modes_with(identified, lambda mode, result: mode.files < _files(result)),
        ),
        (
            f"Damping known to no better than {100.0 * UNCERTAIN:g} %:",
            _modes_with(identified, lambda mode, _: mode.sigma_damping > UNCERTAIN * mode.damping),
        ),
        (f"Modes that the sensors hardly tell apart (MAC above {ALIKE:g}):", alike),
        (
            "A single file, so that the scatter of repeats is unknown:",
            [
                result.record.pose
                for result in identified.records
                if result.repeats and all(len(repeat.files) == 1 for repeat in result.repeats)
            ],
        ),
    ]
    return [(beginning, places) for beginning, places in points if places]


def _modes_with(identified: Identification, predicate: Any) -> list[str]:
    return [
        f"{result.record.pose} ({mode.frequency:.4g} Hz)"
        for result in identified.records
        for mode in result.modes
        if predicate(mode, result)
    ]


def _files(result: RecordResult) -> int:
    return sum(len(repeat.files) for repeat in result.repeats)


def _overview(identified: Identification, content: Mapping[str, Any]) -> list[Block]:
    """Return all records in a table, and their frequencies in a figure if there are several."""
    rows = []
    for i, result in enumerate(identified.records):
        last = len(result.modes) - 1
        rows.append(
            [
                Cell(shortened(result.record.pose)),
                Cell(SHOWN.get(result.record.kind, result.record.kind)),
                number(len(result.modes), ".0f"),
                _frequency(i, result, 0),
                _frequency(i, result, last),
                number(_files(result), ".0f"),
                number(len(result.left_out), ".0f"),
                number(len(content["records"][i]["messages"]), ".0f"),
                number(lowest_coherence(result), ".2f"),
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
            Picture.of(
                identified_modes.by_pose(labels, modes, struck),
                "Frequencies at each pose",
                f"{plural(len(modes), 'mode')} at {plural(len(labels), 'pose')}.",
                "Frequencies at each pose. Their standard deviations are smaller than the marks. A mode that its "
                "neighbours lack was hidden there, or is not a mode.",
            )
        )
    return [*blocks, table(caption, columns, rows)]


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
        here = [
            float(curve.coherence[int(np.argmin(np.abs(curve.frequencies - mode.frequency)))])
            for curve in curves
            if curve.coherence is not None and curve.frequencies[0] <= mode.frequency <= curve.frequencies[-1]
        ]
        known = [value for value in here if np.isfinite(value)]
        if known:
            lowest = max(known) if lowest is None else min(lowest, max(known))
    return lowest


def _frequency(index: int, result: RecordResult, k: int) -> Cell:
    """Return the frequency of a mode of a record, nothing if it has none."""
    if not result.modes:
        return number(None)
    return hertz(result.modes[k].frequency, pointer("records", index, "modes", k, "frequency"))
