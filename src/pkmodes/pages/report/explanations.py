"""The candidates of a diagnosis: the causes found, what remains, all scores, and what the data would not show."""

from __future__ import annotations

from collections.abc import Mapping, Sequence

from pkmodes.core.support.ordering import listed
from pkmodes.loop.diagnosis.verdict import naming
from pkmodes.loop.diagnosis.verdict.findings import Corrected, Finding, explain_saved_sigma, with_saved_sigma
from pkmodes.loop.diagnosis.verdict.result import Damping, Diagnosis, parameter_key
from pkmodes.pages.plots import scores
from pkmodes.pages.report.blocks import Block, Cell, Column, Facts, Listing, Paragraph, Picture, Table
from pkmodes.pages.report.contrast import contrast_of_parts
from pkmodes.pages.report.formatting import (
    MISSING,
    clean,
    display_unit,
    explanation_with_names,
    p_value_cell,
    plural,
    pointer,
    rounded_cell,
    three_digit_cell,
    to_sentence,
    typeset_sentences,
    uncertain_cell,
    unit_text,
)
from pkmodes.pages.report.report_context import ReportContext
from pkmodes.pages.report.tables import compact_table

#: Maximum number of candidates in the table: more than any robot has.
MAX_CANDIDATES = 200
#: Members of a class named in the table of probabilities.
MAX_MEMBERS_NAMED = 3


def cause_blocks(result: Diagnosis | Damping, context: ReportContext, *json_keys: str) -> list[Block]:
    """Return the causes found with their classes, or the explanations that remain.

    - *json_keys: keys that lead to the result in the JSON: none, or that of the damping
    """
    sentences = result.sentences
    blocks: list[Block] = []
    for effect_index, effect in enumerate(result.effects):
        is_class = len(effect.members) > 1
        class_name = clean(naming.class_in_words(effect))
        entries: list[tuple[str, list[Cell]]] = [
            (
                f"One of {naming.number_in_words(len(effect.members))}" if is_class else "Cause",
                [Cell(class_name, strong=True)],
            )
        ]
        if effect.sentence or is_class:
            names = ", ".join(map(clean, effect.members))
            entries.append(("Names" if is_class else "Name", [Cell(names)]))
        if (part_contrast := contrast_of_parts(effect, context)) is not None:
            entries.append(("Which", [Cell(part_contrast.sentence)]))
        effect_pointer = pointer(*json_keys, "effects", effect_index)
        entries.append(("p-value", [p_value_cell(effect.p_value, effect_pointer + pointer("p_value"))]))
        if effect.alone is not None:
            joint_change = effect.alone
            change_pointer = effect_pointer + pointer("term_change", "value")
            sigma_pointer = effect_pointer + pointer("term_change", "sigma")
            term = f"({clean(joint_change.joint.term)})" if joint_change.joint.term else ""
            value = uncertain_cell(
                joint_change.change, joint_change.sigma, change_pointer, sigma_pointer, scale=100.0
            )
            entries.append((f"{clean(joint_change.joint.words)} alone", [value, Cell(f"% {term}".rstrip())]))
        blocks += [Facts(entries), *_relative_size_blocks(effect, effect_pointer, context)]
        blocks.append(_member_table(effect, result.corrected, effect_pointer, context, sentences))
        if not is_class:  # why its standard deviations are larger than those of the fit
            reasons = {
                value.name: explain_saved_sigma(value, result.corrected) for value in effect.parameters
            }
            blocks += [
                Paragraph(typeset_sentences(to_sentence(f"{context.meaning(name) or clean(name)}: {reason}")))
                for name, reason in reasons.items()
                if reason
            ]
        if is_class:
            blocks.append(
                Paragraph(
                    "These data cannot tell the members of this class from one another: each explains the "
                    "measurements as well, with the value in its row. The corrected robot file has the first."
                )
            )
    if result.survivors:
        blocks.append(Paragraph("These explanations remain; the data do not decide between them:"))
        blocks.append(
            Listing(
                [
                    " or ".join(explanation_with_names(name, sentences) for name in survivor_class)
                    for survivor_class in result.survivors
                ]
            )
        )
    return blocks


