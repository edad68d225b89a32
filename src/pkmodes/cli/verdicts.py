"""The verdicts of a diagnosis that ``--fail-on`` treats as failures."""

from __future__ import annotations

import difflib
from collections.abc import Sequence

from pkmodes.core.base.errors import PkmodesError, shown

#: Stands for every verdict that is a failure by itself: all except adequate.
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
    from pkmodes.diagnosis.verdict.verdicts import VERDICTS  # loads SciPy

    known, failures = (*VERDICTS, ANY), set[str]()
    for name in names:
        if name not in known:
            nearest = difflib.get_close_matches(name, known, n=1, cutoff=0.5)
            remedy = f'did you mean "{nearest[0]}"?' if nearest else f"choose from {', '.join(known)}"
            raise PkmodesError(f"unknown verdict {shown(name)}", "--fail-on", remedy)
        failures |= {word for word, verdict in VERDICTS.items() if verdict.fails} if name == ANY else {name}
    return frozenset(failures)
