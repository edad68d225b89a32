"""Modes as a table for notebooks."""

from __future__ import annotations

from html import escape

import numpy as np

from pkmodes.core.solve.fields import FIELDS
from pkmodes.core.solve.results import Modes

#: Rows of a table at most.
ROWS = 20


def table_of_modes(modes: Modes) -> str | None:
    """Return the frequencies of vibration at each pose as an HTML table, and how many poses it leaves out.

    Parameters
    ----------
    modes : Modes

    Returns
    -------
    str or None
        None where no frequencies were requested.
    """
    requested, mechanism = modes.requested, modes.robot.mechanism
    if "frequencies" not in requested:
        return None
    columns = []
    for entry in (FIELDS[name] for name in requested):
        if entry.symbol:
            values = getattr(modes, entry.name)
            vibrations = values.reshape(-1, values.shape[-1])[:, modes.rigid_modes :]
            columns.append((entry.symbol, entry.units_of(mechanism), vibrations))
    poses, reasons = modes.poses.reshape(-1, modes.poses.shape[-1]), np.atleast_1d(modes.reason).ravel()
    heads = [f"{c.name} [{c.unit}]" for c in mechanism.pose]
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
    caption = f"{escape(modes.robot.name)}: frequencies of vibration"
    return f"<table><caption>{caption}</caption><thead><tr>{head}</tr></thead><tbody>{body}</tbody></table>{more}"
