"""The numbers of a diagnosis: errors of the stages, values before and after, stability, the next measurement."""

from __future__ import annotations

from pkmodes.diagnosis.verdict.findings import Corrected
from pkmodes.diagnosis.verdict.result import Diagnosis, key
from pkmodes.diagnosis.verdict.stability_words import DOUBLED, HALVED, WIDENED, meaning, same
from pkmodes.plots import scores
from pkmodes.report.blocks import Block, Cell, Column, Facts, Paragraph, Picture, Table
from pkmodes.report.formatting import (
    NOTHING,
    clean,
    figures,
    named,
    number,
    plural,
    pointer,
    three_digits,
    uncertain,
    unit,
)
from pkmodes.report.setting import Setting
from pkmodes.report.tables import table
from pkmodes.support.ordering import listed, sorted_labels

CHANGES = {HALVED: "\u03c3 halved", DOUBLED: "\u03c3 doubled", WIDENED: "priors twice as wide"}
SAME = "no change"


def errors(result: Diagnosis) -> list[Block]:
    """Return the errors of the stages, over fitted and held-out rows."""
    stages, rows = result.errors, []
    for name, (title, error) in stages.items():
        at, strong = ("error", name), name == [*stages][-1]
        held = error.held_out_rms_relative
        rows.append(
            [
                Cell(title, strong=strong),
                percent(error.rms_relative, pointer(*at, "rms_relative"), strong),
                percent(held, pointer(*at, "held_out_rms_relative"), strong),
                three_digits(error.chi2_per_dof, pointer(*at, "chi2_per_dof"), strong=strong),
            ]
        )
    columns = [Column("model", False), Column("rms, fitted [%]"), Column("rms, held out [%]")]
    columns.append(Column("chi\u00b2 per dof"))
    if not result.held_out_poses:
        rows, columns = [[*row[:2], row[3]] for row in rows], [*columns[:2], columns[3]]
    caption = "Errors of the model: rms of model / measurement \u2212 1, and chi\u00b2 per degree of freedom."
    blocks: list[Block] = [Table(caption, columns, rows)]
    if result.held_out_poses:
        poses = listed([clean(label) for label in sorted_labels(result.held_out_poses)], 20)
        blocks.append(
            Paragraph(
                f"Held out, so that no choice and no fit has seen them: {poses}. The error there is that "
                "of a prediction."
            )
        )
    return blocks


def percent(relative: float | None, at: str = "", strong: bool = False) -> Cell:
    """Return a relative error in per cent."""
    form = ".3f" if relative is None or abs(relative) < 0.1 else ".1f"
    return number(relative, form, at, scale=100.0, strong=strong)


def values(result: Diagnosis, setting: Setting) -> list[Block]:
    """Return the fitted values, with what was declared about them."""
    of_losses = {value.name for value in result.damping.refitted}  # the damping says more of them
    corrected = [value for value in result.corrected if value.name not in of_losses]
    if not corrected:
        return [Paragraph("No value was uncertain, and none was fitted.")]
    rows = [_value(result, value, setting) for value in corrected]
    columns = [Column("value", False), Column("role", False), Column("before")]
    columns += [
        Column("after"),
        Column("\u03c3 of the fit"),
        Column("unit", False),
        Column("prior \u03c3"),
        Column("moved [prior\u00a0\u03c3]"),
    ]
    caption = (
        "Fitted values: as declared, and after the fit with the standard deviations of the corrected robot file, "
        "which include what a candidate that these data do not show could have done to the value; beside them those "
        "of the fit alone."
    )
    blocks: list[Block] = [table(caption, columns, rows)]
    figure = scores.pulls(corrected, setting.words)
    if figure is not None:
        count = plural(sum(v.prior_sigma is not None for v in corrected), "value")
        blocks.append(
            Picture.of(
                figure,
                "Movement of the uncertain values",
                f"{count} with a prior, and how far each moved.",
                "How far the fit moved each uncertain value, in standard deviations of its prior. Beyond 3 the "
                "declared value or its sigma is wrong, or the value makes up for a cause; a bar as wide as the "
                "shaded prior means that the data say nothing about it.",
            )
        )
    return blocks


