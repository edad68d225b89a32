"""The report of ``pkmodes sensitivities``: what frequencies at a pose depend on, and how surely they are known."""

from __future__ import annotations

import math
from collections.abc import Sequence
from typing import TYPE_CHECKING, Any

import numpy as np

from pkmodes.core.mechanism.poses import placed
from pkmodes.core.robot.report_fields import head_of
from pkmodes.figures.tornado_picture import describe
from pkmodes.plots.labels import MINUS, typeset
from pkmodes.plots.tornado import PANELS, tornado
from pkmodes.report.blocks import Block, Cell, Column, Paragraph, Picture, Section, Summary, Table
from pkmodes.report.formatting import NOTHING, clean, number, pointer, sentence, unit
from pkmodes.report.page import need_report, page
from pkmodes.report.sections import origin
from pkmodes.report.sources import Source, known_sources
from pkmodes.sensitivity.changes import CORRELATED, PERCENT, SIGMA, Changes, changes_at, coinciding
from pkmodes.sensitivity.spread import stated_sigmas
from pkmodes.support.motors import motors_in_words
from pkmodes.support.numbers import hertz, plain
from pkmodes.support.words import in_words

if TYPE_CHECKING:
    from pkmodes.core.model import Model

#: Of parameters that act as one.
ONE = "Quantities in one row act as one: only their product or quotient enters the equations."
#: Modes beside each other in a table.
MODES = 6


def sensitivities_report(
    model: Model, content: dict[str, Any], sources: Sequence[Source] | None = None
) -> str:
    """Return the report of sensitivities at a pose.

    Parameters
    ----------
    model : Model
        The robot.
    content : dict
        The JSON of the command, with at least the quantities of which a per cent means something.
    sources : sequence of Source, optional
        The input files as they were read; by default the robot file as it is now.

    Returns
    -------
    str
        HTML that needs no other file and no network.

    Raises
    ------
    MissingExtraError
        If the libraries of the extra ``report`` are not installed.
    """
    need_report()
    sources = known_sources([("robot file", model.robot.source)]) if sources is None else sources
    pose, drives = content["pose"], content["drives"]
    percent = changes_at(model, pose, drives, PERCENT)
    sigma = changes_at(model, pose, drives, SIGMA) if stated_sigmas(model.robot) else None
    sections = [
        Section("percent", "One per cent of each quantity", _per_cent(model, percent, content)),
        Section("sigma", "Standard deviations of the robot file", _per_sigma(model, sigma)),
        origin(sources, model.mechanism, [("rigid-body modes", [Cell(str(content["rigid_modes"]))])]),
    ]
    return page(_summary(model, percent, sigma, content), sections)


def _summary(model: Model, percent: Changes, sigma: Changes | None, content: dict[str, Any]) -> Summary:
    relative = 100.0 * np.abs(percent.changes / percent.frequencies)
    first = percent.largest_of_all(1)
    headline, reason = "No quantity of the robot file changes a frequency", ""
    if first:
        mode = int(relative[first[0]].argmax())
        change = f"{relative[first[0], mode]:.2g}"
        name = " or ".join(_named(model, path) for path in percent.names[first[0]])
        headline = f"Mode {mode + 1} depends most on {name}: {change} % for 1 %"
        reason = "The largest change of any frequency for one per cent of a quantity. "
    at = placed(model.mechanism, np.array(content["pose"]), "g").replace("-", MINUS)
    doing, facts, rigid = motors_in_words(model.robot, content["drives"]), [], content["rigid_modes"]
    for mode, frequency in enumerate(percent.frequencies.tolist()):
        text = f"{hertz(frequency)} Hz"
        if sigma is not None and sigma.together is not None:
            text = _with_sigma(frequency, float(sigma.together[mode]))
        place = pointer("frequencies_hz", rigid + mode)
        facts.append((f"mode {mode + 1}", Cell(typeset(text), frequency, place)))
    return Summary(
        subject=clean(content["robot"]),
        kind="Sensitivities",
        headline=headline,
        reason=f"{reason}At {at}, {doing}; the pose and all other quantities are held constant.",
        notes=[sentence(text) for text in coinciding(content["groups"], rigid, "changes")],
        facts=facts,
        head=head_of(model.robot.report),
    )


def _named(model: Model, path: str) -> str:
    """Return what a quantity is within a sentence: in words, with its path."""
    words = clean(in_words(model.robot.mechanism, path))
    return f"the {words} ({clean(path)})" if words else clean(path)


def _quantity(model: Model, paths: Sequence[str]) -> Cell:
    """Return the quantities of a row: in words, and their paths beneath."""
    words = [clean(in_words(model.robot.mechanism, path)) for path in paths]
    return Cell.named(", ".join(words) if all(words) else "", clean(", ".join(paths)))


