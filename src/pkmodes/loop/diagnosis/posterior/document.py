"""The probabilities of a result: plain data, and their keys in the JSON."""

from __future__ import annotations

from typing import Annotated

from msgspec import Meta

from pkmodes.core.support.documents import Document, Probability

#: Statements that name no candidate.
NOTHING_MISSING, OUTSIDE = "nothing_missing", "outside"
#: What a probability is of: ``nothing_missing``, ``outside``, members of a class, or pairs.
Statement = str | tuple[str, ...] | tuple[tuple[str, str], ...]


class ClassProbability(Document, frozen=True):
    """The probability that the model lacks a member of a class, and nothing else that the data show."""

    members: Annotated[
        tuple[str, ...],
        Meta(
            description="Candidates that the data cannot tell apart, the most probable first.", min_length=1
        ),
    ]
    probability: Probability


class PairProbability(Document, frozen=True):
    """The probability that the model lacks both causes of a pair, and that the data show both."""

    members: Annotated[
        tuple[tuple[str, str], ...],
        Meta(description="Pairs that the data cannot tell apart, the most probable first.", min_length=1),
    ]
    probability: Probability


class Probabilities(Document, frozen=True):
    """How probable each explanation is; together 1.  No verdict depends on them."""

    nothing_missing: Annotated[Probability, Meta(description="Of the model as declared.")]
    outside: Annotated[
        Probability,
        Meta(description="Of something that is not among the candidates, or only in a single joint."),
    ]
    classes: Annotated[
        tuple[ClassProbability, ...], Meta(description="Of one cause, by class, the most probable first.")
    ]
    pairs: Annotated[tuple[PairProbability, ...], Meta(description="Of two causes, the most probable first.")]

    @property
    def statements(self) -> list[tuple[Statement, float]]:
        """All statements with their probabilities."""
        return [
            (NOTHING_MISSING, self.nothing_missing),
            (OUTSIDE, self.outside),
            *((group.members, group.probability) for group in self.classes),
            *((pair.members, pair.probability) for pair in self.pairs),
        ]

    @property
    def top(self) -> tuple[Statement, float]:
        """The most probable statement: ``nothing_missing``, ``outside``, or members; and its probability."""
        return max(self.statements, key=lambda statement: statement[1])
