"""The explanations between which a further measurement could decide, and how probable each is."""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from typing import NamedTuple

from pkmodes.loop.diagnosis.fit.hypothesis import Fit
from pkmodes.loop.diagnosis.fit.store import FitStore
from pkmodes.loop.diagnosis.posterior.document import NOTHING_MISSING, OUTSIDE, Probabilities

#: Maximum number of explanations returned, the most probable first.
MAX_EXPLANATIONS = 8
#: A statement less probable than this is left out, unless one of its members survives the tests; a surviving
#: explanation gets at least this share of the largest probability.
MIN_PROBABILITY = 0.05

#: Names of the causes of an explanation.
Causes = tuple[str, ...]
#: A class of explanations that the tests of the verdict leave, with their names.
NamedFits = Sequence[tuple[str, Fit]]


class Explanation(NamedTuple):
    """An explanation, and its probability relative to the others."""

    name: str
    probability: float
    fit: Fit


def explanations(
    store: FitStore, probabilities: Probabilities | None, classes: Sequence[NamedFits]
) -> list[Explanation]:
    """Return the explanations between which a measurement could decide, the most probable first.

    Members of a class share its probability equally: those that the tests leave, or else all that were fitted.
    Explanations that the tests leave but that are in no class, such as a cause in a single joint, share the
    probability of a cause outside the catalogue; otherwise that probability is not used, because such a cause
    predicts nothing.

    - probabilities: None if they are unknown: the explanations that the tests leave are then equally probable
    - classes: the classes that the tests of the verdict leave, the best first
    """
    surviving = {_causes(fit): (name, fit) for group in classes for name, fit in group}
    fits = sorted((fit for fit in store.all_fits() if not fit.at_bound), key=store.criterion, reverse=True)
    name_and_fit = {_causes(fit): (" + ".join(_causes(fit)) or NOTHING_MISSING, fit) for fit in fits}
    name_and_fit |= surviving
    probability_of: dict[Causes, float] = {}
    for p, members in _statements(probabilities, surviving):
        fitted = [causes for causes in members if causes in name_and_fit and p >= MIN_PROBABILITY]
        supported = [causes for causes in members if causes in surviving] or fitted
        probability_of |= dict.fromkeys(supported, p / max(len(supported), 1))
    for group in classes:
        members = [_causes(fit) for _, fit in group]
        probability_of |= dict.fromkeys(
            members, sum(probability_of[causes] for causes in members) / len(members)
        )
    floor = MIN_PROBABILITY * max(probability_of.values(), default=0.0) or 1.0
    results = [
        Explanation(
            name_and_fit[causes][0], max(p, floor) if causes in surviving else p, name_and_fit[causes][1]
        )
        for causes, p in probability_of.items()
    ]
    return sorted(results, key=lambda explanation: -explanation.probability)[:MAX_EXPLANATIONS]


def _causes(fit: Fit) -> Causes:
    return tuple(sorted(cause.name for cause in fit.causes))


def _statements(
    probabilities: Probabilities | None, surviving: Iterable[Causes]
) -> list[tuple[float, list[Causes]]]:
    """Return the probabilities of all statements, each with the causes of its members."""
    statements: list[tuple[float, list[Causes]]] = [
        (
            p,
            [()]
            if subject == NOTHING_MISSING
            else [(name,) if isinstance(name, str) else name for name in subject],
        )
        for subject, p in (probabilities.statements if probabilities else ())
        if subject != OUTSIDE
    ]
    listed = {causes for _, members in statements for causes in members}
    unlisted = [causes for causes in surviving if causes not in listed]
    return [*statements, (probabilities.outside if probabilities else 1.0, unlisted)]
