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
from pkmodes.loop.diagnosis.verdict.verdicts import ADEQUATE, AMBIGUOUS, VERDICTS, Colour
from pkmodes.loop.updating.corrected_robot import corrected_robot
from pkmodes.pages.plots.evidence import PlottedEvidence
from pkmodes.pages.report import explanations, figures, numbers
from pkmodes.pages.report.action import action, doubt
from pkmodes.pages.report.beyond import beyond
from pkmodes.pages.report.blocks import Block, Cell, Difference, Paragraph, Section, Summary
from pkmodes.pages.report.contrast import contrast
from pkmodes.pages.report.damping import damping, with_other_errors
from pkmodes.pages.report.formatting import (
    clean,
    number,
    pointer,
    prose,
    read_in,
    sentence,
    shortened,
    three_digits,
    uncertain_cell,
    unit,
)
from pkmodes.pages.report.mode_table import mode_table
from pkmodes.pages.report.page import page
from pkmodes.pages.report.places import picture
from pkmodes.pages.report.sections import glossary, view_section
from pkmodes.pages.report.setting import ReportSetting
from pkmodes.pages.report.stability import stability_sentence

#: Relative change of a refitted value from which an adequate model is reported with it.
FAR = 0.2
#: Sections that are unfolded when the page opens.
OPEN = ("errors", "causes", "beyond", "place", "modes")
#: Most values listed in the header for the members of a class; those of a single cause are all listed.
MOST = 6
#: Written as `diff` writes it.
NO_END = "\\ No newline at end of file"


def diagnosis_page(result: Diagnosis, evidence: PlottedEvidence, setting: ReportSetting) -> str:
    """Return the report of a diagnosis as HTML."""
    causes = explanations.causes(result, setting)
    title = (
        "Remaining explanations" if result.survivors else "Cause" + ("s" if len(result.effects) > 1 else "")
    )
    fitted = [
        *numbers.fitted_value_tables(result, setting),
        *numbers.pulls(result, setting),
        *numbers.correlations(result),
    ]
    tried = stability_sentence(result)
    estimated: list[tuple[str, list[Cell]]] = []
    if result.scatter:
        common = number(result.scatter, ".2g", pointer("pose_scatter"), scale=100.0)
        estimated.append(("error common to the modes of a pose [%]", [common]))
    if result.shape_scatter is not None:
        scatter = number(result.shape_scatter, ".2g", pointer("shape_scatter"), scale=100.0)
        estimated.append(("estimated scatter of the shapes [%]", [scatter]))
    sections = [
        Section("errors", "Error before and after", numbers.errors(result)),
        *([Section("causes", title, causes)] if causes else []),
        *([Section("beyond", "Beyond the catalogue", terms)] if (terms := beyond(result, setting)) else []),
        *([Section("place", "Where it is", where)] if (where := picture(result, evidence, setting)) else []),
        *figures.sections(evidence),
        *([Section("damping", "Damping", ratios)] if (ratios := damping(result, setting)) else []),
        Section("candidates", "Candidates", explanations.candidate_blocks(result)),
        Section("values", "Values before and after", fitted),
        *([Section("stability", "Stability", [Paragraph(sentence(clean(tried)))])] if tried else []),
        Section("correction", "Correction", _correction(result, setting.robot)),
        *view_section(setting.view),
        Section("rows", "All measured modes", [mode_table(result, evidence, setting)]),
        glossary(diagnosed=True),
        setting.origin(evidence, estimated),
    ]
    return page(
        _summary(result, setting), [replace(section, folded=section.name not in OPEN) for section in sections]
    )


def _summary(result: Diagnosis, setting: ReportSetting) -> Summary:
    notes = [*result.notes]
    if result.damping.measured:  # which changes neither the verdict nor the headline
        doubtful = f", but {other}" if (other := with_other_errors(result.damping)) else ""
        notes.append(f"the verdict is that of frequencies and shapes; {result.damping.reason}{doubtful}")
    return Summary(
        subject=setting.title(row.drives for row in result.rows),
        kind="Diagnosis",
        verdict=result.verdict,
        headline=prose(verdict_headline(result, setting)),
        reason=prose(sentence(result.reason)),
        tone=_colour(result),
        notes=[prose(sentence(note)) for note in notes],
        action=action(result, setting),
        facts=[(name, cell) for name, cell in _facts(result, setting) if cell.value is not None],
        head=setting.head,
    )