def _member_table(
    effect: Finding,
    corrected: Sequence[Corrected],
    effect_pointer: str,
    context: ReportContext,
    sentences: Mapping[str, str],
) -> Table:
    """Return the values of the cause, and those of each other member of its class, as if it were the cause.

    For a single cause, the reliable standard deviation is shown beside that of the fit.
    """
    is_single = len(effect.members) == 1
    rows = []
    for member in effect.members:
        implausible = effect.member(member).implausible
        for value in effect.alternatives[member]:
            value_pointer = effect_pointer + pointer("alternatives", member, parameter_key(value))
            fit_sigma_pointer = value_pointer + pointer("sigma")
            saved_sigma_pointer = effect_pointer + pointer("parameters", parameter_key(value), "saved_sigma")
            shown_value = with_saved_sigma(value, corrected) if is_single else value
            shown_unit, scale = display_unit(value.unit, value.value)
            rows.append(
                [
                    Cell.named(clean(sentences.get(member, "")), clean(member)),
                    Cell.named(context.meaning(value.name), clean(value.name)),
                    uncertain_cell(
                        value.value,
                        shown_value.sigma,
                        value_pointer + pointer("value"),
                        saved_sigma_pointer if is_single else fit_sigma_pointer,
                        scale=scale,
                        fit_sigma=shown_value.fit_sigma,
                    ),
                    *((rounded_cell(value.sigma, 2, fit_sigma_pointer, scale=scale),) if is_single else ()),
                    Cell(unit_text(shown_unit)),
                    Cell(typeset_sentences(f"no: {implausible}") if implausible else "yes"),
                ]
            )
    columns = [Column("cause", False), Column("parameter", False)]
    columns += (
        [Column("value"), Column("\u03c3 of the fit")] if is_single else [Column("value, \u03c3 of the fit")]
    )
    columns += [Column("unit", False), Column("plausible", False)]
    if is_single:  # the cause stands above
        rows, columns = [row[1:] for row in rows], columns[1:]
    if is_single and all(effect.plausible.values()):
        rows, columns = [row[:-1] for row in rows], columns[:-1]
    caption = (
        f"Size of the cause{', against the declared values' if effect.relative() else ''}; its standard deviation "
        "allows for candidates that these data do not show."
        if is_single
        else "The class: each member as if it were the cause, with its values against the declared ones."
    )
    return compact_table(caption, columns, rows)


def _relative_size_blocks(effect: Finding, effect_pointer: str, context: ReportContext) -> list[Block]:
    """Return the values relative to their mean, where the mean is far less certain."""
    rows = []
    for value in effect.relative():
        value_pointer = effect_pointer + pointer("relative", parameter_key(value))
        rows.append(
            [
                Cell.named(context.meaning(value.name), clean(value.name)),
                uncertain_cell(
                    value.value,
                    value.sigma,
                    value_pointer + pointer("value"),
                    value_pointer + pointer("sigma"),
                ),
                Cell(unit_text(value.unit)),
            ]
        )
    if not rows:
        return []
    columns = [Column("parameter", False), Column("value"), Column("unit", False)]
    caption = "Size of the cause, relative to the mean of its values. That mean is less certain."
    return [compact_table(caption, columns, rows)]


def candidate_blocks(result: Diagnosis) -> list[Block]:
    """Return all candidates with their scores, classes and smallest visible sizes."""
    if not result.candidates:
        names = [clean(name) for name in result.undetectable]
        untested_blocks: list[Block] = (
            [Paragraph("Nothing is said about"), Listing(names, in_columns=True)] if names else []
        )
        limits = [
            (clean(name), [_limit_cell(result, name), Cell(unit_text(limit.unit))])
            for name, limit in result.limits.items()
            if limit.value is not None
        ]
        if limits:
            intro = Paragraph(
                "How far a value of a candidate may be from the declared one at 95 %, if everything else is "
                "as declared within its \u03c3; nothing bounds the others within their plausible range:"
            )
            untested_blocks = [intro, Facts(limits), *untested_blocks]
        return [Paragraph("No candidate was tested."), *untested_blocks]
    figure = scores.candidate_scores(result)
    blocks: list[Block] = []
    if figure is not None:
        ranked = sorted(result.candidates, key=lambda candidate: candidate.p_value)
        name, count = clean(ranked[0].name), len(ranked)
        selection_note = (
            f" (the {scores.MAX_ROWS} most significant of {count})" if count > scores.MAX_ROWS else ""
        )
        marks_note = ""
        if not all(candidate.detectable for candidate in ranked[: scores.MAX_ROWS]):
            marks_note = " Open marks are candidates that these data cannot detect, listed below the table."
        off_axis_count = sum(map(scores.is_beyond_axis, ranked))
        if off_axis_count:
            marks_note += (
                f" The p-values of {plural(off_axis_count, 'candidate')} are too small for a number: the arrows "
                "end beyond the axis, and do not say which is longest."
            )
        blocks.append(
            Picture.from_drawing(
                figure,
                "Scores of the candidates",
                f"{plural(count, 'candidate')} by the p-value of their score; the most significant is {name}.",
                f"Scores of the candidates{selection_note}: how clearly the residual of the refitted model "
                "points at each. The score only shortlists: the choice is made by refitting, so the longest "
                f"line need not be the cause.{marks_note}",
            )
        )
    blocks += [_candidate_table(result), *_probability_tables(result)]
    if result.undetectable:
        intro = Paragraph(
            "Not detectable with these data: nothing bounds them within their plausible range, and no "
            "explanation contains them. That they were not found says nothing about them:"
        )
        blocks += [
            intro,
            Listing([explanation_with_names(name, result.sentences) for name in result.undetectable]),
        ]
    return blocks


