"""Modes of several robots at once, as a diagnosis needs them: compiled against NumPy."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np
import pytest

from helpers.references.numpy_modes import solve
from helpers.robots.lane_samples import NAMES, case
from pkmodes.core.system.evaluation import ExtendedSystem
from pkmodes.loop.updating.modes_of_systems import modes_of_systems, stack_systems

pytestmark = pytest.mark.compiler

EACH = 5
#: Both solve stiff joints to nine digits; shapes of modes a percent apart lose two of them.
FREQUENCY, SHAPE = 1e-9, 1e-7


def systems_of(name: str, effects: Sequence[dict[str, float]]) -> tuple[list[ExtendedSystem], np.ndarray]:
    """Robots with different masses and effects, and the same poses of each."""
    given = case(name, 3, count=EACH + 1)
    mass = "platform_mass" if "platform_mass" in given.parameters._fields else "toolhead_mass"
    found = [
        ExtendedSystem(
            given.mechanism,
            given.parameters._replace(**{mass: getattr(given.parameters, mass) * (1 + b / 7)}),
            values,
        )
        for b, values in enumerate(effects)
    ]
    return found, np.tile(given.poses[-EACH:], (len(found), 1))


def assert_modes_of_numpy(systems: list[ExtendedSystem], points: np.ndarray) -> None:
    modes = modes_of_systems(systems, points)
    assert modes.matrices is None  # not those of NumPy
    eigenvalues, shapes, motions = modes.eigenvalues, modes.shapes, modes.motions
    stack = stack_systems(systems, EACH)
    expected = solve(stack, points)
    rigid = systems[0].rigid_modes
    np.testing.assert_allclose(eigenvalues[:, rigid:], expected.eigenvalues[:, rigid:], rtol=FREQUENCY)
    sign = np.sign((shapes * expected.shapes).sum(axis=-1, keepdims=True))
    size = np.abs(expected.shapes).max(axis=-1, keepdims=True)
    assert (np.abs(shapes * sign - expected.shapes)[:, rigid:] <= SHAPE * size[:, rigid:]).all()
    expected_motions = shapes @ np.swapaxes(stack.platform_motion(points), -1, -2)
    np.testing.assert_allclose(motions, expected_motions, rtol=0, atol=1e-12 * np.abs(expected_motions).max())


@pytest.mark.parametrize("name", NAMES)
def test_robots_without_effects(name: str) -> None:
    assert_modes_of_numpy(*systems_of(name, [{}] * 4))


@pytest.mark.parametrize("name", NAMES)
def test_released_joints_soft_stiff_and_between(name: str) -> None:
    """Those that are too stiff for the kernel are solved by NumPy, the others are not."""
    effect = "gearbox_compliance" if name != "rotary_delta" else "link_compliance"
    effects = [{f"{effect}.compliance": c, "payload.mass": 0.2} for c in (1e-4, 1e-15, 1e-5, 1e-9)]
    assert_modes_of_numpy(*systems_of(name, effects))


@pytest.mark.parametrize("name", NAMES)
def test_massless_joints(name: str) -> None:
    effect = "link_compliance" if name == "rotary_delta" else "clamp_compliance"
    assert_modes_of_numpy(*systems_of(name, [{f"{effect}.compliance": c} for c in (1e-6, 3e-6)]))


def test_numpy_evaluates_what_the_compiled_evaluator_cannot(monkeypatch: pytest.MonkeyPatch) -> None:
    systems, points = systems_of("linear_delta", [{}, {}])
    assert modes_of_systems(systems, points).matrices is None
    with np.errstate(invalid="ignore"):
        assert np.isnan(modes_of_systems(systems, points + 5.0).eigenvalues).all()
    monkeypatch.setenv("PKMODES_BACKEND", "numpy")
    assert modes_of_systems(systems, points).matrices is not None