def _colour(result: Diagnosis) -> Colour:
    """Return the colour of the heading: that of the verdict, or of doubt."""
    doubtful = doubt(result) or (
        result.verdict == ADEQUATE.word and (result.headline or [*_refitted_far(result)])
    )
    return AMBIGUOUS.colour if doubtful else VERDICTS[result.verdict].colour


def _refitted_far(result: Diagnosis) -> Iterator[tuple[str, float]]:
    """Yield the uncertain values that the fit changed by a large part, with that part."""
    for name, value in ((value.name, value) for value in result.refitted):
        if value.before and abs(change := value.after / value.before - 1.0) >= FAR:
            yield name, change


def verdict_headline(result: Diagnosis, setting: ReportSetting | None = None) -> str:
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
    if share := doubt(result):
        verdict = f"Doubtful ({share}): {verdict[0].lower()}{verdict[1:]}"
    also = [part.sentence for effect in result.effects if (part := contrast(effect, setting)) is not None]
    also += [clean(result.headline)] if result.headline else []
    if result.verdict == ADEQUATE.word:
        also += [
            f"{clean(name.removeprefix('effects.'))} was refitted by {format_signed(100.0 * change)} %"
            for name, change in _refitted_far(result)
            if name.removeprefix("effects.") not in result.headline
        ]
    return "; ".join([verdict, *also])


def _facts(result: Diagnosis, setting: ReportSetting) -> list[tuple[str, Cell]]:
    """Return the sizes of the causes, and the errors of the first and the last stage."""
    facts: list[tuple[str, Cell]] = []
    for i, effect in enumerate(result.effects):
        sizes = _class_sizes(effect, i, setting) if len(effect.members) > 1 else _sizes(result, i, setting)
        facts += sizes
    last = "after" if result.after is not None else "refit"
    stages = {"before": (result.before, "as declared")}
    stages[last] = (
        (result.after, f"with the cause{'s' if len(result.effects) > 1 else ''}")
        if result.after is not None
        else (result.refit, "refitted")
    )
    places = {name: pointer("error", name) for name in stages}
    if result.beyond is not None and (term_class := result.beyond.found) and not result.effects:
        last, name = "beyond", term_class.finding.name
        stages[last] = term_class.errors[name], "with what was found"
        members = [*term_class.finding.members]
        places[last] = pointer("beyond", "classes", 0, "members", members.index(name), "error")
    for name, (error, title) in stages.items():
        if error is not None:
            cell = numbers.percent(error.rms_relative, places[name] + pointer("rms_relative"))
            facts.append((f"rms difference {title} [%]", cell))
    error = stages[last][0]
    if error is not None:
        held = error.held_out_rms_relative
        at = places[last] + pointer("held_out_rms_relative")
        facts.append((f"rms of held-out poses {stages[last][1]} [%]", numbers.percent(held, at)))
        chi2 = three_digits(error.chi2_per_dof, places[last] + pointer("chi2_per_dof"))
        facts.append((f"chi\u00b2 per degree of freedom {stages[last][1]}", chi2))
    return facts


def _sizes(result: Diagnosis, i: int, setting: ReportSetting) -> list[tuple[str, Cell]]:
    """Return the values of a cause, with reliable standard deviations; of a single joint, only its change."""
    effect = result.effects[i]
    facts, relative = list[tuple[str, Cell]](), effect.relative()
    if effect.alone is not None:
        joint_change, at = effect.alone, pointer("effects", i, "term_change")
        cell = uncertain_cell(
            joint_change.change, joint_change.sigma, f"{at}/value", f"{at}/sigma", scale=100.0
        )
        facts.append(
            (
                f"{clean(joint_change.joint.words)} alone: change of its {clean(joint_change.joint.quantity)} [%]",
                cell,
            )
        )
        return facts
    for value in relative or effect.parameters:
        keys = ("effects", i, "relative" if relative else "parameters", parameter_key(value))
        sigma = pointer(*keys, "sigma" if relative else "saved_sigma")
        saved = with_saved_sigma(value, result.corrected)
        read, scale = read_in(value.unit, value.value)
        # The digits are those of the error beside them: that of the fit alone is in the section on the cause.
        cell = uncertain_cell(value.value, saved.sigma, pointer(*keys, "value"), sigma, scale=scale)
        name = clean(parameter_key(value))
        title = f"{name} relative to the mean" if relative else setting.words(value.name) or name
        facts.append((f"{title} [{unit(read)}]" if unit(read) else title, cell))
    return facts


