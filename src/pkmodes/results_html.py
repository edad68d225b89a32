"""Modes as a table for notebooks."""

from __future__ import annotations

from html import escape
from typing import TYPE_CHECKING

import numpy as np

if TYPE_CHECKING:
    from pkmodes.results import Modes

#: Rows of a table at most.
ROWS = 20


def table_of_modes(modes: Modes) -> str:
    """Return the frequencies of vibration at each pose as an HTML table, and how many poses it leaves out.

    Parameters
    ----------
    modes : Modes
    """
    kind, rigid = modes.robot.kind, modes.rigid_modes
    frequencies = modes.frequencies.reshape(-1, modes.frequencies.shape[-1])[:, rigid:]
    poses = modes.poses.reshape(-1, modes.poses.shape[-1])
    reasons = np.atleast_1d(modes.reason).ravel()
    heads = [f"{c.name} [{c.unit}]" for c in kind.pose] + [
        f"f{i + 1} [Hz]" for i in range(frequencies.shape[1])
    ]
    rows = []
    for pose, values, reason in zip(poses[:ROWS], frequencies[:ROWS], reasons[:ROWS], strict=True):
        cells = [f"{value:.6g}" for value in pose]
        cells += [escape(str(reason))] * len(values) if reason else [f"{value:.3f}" for value in values]
        rows.append("".join(f"<td>{cell}</td>" for cell in cells))
    head = "".join(f'<th scope="col">{escape(title)}</th>' for title in heads)
    body = "".join(f"<tr>{row}</tr>" for row in rows)
    more = f"<p>{len(poses) - ROWS:,} more poses</p>" if len(poses) > ROWS else ""
    caption = f"{escape(modes.robot.name)}: frequencies of vibration"
    return f"<table><caption>{caption}</caption><thead><tr>{head}</tr></thead><tbody>{body}</tbody></table>{more}"
