"""The candidates of a diagnosis: the causes found, what remains, all scores, and what the data would not show."""

from __future__ import annotations

from collections.abc import Mapping, Sequence

from pkmodes.core.support.ordering import listed
from pkmodes.loop.diagnosis.verdict import naming
from pkmodes.loop.diagnosis.verdict.findings import Corrected, Finding, explain_saved_sigma, with_saved_sigma
from pkmodes.loop.diagnosis.verdict.result import Damping, Diagnosis, parameter_key
from pkmodes.pages.plots import scores
from pkmodes.pages.report.blocks import Block, Cell, Column, Facts, Listing, Paragraph, Picture, Table
from pkmodes.pages.report.contrast import contrast
from pkmodes.pages.report.formatting import (
    NOTHING,
    clean,
    figures,
    named,
    p_value,
    plural,
    pointer,
    prose,
    read_in,
    sentence,
    three_digits,
    uncertain_cell,
    unit,
)
from pkmodes.pages.report.setting import ReportSetting
from pkmodes.pages.report.tables import table

#: Most candidates in the table: more than any robot has.
MOST = 200
#: Members of a class named in the table of probabilities.
SHOWN = 3


def causes(result: Diagnosis | Damping, setting: ReportSetting, *top: str) -> list[Block]:
    """Return the causes found with their classes, or the explanations that remain.

    - *top: keys that lead to the result in the JSON: none, or that of the damping
    """
    sentences = result.sentences
    blocks: list[Block] = []
    for i, effect in enumerate(result.effects):
        several = len(effect.members) > 1
        class_name = clean(naming.class_in_words(effect))
        entries: list[tuple[str, list[Cell]]] = [
            (
                f"One of {naming.number_in_words(len(effect.members))}" if several else "Cause",
                [Cell(class_name, strong=True)],
            )
        ]
        if effect.sentence or several:
            names = ", ".join(map(clean, effect.members))
            entries.append(("Names" if several else "Name", [Cell(names)]))
        if (part := contrast(effect, setting)) is not None:
            entries.append(("Which", [Cell(part.sentence)]))
        at = pointer(*top, "effects", i)
        entries.append(("p-value", [p_value(effect.p_value, at + pointer("p_value"))]))
        if effect.alone is not None:
            joint_change = effect.alone
            of, place = at + pointer("term_change", "value"), at + pointer("term_change", "sigma")
            term = f"({clean(joint_change.joint.term)})" if joint_change.joint.term else ""
            value = uncertain_cell(joint_change.change, joint_change.sigma, of, place, scale=100.0)
            entries.append((f"{clean(joint_change.joint.words)} alone", [value, Cell(f"% {term}".rstrip())]))
        blocks += [Facts(entries), *_relative(effect, at, setting)]
        blocks.append(_members(effect, result.corrected, at, setting, sentences))
        if not several:  # why its standard deviations are larger than those of the fit
            reasons = {
                value.name: explain_saved_sigma(value, result.corrected) for value in effect.parameters
            }
            blocks += [
                Paragraph(prose(sentence(f"{setting.words(name) or clean(name)}: {why}")))
                for name, why in reasons.items()
                if why
            ]
        if several:
            blocks.append(
                Paragraph(
                    "These data cannot tell the members of this class from one another: each explains the "
                    "measurements as well, with the value in its row. The corrected robot file has the first."
                )
            )
    if result.survivors:
        blocks.append(Paragraph("These explanations remain; the data do not decide between them:"))
        blocks.append(
            Listing([" or ".join(named(name, sentences) for name in group) for group in result.survivors])
        )
    return blocks


