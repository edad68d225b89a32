"""Tables of the pages that the suites write."""

from __future__ import annotations

import statistics
from collections.abc import Callable, Iterable, Mapping, Sequence
from typing import Any, TypeVar

from studies.running import Outcome

#: All states of an outcome, in the order of the columns; see `running.Outcome`.
STATES = ("named", "partly", "wrong", "abstained", "adequate", "failed")

J = TypeVar("J", bound=Outcome[Any])


def count(outcomes: Iterable[Outcome[Any]], state: str) -> int:
    """Count the outcomes with a state."""
    return sum(o.state == state for o in outcomes)


def grouped(outcomes: Iterable[J], key: Callable[[J], str]) -> dict[str, list[J]]:
    """Group outcomes by a name, in the order of their first ones."""
    groups: dict[str, list[J]] = {}
    for outcome in outcomes:
        groups.setdefault(key(outcome), []).append(outcome)
    return groups


def confusion(groups: Mapping[str, Sequence[J]], title: str, states: Sequence[str] = STATES) -> list[str]:
    """Return how often each state occurred, a line a group; the title is that of the first column."""
    states = [s for s in states if s != "failed" or any(count(group, s) for group in groups.values())]
    rows = [
        [name, str(len(group)), *(str(count(group, state) or "") for state in states)]
        for name, group in groups.items()
    ]
    return table([title, "cases", *states], rows)


def table(head: Sequence[str], rows: Sequence[Sequence[str]]) -> list[str]:
    """Return the lines of a table."""
    first, *others = (f"| {' | '.join(cells)} |" for cells in (head, *rows))
    return [first, f"|{'---|' * len(head)}", *others]


def listed(head: Sequence[str], rows: Sequence[Sequence[str]]) -> list[str]:
    """Return the lines of a table, or that there is nothing to list."""
    return table(head, rows) if rows else ["None."]


def in_words(outcome: Outcome[Any]) -> str:
    """Return the classes of an outcome."""
    return "; ".join(" or ".join(members) for members in outcome.classes)


def times(seconds: Sequence[float]) -> str:
    """Return the median and the longest of some times."""
    return f"Median {statistics.median(seconds):.1f} s, longest {max(seconds):.1f} s"
