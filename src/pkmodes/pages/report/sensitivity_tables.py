"""What frequencies at a pose depend on, in numbers: per cent, standard deviations, derivatives per unit."""

from __future__ import annotations

from collections.abc import Sequence
from typing import TYPE_CHECKING, Any

import numpy as np

from pkmodes.core.base.numbers import plain
from pkmodes.core.mechanism.poses import format_pose
from pkmodes.core.robot.report_fields import head_of
from pkmodes.core.support.motors import motors_in_words
from pkmodes.core.support.words import meaning_of
from pkmodes.loop.sensitivity.changes import CORRELATED, Changes, coinciding
from pkmodes.loop.sensitivity.spread import stated_sigmas
from pkmodes.pages.plots.labels import MINUS
from pkmodes.pages.report.blocks import Cell, Column, Summary, Table
from pkmodes.pages.report.formatting import (
    NOTHING,
    clean,
    figures,
    hertz,
    number,
    plural,
    pointer,
    quantity_cell,
    sentence,
    shortened,
    uncertain_cell,
    unit_cell,
)

if TYPE_CHECKING:
    from pkmodes.core.model import Model

#: Note on parameters that act as one.
ONE = "Quantities in one row act as one: only their product or quotient enters the equations."
#: Largest relative difference of changes that are equal in a headline.
ALIKE = 1e-3
#: Columns of a table to the left of the modes.
NAMED = 2
#: Derivatives below these bounds are rounding errors: relative change of the frequency per relative change of the
#: value, or per SI unit if the value is 0.
ROUNDING, ROUNDING_BY_UNIT = 1e-9, 1e-15


def sensitivities_summary(
    model: Model,
    percent: Changes,
    sigma: Changes | None,
    content: dict[str, Any],
    *,
    chosen_only: bool = False,
) -> Summary:
    """Return what the frequencies depend on most, and their standard deviations.

    - chosen_only: whether the changes are those of chosen quantities only
    """
    relative = 100.0 * np.abs(percent.changes / percent.frequencies)
    first = percent.largest_of_all(1)
    headline, reason = "No quantity of the robot file changes a frequency", ""
    if first:
        mode = int(relative[first[0]].argmax())
        change = plain(relative[first[0], mode], 2)
        names = []
        for path in map(clean, percent.names[first[0]]):
            words = clean(meaning_of(model.robot.mechanism, path))
            names.append(f"the {words} ({path})" if words else path)
        which = f"Of the chosen quantities, mode {mode + 1}" if chosen_only else f"Mode {mode + 1}"
        largest = relative.max(axis=1)
        alike = int((largest >= (1.0 - ALIKE) * largest[first[0]]).sum()) - 1
        others = (
            f"; {plural(alike, 'other')} change{'s' if alike == 1 else ''} a frequency as much"
            if alike
            else ""
        )
        headline = f"{which} depends most on {' or '.join(names)}: {change} % for 1 %{others}"
        reason = "The largest change of any frequency for one per cent of a quantity. "
    at = format_pose(model.mechanism, np.array(content["pose"]), "g").replace("-", MINUS)
    doing, facts, rigid = motors_in_words(model.robot, content["drives"]), [], content["rigid_modes"]
    for mode, frequency in enumerate(percent.frequencies.tolist()):
        error = 0.0 if sigma is None or sigma.combined is None else float(sigma.combined[mode])
        place = pointer("frequencies_hz", rigid + mode)
        cell = uncertain_cell(frequency, error, place) if error > 0.0 else hertz(frequency, place)
        facts.append((f"mode {mode + 1} [Hz]", cell))
    return Summary(
        subject=f"{shortened(content['robot'])}, {doing}",
        kind="Sensitivities",
        headline=headline,
        reason=f"{reason}At {at}, {doing}; the pose and all other quantities are held constant.",
        notes=[sentence(text) for text in coinciding(content["groups"], rigid, "changes")],
        facts=facts,
        head=head_of(model.robot.report),
    )


def _quantity(model: Model, paths: Sequence[str]) -> Cell:
    """Return the quantities of a row: in words, and their paths beneath."""
    words = [clean(meaning_of(model.robot.mechanism, path)) for path in paths]
    return Cell.named(", ".join(words) if all(words) else "", clean(", ".join(paths)))


