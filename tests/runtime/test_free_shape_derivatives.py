"""Derivatives of mode shapes stay finite for several rigid-body modes with exactly zero eigenvalues."""

from __future__ import annotations

from types import SimpleNamespace
from typing import Any, cast

import numpy as np

from pkmodes.sensitivity.shapes import shape_derivatives


def test_modes_that_nothing_holds_do_not_overflow() -> None:
    dM = np.ones((1, 1, 3, 3)) * 1e12
    still = SimpleNamespace(
        dense=lambda: (dM, dM),
        locked=(),
        free=np.arange(3),
        size=3,
        massless=np.zeros(3, dtype=bool),
    )
    found = shape_derivatives(cast(Any, still), np.array([[0.0, 0.0, 1e6]]), 1e4 * np.eye(3)[None])
    assert np.isfinite(found).all()
