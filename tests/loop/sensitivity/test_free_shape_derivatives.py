"""Derivatives of mode shapes stay finite for several rigid-body modes with exactly zero eigenvalues."""

from __future__ import annotations

from types import SimpleNamespace
from typing import Any, cast

import numpy as np

from pkmodes.loop.sensitivity.shapes import shape_derivatives


def test_modes_that_nothing_holds_do_not_overflow() -> None:
    eigenvalues, shapes = np.array([[0.0, 0.0, 1e6]]), 1e4 * np.eye(3)[None]
    inertia = 1e12 * np.ones((3, 3)) @ shapes
    still = SimpleNamespace(
        changes=lambda eigenvalues, shapes: (
            ((1.0 - eigenvalues[..., None]) * inertia)[:, None],
            (shapes * inertia).sum(axis=-1)[:, None],
        ),
        locked_paths=(),
        free=np.arange(3),
        size=3,
        system=SimpleNamespace(massless=np.zeros(3, dtype=bool), to_model_coordinates=np.asarray),
    )
    found = shape_derivatives(cast(Any, still), eigenvalues, shapes)
    assert np.isfinite(found).all()
