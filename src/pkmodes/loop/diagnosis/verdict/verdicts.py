"""The verdicts, one entry each, which determine exit codes, reports and the JSON schema."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING, Literal

#: Colours that a verdict may have on a page.
Colour = Literal["good", "found", "open", "bad", "plain"]


@dataclass(frozen=True)
class Verdict:
    """A verdict.

    - word: its name in results and on the command line
    - sentence: heading of a report; ``{causes}`` stands for what was found (`naming.found_in_words`), and ``{s}``
      makes a plural
    - fails: whether ``pkmodes diagnose --fail-on any`` ends with exit code 1
    - colour: colour of the heading
    - inspect, sure: what to look at, and how sure the verdict is, in the words of an owner.  ``{likely}`` stands for
      the probability of the claim in words, and ``{what}`` for the claim; where causes were found, look at these.
    - nothing_next: why no next measurement is proposed where there are no two explanations between which one could
      decide
    - settled: whether the residual of the last model is noise: its values are reported, and correct the robot file
    """

    word: str
    sentence: str
    fails: bool
    colour: Colour
    nothing_next: str
    inspect: str = "no part in particular: no cause is claimed"
    sure: str = "not sure: no cause is claimed"
    settled: bool = False


ADEQUATE = Verdict(
    "adequate",
    "The model is adequate",
    False,
    "good",
    "the residual is noise, so there are no explanations of it to separate",
    "nothing: the model explains what was measured",
    "{likely} nothing is missing that these data could show",
    settled=True,
)
EFFECT_FOUND = Verdict(
    "effect_found",
    "Cause{s} {causes}",
    True,
    "found",
    "these data distinguish what is claimed from every other candidate",
    sure="{likely} {what}",
    settled=True,
)
AMBIGUOUS = Verdict(
    "ambiguous",
    "Several explanations remain",
    True,
    "open",
    "no two of the explanations can be compared",
    sure="not sure: these data leave several explanations, and do not decide between them",
)
UNEXPLAINED = Verdict(
    "unexplained",
    "The residual is not explained",
    True,
    "bad",
    "no explanations are left between which a measurement could decide",
    "no part in particular: no cause is claimed; before the machine, check what the files say about units, "
    "directions, motors and errors",
    "not sure of any cause, so none is claimed",
)
INSUFFICIENT_DATA = Verdict(
    "insufficient_data",
    "Too few data to decide",
    True,
    "plain",
    "the data are too few to compare explanations: measure more modes, at more poses",
    "nothing yet: the data are too few to say what is wrong, if anything is",
    "not sure of anything: the data are too few",
)

#: All verdicts by their words, in the order of messages and of the schema.
VERDICTS = {
    verdict.word: verdict for verdict in (ADEQUATE, EFFECT_FOUND, AMBIGUOUS, UNEXPLAINED, INSUFFICIENT_DATA)
}

#: Statuses of terms, beyond the catalogue.
FOUND = Verdict(
    "found",
    "Not in the catalogue: {causes}",
    True,
    "found",
    "these data distinguish what is claimed from everything else that was tried",
    sure="{likely} {what}",
    settled=True,
)
SEVERAL = Verdict(
    "several", "Several places remain", True, "open", "no two of the explanations can be compared"
)
NOTHING = Verdict("none", "No single place is claimed", True, "bad", "no explanations are left to tell apart")
#: All of these by their words.
STATUSES = {status.word: status for status in (FOUND, SEVERAL, NOTHING)}

#: Word in place of a verdict on the damping where none was measured.
NOT_MEASURED = "not_measured"

if TYPE_CHECKING:
    Word = str
    DampingWord = str
    StatusWord = str
else:
    #: Types of the verdicts in a result, on damping and on terms: the enumerations of the JSON schema.
    Word = Literal[tuple(VERDICTS)]
    DampingWord = Literal[(*VERDICTS, NOT_MEASURED)]
    StatusWord = Literal[tuple(STATUSES)]
