"""Sections that several reports have: the glossary, the view in three dimensions, and where a report comes from."""

from __future__ import annotations

from collections.abc import Sequence

from pkmodes.core.base.version import VERSION
from pkmodes.core.mechanism.registry import Mechanism
from pkmodes.pages.report.blocks import Block, Cell, EmbeddedHtml, Facts, Paragraph, Section
from pkmodes.pages.report.formatting import clean, shorten
from pkmodes.pages.report.sources import Source

#: Terms that the reader of a comparison or a diagnosis needs, as in docs/explanation/diagnosis.md.
COMPARISON_TERMS = {
    "difference": "Model minus measurement: in per cent of the measured frequency, or in \u03c3.",
    "\u03c3": "Standard deviation of the measured frequency, with the uncertainty of the pose where one is stated. "
    "Differences above 3 \u03c3 are rarely noise.",
    "rms": "Root mean square of the relative differences.",
    "chi\u00b2 per dof": "Mean square of the differences in \u03c3, per degree of freedom: near 1 for noise of the "
    "stated size.",
    "MAC": "Modal assurance criterion of a measured shape and a shape of the model: 1 if they are the same.",
    "unmatched": "A measured mode for which the model has no mode left within a factor of 1.8 in frequency.",
}
DIAGNOSIS_TERMS = {
    "uncertain value": "Declared with a standard deviation, its prior, and refitted within it in every fit.",
    "candidate": "Something the model may lack or have wrong. A cause is a candidate that was found.",
    "class": "Candidates that these data cannot tell apart. A claim never goes beyond its class.",
    "held out": "A pose that took no part in any choice or fit: its error is that of a prediction.",
    "set aside": "A measured mode that contradicts all others and was left out of the fit.",
    "p-value": "How likely noise alone is to look like this: the smaller, the stronger the evidence.",
}


def origin_section(
    sources: Sequence[Source],
    mechanism: Mechanism | None,
    further_facts: Sequence[tuple[str, Sequence[Cell]]] = (),
    version: str = VERSION,
) -> Section:
    """Return the last section of a report: its input files with their digests, and the version that made the numbers.

    - mechanism: of the robot; None where the report does not name it
    """
    facts: list[tuple[str, Sequence[Cell]]] = []
    for source in sources:
        facts.append((source.role, [Cell(shorten(source.name))]))
        facts.append((f"SHA-256 of the {source.role}", [Cell(source.digest)]))
    if mechanism is not None:
        facts.append(("mechanism", [Cell(clean(mechanism.title))]))
    facts += [*further_facts, ("pkmodes", [Cell(version)])]
    return Section("origin", "Data and versions", [Facts(facts)])


def view_section(view: str | None, robot: str = "") -> list[Section]:
    """Return the section of the view in three dimensions, which is made elsewhere; none without it.

    - robot: which robot it shows, where the page is about several
    """
    if view is None:
        return []
    blocks: list[Block] = [
        Paragraph(
            f"The machine in its modes{f': {robot}' if robot else ''}. It moves on a screen; a printed page has a "
            "still picture."
        ),
        EmbeddedHtml(view),
    ]
    return [Section("view", "In three dimensions", blocks)]


def glossary_section(is_diagnosis: bool) -> Section:
    """Return the section that explains the words of a comparison or a diagnosis."""
    terms = COMPARISON_TERMS | (DIAGNOSIS_TERMS if is_diagnosis else {})
    entries = [(word, [Cell(meaning)]) for word, meaning in terms.items()]
    return Section("words", "Glossary", [Facts(entries)])
