"""What frequencies at a pose depend on, in numbers: per cent, standard deviations, derivatives per unit."""

from __future__ import annotations

from collections.abc import Sequence
from typing import TYPE_CHECKING, Any

import numpy as np

from pkmodes.core.base.numbers import format_signed, plain
from pkmodes.core.robot.report_fields import head_of
from pkmodes.core.support.motors import motors_in_words
from pkmodes.core.support.ordering import joined
from pkmodes.core.support.words import meaning_of
from pkmodes.loop.diagnosis.verdict.naming import NUMBER_WORDS
from pkmodes.loop.sensitivity.alike import TIE_FRACTION
from pkmodes.loop.sensitivity.changes import CORRELATED, Changes, coinciding
from pkmodes.loop.sensitivity.spread import stated_sigmas
from pkmodes.pages.plots.labels import MINUS
from pkmodes.pages.report.blocks import Cell, Column, Summary, Table
from pkmodes.pages.report.formatting import (
    MISSING,
    clean,
    frequency_cell,
    number_cell,
    plural,
    pointer,
    pose_in_words,
    quantity_cell,
    rounded_cell,
    shorten,
    to_sentence,
    uncertain_cell,
    unit_cell,
)

if TYPE_CHECKING:
    from pkmodes.core.model import Model

#: Note on parameters that act as one.
ACT_AS_ONE_NOTE = "Quantities in one row act as one: only their product or quotient enters the equations."
#: All modes in a headline, and the maximum number of quantities that it names.
EVERY_FREQUENCY, MAX_NAMED = "every frequency", 3
#: Columns of a table to the left of the modes.
LABEL_COLUMNS = 2
#: Derivatives below these bounds are rounding errors: relative change of the frequency per relative change of the
#: value, or per SI unit if the value is 0.
MIN_RELATIVE_RATE, MIN_RATE_PER_UNIT = 1e-9, 1e-15


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
    headline, reason = "No quantity of the robot file changes a frequency", ""
    if strongest := percent.strongest():
        headline = _headline(model, percent, strongest, chosen_only=chosen_only)
        is_tie = len(strongest) > 1 or len(strongest[0][1]) > 1
        tie_note = f"; changes within {plain(100 * TIE_FRACTION)} % of it count as alike" if is_tie else ""
        reason = f"The largest change of any frequency for one per cent of a quantity{tie_note}. "
    pose_text = pose_in_words(model.mechanism, content["pose"])
    motors, facts, rigid = motors_in_words(model.robot, content["drives"]), [], content["rigid_modes"]
    for mode, frequency in enumerate(percent.frequencies.tolist()):
        frequency_sigma = 0.0 if sigma is None or sigma.combined is None else float(sigma.combined[mode])
        frequency_pointer = pointer("frequencies_hz", rigid + mode)
        cell = (
            uncertain_cell(frequency, frequency_sigma, frequency_pointer)
            if frequency_sigma > 0.0
            else frequency_cell(frequency, frequency_pointer)
        )
        facts.append((f"mode {mode + 1} [Hz]", cell))
    return Summary(
        subject=f"{shorten(content['robot'])}, {motors}",
        kind="Sensitivities",
        headline=headline,
        reason=f"{reason}At {pose_text}, {motors}; the pose and all other quantities are held constant.",
        notes=[to_sentence(text) for text in coinciding(content["groups"], rigid, "changes")],
        facts=facts,
        head=head_of(model.robot.report),
    )


def _headline(
    model: Model, percent: Changes, strongest: list[tuple[int, list[int]]], *, chosen_only: bool
) -> str:
    """Return the quantities that change a frequency most, with the change and its sign.

    - strongest: from `Changes.strongest`
    """
    if len(strongest) == 1:
        (index, modes), *_ = strongest
        modes_text = _modes_text(percent, modes)
        verb = "depends" if len(modes) == 1 or modes_text == EVERY_FREQUENCY else "depend"
        return (
            f"{_opening(modes_text, chosen_only)} {verb} most on {_quantity_text(model, percent, index)}: "
            f"{_change_text(percent, index, modes)} of the frequency for +1 %"
        )
    clauses = [
        f"{_quantity_text(model, percent, index, with_paths=False)}, {_change_text(percent, index, modes)} of "
        f"{_modes_text(percent, modes)}"
        for index, modes in strongest[:MAX_NAMED]
    ]
    if (surplus := len(strongest) - MAX_NAMED) > 0:
        clauses.append(f"and {plural(surplus, 'other')}")
    count = NUMBER_WORDS[len(strongest)] if len(strongest) < len(NUMBER_WORDS) else str(len(strongest))
    opening = _opening(count if chosen_only else f"{count} quantities", chosen_only)
    return f"{opening} change a frequency most, and alike, for +1 % of each: {'; '.join(clauses)}"


def _opening(subject: str, chosen_only: bool) -> str:
    return f"Of the chosen quantities, {subject}" if chosen_only else subject[0].upper() + subject[1:]


def _quantity_text(model: Model, percent: Changes, index: int, *, with_paths: bool = True) -> str:
    """Return a quantity in words; several where they act as one.

    - with_paths: whether paths stand beside the words
    """
    names = []
    for path in map(clean, percent.names[index]):
        words = clean(meaning_of(model.robot.mechanism, path))
        names.append(f"the {words} ({path})" if words and with_paths else words or path)
    return " or ".join(names)


