"""The report of a diagnosis, with the correction of the robot as a difference of its file."""

from __future__ import annotations

import difflib
from collections.abc import Iterator
from dataclasses import replace
from pathlib import Path

from pkmodes.core.base.errors import PkmodesError
from pkmodes.core.base.numbers import format_signed
from pkmodes.core.robot.robot import Robot
from pkmodes.loop.diagnosis.verdict import naming
from pkmodes.loop.diagnosis.verdict.findings import Finding, with_saved_sigma
from pkmodes.loop.diagnosis.verdict.result import Diagnosis, parameter_key
from pkmodes.loop.diagnosis.verdict.terms import TermClass
from pkmodes.loop.diagnosis.verdict.verdicts import ADEQUATE, AMBIGUOUS, VERDICTS, Colour
from pkmodes.loop.updating.corrected_robot import corrected_robot
from pkmodes.loop.updating.saved_term import is_declared, term_to_save
from pkmodes.pages.plots.evidence import WITH_TERM, PlottedEvidence
from pkmodes.pages.report import explanations, figures, numbers
from pkmodes.pages.report.action import recommended_action
from pkmodes.pages.report.beyond import beyond_blocks
from pkmodes.pages.report.blocks import Block, Cell, Paragraph, Section, Summary, TextDifference
from pkmodes.pages.report.certainty import claim_condition, doubtful_probability, is_claim_in_doubt
from pkmodes.pages.report.contrast import contrast_of_parts
from pkmodes.pages.report.damping import damping_blocks, stability_clause
from pkmodes.pages.report.formatting import (
    clean,
    display_unit,
    number_cell,
    pointer,
    shorten,
    three_digit_cell,
    to_sentence,
    typeset_sentences,
    uncertain_cell,
    unit_text,
)
from pkmodes.pages.report.mode_table import mode_table
from pkmodes.pages.report.page import page
from pkmodes.pages.report.places import place_pictures
from pkmodes.pages.report.report_context import ReportContext
from pkmodes.pages.report.sections import glossary_section, view_section
from pkmodes.pages.report.stability import stability_sentence

#: Relative change of a refitted value from which an adequate model is reported with it.
MIN_REPORTED_CHANGE = 0.2
#: Sections that are unfolded when the page opens.
UNFOLDED_SECTIONS = ("errors", "causes", "beyond", "place", "modes")
#: Maximum number of values listed in the header for the members of a class; those of a single cause are all listed.
MAX_CLASS_VALUES = 6
#: The note of `diff` on a file without a final newline.
NO_FINAL_NEWLINE = "\\ No newline at end of file"


def diagnosis_page(
    result: Diagnosis, evidence: PlottedEvidence, context: ReportContext, measured_responses: list[Block]
) -> str:
    """Return the report of a diagnosis as HTML.

    - measured_responses: pictures of measured frequency responses, if there are any
    """
    causes = explanations.cause_blocks(result, context)
    title = (
        "Remaining explanations" if result.survivors else "Cause" + ("s" if len(result.effects) > 1 else "")
    )
    value_blocks = [
        *numbers.fitted_value_tables(result, context),
        *numbers.pull_pictures(result, context),
        *numbers.correlation_pictures(result),
    ]
    stability = stability_sentence(result)
    scatter_facts: list[tuple[str, list[Cell]]] = []
    if result.scatter:
        scatter_cell = number_cell(result.scatter, ".2g", pointer("pose_scatter"), scale=100.0)
        scatter_facts.append(("error common to the modes of a pose [%]", [scatter_cell]))
    if result.shape_scatter is not None:
        shape_scatter_cell = number_cell(result.shape_scatter, ".2g", pointer("shape_scatter"), scale=100.0)
        scatter_facts.append(("estimated scatter of the shapes [%]", [shape_scatter_cell]))
    sections = [
        Section("errors", "Error before and after", numbers.error_blocks(result)),
        *([Section("causes", title, causes)] if causes else []),
        *(
            [Section("beyond", "Beyond the catalogue", term_blocks)]
            if (term_blocks := beyond_blocks(result, context))
            else []
        ),
        *(
            [Section("place", "Where it is", place_blocks)]
            if (place_blocks := place_pictures(result, evidence, context))
            else []
        ),
        *figures.figure_sections(evidence),
        *([Section("responses", "Frequency responses", measured_responses)] if measured_responses else []),
        *(
            [Section("damping", "Damping", ratio_blocks)]
            if (ratio_blocks := damping_blocks(result, context))
            else []
        ),
        Section("candidates", "Candidates", explanations.candidate_blocks(result)),
        Section("values", "Values before and after", value_blocks),
        *(
            [Section("stability", "Stability", [Paragraph(to_sentence(clean(stability)))])]
            if stability
            else []
        ),
        Section("correction", "Correction", _correction_blocks(result, context.robot)),
        *view_section(context.view),
        Section("rows", "All measured modes", [mode_table(result, evidence, context)]),
        glossary_section(is_diagnosis=True),
        context.origin(evidence, scatter_facts),
    ]
    return page(
        _summary(result, context),
        [replace(section, folded=section.html_id not in UNFOLDED_SECTIONS) for section in sections],
    )