def _members(
    effect: Finding,
    corrected: Sequence[Corrected],
    place: str,
    setting: ReportSetting,
    sentences: Mapping[str, str],
) -> Table:
    """Return the values of the cause, and those of each other member of its class, as if it were the cause.

    For a single cause, the reliable standard deviation is shown beside that of the fit.
    """
    single = len(effect.members) == 1
    rows = []
    for member in effect.members:
        why = effect.member(member).implausible
        for value in effect.alternatives[member]:
            at = place + pointer("alternatives", member, parameter_key(value))
            fit, saved = (
                at + pointer("sigma"),
                place + pointer("parameters", parameter_key(value), "saved_sigma"),
            )
            shown = with_saved_sigma(value, corrected) if single else value
            read, scale = read_in(value.unit, value.value)
            rows.append(
                [
                    Cell.named(clean(sentences.get(member, "")), clean(member)),
                    Cell.named(setting.words(value.name), clean(value.name)),
                    uncertain_cell(
                        value.value,
                        shown.sigma,
                        at + pointer("value"),
                        saved if single else fit,
                        scale=scale,
                        fit=shown.fit_sigma,
                    ),
                    *((figures(value.sigma, 2, fit, scale=scale),) if single else ()),
                    Cell(unit(read)),
                    Cell(prose(f"no: {why}") if why else "yes"),
                ]
            )
    columns = [Column("cause", False), Column("parameter", False)]
    columns += (
        [Column("value"), Column("\u03c3 of the fit")] if single else [Column("value, \u03c3 of the fit")]
    )
    columns += [Column("unit", False), Column("plausible", False)]
    if single:  # the cause stands above
        rows, columns = [row[1:] for row in rows], columns[1:]
    if single and all(effect.plausible.values()):
        rows, columns = [row[:-1] for row in rows], columns[:-1]
    caption = (
        f"Size of the cause{', with that mean' if effect.relative() else ''}; its standard deviation includes what "
        "a candidate that these data do not show could have done to it."
        if single
        else "The class: each member as if it were the cause."
    )
    return table(caption, columns, rows)


def _relative(effect: Finding, place: str, setting: ReportSetting) -> list[Block]:
    """Return the values relative to their mean, where the mean is far less certain."""
    rows = []
    for value in effect.relative():
        at = place + pointer("relative", parameter_key(value))
        rows.append(
            [
                Cell.named(setting.words(value.name), clean(value.name)),
                uncertain_cell(value.value, value.sigma, at + pointer("value"), at + pointer("sigma")),
                Cell(unit(value.unit)),
            ]
        )
    if not rows:
        return []
    columns = [Column("parameter", False), Column("value"), Column("unit", False)]
    caption = "Size of the cause, relative to the mean of its values. That mean is less certain."
    return [table(caption, columns, rows)]


def candidate_blocks(result: Diagnosis) -> list[Block]:
    """Return all candidates with their scores, classes and smallest visible sizes."""
    if not result.candidates:
        names = [clean(name) for name in result.undetectable]
        about: list[Block] = [Paragraph("Nothing is said about"), Listing(names, names=True)] if names else []
        limits = [
            (clean(name), [_limit(result, name), Cell(unit(limit.unit))])
            for name, limit in result.limits.items()
            if limit.value is not None
        ]
        if limits:
            intro = Paragraph(
                "How far a value of a candidate may be from the declared one at 95 %, if everything else is as "
                "declared within its \u03c3; nothing bounds the others within their plausible range:"
            )
            about = [intro, Facts(limits), *about]
        return [Paragraph("No candidate was tested."), *about]
    figure = scores.candidate_scores(result)
    blocks: list[Block] = []
    if figure is not None:
        ranked = sorted(result.candidates, key=lambda candidate: candidate.p_value)
        name, count = clean(ranked[0].name), len(ranked)
        which = f" (the {scores.MOST} most significant of {count})" if count > scores.MOST else ""
        open_marks = ""
        if not all(candidate.detectable for candidate in ranked[: scores.MOST]):
            open_marks = " Open marks are candidates that these data cannot detect, listed below the table."
        beyond = sum(map(scores.is_beyond, ranked))
        if beyond:
            open_marks += (
                f" The p-values of {plural(beyond, 'candidate')} are too small for a number: the arrows end beyond "
                "the axis, and do not say which is longest."
            )
        blocks.append(
            Picture.of(
                figure,
                "Scores of the candidates",
                f"{plural(count, 'candidate')} by the p-value of their score; the most "
                f"significant is {name}.",
                f"Scores of the candidates{which}: how clearly the residual of the refitted model points at "
                "each. The score only shortlists: the choice is made by refitting, so the longest line need not be "
                f"the cause.{open_marks}",
            )
        )
    blocks += [_table(result), *_probabilities(result)]
    if result.undetectable:
        intro = Paragraph(
            "Not detectable with these data: nothing bounds them within their plausible range, and no explanation "
            "contains them. That they were not found says nothing about them:"
        )
        blocks += [intro, Listing([named(name, result.sentences) for name in result.undetectable])]
    return blocks


