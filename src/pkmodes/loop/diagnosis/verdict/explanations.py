"""The explanations between which a further measurement could decide, and how probable each is."""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from typing import NamedTuple

from pkmodes.loop.diagnosis.fit.hypothesis import Fit
from pkmodes.loop.diagnosis.fit.store import FitStore
from pkmodes.loop.diagnosis.posterior.document import NOTHING_MISSING, OUTSIDE, Probabilities

#: Largest number of explanations, the most probable ones.
MOST = 8
#: Statements less probable than this are left out unless the tests leave a member of them; the explanations that the
#: tests leave are at least this probable, relative to the most probable one.
LEAST = 0.05

#: Names of the causes of an explanation.
Causes = tuple[str, ...]
#: A class of explanations that the tests of the verdict leave, with their names.
Named = Sequence[tuple[str, Fit]]


class Explanation(NamedTuple):
    """An explanation, and its probability relative to the others."""

    name: str
    probability: float
    fit: Fit


def explanations(
    store: FitStore, probabilities: Probabilities | None, classes: Sequence[Named]
) -> list[Explanation]:
    """Return the explanations between which a measurement could decide, the most probable first.

    Members of a class share its probability equally: those that the tests leave, or else all that were fitted.
    Explanations that the tests leave but that are in no class, such as a cause in a single joint, share the
    probability of something outside.  Otherwise something outside takes no part, because it predicts nothing.

    - probabilities: None if they are unknown: the explanations that the tests leave are then equally probable
    - classes: the classes that the tests of the verdict leave, the best first
    """
    remaining = {_causes(fit): (name, fit) for group in classes for name, fit in group}
    tried = sorted((fit for fit in store.tried() if not fit.at_bound), key=store.criterion, reverse=True)
    by_causes = {_causes(fit): (" + ".join(_causes(fit)) or NOTHING_MISSING, fit) for fit in tried}
    by_causes |= remaining
    of: dict[Causes, float] = {}
    for p, members in _statements(probabilities, remaining):
        fitted = [causes for causes in members if causes in by_causes and p >= LEAST]
        supported = [causes for causes in members if causes in remaining] or fitted
        of |= dict.fromkeys(supported, p / max(len(supported), 1))
    for group in classes:
        members = [_causes(fit) for _, fit in group]
        of |= dict.fromkeys(members, sum(of[causes] for causes in members) / len(members))
    least = LEAST * max(of.values(), default=0.0) or 1.0
    results = [
        Explanation(by_causes[causes][0], max(p, least) if causes in remaining else p, by_causes[causes][1])
        for causes, p in of.items()
    ]
    return sorted(results, key=lambda explanation: -explanation.probability)[:MOST]


def _causes(fit: Fit) -> Causes:
    return tuple(sorted(cause.name for cause in fit.causes))


def _statements(
    probabilities: Probabilities | None, remaining: Iterable[Causes]
) -> list[tuple[float, list[Causes]]]:
    """Return the probabilities of all statements, each with the causes of its members."""
    stated: list[tuple[float, list[Causes]]] = [
        (
            p,
            [()]
            if subject == NOTHING_MISSING
            else [(name,) if isinstance(name, str) else name for name in subject],
        )
        for subject, p in (probabilities.statements if probabilities else ())
        if subject != OUTSIDE
    ]
    listed = {causes for _, members in stated for causes in members}
    unlisted = [causes for causes in remaining if causes not in listed]
    return [*stated, (probabilities.outside if probabilities else 1.0, unlisted)]