def _summary(result: Diagnosis, context: ReportContext) -> Summary:
    notes = [*result.notes]
    if result.damping.measured:  # which changes neither the verdict nor the headline
        doubt = f", but {clause}" if (clause := stability_clause(result.damping)) else ""
        notes.append(f"the verdict is that of frequencies and shapes; {result.damping.reason}{doubt}")
    return Summary(
        subject=context.title(row.drives for row in result.rows),
        kind="Diagnosis",
        verdict=result.verdict,
        headline=typeset_sentences(verdict_headline(result, context)),
        reason=typeset_sentences(to_sentence(result.reason)),
        tone=_colour(result),
        notes=[typeset_sentences(to_sentence(note)) for note in notes],
        action=recommended_action(result, context),
        facts=[(name, cell) for name, cell in _header_facts(result, context) if cell.value is not None],
        head=context.head,
    )


def _colour(result: Diagnosis) -> Colour:
    """Return the colour of the heading: that of the verdict, or of doubt."""
    is_doubtful = is_claim_in_doubt(result) or (
        result.verdict == ADEQUATE.word and (result.headline or [*_large_refits(result)])
    )
    return AMBIGUOUS.colour if is_doubtful else VERDICTS[result.verdict].colour


def _large_refits(result: Diagnosis) -> Iterator[tuple[str, float]]:
    """Yield the uncertain values that the fit changed most, with their relative changes."""
    for name, value in ((value.name, value) for value in result.refitted):
        if value.before and abs(change := value.after / value.before - 1.0) >= MIN_REPORTED_CHANGE:
            yield name, change


def verdict_headline(result: Diagnosis, context: ReportContext | None = None) -> str:
    """Return the verdict as a sentence, with its doubt, the causes and what matters of the refitted values."""
    if (
        result.beyond is not None
        and not result.effects
        and (words := result.beyond.words(naming.MAX_CLASS_LENGTH))
    ):
        return clean(words)
    causes = clean(naming.found_in_words(result.effects, naming.MAX_CLASS_LENGTH)) if result.effects else ""
    verdict = VERDICTS[result.verdict].sentence.format(
        causes=causes, s="s" if len(result.effects) > 1 else ""
    )
    probability = doubtful_probability(result)
    if probability:
        verdict = f"Doubtful ({probability}): {verdict[0].lower()}{verdict[1:]}"
    additions = [
        part_contrast.sentence
        for effect in result.effects
        if (part_contrast := contrast_of_parts(effect, context)) is not None
    ]
    if not probability and (clause := claim_condition(result)):
        additions.append(clause)
    additions += [clean(result.headline)] if result.headline else []
    if result.verdict == ADEQUATE.word:
        additions += [
            f"{clean(name.removeprefix('effects.'))} was refitted by {format_signed(100.0 * change)} %"
            for name, change in _large_refits(result)
            if name.removeprefix("effects.") not in result.headline
        ]
    return "; ".join([verdict, *additions])


