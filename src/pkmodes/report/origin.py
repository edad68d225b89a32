"""Sections that several reports have: the view in three dimensions, and which data and version it all comes from."""

from __future__ import annotations

from collections.abc import Sequence

from pkmodes.core.base.version import VERSION
from pkmodes.core.mechanism.registry import Mechanism
from pkmodes.report.blocks import Block, Cell, Facts, Foreign, Paragraph, Section
from pkmodes.report.formatting import clean
from pkmodes.report.sources import Source


def origin(
    sources: Sequence[Source],
    mechanism: Mechanism | None,
    more: Sequence[tuple[str, Sequence[Cell]]] = (),
    version: str = VERSION,
) -> Section:
    """Return the last section of a report: its input files with their digests, and the version that made the numbers.

    Parameters
    ----------
    mechanism : Mechanism or None
        Of the robot; None where the report does not name it.
    more : sequence of (str, sequence of Cell)
        Further facts.
    """
    facts: list[tuple[str, Sequence[Cell]]] = []
    for source in sources:
        facts.append((source.role, [Cell(clean(source.name))]))
        facts.append((f"SHA-256 of the {source.role}", [Cell(source.digest)]))
    if mechanism is not None:
        facts.append(("mechanism", [Cell(clean(mechanism.title))]))
    facts += [*more, ("pkmodes", [Cell(version)])]
    return Section("origin", "Data and versions", [Facts(facts)])


def view_section(view: str | None) -> list[Section]:
    """Return the section of the view in three dimensions, which is made elsewhere; none without it."""
    if view is None:
        return []
    blocks: list[Block] = [
        Paragraph("The machine in its modes: it moves on screen, and a still of it is printed."),
        Foreign(view),
    ]
    return [Section("view", "In three dimensions", blocks)]
