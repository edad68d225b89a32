"""Derivatives of frequencies by reverse accumulation in lanes: against the forward route, differences and NumPy."""

from __future__ import annotations

from itertools import product

import numpy as np
import pytest

import pkmodes
from helpers.robots.lane_samples import (
    EFFECTS,
    EXTREMES,
    NAMES,
    SIX_LEGGED,
    Case,
    case,
    directions,
    evaluator,
    results,
    robot_of,
)
from helpers.robots.one_of_each import EVERY, POSES, load_free
from pkmodes import PkmodesError
from pkmodes.core.system.evaluation import ExtendedSystem
from pkmodes.loop.sensitivity.compiled import terms_of
from pkmodes.loop.sensitivity.matrices import POSE, MatrixDerivatives
from pkmodes.loop.sensitivity.modes import ROUNDING
from pkmodes.loop.sensitivity.paths import ParameterPath

pytestmark = pytest.mark.compiler

#: Of the largest derivative along the same path; and where a heavy motor hardly moves because the motions of its
#: coordinates cancel, or a rigid mode has digits of the stiffest one only.
EXACT, CANCELLED = 1e-11, 1e-8


def assert_agrees(given: Case, tolerance: float = EXACT) -> None:
    """Compare with phi^T (dK - lambda dM) phi, dM and dK from the implicit function theorem."""
    varied, _ = directions(given)
    codes, found = results(given, given.poses[:12])
    p = given.poses[:12][codes == 0]
    assert len(p) > 6
    found = {name: array[codes == 0] for name, array in found.items()}
    system = given.evaluation
    if not isinstance(system, ExtendedSystem):
        system = ExtendedSystem(given.mechanism, given.parameters, {})
    forward = MatrixDerivatives(system, p, [varied]).eigenvalues(found["eigenvalues"], found["shapes"])
    expected = np.swapaxes(forward, -1, -2)
    largest = np.abs(expected).max(axis=(0, 2))[None, :, None]
    assert (np.abs(found["eigenvalue_rates"] - expected) <= tolerance * largest).all()
    assert np.count_nonzero(largest) > len(varied) / 2
    values = found["eigenvalues"]
    size = np.abs(values)
    nothing = size <= ROUNDING * np.abs(values).max(axis=1, keepdims=True)
    by_frequency = 4 * np.pi * np.sqrt(np.where(nothing, np.nan, size))[:, None]
    np.testing.assert_allclose(
        found["frequency_rates"], found["eigenvalue_rates"] / by_frequency, rtol=1e-14, atol=0
    )


@pytest.mark.parametrize("name", NAMES)
def test_derivatives_agree_with_the_forward_route(subtests: pytest.Subtests, name: str) -> None:
    for effects, seed in product(EFFECTS, range(3)):
        with subtests.test(f"{effects}, {seed}"):
            assert_agrees(case(name, seed, effects))


@pytest.mark.parametrize("name", SIX_LEGGED)
def test_derivatives_of_platforms_that_turn(name: str) -> None:
    """Here the forward route is a complex step of M and K."""
    assert_agrees(case(name, 1, "everything", count=12))


@pytest.mark.parametrize("name", NAMES)
def test_derivatives_of_hard_eigenproblems(subtests: pytest.Subtests, name: str) -> None:
    for extreme, effects in product(EXTREMES, ["none", "everything"]):
        with subtests.test(f"{extreme}, {effects}"):
            assert_agrees(case(name, 3, effects, extreme), CANCELLED if extreme == "heavy motors" else EXACT)


