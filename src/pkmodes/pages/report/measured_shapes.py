"""Where the shapes of two measurements differ, in sentences and tables."""

from __future__ import annotations

from pkmodes.core.base.numbers import plain
from pkmodes.loop.measured.comparison import MeasurementsCompared, ModePair
from pkmodes.loop.measured.shape_changes import PlaceChange
from pkmodes.loop.measured.strain_energy import most_changed
from pkmodes.loop.measured.trust import CAUTIONS_WITHOUT_PLACE
from pkmodes.pages.report.blocks import Cell, Column, Table
from pkmodes.pages.report.formatting import MISSING, number_cell, plural, pointer, shorten, three_digit_cell
from pkmodes.pages.report.tables import compact_table

#: Maximum number of modes named in sentences, and channels of each.
MAX_MODES_NAMED, MAX_CHANNELS_NAMED = 3, 2


def mode_name(pair: ModePair) -> str:
    """Return which mode a pair is, by its first frequency, as in the table."""
    return f"{pair.first:.5g} Hz at {shorten(pair.pose)}"


def sigmas_in_words(sigmas: float | None) -> str:
    """Return a number of standard deviations within a sentence."""
    size = abs(sigmas or 0.0)
    return f"{size:.{1 if size < 9.95 else 0}f} sigma"


def place_sentences(result: MeasurementsCompared) -> list[str]:
    """Return what the shapes show about the place of a change, in sentences."""
    sentences = []
    if place := most_changed(result.strain_energy):
        low, high = map(shorten, place.channels)
        is_increase = place.index > 1.0
        sentences.append(
            f"Of the strain energy at {shorten(place.pose)}, {'more' if is_increase else 'less'} is between {low} "
            f"and {high}: index {plain(place.index, 3)} ({sigmas_in_words(place.sigmas)}), as where stiffness is "
            f"{'lost' if is_increase else 'gained'} there, or a mass changed."
        )
    trusted_count, changed_shapes = 0, list[tuple[ModePair, list[PlaceChange]]]()
    for pair in result.pairs:
        if pair.shape and pair.shape.chi2 is not None and _can_locate_change(pair):
            trusted_count += 1
            clear_changes = [change for change in pair.shape.components if change.differs]
            if clear_changes:
                changed_shapes.append(
                    (pair, sorted(clear_changes, key=lambda change: -abs(change.sigmas or 0.0)))
                )
    changed_shapes.sort(key=lambda entry: -abs(entry[1][0].sigmas or 0.0))
    for pair, places in changed_shapes[:MAX_MODES_NAMED]:
        channels_text = ", ".join(
            f"{shorten(place.channel)} ({sigmas_in_words(place.sigmas)})"
            for place in places[:MAX_CHANNELS_NAMED]
        )
        sentences.append(
            f"The shape of {mode_name(pair)} differs most at {channels_text}; its MAC is {pair.mac:.3f}."
        )
    if len(changed_shapes) > MAX_MODES_NAMED:
        sentences.append(
            f"So do the shapes of {plural(len(changed_shapes) - MAX_MODES_NAMED, 'other mode')}."
        )
    if trusted_count and not sentences:
        sentences.append("No shape differs at any channel by more than its errors.")
    return sentences


def _can_locate_change(pair: ModePair) -> bool:
    """Return whether the shape of a pair can locate a change."""
    return not CAUTIONS_WITHOUT_PLACE.intersection(pair.cautions)


