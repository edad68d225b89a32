"""The last section of a report: which data and which version it comes from."""

from __future__ import annotations

from collections.abc import Sequence

from pkmodes.core.base.version import VERSION
from pkmodes.plots.evidence import Evidence
from pkmodes.report.blocks import Block, Cell, Facts, Foreign, Paragraph, Section
from pkmodes.report.formatting import clean, plural
from pkmodes.report.setting import Setting
from pkmodes.report.sources import Source


def origin(evidence: Evidence, setting: Setting, more: Sequence[tuple[str, Sequence[Cell]]] = ()) -> Section:
    """Return data and versions.

    Parameters
    ----------
    more : sequence of (str, sequence of Cell)
        Further facts.
    """
    entries = files_of(setting.sources)
    if setting.robot is not None:
        entries.append(("mechanism", [Cell(clean(setting.robot.mechanism.title))]))
    rows = (
        f"{plural(len(evidence.measured), 'measured mode')} at {plural(len(evidence.labels), evidence.place)}"
    )
    entries.append(("measurements", [Cell(rows)]))
    if setting.data is not None and setting.data.band is not None:
        low, high = setting.data.band
        entries.append(("band", [Cell(f"{low:g} Hz to {high:g} Hz")]))
    entries += more
    entries.append(("pkmodes", [Cell(VERSION)]))
    return Section("origin", "Data and versions", [Facts(entries)])


def files_of(sources: Sequence[Source]) -> list[tuple[str, Sequence[Cell]]]:
    """Return the facts about the input files: names and digests."""
    facts: list[tuple[str, Sequence[Cell]]] = []
    for source in sources:
        facts.append((source.role, [Cell(clean(source.name))]))
        facts.append((f"SHA-256 of the {source.role}", [Cell(source.digest)]))
    return facts


def view_section(view: str | None) -> list[Section]:
    """Return the section of the view in three dimensions, which is made elsewhere; none without it."""
    if view is None:
        return []
    blocks: list[Block] = [
        Paragraph("The machine in its modes: it moves on screen, and a still of it is printed."),
        Foreign(view),
    ]
    return [Section("view", "In three dimensions", blocks)]