def _value(result: Diagnosis, value: Corrected, setting: Setting) -> list[Cell]:
    """Return a row; its numbers are in the JSON under refitted, or with the cause."""
    before, after, sigma, saved = "", "", "", ""
    role = "fitted"
    if any(refitted.name == value.name for refitted in result.refitted):
        role = "uncertain"
        before, after, sigma, saved = (
            pointer("refitted", value.name, name) for name in ("before", "after", "sigma", "saved_sigma")
        )
    for i, effect in enumerate(result.effects):
        if any(own.name == value.name for own in effect.parameters):
            role = "cause"
            at = ("effects", i, "parameters", key(value))
            after, sigma, saved = (pointer(*at, name) for name in ("value", "sigma", "saved_sigma"))
    prior = value.prior_sigma
    return [
        Cell.named(setting.words(value.name), clean(value.name)),
        Cell(f"{role}, at a bound" if value.at_bound else role),
        figures(value.declared, 6, before),
        uncertain(value.value, value.saved_sigma, after, saved),
        figures(value.sigma, 2, sigma),
        Cell(unit(value.unit)),
        figures(prior, 2),
        number((value.value - value.declared) / prior if prior else None, "+.1f"),
    ]


def stability(result: Diagnosis) -> list[Block]:
    """Return what the verdict becomes with other errors or priors."""
    if not result.stability:
        return []
    if all(same(result, s) for s in result.stability):
        *first, last = (f"with {CHANGES.get(s.change, s.change)}" for s in result.stability)
        changes = " and ".join([", ".join(first), last] if first else [last])
        kept = "The verdict and its causes stay" if result.effects else "The verdict stays"
        return [Paragraph(f"{kept} the same {changes}.")]
    sentences = {one.name: one.sentence for one in result.candidates}
    rows = [
        [
            Cell(CHANGES.get(s.change, s.change)),
            Cell(s.verdict),
            Cell(" + ".join(named(name, sentences) for name in s.effects) or NOTHING),
            Cell(SAME if same(result, s) else meaning(result, s) or NOTHING),
        ]
        for s in result.stability
    ]
    columns = [Column("change", False), Column("verdict", False), Column("best explanation", False)]
    columns.append(Column("why it differs", False))
    caption = "The explanations tried, fitted again with other errors and priors."
    return [table(caption, columns, rows)]


def next_measurement(result: Diagnosis, setting: Setting) -> list[Block]:
    """Return where two remaining explanations differ most; nothing if nothing is left to separate."""
    proposed = result.next_measurement
    if proposed is None:
        return [Paragraph(f"None is proposed: {clean(result.next_measurement_reason)}.")]
    at = "next_measurement"
    entries: list[tuple[str, list[Cell]]] = [
        (f"{name} [{unit(symbol)}]" if unit(symbol) else name, [number(value, ".4f", pointer(at, "pose", k))])
        for k, ((name, symbol), value) in enumerate(
            zip(setting.components(len(proposed.pose)), proposed.pose, strict=True)
        )
    ]
    if proposed.drives:
        entries.append(("motors", [Cell(proposed.drives)]))
    if proposed.load:
        entries.append(("set", [Cell(setting.load(proposed.load))]))
    one, other = map(clean, proposed.separates)
    entries.append(("separates", [Cell(f"{one} and {other}")]))
    sigmas = number(proposed.sigmas, ".0f", pointer(at, "sigmas"))
    entries.append(("by", [sigmas, Cell("standard deviations")]))
    caveat = [Paragraph(f"{proposed.caveat}.")] if proposed.caveat else []
    return [
        Paragraph("Measure next here, where two remaining explanations differ most:"),
        Facts(entries),
        *caveat,
    ]