@pytest.mark.parametrize("effects", EFFECTS)
@pytest.mark.parametrize("name", NAMES)
def test_paths_have_the_same_derivatives_alone_and_among_others(name: str, effects: str) -> None:
    """Without effects, the shorter model is differentiated if no path belongs to one."""
    given = case(name, 3, effects)
    varied, terms = directions(given)
    # values of the robot file may be those of an effect: effect.parameter
    own = [path.path for path in varied if not any("." in field for field, _ in path.weights)]
    few, short = directions(given, own)
    assert terms.all_coordinates
    assert (short.all_coordinates, short.locked_joints) == (False, False)
    run = evaluator(given)
    both = []
    for paths, some in ((varied, terms), (few, short)):
        array = np.full((len(given.poses), len(paths), run.modes), 12345.0)
        run.run(np.ascontiguousarray(given.poses), {"eigenvalue_rates": array}, terms=some)
        both.append(array[:, [path.path in own for path in paths]])
    largest = np.nanmax(np.abs(both[0]), axis=(0, 2))[None, :, None]
    valid = np.isfinite(both[0]).all(axis=(1, 2))
    assert valid.sum() > len(valid) / 2
    assert (np.abs(both[0] - both[1]) <= EXACT * largest)[valid].all()


def test_a_payload_counts_for_paths_of_the_robot() -> None:
    model = pkmodes.load("robots/linear-delta-2022.toml").with_values({"effects.payload.mass": 3.0})
    numpy, compiled = (
        model.sensitivities(POSES["linear_delta"], ["link.length"], fields=["frequencies"], backend=backend)
        for backend in ("numpy", "compiled")
    )
    np.testing.assert_allclose(compiled.frequencies[:, 3:], numpy.frequencies[:, 3:], rtol=1e-9)


@pytest.mark.parametrize("name", NAMES)
def test_derivatives_are_those_of_differences(name: str) -> None:
    """Central differences of frequencies that NumPy computes, with the accuracy of differences."""
    pose = POSES[name]
    model = load_free(EVERY[name])
    kept = [path for path in model.sensitivities(pose).parameters if "effects" not in path]
    found = model.sensitivities(pose, kept, fields=["frequencies"], backend="compiled")
    rigid = model.modes(pose).rigid_modes
    compared = 0
    for path, value, rates in zip(kept, found.values, found.frequencies[:, rigid:], strict=True):
        if value == 0.0:
            continue
        step = 1e-5 * abs(value)
        try:
            ends = [
                model.with_values({path: value + s}).frequencies(pose, backend="numpy") for s in (step, -step)
            ]
        except PkmodesError:  # a value that the file gives in another key
            continue
        slope = (ends[0] - ends[1])[rigid:] / (2 * step)
        size = model.frequencies(pose)[rigid:] / abs(value)
        np.testing.assert_allclose(rates, slope, rtol=1e-6, atol=1e-9 * size.max())
        compared += 1
    assert compared > len(kept) / 2


@pytest.mark.parametrize("effects", ["none", "everything"])
@pytest.mark.parametrize("name", NAMES)
def test_derivatives_by_the_pose(name: str, effects: str) -> None:
    given = case(name, 3, effects, count=4)
    size = len(given.mechanism.pose)
    along = [ParameterPath(f"pose {i}", 0.0, "m", {(POSE, (i,)): 1.0}) for i in range(size)]
    system = given.evaluation
    if not isinstance(system, ExtendedSystem):
        system = ExtendedSystem(given.mechanism, given.parameters, {})
    run, first = evaluator(given), given.evaluation.rigid_modes
    found = np.full((len(given.poses), size, run.modes), 12345.0)
    values = {step: [np.empty((len(given.poses), run.modes)) for _ in along] for step in (-1e-6, 1e-6)}
    run.run(np.ascontiguousarray(given.poses), {"eigenvalue_rates": found}, terms=terms_of(system, along))
    for step, arrays in values.items():
        for i, array in enumerate(arrays):
            moved = given.poses + step * np.eye(size)[i]
            run.run(np.ascontiguousarray(moved), {"eigenvalues": array})
    for i in range(size):
        slope = (values[1e-6][i] - values[-1e-6][i]) / 2e-6
        rounding = 1e-15 * np.abs(values[1e-6][i]).max() / 2e-6  # of the differences
        close = 1e-7 * np.abs(slope).max() + rounding
        np.testing.assert_allclose(found[:, i, first:], slope[:, first:], rtol=1e-5, atol=close)


