"""Directions in which terms would change the data, beside a fit."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import replace
from itertools import zip_longest

import numpy as np

from pkmodes.loop.diagnosis.fit.fitter import Fitter
from pkmodes.loop.diagnosis.fit.hypothesis import Fit
from pkmodes.loop.diagnosis.problem import Array, Candidate
from pkmodes.loop.diagnosis.search.score import LEFT


def of_starts(fitter: Fitter, plain: Fit, terms: Sequence[Candidate]) -> Iterator[tuple[Array, int]]:
    """Yield the directions of terms that have their own starts: one, that of their size, at each start.

    At size 0 the other parameters have no effect, but they determine the effect of a small size: a resonator pushes
    the modes on both sides of its frequency apart.
    """
    for starts in zip_longest(*(dict.fromkeys(start[1:] for start in term.starts) for term in terms)):
        present = [(term, fixed) for term, fixed in zip(terms, starts, strict=True) if fixed is not None]
        values = plain.values.copy()
        for term, fixed in present:
            values[list(fitter.indices(term))[1:]] = fixed
        by = [fitter.indices(term)[0] for term, _ in present]
        raw = np.nan_to_num(fitter.signatures(replace(plain, values=values), by)[1])
        remainder = raw - plain.basis @ (plain.basis.T @ raw)
        size = np.linalg.norm(remainder, axis=0)
        for k in np.flatnonzero(size > LEFT * np.linalg.norm(raw, axis=0)):
            yield remainder[:, [k]] / size[k], 1
