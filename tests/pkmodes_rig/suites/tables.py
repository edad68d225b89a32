"""Tables of the pages that the suites write."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Mapping, Sequence
from typing import Protocol, TypeVar

#: All states of an outcome, in the order of the columns; see `judging.Outcome`.
STATES = ("named", "partly", "wrong", "abstained", "adequate", "failed")


class Judged(Protocol):
    """What the tables need of an outcome."""

    @property
    def state(self) -> str:
        """One of `STATES`."""

    @property
    def classes(self) -> tuple[tuple[str, ...], ...]:
        """Classes of the causes found, or the survivors."""


J = TypeVar("J", bound=Judged)


def grouped(outcomes: Iterable[J], key: Callable[[J], str]) -> dict[str, list[J]]:
    """Group outcomes by a name, in the order of their first ones."""
    groups: dict[str, list[J]] = {}
    for outcome in outcomes:
        groups.setdefault(key(outcome), []).append(outcome)
    return groups


def confusion(groups: Mapping[str, Sequence[J]], title: str) -> list[str]:
    """Return how often each state occurred, a line a group; the title is that of the first column."""
    states = [s for s in STATES if s != "failed" or any(o.state == s for g in groups.values() for o in g)]
    counts = {
        name: [sum(o.state == state for o in group) for state in states] for name, group in groups.items()
    }
    rows = [
        [name, str(len(groups[name])), *(str(count or "") for count in each)] for name, each in counts.items()
    ]
    return table([title, "cases", *states], rows)


def table(head: Sequence[str], rows: Sequence[Sequence[str]]) -> list[str]:
    """Return the lines of a table."""
    first, *others = (f"| {' | '.join(cells)} |" for cells in (head, *rows))
    return [first, f"|{'---|' * len(head)}", *others]


def listed(head: Sequence[str], rows: Sequence[Sequence[str]]) -> list[str]:
    """Return the lines of a table, or that there is nothing to list."""
    return table(head, rows) if rows else ["None."]


def in_words(outcome: Judged) -> str:
    """Return the classes of an outcome."""
    return "; ".join(" or ".join(members) for members in outcome.classes)