def _class_sizes(effect: Finding, i: int, setting: ReportSetting) -> list[tuple[str, Cell]]:
    """Return the value of each member of a class; only the number of members if there are too many.

    Where only the ratio of two parts is known, the part that is lower is the value.
    """
    facts: list[tuple[str, Cell]] = []
    part = contrast(effect, setting)
    for name in effect.members:
        if name == effect.name and part is not None:
            at = pointer("effects", i, "relative", parameter_key(part.value))
            cell = uncertain_cell(
                part.value.value,
                part.value.sigma,
                at + pointer("value"),
                at + pointer("sigma"),
                scale=100.0,
            )
            start = "either" if not facts else "or"
            facts.append((f"{start}: {part.quantity} of {part.part} relative to the mean [%]", cell))
            continue
        start = "either" if not facts else "or"
        also = ", implausible" if effect.member(name).implausible else ""
        for value in effect.alternatives[name]:
            keys = ("effects", i, "alternatives", name, parameter_key(value))
            read, scale = read_in(value.unit, value.value)
            cell = uncertain_cell(
                value.value, value.sigma, pointer(*keys, "value"), pointer(*keys, "sigma"), scale=scale
            )
            title = setting.words(value.name) or clean(effect.member(name).words)
            of = f" [{unit(read)}]" if unit(read) else ""
            facts.append((f"{start}{also}: {title}{of}", cell))
    if len(facts) > MOST:
        return [
            ("possible causes, with their values below", Cell(str(len(effect.members)), len(effect.members)))
        ]
    return facts


def _correction(result: Diagnosis, robot: Robot | None) -> list[Block]:
    """Return the difference that ``--save-robot`` makes, which `patch` can apply, or why there is none."""
    if robot is None:
        return [Paragraph("The model is not a robot file, so there is no file to correct.")]
    if not result.settled:
        return [Paragraph(f"No correction: the verdict is {result.verdict}.")]
    try:
        after = corrected_robot(robot, result)
    except PkmodesError as error:
        return [Paragraph(f"There is no corrected robot file: {clean(error.what)}.")]
    source = Path(robot.source)
    before, name = source.read_bytes().decode("utf-8"), shortened(source.name)
    difference = difflib.unified_diff(_lines(before), _lines(after), name, name, lineterm="")
    lines = [part for line in difference for part in line.split("\n")]
    if not lines:
        return [Paragraph("The robot file needs no correction.")]
    losses = "the losses that the damping shows, " if result.damping.effects else ""
    several = [effect for effect in result.every_cause if len(effect.members) > 1]
    chosen = "".join(f" {sentence(clean(naming.choice_in_words(effect)))}" for effect in several)
    return [
        Paragraph(
            "What changes in the corrected robot file, as written by --save-robot: the cause where one was "
            f"found, {losses}and the refitted values with their new standard deviations. Comments and order "
            f"are kept.{chosen}"
        ),
        Difference("Difference of the robot file", lines),
    ]


def _lines(text: str) -> list[str]:
    """Return the lines of a text without line ends; as in `diff`, the last one states if it had none."""
    *lines, rest = text.replace("\r\n", "\n").split("\n")
    visible = [
        "\t".join(clean(part) for part in line.split("\t")) for line in [*lines, *([rest] if rest else [])]
    ]
    return [*visible[:-1], f"{visible[-1]}\n{NO_END}"] if rest else visible
