"""Chains of masses and springs, assembled here by hand: the truth of tests of any structure."""

from __future__ import annotations

import numpy as np


def chain(masses: np.ndarray, springs: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
    """Return M and K of masses in a row, each on a spring to the one before it, the first one to the ground."""
    K = np.diag(springs + np.append(springs[1:], 0.0))
    K -= np.diag(springs[1:], 1) + np.diag(springs[1:], -1)
    return np.diag(masses), K