def _header_facts(result: Diagnosis, context: ReportContext) -> list[tuple[str, Cell]]:
    """Return the sizes of the causes, and the errors of the first and the last stage."""
    facts: list[tuple[str, Cell]] = []
    for i, effect in enumerate(result.effects):
        is_class = len(effect.members) > 1
        facts += _class_sizes(effect, i, context) if is_class else _cause_sizes(result, i, context)
    last_stage = "after" if result.after is not None else "refit"
    stages = {"before": (result.before, "as declared")}
    stages[last_stage] = (
        (result.after, f"with the cause{'s' if len(result.effects) > 1 else ''}")
        if result.after is not None
        else (result.refit, "refitted")
    )
    error_pointers = {name: pointer("error", name) for name in stages}
    if (found := numbers.error_with_term(result)) is not None:
        last_stage, error_pointers["beyond"] = "beyond", found[1]
        stages[last_stage] = found[0], WITH_TERM
    for name, (error, title) in stages.items():
        if error is not None:
            cell = numbers.percent_cell(error.rms_relative, error_pointers[name] + pointer("rms_relative"))
            facts.append((f"rms difference {title} [%]", cell))
    error = stages[last_stage][0]
    if error is not None:
        held_out_pointer = error_pointers[last_stage] + pointer("held_out_rms_relative")
        held_out_cell = numbers.percent_cell(error.held_out_rms_relative, held_out_pointer)
        facts.append((f"rms of held-out poses {stages[last_stage][1]} [%]", held_out_cell))
        chi2 = three_digit_cell(error.chi2_per_dof, error_pointers[last_stage] + pointer("chi2_per_dof"))
        fitted = sum(not (row.held_out or row.outlier) for row in result.rows)
        whose = f"all {fitted} fitted modes, {stages[last_stage][1]}"
        facts.append((f"chi\u00b2 per degree of freedom of {whose}", chi2))
    return facts


def _cause_sizes(result: Diagnosis, effect_index: int, context: ReportContext) -> list[tuple[str, Cell]]:
    """Return the values of a cause, with reliable standard deviations; of a single joint, only its change."""
    effect = result.effects[effect_index]
    facts, relative = list[tuple[str, Cell]](), effect.relative()
    if effect.alone is not None:
        joint_change, change_pointer = effect.alone, pointer("effects", effect_index, "term_change")
        cell = uncertain_cell(
            joint_change.change,
            joint_change.sigma,
            f"{change_pointer}/value",
            f"{change_pointer}/sigma",
            scale=100.0,
        )
        facts.append(
            (
                f"{clean(joint_change.joint.words)} alone: change of its {clean(joint_change.joint.quantity)} [%]",
                cell,
            )
        )
        return facts
    for value in relative or effect.parameters:
        keys = ("effects", effect_index, "relative" if relative else "parameters", parameter_key(value))
        sigma_pointer = pointer(*keys, "sigma" if relative else "saved_sigma")
        saved = with_saved_sigma(value, result.corrected)
        shown_unit, scale = display_unit(value.unit, value.value)
        # The digits are those of the error beside them: that of the fit alone is in the section on the cause.
        cell = uncertain_cell(value.value, saved.sigma, pointer(*keys, "value"), sigma_pointer, scale=scale)
        name = clean(parameter_key(value))
        title = f"{name} relative to the mean" if relative else context.meaning(value.name) or name
        facts.append((f"{title} [{unit_text(shown_unit)}]" if unit_text(shown_unit) else title, cell))
    return facts


