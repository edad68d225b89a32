"""Where the shapes of two measurements differ, in sentences and tables."""

from __future__ import annotations

from pkmodes.core.base.numbers import plain
from pkmodes.loop.measured.comparison import MeasurementsCompared, ModePair
from pkmodes.loop.measured.shape_changes import PlaceChange
from pkmodes.loop.measured.strain_energy import most_changed
from pkmodes.loop.measured.trust import CAUTIONS_WITHOUT_PLACE
from pkmodes.pages.report.blocks import Cell, Column, Table
from pkmodes.pages.report.formatting import NOTHING, number, plural, pointer, shortened, three_digits
from pkmodes.pages.report.tables import table

#: Most modes named in sentences, and channels of each.
MODES, CHANNELS = 3, 2


def mode_name(pair: ModePair) -> str:
    """Return which mode a pair is, in words."""
    mode = f"mode {shortened(pair.mode)}" if pair.mode else f"{pair.first:.5g} Hz"
    return f"{mode} at {shortened(pair.pose)}"


def deviations_in_words(sigmas: float | None) -> str:
    """Return a number of standard deviations within a sentence."""
    size = abs(sigmas or 0.0)
    return f"{size:.{1 if size < 9.95 else 0}f} sigma"


def where(result: MeasurementsCompared) -> list[str]:
    """Return what the shapes show about the place of a change, in sentences."""
    sentences = []
    if place := most_changed(result.strain_energy):
        low, high = map(shortened, place.channels)
        increased = place.index > 1.0
        sentences.append(
            f"Of the strain energy at {shortened(place.pose)}, {'more' if increased else 'less'} is between {low} "
            f"and {high}: index {plain(place.index, 3)} ({deviations_in_words(place.sigmas)}), as where stiffness is "
            f"{'lost' if increased else 'gained'} there, or a mass changed."
        )
    trusted, moved = 0, list[tuple[ModePair, list[PlaceChange]]]()
    for pair in result.pairs:
        if pair.shape and pair.shape.chi2 is not None and _shows_places(pair):
            trusted += 1
            clear = [change for change in pair.shape.components if change.differs]
            if clear:
                moved.append((pair, sorted(clear, key=lambda change: -abs(change.sigmas or 0.0))))
    moved.sort(key=lambda entry: -abs(entry[1][0].sigmas or 0.0))
    for pair, places in moved[:MODES]:
        at = ", ".join(
            f"{shortened(place.channel)} ({deviations_in_words(place.sigmas)})" for place in places[:CHANNELS]
        )
        sentences.append(f"The shape of {mode_name(pair)} differs most at {at}; its MAC is {pair.mac:.3f}.")
    if len(moved) > MODES:
        sentences.append(f"So do the shapes of {plural(len(moved) - MODES, 'other mode')}.")
    if trusted and not sentences:
        sentences.append("No shape differs at any channel by more than its errors.")
    return sentences


def _shows_places(pair: ModePair) -> bool:
    """Return whether the shape of a pair can locate a change."""
    return not CAUTIONS_WITHOUT_PLACE.intersection(pair.cautions)


def shape_tables(result: MeasurementsCompared, max_rows: int | None) -> list[Table]:
    """Return the places at which shapes differ: the clearest first, up to `max_rows`, or all in order."""
    places = [
        (i, key, k, place)
        for i, pair in enumerate(result.pairs)
        if pair.shape is not None
        for key, changes in (("components", pair.shape.components), ("curvatures", pair.shape.curvatures))
        for k, place in enumerate(changes)
    ]
    if max_rows is not None:
        clear = [entry for entry in places if entry[3].differs and _shows_places(result.pairs[entry[0]])]
        omitted = max(len(clear) - max_rows, 0)
        places = sorted(clear, key=lambda entry: -abs(entry[3].sigmas or 0.0))[:max_rows]
    else:
        omitted = 0
    rows = []
    for i, key, k, place in places:
        pair, at = result.pairs[i], pointer("pairs", i, "shape", key, k)
        rows.append(
            [
                Cell(shortened(pair.pose)),
                number(pair.first_line, ".0f", pointer("pairs", i, "first_line")),
                Cell({"components": "shape", "curvatures": "curvature"}[key]),
                Cell(shortened(place.channel)),
                number(place.first, "+.3f", at + pointer("first")),
                number(place.second, "+.3f", at + pointer("second")),
                number(place.change, "+.3f", at + pointer("change")),
                three_digits(place.sigma, at + pointer("sigma")),
                number(place.sigmas, "+.1f", at + pointer("sigmas")),
                Cell("yes" if place.differs else NOTHING),
            ]
        )
    tables = []
    if rows:
        columns = [Column("pose", numbers=False), Column("line"), Column("of", numbers=False)]
        columns += [Column("channel", numbers=False), Column("first"), Column("second")]
        columns += [Column("change"), Column("sigma"), Column("[\u03c3]"), Column("clear", numbers=False)]
        caption = "Changes of shapes, relative to the largest component; the second is scaled to the first."
        note = f"{plural(omitted, 'place')} less clear: --all prints every place." if omitted else ""
        tables.append(table(caption, columns, rows, note=note))
    return [*tables, *_strain_energy(result, max_rows)]


def _strain_energy(result: MeasurementsCompared, max_rows: int | None) -> list[Table]:
    """Return the table of strain energies, if one is clear or all are requested."""
    changes = list(enumerate(result.strain_energy))
    if max_rows is not None:
        poses = {change.pose for _, change in changes if change.differs}
        changes = [(k, change) for k, change in changes if change.pose in poses]
    shown = changes if max_rows is None else changes[:max_rows]
    rows = []
    for k, change in shown:
        at = pointer("strain_energy", k)
        rows.append(
            [
                Cell(shortened(change.pose)),
                Cell(" \u2013 ".join(map(shortened, change.channels))),
                Cell(str(len(change.lines)), len(change.lines)),
                number(change.first, ".1f", at + pointer("first"), scale=100.0),
                number(change.second, ".1f", at + pointer("second"), scale=100.0),
                number(change.index, ".3f", at + pointer("index")),
                three_digits(change.sigma, at + pointer("sigma")),
                number(change.sigmas, "+.1f", at + pointer("sigmas")),
                Cell("yes" if change.differs else NOTHING),
            ]
        )
    if not rows:
        return []
    columns = [Column("pose", numbers=False), Column("between", numbers=False), Column("modes")]
    columns += [Column("first [%]"), Column("second [%]"), Column("index"), Column("sigma")]
    columns += [Column("[\u03c3]"), Column("clear", numbers=False)]
    caption = (
        "Shares of strain energy between neighbours; the damage index is above 1 where stiffness is lost."
    )
    omitted = len(changes) - len(shown)
    note = f"{plural(omitted, 'place')} more: --all prints every place." if omitted else ""
    return [table(caption, columns, rows, note=note)]
