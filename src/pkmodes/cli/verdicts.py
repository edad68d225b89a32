"""The verdicts of a diagnosis that ``--fail-on`` treats as failures."""

from __future__ import annotations

import difflib
from collections.abc import Sequence

from pkmodes.base.errors import PkmodesError, shown

VERDICTS = ("adequate", "effect_found", "ambiguous", "unexplained", "insufficient_data")
#: Stands for every verdict except adequate.
ANY = "any"


def failing(names: Sequence[str]) -> frozenset[str]:
    """Return the verdicts that the names stand for.

    Parameters
    ----------
    names : sequence of str
        Verdicts, or the word any.

    Raises
    ------
    PkmodesError
        If there is no such verdict.
    """
    found: set[str] = set()
    for name in names:
        if name not in (*VERDICTS, ANY):
            nearest = difflib.get_close_matches(name, [*VERDICTS, ANY], n=1, cutoff=0.5)
            remedy = (
                f'did you mean "{nearest[0]}"?' if nearest else f"choose from {', '.join(VERDICTS)}, {ANY}"
            )
            raise PkmodesError(f"unknown verdict {shown(name)}", "--fail-on", remedy)
        found |= set(VERDICTS) - {"adequate"} if name == ANY else {name}
    return frozenset(found)