def _class_sizes(effect: Finding, effect_index: int, context: ReportContext) -> list[tuple[str, Cell]]:
    """Return the value of each member of a class; only the number of members if there are too many.

    Where only the ratio of two parts is known, the part that is lower is the value.
    """
    facts: list[tuple[str, Cell]] = []
    part_contrast = contrast_of_parts(effect, context)
    for name in effect.members:
        if name == effect.name and part_contrast is not None:
            value_pointer = pointer("effects", effect_index, "relative", parameter_key(part_contrast.value))
            cell = uncertain_cell(
                part_contrast.value.value,
                part_contrast.value.sigma,
                value_pointer + pointer("value"),
                value_pointer + pointer("sigma"),
                scale=100.0,
            )
            conjunction = "either" if not facts else "or"
            facts.append(
                (
                    f"{conjunction}: {part_contrast.quantity} of {part_contrast.part} relative to the mean [%]",
                    cell,
                )
            )
            continue
        conjunction = "either" if not facts else "or"
        implausible_note = ", implausible" if effect.member(name).implausible else ""
        for value in effect.alternatives[name]:
            keys = ("effects", effect_index, "alternatives", name, parameter_key(value))
            shown_unit, scale = display_unit(value.unit, value.value)
            cell = uncertain_cell(
                value.value, value.sigma, pointer(*keys, "value"), pointer(*keys, "sigma"), scale=scale
            )
            title = context.meaning(value.name) or clean(effect.member(name).words)
            unit_suffix = f" [{unit_text(shown_unit)}]" if unit_text(shown_unit) else ""
            facts.append((f"{conjunction}{implausible_note}: {title}{unit_suffix}", cell))
    if len(facts) > MAX_CLASS_VALUES:
        return [
            ("possible causes, with their values below", Cell(str(len(effect.members)), len(effect.members)))
        ]
    return facts


def _correction_blocks(result: Diagnosis, robot: Robot | None) -> list[Block]:
    """Return what ``--save-robot`` changes in the file, as a difference for `patch`, or why there is none."""
    if robot is None:
        return [Paragraph("The model is not a robot file, so there is no file to correct.")]
    term = term_to_save(result)
    if not result.settled and term is None:
        return [Paragraph(f"No correction: the verdict is {result.verdict}.")]
    try:
        after = corrected_robot(robot, result)
    except PkmodesError as error:
        return [Paragraph(f"There is no corrected robot file: {clean(error.what)}.")]
    source = Path(robot.source)
    before, name = source.read_bytes().decode("utf-8"), shorten(source.name)
    difference = difflib.unified_diff(_diff_lines(before), _diff_lines(after), name, name, lineterm="")
    lines = [part for line in difference for part in line.split("\n")]
    if not lines:
        return [Paragraph("The robot file needs no correction.")]
    losses = "the losses that the damping shows, " if result.damping.effects else ""
    classes = [effect for effect in result.every_cause if len(effect.members) > 1]
    choice_notes = "".join(f" {to_sentence(clean(naming.choice_in_words(effect)))}" for effect in classes)
    return [
        Paragraph(
            "What changes in the corrected robot file, as written by --save-robot: the cause where one was "
            f"found, {losses}and the refitted values with their new standard deviations. Comments and order "
            f"are kept.{choice_notes}{_note_on_generating(term)}"
        ),
        TextDifference("Difference of the robot file", lines),
    ]


def _note_on_generating(term: TermClass | None) -> str:
    """Return how the code is generated that reads a file with a term; empty where the file needs no new code."""
    if term is None or is_declared(term):
        return ""
    return (
        " Its effect is not in the catalogue, so that only a mechanism generated with it reads this file: write the "
        "effect with --save-effect FILE.py, run pkmodes generate ROBOT.toml --effect FILE.py --out DIR, and give the "
        "commands --mechanism DIR/<mechanism>."
    )


def _diff_lines(text: str) -> list[str]:
    """Return the lines of a text without line ends; as in `diff`, a note follows if the last one had none."""
    *lines, unended_line = text.replace("\r\n", "\n").split("\n")
    visible = [
        "\t".join(clean(part) for part in line.split("\t"))
        for line in [*lines, *([unended_line] if unended_line else [])]
    ]
    return [*visible[:-1], f"{visible[-1]}\n{NO_FINAL_NEWLINE}"] if unended_line else visible