def per_cent_table(
    model: Model, changes: Changes, content: dict[str, Any], max_rows: int | None = None
) -> Table:
    """Return what one per cent more of each quantity does to every frequency.

    - max_rows: most quantities, the first; None for all
    """
    order, frequencies = changes.largest_of_all(), changes.frequencies.tolist()
    rigid, paths, rows = content["rigid_modes"], content["parameters"], []
    for i in order[:max_rows]:
        indices = [paths.index(name) for name in changes.paths[i] if name in paths]
        values = [quantity_cell(content["values"][t], content["units"][t], 5).text for t in indices]
        row = [_quantity(model, changes.names[i]), Cell(", ".join(values) or NOTHING)]
        for mode, frequency in enumerate(frequencies):
            value, place = float(100.0 * changes.changes[i, mode] / frequency), ""
            if indices:
                place = pointer("relative_derivatives", indices[0], rigid + mode)
                value = content["relative_derivatives"][indices[0]][rigid + mode]
            row.append(number(value, "+.4f", place))
        rows.append(row)
    note = "" if all(len(changes.names[i]) == 1 for i in order[:max_rows]) else ONE
    if max_rows is not None and len(order) > max_rows:
        note = f"{note} The {max_rows} largest of {len(order)}, by their largest change in any mode.".strip()
    caption = "Per cent of each frequency for one per cent more of a quantity, the largest first."
    return Table(
        caption, _columns("quantity", "value", page_only=True, modes=len(frequencies)), rows, note=note
    )


def per_sigma_table(model: Model, changes: Changes) -> Table:
    """Return what one standard deviation more of each value does to every frequency, and all of them together."""
    assert changes.combined is not None
    sigmas, rows = stated_sigmas(model.robot), []
    for i in changes.largest_of_all():
        (path,) = changes.names[i]
        symbol = model.robot.quantities[path].unit
        row = [_quantity(model, [path]), quantity_cell(sigmas[path], symbol, 3)]
        rows.append([*row, *(number(float(value), "+.3f") for value in changes.changes[i])])
    combined = [number(float(value), ".3f", strong=True) for value in changes.combined]
    rows.append([Cell("all together", strong=True), Cell(""), *combined])
    how = CORRELATED if model.robot.covariance else "the root of the sum of squares, for independent errors"
    return Table(
        "Hz for one standard deviation more of a value, and the standard deviation of each frequency.",
        _columns("quantity", "\u03c3", page_only=False, modes=len(changes.frequencies)),
        rows,
        note=f"All together: {how}. Exact to first order: good where the standard deviations are small compared with "
        "the values.",
    )


def per_unit_table(model: Model, content: dict[str, Any]) -> Table:
    """Return the derivatives of every frequency in Hz per unit, of the quantities on which any depends."""
    rigid, rows = content["rigid_modes"], []
    influential = influential_quantities(content)
    largest = [
        max((abs(derivative or 0.0) for derivative in line[rigid:]), default=0.0)
        for line in content["relative_derivatives"]
    ]
    for t in sorted(influential, key=lambda t: -float(f"{largest[t]:.6g}")):
        path = content["parameters"][t]
        values = [
            number(value, ".4g", pointer("frequency_derivatives", t, rigid + mode))
            for mode, value in enumerate(content["frequency_derivatives"][t][rigid:])
        ]
        value = figures(content["values"][t], 6, pointer("values", t))
        rows.append([_quantity(model, [path]), value, unit_cell(content["units"][t]), *values])
    modes = len(content["frequencies_hz"]) - rigid
    columns = [Column("quantity", False), Column("value"), Column("unit", False)]
    columns += [Column(f"mode {mode + 1}") for mode in range(modes)]
    return Table("Hz per unit of the value.", columns, rows)


def influential_quantities(content: dict[str, Any]) -> list[int]:
    """Return the quantities on which a frequency depends, by more than rounding."""
    rigid, frequencies = content["rigid_modes"], np.abs(content["frequencies_hz"])
    rates = np.array(content["frequency_derivatives"], dtype=float).reshape(-1, len(frequencies))
    floor = np.array([ROUNDING / abs(v) if v else ROUNDING_BY_UNIT for v in content["values"]])
    # NaN, where a frequency is 0, counts as depending.
    still = np.abs(rates) <= floor[:, None] * frequencies
    return np.flatnonzero(~still[:, rigid:].all(axis=1)).tolist()


def _columns(first: str, second: str, *, page_only: bool, modes: int) -> list[Column]:
    titles = [Column(first, False), Column(second, False, page_only=page_only)]
    return [*titles, *(Column(f"mode {mode + 1}") for mode in range(modes))]
