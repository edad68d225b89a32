"""The page of ``pkmodes compare BEFORE.csv AFTER.csv``: two measurements of a machine, such as about a repair."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace

from pkmodes.loop.measured.comparison import MeasurementsCompared
from pkmodes.pages.plots.before_after import changes_of_modes
from pkmodes.pages.report.blocks import Block, Cell, Paragraph, Picture, Section
from pkmodes.pages.report.formatting import file_name, plural, shorten, typeset_sentences
from pkmodes.pages.report.measured_shapes import shape_tables
from pkmodes.pages.report.measurements import measurements_summary, mode_pair_tables
from pkmodes.pages.report.page import need_report, page
from pkmodes.pages.report.sections import origin_section
from pkmodes.pages.report.sources import Source


def measurements_report(result: MeasurementsCompared, sources: Sequence[Source]) -> str:
    """Return the page of two measurements compared.

    - sources: the measurement files as they were read

    Returns HTML that needs no other file and no network.
    Raises MissingExtraError if the libraries of the extra ``report`` are not installed.
    """
    need_report()
    sections = [
        Section(
            "changes",
            "Before and after, mode by mode",
            [*_change_pictures(result), *mode_pair_tables(result, None)],
        )
    ]
    shapes = shape_tables(result, None)
    if shapes:
        sections.append(Section("shapes", "Mode shapes", shapes, folded=True))
    unpaired = _unpaired_blocks(result)
    if unpaired:
        sections.append(Section("alone", "Modes without a partner", unpaired))
    facts = [("pairs", [Cell(f"{plural(len(result.pairs), 'pair')} at {plural(result.poses, 'pose')}")])]
    sections.append(replace(origin_section(sources, None, facts), folded=True))
    plain_summary = measurements_summary(result)
    names = [shorten(file_name(path)) for path in (result.first, result.second)]
    summary = replace(
        plain_summary,
        subject=" and ".join(names),
        headline=typeset_sentences(plain_summary.headline),
        reason=typeset_sentences(plain_summary.reason),
        notes=[typeset_sentences(note) for note in plain_summary.notes],
    )
    return page(summary, sections)


def _change_pictures(result: MeasurementsCompared) -> list[Block]:
    """Return the change of each mode with its error; empty without a pair."""
    if not result.pairs:
        return []
    clear_count = sum(pair.differs for pair in result.pairs)
    return [
        Picture.from_drawing(
            changes_of_modes(result),
            "Change of each mode",
            f"Relative change of {plural(len(result.pairs), 'mode')}; {clear_count} by more than the errors.",
            "Change of each frequency, second over first minus 1, at the frequency of the first. Bars are one "
            "standard deviation of the difference on either side; filled marks changed by more than the errors of "
            "all modes together allow.",
        )
    ]


def _unpaired_blocks(result: MeasurementsCompared) -> list[Block]:
    """Return the lines of the modes that only one measurement has."""
    blocks: list[Block] = []
    for name, lines in ((result.first, result.first_unpaired), (result.second, result.second_unpaired)):
        if lines:
            text = ", ".join(map(str, lines))
            blocks.append(
                Paragraph(f"Only in {shorten(file_name(name))}: line{'' if len(lines) == 1 else 's'} {text}.")
            )
    return blocks