def _modes_text(percent: Changes, modes: Sequence[int]) -> str:
    """Return the numbers of modes, counted from 0, in words."""
    if len(modes) == len(percent.frequencies) > 1:
        return EVERY_FREQUENCY
    numbers = [str(mode + 1) for mode in modes]
    return f"mode{'s' if len(modes) > 1 else ''} {joined(numbers)}"


def _change_text(percent: Changes, index: int, modes: Sequence[int]) -> str:
    """Return the relative change of some frequencies for one per cent more of a quantity, with its sign."""
    changes = 100.0 * percent.changes[index, modes] / percent.frequencies[modes]
    texts = list(dict.fromkeys(format_signed(change) for change in sorted(changes.tolist(), key=abs)))
    between = " to " if (changes > 0.0).all() or (changes < 0.0).all() else " or "
    return f"{between.join(texts)} %".replace("-", MINUS)


def _label_cell(model: Model, paths: Sequence[str]) -> Cell:
    """Return the quantities of a row: in words, and their paths beneath."""
    words = [clean(meaning_of(model.robot.mechanism, path)) for path in paths]
    return Cell.named(", ".join(words) if all(words) else "", clean(", ".join(paths)))


def per_cent_table(
    model: Model, changes: Changes, content: dict[str, Any], max_rows: int | None = None
) -> Table:
    """Return what one per cent more of each quantity does to every frequency.

    - max_rows: maximum number of quantities, the first ones; None for all
    """
    order, frequencies = changes.largest_of_all(), changes.frequencies.tolist()
    rigid, paths, rows = content["rigid_modes"], content["parameters"], []
    for change_index in order[:max_rows]:
        parameter_indices = [paths.index(name) for name in changes.paths[change_index] if name in paths]
        values = [
            quantity_cell(content["values"][parameter_index], content["units"][parameter_index], 5).text
            for parameter_index in parameter_indices
        ]
        row = [_label_cell(model, changes.names[change_index]), Cell(", ".join(values) or MISSING)]
        for mode, frequency in enumerate(frequencies):
            value, derivative_pointer = float(100.0 * changes.changes[change_index, mode] / frequency), ""
            if parameter_indices:
                derivative_pointer = pointer("relative_derivatives", parameter_indices[0], rigid + mode)
                value = content["relative_derivatives"][parameter_indices[0]][rigid + mode]
            row.append(number_cell(value, "+.4f", derivative_pointer))
        rows.append(row)
    note = (
        ""
        if all(len(changes.names[change_index]) == 1 for change_index in order[:max_rows])
        else ACT_AS_ONE_NOTE
    )
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
    for change_index in changes.largest_of_all():
        (path,) = changes.names[change_index]
        symbol = model.robot.quantities[path].unit
        row = [_label_cell(model, [path]), quantity_cell(sigmas[path], symbol, 3)]
        rows.append([*row, *(number_cell(float(value), "+.3f") for value in changes.changes[change_index])])
    combined = [number_cell(float(value), ".3f", strong=True) for value in changes.combined]
    rows.append([Cell("all together", strong=True), Cell(""), *combined])
    combination = (
        CORRELATED if model.robot.covariance else "the root of the sum of squares, for independent errors"
    )
    return Table(
        "Hz for one standard deviation more of a value, and the standard deviation of each frequency.",
        _columns("quantity", "\u03c3", page_only=False, modes=len(changes.frequencies)),
        rows,
        note=f"All together: {combination}. Exact to first order: good where the standard deviations are small "
        "compared with the values.",
    )


def per_unit_table(model: Model, content: dict[str, Any]) -> Table:
    """Return the derivatives of every frequency in Hz per unit, of the quantities on which any depends."""
    rigid, rows = content["rigid_modes"], []
    influential = influential_quantities(content)
    largest = [
        max((abs(derivative or 0.0) for derivative in derivatives[rigid:]), default=0.0)
        for derivatives in content["relative_derivatives"]
    ]
    for parameter_index in sorted(influential, key=lambda index: -float(f"{largest[index]:.6g}")):
        path = content["parameters"][parameter_index]
        values = [
            number_cell(value, ".4g", pointer("frequency_derivatives", parameter_index, rigid + mode))
            for mode, value in enumerate(content["frequency_derivatives"][parameter_index][rigid:])
        ]
        value = rounded_cell(content["values"][parameter_index], 6, pointer("values", parameter_index))
        rows.append(
            [_label_cell(model, [path]), value, unit_cell(content["units"][parameter_index]), *values]
        )
    modes = len(content["frequencies_hz"]) - rigid
    columns = [Column("quantity", False), Column("value"), Column("unit", False)]
    columns += [Column(f"mode {mode + 1}") for mode in range(modes)]
    return Table("Hz per unit of the value.", columns, rows)


def influential_quantities(content: dict[str, Any]) -> list[int]:
    """Return the quantities on which a frequency depends, by more than rounding."""
    rigid, frequencies = content["rigid_modes"], np.abs(content["frequencies_hz"])
    rates = np.array(content["frequency_derivatives"], dtype=float).reshape(-1, len(frequencies))
    smallest_rates = np.array(
        [MIN_RELATIVE_RATE / abs(v) if v else MIN_RATE_PER_UNIT for v in content["values"]]
    )
    # NaN, where a frequency is 0, counts as depending.
    is_constant = np.abs(rates) <= smallest_rates[:, None] * frequencies
    return np.flatnonzero(~is_constant[:, rigid:].all(axis=1)).tolist()


def _columns(first: str, second: str, *, page_only: bool, modes: int) -> list[Column]:
    titles = [Column(first, False), Column(second, False, page_only=page_only)]
    return [*titles, *(Column(f"mode {mode + 1}") for mode in range(modes))]
