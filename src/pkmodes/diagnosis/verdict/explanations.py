"""The explanations between which a further measurement could decide, and how probable each is."""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from typing import NamedTuple

from pkmodes.diagnosis.fit.hypothesis import Fit
from pkmodes.diagnosis.fit.store import FitStore
from pkmodes.diagnosis.posterior.document import NOTHING_MISSING, OUTSIDE, Probabilities

#: Largest number of explanations: the most probable ones.
MOST = 8
#: Statements less probable than this are left out where the tests leave nothing of them; what these leave is at least
#: this probable, relative to the most probable.
LEAST = 0.05

#: Names of the causes of an explanation.
Causes = tuple[str, ...]
#: A class of explanations that the tests of the verdict leave, with their names.
Named = Sequence[tuple[str, Fit]]


class Explanation(NamedTuple):
    """An explanation, and how probable it is beside the others."""

    name: str
    probability: float
    fit: Fit


def explanations(store: FitStore, said: Probabilities | None, left: Sequence[Named]) -> list[Explanation]:
    """Return the explanations between which a measurement could decide, the most probable first.

    Members of a class have equal parts of its probability: those that the tests leave, or else all that were fitted.
    What the tests leave that is in no class, such as a cause in a single joint, shares the probability of something
    outside.  Otherwise something outside takes no part, because it predicts nothing.

    Parameters
    ----------
    said : Probabilities or None
        None if they are not known: what the tests leave is then equally probable.
    left : sequence of sequence of (str, Fit)
        The classes that the tests of the verdict leave, the best first.
    """
    remaining = {_causes(fit): (name, fit) for some in left for name, fit in some}
    tried = sorted((fit for fit in store.tried() if not fit.at_bound), key=store.criterion, reverse=True)
    known = {_causes(fit): (" + ".join(_causes(fit)) or NOTHING_MISSING, fit) for fit in tried} | remaining
    of: dict[Causes, float] = {}
    for p, members in _statements(said, remaining):
        fitted = [one for one in members if one in known and p >= LEAST]
        some = [one for one in members if one in remaining] or fitted
        of |= dict.fromkeys(some, p / max(len(some), 1))
    for group in left:
        members = [_causes(fit) for _, fit in group]
        of |= dict.fromkeys(members, sum(of[one] for one in members) / len(members))
    least = LEAST * max(of.values(), default=0.0) or 1.0
    every = [
        Explanation(known[one][0], max(p, least) if one in remaining else p, known[one][1])
        for one, p in of.items()
    ]
    return sorted(every, key=lambda one: -one.probability)[:MOST]


def _causes(fit: Fit) -> Causes:
    return tuple(sorted(cause.name for cause in fit.causes))


def _statements(said: Probabilities | None, remaining: Iterable[Causes]) -> list[tuple[float, list[Causes]]]:
    """Return the probabilities of all statements, each with the causes of its members."""
    stated: list[tuple[float, list[Causes]]] = [
        (p, [()] if what == NOTHING_MISSING else [(one,) if isinstance(one, str) else one for one in what])
        for what, p in (said.statements if said else ())
        if what != OUTSIDE
    ]
    listed = {one for _, members in stated for one in members}
    return [*stated, (said.outside if said else 1.0, [one for one in remaining if one not in listed])]
