"""Which poses a compiled solver leaves to NumPy, which eigenvalues are refused, and the order of fields."""

from __future__ import annotations

from types import SimpleNamespace
from typing import Any

import numpy as np
import pytest

import pkmodes
from helpers.robots.sample_robots import published
from pkmodes.core.base.errors import PoseError
from pkmodes.core.mechanism.registry import mechanism
from pkmodes.core.solve import numpy_solver
from pkmodes.core.solve.compiled_solver import CompiledSolver
from pkmodes.core.solve.field_arrays import chosen_fields
from pkmodes.core.solve.solver import UNSOLVED
from pkmodes.core.system.evaluation import ExtendedSystem
from pkmodes.loop.updating.modes_of_systems import _by_solvers

LINEAR_DELTA = mechanism("linear_delta")


def solver(coordinates: int, first: int, rigid: int, held: int = 0) -> CompiledSolver:
    names = tuple(f"q_{i}" for i in range(coordinates))
    system: Any = SimpleNamespace(
        coordinates=names,
        base_count=first,
        rigid_modes=rigid,
        held_motions=held,
        loose_motions=rigid + held if held else 0,
    )
    return CompiledSolver(SimpleNamespace(modes=coordinates), system)


#: Coordinates, those of the base, rigid modes, held motions; eigenvalues; whether NumPy has to solve them.
MARKS = (
    ((3, 2, 0, 0), (1.0, 1.0, 900.0), False),
    ((3, 2, 0, 0), (1.0, 1.0, 5e3), True),  # a joint that is stiff, but not enough for the graded form
    ((3, 2, 0, 0), (1e-4, 1.0, 1.0), False),
    ((3, 2, 0, 0), (1e-6, 1.0, 1.0), True),  # a soft joint
    ((2, 2, 0, 0), (1e-5, 1.0), False),
    ((2, 2, 0, 0), (1e-7, 1.0), True),  # magnitudes out of proportion
    ((3, 3, 1, 0), (1e-9, 1e-5, 1.0), False),  # a rigid-body mode
    ((3, 3, 0, 2), (-1.0, 1e-5, 1.0), False),
    ((3, 3, 0, 2), (-1.0, 1e-6, 1.0), True),  # of two held motions, the one that is not the lowest
    ((3, 3, 1, 1), (-1.0, 1e-6, 1.0), True),  # of two motions, of which gravity or the spring holds either
    ((3, 3, 1, 1), (-1.0, 1e-5, 1.0), False),
)


@pytest.mark.parametrize(("sizes", "eigenvalues", "left"), MARKS)
def test_what_the_kernel_cannot_resolve_is_left_to_numpy(
    sizes: tuple[int, ...], eigenvalues: tuple[float, ...], left: bool
) -> None:
    codes = solver(*sizes)._mark_unresolved(np.zeros(1, np.int8), {"eigenvalues": np.array([eigenvalues])})
    assert codes[0] == (UNSOLVED if left else 0)


def test_frequencies_alone_show_magnitudes_out_of_proportion() -> None:
    frequencies = np.array([[0.0, 1.0, 900.0], [0.0, 1.0, 1100.0], [np.nan, np.nan, np.nan]])
    codes = solver(3, 3, 1)._mark_unresolved(np.array([0, 0, 2], np.int8), {"frequencies": frequencies})
    assert codes.tolist() == [0, UNSOLVED, 2]


def test_a_pose_that_cannot_be_evaluated_is_not_left_to_numpy() -> None:
    """Whatever its eigenvalues seem to be."""
    eigenvalues = np.array([[1e-9, 1.0, 1e9]] * 3)
    codes = solver(3, 2, 0)._mark_unresolved(
        np.array([2, 0, UNSOLVED], np.int8), {"eigenvalues": eigenvalues}
    )
    assert codes.tolist() == [2, UNSOLVED, UNSOLVED]


@pytest.mark.parametrize("bad", [np.inf, -np.inf, np.nan])
def test_eigenvalues_that_are_not_finite_are_refused(monkeypatch: pytest.MonkeyPatch, bad: float) -> None:
    eigenvalues = np.array([[1.0, 2.0, 3.0], [1.0, 2.0, bad]])
    monkeypatch.setattr(numpy_solver, "modes_of", lambda at: (eigenvalues, np.zeros((2, 3, 3))))
    system = SimpleNamespace(held_motions=0, rigid_modes=0, base_count=3, coordinates=("x", "y", "z"))
    with pytest.raises(PoseError, match="the eigenvalues are not finite"):
        numpy_solver.checked_modes(SimpleNamespace(system=system, source="a robot"))  # type: ignore[arg-type]


@pytest.mark.compiler
def test_the_compiled_solver_serves_a_diagnosis_unless_a_pose_cannot_be_evaluated(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    monkeypatch.setenv("PKMODES_BACKEND", "compiled")
    parameters, p = published((0.6, 0.03, -0.245))
    system = ExtendedSystem(LINEAR_DELTA, parameters, {})
    poses = np.array([p, p + 0.01])
    assert _by_solvers([system], system, poses) is not None
    for bad in ([np.nan, 0.0, 0.0], [9.0, 0.0, 0.0]):
        assert _by_solvers([system], system, np.array([p, bad])) is None


def test_fields_are_in_their_order_and_not_in_that_of_the_request() -> None:
    known = ("a", "b", "c")
    assert chosen_fields(("c", "a"), None, known) == ("a", "c")
    assert chosen_fields(None, {"b": np.zeros(1), "a": np.zeros(1)}, known) == ("a", "b")


def test_equivalent_calls_give_the_same_bits_of_shape_derivatives() -> None:
    model = pkmodes.load("robots/linear-delta-2022.toml")
    poses = np.array([0.6, 0.0, -0.245]) + np.linspace(0.0, 0.05, 5)[:, None] * [1.0, 0.5, 0.2]
    paths = ["platform.mass", "belt.width", "effects.gearbox_compliance.compliance"]
    whole = model.sensitivities(poses, paths, fields=["shapes"]).shapes
    out = {"shapes": np.full_like(whole, np.nan)}
    assert model.sensitivities(poses, paths, out=out).shapes is out["shapes"]
    np.testing.assert_array_equal(out["shapes"], whole)
    np.testing.assert_array_equal(model.sensitivities(poses, paths).shapes, whole)
    pieces = [model.sensitivities(part, paths, fields=["shapes"]).shapes for part in (poses[:2], poses[2:])]
    np.testing.assert_array_equal(np.concatenate(pieces), whole)