def _probabilities(result: Diagnosis) -> list[Block]:
    """Return how probable each explanation is, a second opinion."""
    probabilities = result.probabilities
    if probabilities is None or (result.beyond is not None and result.beyond.found and not result.effects):
        return []  # what was found beyond the catalogue has a probability of its own, beside all that was tried

    def row(explanation: str, value: float, *at: str | int) -> list[Cell]:
        return [Cell(explanation), three_digits(value, pointer("probabilities", *at))]

    rows = [row("nothing is missing", probabilities.nothing_missing, "nothing_missing")]
    for i, group in enumerate(probabilities.classes):
        rows.append(row(_first_names(group.members), group.probability, "classes", i, "probability"))
    for i, pair in enumerate(probabilities.pairs):
        names = [" + ".join(both) for both in pair.members]
        rows.append(row(_first_names(names), pair.probability, "pairs", i, "probability"))
    rows.append(row("something that is not among the candidates", probabilities.outside, "outside"))
    rows.sort(key=lambda cells: -(cells[1].value or 0.0))
    caption = (
        "A second opinion: how probable each explanation is, from the same fits. The verdict does not depend on it. "
        "Members of a class, which these data cannot tell apart, have one probability."
    )
    return [table(caption, [Column("explanation", False), Column("probability")], rows)]


def _first_names(names: Sequence[str]) -> str:
    """Return the first names of a class, and how many more it has."""
    return listed([clean(name) for name in names], SHOWN, " or ", " or ")


def _table(result: Diagnosis) -> Table:
    order = sorted(range(len(result.candidates)), key=lambda k: result.candidates[k].p_value)
    rows = [row for k in order[:MOST] for row in _rows(result, k)]
    columns = [Column("candidate", False), Column("standing", False)]
    columns += [
        Column("p of its score"),
        Column("visible from"),
        Column("limit (95\u00a0%)"),
        Column("unit", False),
        Column("detectable", False),
    ]
    omitted = len(result.candidates) - MOST
    note = (
        f"{plural(omitted, 'more candidate')} with larger p-values: see --json, under candidates."
        if omitted > 0
        else ""
    )
    caption = (
        "Candidates, the most significant score first. Visible from: the smallest change that these data would "
        "probably show (5 \u03c3), of a candidate that they can detect. Limit: how far the value may still be from "
        f"the declared one at 95 %, beside what the diagnosis says; {NOTHING} where nothing bounds it within its "
        "plausible range. That nothing was found is no proof that an effect is absent."
    )
    return table(caption, columns, rows, note=note)


def _rows(result: Diagnosis, k: int) -> list[list[Cell]]:
    """Return a row for each parameter of a candidate: the smallest visible size, and the limit."""
    candidate, rows = result.candidates[k], []
    sizes = {value.name.removeprefix("effects."): value for value in candidate.visible_from}
    limited = [name for name, limit in result.limits.items() if limit.candidate == candidate.name]
    names = [*dict.fromkeys([*limited, *sizes])] or [""]
    for name in names:
        parameter = "" if len(names) == 1 else f".{name.removeprefix(f'{candidate.name}.')}"
        visible = sizes.get(name) if candidate.detectable else None
        limit, size = result.limits.get(name), Cell(NOTHING)
        bounds = [value for value in (visible, limit) if value is not None and value.value is not None]
        read, scale = read_in(
            bounds[0].unit if bounds else "1", *(value.value for value in bounds if value.value is not None)
        )
        if visible is not None:
            at = pointer("candidates", k, "visible_from", parameter_key(visible), "value")
            size = figures(visible.value, 2, at, scale=scale)
        rows.append(
            [
                Cell.named(clean(candidate.sentence), clean(f"{candidate.name}{parameter}")),
                Cell(standing(result, candidate.name)),
                p_value(candidate.p_value, pointer("candidates", k, "p_value")),
                size,
                _limit(result, name, scale),
                Cell(unit(read)),
                Cell("yes" if candidate.detectable else "no"),
            ]
        )
    return rows


def _limit(result: Diagnosis, name: str, scale: float = 1.0) -> Cell:
    limit = result.limits.get(name)
    if limit is None:
        return Cell("")
    at = pointer("limits", name) if limit.value is None else pointer("limits", name, "value")
    return figures(limit.value, 2, at, scale=scale)


def standing(result: Diagnosis | Damping, name: str) -> str:
    """Return the outcome for a candidate."""
    for effect in result.effects:
        if name in effect.members:
            several = len(effect.members) > 1
            return f"one of {naming.number_in_words(len(effect.members))}" if several else "found"
    for i, group in enumerate(result.survivors, start=1):
        if any(name in explanation.split(" + ") for explanation in group):
            return f"remains ({i})"
    return "not claimed"
