"""Modes as a table for notebooks."""

from __future__ import annotations

from collections.abc import Sequence
from html import escape

import numpy as np
from numpy.typing import NDArray

from pkmodes_description import Named

#: Rows of a table at most.
ROWS = 20


def table_of_modes(
    name: str,
    pose: Sequence[Named],
    poses: NDArray[np.float64],
    columns: Sequence[tuple[str, str, NDArray[np.float64]]],
    reasons: NDArray[np.str_],
) -> str:
    """Return the frequencies of vibration at each pose as an HTML table, and how many poses it leaves out.

    Parameters
    ----------
    name : str
        Of the robot.
    pose : sequence of Named
        Components of a pose.
    poses : ndarray, shape (N, d)
    columns : sequence of (str, str, ndarray of shape (N, modes))
        Symbol, unit and values of the frequencies, and of other fields of the modes.
    reasons : ndarray of str, shape (N,)
        Why a pose could not be evaluated, empty where it could.
    """
    heads = [f"{c.name} [{c.unit}]" for c in pose]
    heads += [f"{symbol}{i + 1} [{unit}]" for symbol, unit, part in columns for i in range(part.shape[1])]
    values_of = np.hstack([part for _, _, part in columns])
    rows = []
    for point, values, reason in zip(poses[:ROWS], values_of[:ROWS], reasons[:ROWS], strict=True):
        cells = [f"{value:.6g}" for value in point]
        cells += [escape(str(reason))] * len(values) if reason else [f"{value:.3f}" for value in values]
        rows.append("".join(f"<td>{cell}</td>" for cell in cells))
    head = "".join(f'<th scope="col">{escape(title)}</th>' for title in heads)
    body = "".join(f"<tr>{row}</tr>" for row in rows)
    more = f"<p>{len(poses) - ROWS:,} more poses</p>" if len(poses) > ROWS else ""
    caption = f"{escape(name)}: frequencies of vibration"
    return f"<table><caption>{caption}</caption><thead><tr>{head}</tr></thead><tbody>{body}</tbody></table>{more}"
