"""The wording of a change: a diagnosis is about a declared model, a change about two states."""

from __future__ import annotations

import re
from dataclasses import replace
from typing import TypeVar

from pkmodes.core.base.numbers import plain, round_to_sigma
from pkmodes.loop.diagnosis.problem import Candidate
from pkmodes.loop.diagnosis.verdict.findings import Finding
from pkmodes.loop.diagnosis.verdict.result import Diagnosis

BY_MORE, AS_BEFORE = "by more than the errors of both", "a machine as in {trusted}"
#: Phrases about a declared model, with those about a trusted and a later state that replace them, in this order.
PHRASES = (
    ("the residual of the declared model is not noise", f"{{later}} differs from {{trusted}} {BY_MORE}"),
    ("the residual of the declared model is noise", f"{{later}} does not differ from {{trusted}} {BY_MORE}"),
    (
        "the residual is noise once the uncertain values are refitted",
        "{later} differs from {trusted} only by what two days may differ by",
    ),
    (", not as declared (", ", not without ("),
    ("the declared model explains the residual", f"{AS_BEFORE} explains the difference"),
    ("the declared model with its uncertain values", AS_BEFORE),
    ("the declared model and its uncertain values", AS_BEFORE),
    ("the declared model", AS_BEFORE),
    ("the cause is narrowed to", "the change is narrowed to"),
    ("the residual", "the difference"),
    ("a residual", "a difference"),
    ("its declared value", "its value in {trusted}"),
    ("the declared one", "that in {trusted}"),
    ("agree with the model", "agree with {trusted}"),
    ("the stated errors", "the errors of both"),
    ("the stated ones", "those of both"),
    ("these data cannot show causes below their limits", "a change below its limit would not be seen"),
    ("nothing is missing", "nothing changed"),
    ("the model explains what was measured", "{later} is as {trusted} within the errors of both"),
    ("The model with its uncertain values refitted", "A machine as in {trusted}, on another day,"),
    ("The model as declared", "A machine as in {trusted}"),
    (
        "before the machine, check what the files say about units, directions, motors and errors",
        "before the machine, check whether both were measured in the same way",
    ),
    ("measure or look it up again", "look for what changed it"),
    ("this is the cause", "this changed"),
    ("without the cause", "without the change"),
    ("one of these is the cause", "one of these changed"),
    ("these are the causes", "these changed"),
    ("no cause is claimed", "no change is claimed"),
    ("not sure of any cause", "not sure of any change"),
    ("tried where the catalogue does not explain the measurements", "tried"),
    ("Not in the catalogue: ", ""),
    ("explains the measurements", "explains the difference"),
)
#: Difference of the stiffness of all equal parts, as from one day to another, in a sentence on refitted values.
ANOTHER_DAY = re.compile(
    r"day\.(\w+)_stiffness (?:was refitted )?from 0 to (-?[\d.e-]+)(?: \+- ([\d.e-]+))?"
    r"(?: \([+-][\d.]+ sigma(?:; [^()]+ would have the same effect)?\))?"
)
#: Sentences of candidates that are declared values.
WRONG_VALUE = re.compile(r"the declared ([^;,()]+?) is wrong")
DIFFERING_VALUE = re.compile(r"the value of (\S+) differs from that of the other axes")
OTHER_VALUE = re.compile(r"another value of ([\w.]*\w)")


def as_change(sentence: str) -> str:
    """Return the sentence of a cause as one of a change."""
    sentence = WRONG_VALUE.sub(r"the \1 changed", sentence)
    sentence = DIFFERING_VALUE.sub(r"the value of \1 changed", sentence)
    return OTHER_VALUE.sub(r"the value of \1 changed", sentence)


def candidate_as_change(candidate: Candidate) -> Candidate:
    """Return a candidate whose sentence describes a change."""
    return replace(candidate, sentence=as_change(candidate.sentence))


def reword(text: str, trusted: str, later: str) -> str:
    """Return a text about a declared model and its residual, reworded for a trusted state and a later one."""
    for phrase, replacement in PHRASES:
        text = text.replace(phrase, replacement.format(trusted=trusted, later=later))
    return as_change(ANOTHER_DAY.sub(_another_day_in_words, text))


def _another_day_in_words(match: re.Match[str]) -> str:
    """Return by how much all equal parts are stiffer or softer, as after a change of temperature."""
    part_name, percent = match[1].replace("_", " "), 100.0 * float(match[2])
    size = (
        plain(abs(percent), 2) if match[3] is None else round_to_sigma(abs(percent), 100.0 * float(match[3]))
    )
    return f"all {part_name}s are {size} % {'stiffer' if percent > 0.0 else 'softer'}"


Result = TypeVar("Result", bound=Diagnosis)


def reword_result(result: Result, trusted: str, later: str) -> Result:
    """Return a result in the words of a change."""

    def reworded(text: str) -> str:
        return reword(text, trusted, later)

    beyond = result.beyond
    if beyond is not None:
        classes = tuple(
            replace(term_class, finding=_reword_finding(term_class.finding)) for term_class in beyond.classes
        )
        beyond = replace(beyond, reason=reworded(beyond.reason), classes=classes)
    reason = result.reason
    if beyond is not None and beyond.found is not None and not result.effects:
        reason = beyond.reason  # the catalogue and the terms were tested alike
    return replace(
        result,
        reason=reworded(reason),
        headline=reworded(result.headline),
        notes=tuple(map(reworded, result.notes)),
        not_separated=reworded(result.not_separated),
        effects=tuple(map(_reword_finding, result.effects)),
        candidates=tuple(
            replace(candidate, sentence=as_change(candidate.sentence)) for candidate in result.candidates
        ),
        beyond=beyond,
    )


def _reword_finding(effect: Finding) -> Finding:
    members = {
        name: replace(member, sentence=as_change(member.sentence)) for name, member in effect.about.items()
    }
    return replace(effect, sentence=as_change(effect.sentence), about=members)
