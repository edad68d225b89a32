"""Sections that several reports have: the glossary, the view in three dimensions, and where a report comes from."""

from __future__ import annotations

from collections.abc import Sequence

from pkmodes.core.base.version import VERSION
from pkmodes.core.mechanism.registry import Mechanism
from pkmodes.pages.report.blocks import Block, Cell, EmbeddedHtml, Facts, Paragraph, Section
from pkmodes.pages.report.formatting import clean, shorten
from pkmodes.pages.report.sources import Source
from pkmodes.pages.report.unmatched import FARTHEST, OTHER_SHAPE

#: Terms that the reader of a comparison or a diagnosis needs, as in docs/explanation/diagnosis.md.
COMPARISON_TERMS = {
    "difference": "Model minus measurement: in per cent of the measured frequency, or in \u03c3.",
    "\u03c3": "Standard deviation of the measured frequency, with the uncertainty of the pose where one is stated. "
    "Differences above 3 \u03c3 are rarely noise.",
    "rms": "Root mean square of the relative differences.",
    "chi\u00b2 per dof": "Mean square of the differences in \u03c3, per degree of freedom: near 1 for noise of the "
    "stated size. It is that of the modes with a partner; the others have no difference, and are left out.",
    "MAC": "Modal assurance criterion of a measured shape and a shape of the model, or of all that modes close to "
    "each other can form: 1 if they are the same.",
    "unmatched": "A measured mode without a partner. Each mode of the model goes with the measured mode to which it "
    f"is nearest in frequency and shape. For this one none is left within {FARTHEST} in frequency, or the one left "
    f"has {OTHER_SHAPE}, by more than the errors of the shape explain.",
}
DIAGNOSIS_TERMS = {
    "chi\u00b2 per dof": "Mean square of the differences in \u03c3, per degree of freedom, of all fitted modes and "
    "the uncertain values: near 1 for noise of the stated size. An unmatched mode counts too, since it is to be "
    f"explained: as a difference by {FARTHEST} where no mode is left, or as the difference from the nearest mode if "
    "that has another shape. A comparison leaves these modes out, so that its chi\u00b2 is smaller.",
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
