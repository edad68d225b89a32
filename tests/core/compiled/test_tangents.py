"""Derivatives of matrices along paths by forward accumulation in lanes: against the generated NumPy derivatives."""

from __future__ import annotations

from itertools import product
from pathlib import Path
from typing import NamedTuple

import numpy as np
import pytest

from helpers.robots.lane_samples import EFFECTS, NAMES, ROOT, SIX_LEGGED, case, robot_of
from pkmodes.core.compiled import build
from pkmodes.core.compiled.lanes import FULL_MATRIX_FIELDS, MATRIX_RATE_FIELDS, MODE_RATE_FIELDS
from pkmodes.core.compiled.loader import NoLibraryError, load
from pkmodes.core.mechanism.poses import MAX_CONDITION
from pkmodes.core.solve.at_poses import RobotAtPoses
from pkmodes.core.solve.compiled_solver import CompiledSolver
from pkmodes.core.system.evaluation import ExtendedSystem
from pkmodes.core.system.motors import solved_system
from pkmodes.loop.sensitivity.compiled import CompiledDerivatives, derivatives_of, terms_of, terms_of_all
from pkmodes.loop.sensitivity.locked import locked_joints
from pkmodes.loop.sensitivity.matrices import COMPLEX_STEP, POSE, MatrixDerivatives
from pkmodes.loop.sensitivity.paths import ParameterPath, paths, resolve_all
from pkmodes.loop.sensitivity.shapes import shape_derivatives
from pkmodes.loop.updating.modes_of_systems import ModesOfSystems, modes_of_systems

pytestmark = pytest.mark.compiler

#: Poses of each robot: a full block of lanes, and some more.
EACH = 11
#: Of the largest derivative along the same path.
EXACT = 1e-11


class Robots(NamedTuple):
    """Robots with different masses at the same poses, with their modes."""

    systems: list[ExtendedSystem]
    points: np.ndarray
    paths: list[ParameterPath]
    modes: ModesOfSystems

    def derivatives(self) -> tuple[MatrixDerivatives, MatrixDerivatives]:
        """From the library, and from NumPy."""
        of_each, (system, eigenvalues, shapes, _, _, solver) = [self.paths] * len(self.systems), self.modes
        terms = terms_of_all(self.systems, of_each)
        found = derivatives_of(
            solver, system, self.points, of_each, (eigenvalues, shapes), terms, MODE_RATE_FIELDS
        )
        assert isinstance(found, CompiledDerivatives)
        return found, MatrixDerivatives(system, self.points, of_each)


def robots(name: str, effects: str, count: int) -> Robots:
    given = case(name, 3, effects, count=EACH + 1)
    mass = "platform_mass" if "platform_mass" in given.parameters._fields else "toolhead_mass"
    systems = []
    for b in range(count):
        parameters = given.parameters._replace(**{mass: getattr(given.parameters, mass) * (1 + b / 7)})
        systems.append(ExtendedSystem(given.mechanism, parameters, given.values))
    robot = robot_of(given)
    moves = resolve_all(robot, [path for path in paths(robot) if path != "axis.joint_radius"])
    moves += [
        ParameterPath(f"{POSE}.{component.name}", 0.0, component.unit, {(POSE, (i,)): 1.0})
        for i, component in enumerate(given.mechanism.pose)
    ]
    if count > 1:  # locked joints are differentiated for one robot only
        locked = locked_joints(systems[0], moves).paths
        moves = [move for t, move in enumerate(moves) if t not in locked]
    points = np.tile(given.poses[-EACH:], (count, 1))
    return Robots(systems, points, moves, modes_of_systems(systems, points))


def assert_near(found: np.ndarray, expected: np.ndarray, *over: int, least: float | np.ndarray = 0.0) -> None:
    """Compare relative to the largest of each path, or to `least` if that is larger."""
    largest = np.maximum(np.abs(expected).max(axis=over, keepdims=True), least)
    assert (np.abs(found - expected) <= EXACT * largest).all()
    assert np.any(expected)


def assert_derivatives(name: str, effects: str, count: int) -> None:
    given = robots(name, effects, count)
    found, expected = given.derivatives()
    eigenvalues, shapes, rigid = given.modes.eigenvalues, given.modes.shapes, given.systems[0].rigid_modes
    rates = expected.eigenvalues(eigenvalues, shapes)
    assert_near(found.eigenvalues(eigenvalues, shapes), rates, 0, 1)
    for one, other in zip(
        found.changes(eigenvalues, shapes), expected.changes(eigenvalues, shapes), strict=True
    ):
        assert_near(one, other, 0, *range(2, one.ndim))
    turned, wanted = (shape_derivatives(one, eigenvalues, shapes) for one in (found, expected))
    if eigenvalues.shape[1] > rigid:  # single rigid modes are arbitrary
        # where a mode stretches one belt only, its shape does not depend on the belt: the derivative is rounding
        usual = np.abs(rates).max(axis=(0, 1)) / np.abs(eigenvalues).max() * np.abs(shapes).max()
        assert_near(turned[:, :, rigid:], wanted[:, :, rigid:], 0, 2, 3, least=usual[:, None, None])