def _with_sigma(frequency: float, sigma: float) -> str:
    """Return a frequency with its standard deviation, both to two digits of the latter."""
    if not sigma > 0.0:
        return f"{hertz(frequency)} Hz"
    decimals = max(0, 1 - math.floor(math.log10(sigma)))
    return f"{frequency:.{decimals}f} \u00b1 {sigma:.{decimals}f} Hz"


def _per_cent(model: Model, changes: Changes, content: dict[str, Any]) -> list[Block]:
    order = changes.largest_of_all()
    if not order:
        return [Paragraph("No frequency depends on any quantity of the robot file.")]
    rigid, paths = content["rigid_modes"], content["parameters"]
    rows = []
    for i in order:
        known = [paths.index(name) for name in changes.paths[i] if name in paths]
        values = [f"{typeset(plain(content['values'][t], 5))} {unit(content['units'][t])}" for t in known]
        row = [
            _quantity(model, changes.names[i]),
            Cell(", ".join(value.rstrip() for value in values) or NOTHING),
        ]
        for mode, frequency in enumerate(changes.frequencies.tolist()):
            value, place = float(100.0 * changes.changes[i, mode] / frequency), ""
            if known:
                place = pointer("relative_derivatives", known[0], rigid + mode)
                value = content["relative_derivatives"][known[0]][rigid + mode]
            row.append(number(value, "+.4f", place))
        rows.append(row)
    caption = "Per cent of each frequency for one per cent more of a quantity, the largest first."
    note = "" if all(len(names) == 1 for names in changes.names) else ONE + " "
    note += (
        "Coordinates are left out, since a per cent of a coordinate depends on where the origin lies; --all and the "
        "JSON have everything."
    )
    titles = [Column("quantity", False), Column("value", False)]
    return [*_pictures(changes), *_tables(caption, titles, rows, len(changes.frequencies), note)]


def _per_sigma(model: Model, changes: Changes | None) -> list[Block]:
    if changes is None or changes.together is None:
        return [
            Paragraph(
                'The robot file states no standard deviations. Where it does, as in mass = { value = "1.5 kg", '
                'sigma = "1 %" }, this section says how surely each frequency is known.'
            )
        ]
    sigmas, rows = stated_sigmas(model.robot), []
    for i in changes.largest_of_all():
        (path,) = changes.names[i]
        quantity = model.robot.quantities[path]
        text = f"{typeset(plain(sigmas[path], 3))} {unit(quantity.unit)}".rstrip()
        row = [_quantity(model, [path]), Cell(text, sigmas[path])]
        rows.append([*row, *(number(float(value), "+.3f") for value in changes.changes[i])])
    rows.append(
        [
            Cell("all together", strong=True),
            Cell(""),
            *(number(float(value), ".3f", strong=True) for value in changes.together),
        ]
    )
    caption = "Hz for one standard deviation more of a value, and the standard deviation of each frequency."
    together = (
        CORRELATED
        if model.robot.covariance
        else "the root of the sum of squares, for values that err independently"
    )
    note = (
        f"All together: {together}. Exact to first order: good where the standard deviations are small against the "
        "values."
    )
    titles = [Column("value", False), Column("\u03c3", False)]
    return [*_pictures(changes), *_tables(caption, titles, rows, len(changes.frequencies), note)]


def _pictures(changes: Changes) -> list[Block]:
    """Return the tornado charts, in as many figures as fit pages."""
    blocks: list[Block] = []
    count, text = len(changes.frequencies), describe(changes)
    for start in range(0, count, PANELS):
        modes = range(start, min(start + PANELS, count))
        drawn = tornado(changes, modes)
        title = "Largest changes" if changes.by == PERCENT else "Largest changes by standard deviations"
        if count > PANELS:
            title += f", modes {modes[0] + 1} to {modes[-1] + 1}"
        blocks.append(Picture.of(drawn, title, text, text if not start else f"{title}."))
    return blocks


def _tables(
    caption: str, titles: Sequence[Column], rows: Sequence[Sequence[Cell]], modes: int, note: str
) -> list[Block]:
    """Return the table, in parts of several modes each where there are many."""
    blocks: list[Block] = []
    for start in range(0, modes, MODES):
        chosen = range(start, min(start + MODES, modes))
        columns = [*titles, *(Column(f"mode {mode + 1}") for mode in chosen)]
        part = [[*row[:2], *(row[2 + mode] for mode in chosen)] for row in rows]
        last = chosen[-1] == modes - 1
        blocks.append(Table(caption, columns, part, note=note if last else ""))
    return blocks