def _probability_tables(result: Diagnosis) -> list[Block]:
    """Return how probable each explanation is, a second opinion."""
    probabilities = result.probabilities
    if probabilities is None or (result.beyond is not None and result.beyond.found and not result.effects):
        return []  # what was found beyond the catalogue has a probability of its own, beside all that was tried

    def table_row(explanation: str, value: float, *keys: str | int) -> list[Cell]:
        return [Cell(explanation), three_digit_cell(value, pointer("probabilities", *keys))]

    rows = [table_row("nothing is missing", probabilities.nothing_missing, "nothing_missing")]
    for i, explanation_class in enumerate(probabilities.classes):
        rows.append(
            table_row(
                _first_names(explanation_class.members),
                explanation_class.probability,
                "classes",
                i,
                "probability",
            )
        )
    for i, pair in enumerate(probabilities.pairs):
        names = [" + ".join(causes) for causes in pair.members]
        rows.append(table_row(_first_names(names), pair.probability, "pairs", i, "probability"))
    rows.append(table_row("something that is not among the candidates", probabilities.outside, "outside"))
    rows.sort(key=lambda cells: -(cells[1].value or 0.0))
    caption = (
        "A second opinion: how probable each explanation is, from the same fits. The verdict does not depend on "
        "it. Members of a class, which these data cannot tell apart, have one probability."
    )
    return [compact_table(caption, [Column("explanation", False), Column("probability")], rows)]


def _first_names(names: Sequence[str]) -> str:
    """Return the first names of a class, and how many more it has."""
    return listed([clean(name) for name in names], MAX_MEMBERS_NAMED, " or ", " or ")


def _candidate_table(result: Diagnosis) -> Table:
    order = sorted(range(len(result.candidates)), key=lambda index: result.candidates[index].p_value)
    rows = [row for index in order[:MAX_CANDIDATES] for row in _candidate_rows(result, index)]
    columns = [Column("candidate", False), Column("standing", False)]
    columns += [
        Column("p of its score"),
        Column("visible from"),
        Column("limit (95\u00a0%)"),
        Column("unit", False),
        Column("detectable", False),
    ]
    omitted = len(result.candidates) - MAX_CANDIDATES
    note = (
        f"{plural(omitted, 'more candidate')} with larger p-values: see --json, under candidates."
        if omitted > 0
        else ""
    )
    caption = (
        "Candidates, the most significant score first. Visible from: the smallest change that these data would "
        "probably show (5 \u03c3), of a candidate that they can detect. Limit: how far the value may still be from "
        f"the declared one at 95 %, beside what the diagnosis says; {MISSING} where nothing bounds it within its "
        "plausible range. A candidate with neither is detectable if its score is significant, or it is part of an "
        "explanation. That nothing was found is no proof that an effect is absent."
    )
    return compact_table(caption, columns, rows, note=note)


def _candidate_rows(result: Diagnosis, candidate_index: int) -> list[list[Cell]]:
    """Return a row for each parameter of a candidate: the smallest visible size, and the limit."""
    candidate, rows = result.candidates[candidate_index], []
    sizes = {value.name.removeprefix("effects."): value for value in candidate.visible_from}
    limited_names = [name for name, limit in result.limits.items() if limit.candidate == candidate.name]
    names = [*dict.fromkeys([*limited_names, *sizes])] or [""]
    for name in names:
        parameter_suffix = "" if len(names) == 1 else f".{name.removeprefix(f'{candidate.name}.')}"
        visible = sizes.get(name) if candidate.detectable else None
        limit, visible_cell = result.limits.get(name), Cell(MISSING)
        bounds = [bound for bound in (visible, limit) if bound is not None and bound.value is not None]
        shown_unit, scale = display_unit(
            bounds[0].unit if bounds else "1", *(bound.value for bound in bounds if bound.value is not None)
        )
        if visible is not None:
            size_pointer = pointer(
                "candidates", candidate_index, "visible_from", parameter_key(visible), "value"
            )
            visible_cell = rounded_cell(visible.value, 2, size_pointer, scale=scale)
        rows.append(
            [
                Cell.named(clean(candidate.sentence), clean(f"{candidate.name}{parameter_suffix}")),
                Cell(candidate_outcome(result, candidate.name)),
                p_value_cell(candidate.p_value, pointer("candidates", candidate_index, "p_value")),
                visible_cell,
                _limit_cell(result, name, scale),
                Cell(unit_text(shown_unit)),
                Cell("yes" if candidate.detectable else "no"),
            ]
        )
    return rows


def _limit_cell(result: Diagnosis, name: str, scale: float = 1.0) -> Cell:
    limit = result.limits.get(name)
    if limit is None:
        return Cell("")
    limit_pointer = pointer("limits", name) if limit.value is None else pointer("limits", name, "value")
    return rounded_cell(limit.value, 2, limit_pointer, scale=scale)


def candidate_outcome(result: Diagnosis | Damping, name: str) -> str:
    """Return the outcome for a candidate."""
    for effect in result.effects:
        if name in effect.members:
            is_class = len(effect.members) > 1
            return f"one of {naming.number_in_words(len(effect.members))}" if is_class else "found"
    for i, survivor_class in enumerate(result.survivors, start=1):
        if any(name in explanation.split(" + ") for explanation in survivor_class):
            return f"remains ({i})"
    return "not claimed"