def shape_tables(result: MeasurementsCompared, max_rows: int | None) -> list[Table]:
    """Return the places at which shapes differ: the clearest first, up to `max_rows`, or all in order."""
    place_changes = [
        (pair_index, kind, index, place_change)
        for pair_index, pair in enumerate(result.pairs)
        if pair.shape is not None
        for kind, changes in (("components", pair.shape.components), ("curvatures", pair.shape.curvatures))
        for index, place_change in enumerate(changes)
    ]
    if max_rows is not None:
        clear_changes = [
            indexed_change
            for indexed_change in place_changes
            if indexed_change[3].differs and _can_locate_change(result.pairs[indexed_change[0]])
        ]
        omitted = max(len(clear_changes) - max_rows, 0)
        place_changes = sorted(
            clear_changes, key=lambda indexed_change: -abs(indexed_change[3].sigmas or 0.0)
        )[:max_rows]
    else:
        omitted = 0
    rows = []
    for pair_index, kind, index, place_change in place_changes:
        pair, change_pointer = result.pairs[pair_index], pointer("pairs", pair_index, "shape", kind, index)
        rows.append(
            [
                Cell(shorten(pair.pose)),
                number_cell(pair.first_line, ".0f", pointer("pairs", pair_index, "first_line")),
                Cell({"components": "shape", "curvatures": "curvature"}[kind]),
                Cell(shorten(place_change.channel)),
                number_cell(place_change.first, "+.3f", change_pointer + pointer("first")),
                number_cell(place_change.second, "+.3f", change_pointer + pointer("second")),
                number_cell(place_change.change, "+.3f", change_pointer + pointer("change")),
                three_digit_cell(place_change.sigma, change_pointer + pointer("sigma")),
                number_cell(place_change.sigmas, "+.1f", change_pointer + pointer("sigmas")),
                Cell("yes" if place_change.differs else MISSING),
            ]
        )
    tables = []
    if rows:
        columns = [Column("pose", numeric=False), Column("line"), Column("of", numeric=False)]
        columns += [Column("channel", numeric=False), Column("first"), Column("second")]
        columns += [Column("change"), Column("sigma"), Column("[\u03c3]"), Column("clear", numeric=False)]
        caption = "Changes of shapes, relative to the largest component; the second is scaled to the first."
        note = f"{plural(omitted, 'place')} less clear: --all prints every place." if omitted else ""
        tables.append(compact_table(caption, columns, rows, note=note))
    return [*tables, *_strain_energy_tables(result, max_rows)]


def _strain_energy_tables(result: MeasurementsCompared, max_rows: int | None) -> list[Table]:
    """Return the table of strain energies, if one is clear or all are requested."""
    changes = list(enumerate(result.strain_energy))
    if max_rows is not None:
        poses = {change.pose for _, change in changes if change.differs}
        changes = [(index, change) for index, change in changes if change.pose in poses]
    shown_changes = changes if max_rows is None else changes[:max_rows]
    rows = []
    for index, change in shown_changes:
        change_pointer = pointer("strain_energy", index)
        rows.append(
            [
                Cell(shorten(change.pose)),
                Cell(" \u2013 ".join(map(shorten, change.channels))),
                Cell(str(len(change.lines)), len(change.lines)),
                number_cell(change.first, ".1f", change_pointer + pointer("first"), scale=100.0),
                number_cell(change.second, ".1f", change_pointer + pointer("second"), scale=100.0),
                number_cell(change.index, ".3f", change_pointer + pointer("index")),
                three_digit_cell(change.sigma, change_pointer + pointer("sigma")),
                number_cell(change.sigmas, "+.1f", change_pointer + pointer("sigmas")),
                Cell("yes" if change.differs else MISSING),
            ]
        )
    if not rows:
        return []
    columns = [Column("pose", numeric=False), Column("between", numeric=False), Column("modes")]
    columns += [Column("first [%]"), Column("second [%]"), Column("index"), Column("sigma")]
    columns += [Column("[\u03c3]"), Column("clear", numeric=False)]
    caption = (
        "Shares of strain energy between neighbours; the damage index is above 1 where stiffness is lost."
    )
    omitted = len(changes) - len(shown_changes)
    note = f"{plural(omitted, 'place')} more: --all prints every place." if omitted else ""
    return [compact_table(caption, columns, rows, note=note)]
