"""The compiled evaluator as the other ways are called, and its gradients."""

from __future__ import annotations

from functools import cache

import numpy as np

from peers import Array, Way
from published import published, rigid_modes

#: Parameters with respect to which frequencies are differentiated.
GRADIENTS = 64
#: Poses for which gradients are computed together: these take 4.6 kB for each pose, and shall stay in the cache.
TOGETHER = 1024


def compiled(threads: int = 1) -> Way:
    """Return frequencies, or frequencies and shapes, from the compiled library."""
    model = published()

    def run(poses: Array, frequencies: Array, shapes: Array | None) -> None:
        if shapes is None:
            model.frequencies(poses, out=frequencies, backend="compiled", threads=threads)
        else:
            out = {"frequencies": frequencies, "shapes": shapes}
            model.modes(poses, out=out, backend="compiled", threads=threads)

    return Way("pkmodes, compiled", "(g) pkmodes, compiled", run)


@cache
def paths() -> list[str]:
    """Choose the first quantities of the robot itself: no parameters of effects, which it does not have."""
    model = published()
    found = model.sensitivities([0.6, 0.0, -0.245], fields=["frequencies"]).parameters
    return [path for path in found if not path.startswith(("effects.", "frame."))][:GRADIENTS]


def gradients(poses: Array, rates: Array) -> None:
    """Fill derivatives of frequencies, (N, 64, n), or as many as there is room for, again and again."""
    model, chosen, size = published(), paths(), min(TOGETHER, len(rates))
    for start in range(0, len(poses), size):
        some = poses[start : start + size]
        out = {"frequencies": rates[: len(some)]}
        model.sensitivities(some, chosen, fields=["frequencies"], out=out, backend="compiled", threads=1)


def room_for_gradients(count: int) -> Array:
    return np.zeros((min(count, TOGETHER), len(paths()), len(published().coordinates)))


def check_gradients(poses: Array) -> None:
    """Compare a derivative with central differences.

    Raises
    ------
    AssertionError
        If it differs by more than 1e-5 of the largest.
    """
    name, model = "platform.mass", published()
    rates, (value, step) = room_for_gradients(len(poses)), (float(model.robot.parameters.platform_mass), 1e-5)
    gradients(poses, rates)
    ahead, behind = (
        model.with_values({name: value + sign * step}).frequencies(poses, backend="numpy") for sign in (1, -1)
    )
    expected = ((ahead - behind) / (2 * step))[:, rigid_modes() :]
    found = rates[:, paths().index(name), rigid_modes() :]
    assert np.abs(found - expected).max() < 1e-5 * np.abs(expected).max()