@pytest.mark.parametrize("name", NAMES)
def test_derivatives_are_those_of_the_generated_code(subtests: pytest.Subtests, name: str) -> None:
    for effects, count in product(EFFECTS, [1, 3]):
        with subtests.test(f"{effects}, {count}"):
            assert_derivatives(name, effects, count)


@pytest.mark.parametrize("name", SIX_LEGGED)
def test_derivatives_of_platforms_that_turn(name: str) -> None:
    assert_derivatives(name, "everything", 2)


@pytest.mark.parametrize("name", NAMES)
def test_the_motion_of_the_platform_by_complex_step(name: str) -> None:
    given = robots(name, "nothing", 2)
    found, _ = given.derivatives()
    motions = found.motions(given.modes.shapes)
    assert motions is not None
    for i in range(given.points.shape[1]):
        step = COMPLEX_STEP * 1j * np.eye(given.points.shape[1])[i]
        system = given.modes.system
        J = system.full_platform_motion(given.points + step).imag[..., system.free] / COMPLEX_STEP
        expected = given.modes.shapes @ np.swapaxes(J, -1, -2)
        pose = len(given.paths) - given.points.shape[1] + i
        np.testing.assert_allclose(
            motions[:, pose], expected, rtol=0, atol=EXACT * max(np.abs(expected).max(), 1.0)
        )
    masses = [t for t, path in enumerate(given.paths) if path.path == "platform.mass"]
    assert not motions[:, masses].any()


def assert_matrices(name: str, effects: str, drives: str) -> None:
    """Compare dM, dK, M and K with the generated code's, and one pose with the same pose among others."""
    given = case(name, 3, effects, count=EACH)
    robot = robot_of(given)
    system = solved_system(ExtendedSystem(given.mechanism, given.parameters, given.values), drives)
    solver = CompiledSolver.init(system, MAX_CONDITION)
    moves = resolve_all(robot, [path for path in paths(robot) if path != "axis.joint_radius"])
    terms, locked = terms_of(system, moves), locked_joints(system, moves)
    fields = (*MATRIX_RATE_FIELDS, *FULL_MATRIX_FIELDS)
    none = np.empty((EACH, 0)), np.empty((EACH, 0, len(system.coordinates)))
    at = RobotAtPoses(system, given.poses, "", {})
    found = derivatives_of(solver, system, given.poses, [moves], none, terms, fields)
    assert isinstance(found, CompiledDerivatives)
    expected = MatrixDerivatives(system, given.poses, [moves])
    evaluated = np.setdiff1d(np.arange(len(moves)), locked.paths)
    for one, other in zip(found.dense(), expected.dense(), strict=True):
        largest = np.abs(other).max(axis=(2, 3), initial=0.0, where=np.isfinite(other))
        limit = EXACT * largest.max(axis=0)[:, None, None]
        assert (np.abs(one - other)[:, evaluated] <= limit[evaluated]).all()
        assert np.isnan(one[:, list(locked.paths)]).all()
        assert np.any(other[:, evaluated])
    for one, other in ((found.mass, expected.mass), (found.stiffness, expected.stiffness)):
        np.testing.assert_allclose(one, other, rtol=0, atol=EXACT * np.abs(other).max())
    together = solver.along(at, none, terms, fields)
    for i in (0, EACH - 1):
        at = RobotAtPoses(system, given.poses[i : i + 1], "", {})
        alone = solver.along(at, (none[0][:1], none[1][:1]), terms, fields)
        assert together is not None
        assert alone is not None
        for field in fields:
            np.testing.assert_array_equal(alone[field][0], together[field][i])


@pytest.mark.parametrize("drives", ["free", "held"])
@pytest.mark.parametrize("name", [*NAMES, *SIX_LEGGED])
def test_derivatives_of_matrices_are_those_of_the_generated_code(
    subtests: pytest.Subtests, name: str, drives: str
) -> None:
    for effects in EFFECTS:
        with subtests.test(effects):
            assert_matrices(name, effects, drives)


def test_numpy_evaluates_poses_that_the_library_refuses() -> None:
    given = robots("linear_delta", "none", 1)
    _, eigenvalues, shapes, _, _, solver = given.modes
    assert solver is not None
    far, terms = given.points + 5.0, terms_of(given.systems[0], given.paths)
    found = derivatives_of(
        solver, given.systems[0], far, [given.paths], (eigenvalues, shapes), terms, MODE_RATE_FIELDS
    )
    assert type(found) is MatrixDerivatives


def test_headers_of_an_earlier_version_are_to_be_generated_again(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    (tmp_path / "earlier_header").mkdir()
    (tmp_path / "earlier_header" / "__init__.py").touch()
    header = (ROOT / "generated/pkmodes_generated/corexy" / build.HEADER).read_text(encoding="utf-8")
    earlier = header.replace("lanes_extended_statics", "lanes_something_else")
    (tmp_path / "earlier_header" / build.HEADER).write_text(earlier, encoding="utf-8")
    monkeypatch.syspath_prepend(tmp_path)
    with pytest.raises(NoLibraryError) as error:
        load("earlier_header", "corexy")
    assert "by an earlier version" in error.value.why
    assert "generate it again" in error.value.remedy