@pytest.mark.parametrize("fields", [["frequencies"], ["eigenvalues"], ["eigenvalues", "frequencies"]])
@pytest.mark.parametrize("name", NAMES)
def test_both_back_ends_say_the_same(name: str, fields: list[str]) -> None:
    model = load_free(EVERY[name])
    poses = np.array([POSES[name], [9.0] * len(POSES[name]), POSES[name]])
    poses[2, 0] += 0.01
    numpy, compiled = (
        model.sensitivities(poses, fields=fields, on_error="nan", backend=backend)
        for backend in ("numpy", "compiled")
    )
    assert compiled.parameters == numpy.parameters
    np.testing.assert_array_equal(compiled.reason, numpy.reason)
    np.testing.assert_array_equal(compiled.valid, [True, False, True])
    for field in fields:
        expected, found = getattr(numpy, field), getattr(compiled, field)
        np.testing.assert_array_equal(np.isnan(found), np.isnan(expected))
        error = np.abs(found - expected)[[0, 2]]
        error /= np.maximum(np.nanmax(np.abs(expected), axis=(0, 2)), 1e-300)[:, None]
        rigid = model.mechanism.rigid_modes
        assert error[..., rigid:].max() <= EXACT
        assert np.nanmax(error[..., :rigid], initial=0.0) <= CANCELLED
    with pytest.raises(pkmodes.PoseError, match="pose 1 at"):
        model.sensitivities(poses, fields=fields, backend="compiled")


def test_repeated_modes_have_the_derivatives_of_their_branches() -> None:
    """At its centre a tower printer has pairs of modes; elsewhere it has none."""
    given = case("linear_delta", 1, count=40)
    model = pkmodes.Model(robot_of(given))
    poses = np.concatenate([given.poses[:1], given.poses[10:14]])
    both = [
        model.sensitivities(
            poses, ["platform.mass", "axis.1.belt.width"], fields=["eigenvalues"], backend=backend
        )
        for backend in ("numpy", "compiled")
    ]
    groups = model.sensitivities(poses, ["platform.mass"], fields=["groups"]).groups
    assert (np.diff(groups[0]) == 0).any()
    largest = np.abs(both[0].eigenvalues).max(axis=(0, 2))[None, :, None]
    assert (np.abs(both[1].eigenvalues - both[0].eigenvalues) <= 1e-9 * largest).all()


def test_stiff_joints_are_left_to_numpy() -> None:
    model = pkmodes.load("robots/linear-delta-2022.toml")
    stiff = model.with_values({"effects.frame_compliance.compliance": "1e-16 m/N"})
    both = [
        stiff.sensitivities(POSES["linear_delta"], ["platform.mass"], fields=["frequencies"], backend=backend)
        for backend in ("numpy", "compiled")
    ]
    np.testing.assert_allclose(both[1].frequencies[:, 3:9], both[0].frequencies[:, 3:9], rtol=1e-9)


def test_out_and_threads() -> None:
    model = pkmodes.load("robots/linear-delta-2022.toml")
    poses = np.array(POSES["linear_delta"]) + 0.01 * np.random.default_rng(3).uniform(-1, 1, (5000, 3))
    names = ["platform.mass", "axis.span", "effects.payload.mass"]
    wide = np.full((5000, 3, 18), -1.0)
    found = model.sensitivities(poses, names, out={"frequencies": wide[..., ::2]}, threads=1)
    again = model.sensitivities(poses, names, fields=["frequencies"], threads=2)
    assert found.frequencies.tobytes() == again.frequencies.tobytes()
    assert (wide[..., 1::2] == -1.0).all()
    with pytest.raises(PkmodesError, match="expected a positive integer"):
        model.sensitivities(poses[0], names, threads=0)
