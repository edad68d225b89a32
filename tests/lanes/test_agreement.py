"""The compiled evaluator agrees with generated NumPy and LAPACK, and solves its eigenproblem, for every mechanism."""

from __future__ import annotations

import numpy as np
import pytest

from lane_samples import EFFECTS, EXTREMES, NAMES, Case, case, results
from pkmodes.eigen import has_stiff_joint, natural_frequencies
from pkmodes.generated import Generated
from pkmodes.poses import check_poses
from pkmodes.solving import solve

#: Relative, of frequencies of vibration; of shapes to the largest component where modes are apart.
FREQUENCY, SHAPE = 1e-10, 1e-8
#: Of residual and M-orthogonality, relative to the largest.
EXACT = 1e-12
#: Modes closer than this, relative to the highest eigenvalue, may be any basis of their space.
APART = 1e-6


def assert_agrees(given: Case) -> None:
    codes, found = results(given, given.poses)
    checked = check_poses(given.poses, given.kind, given.parameters, "nan")
    np.testing.assert_array_equal(codes, checked.codes)
    valid = codes == 0
    assert valid.sum() > len(valid) / 2
    p, found = given.poses[valid], {name: array[valid] for name, array in found.items()}
    expected = solve(given.evaluation, p)
    rigid, M, K = given.evaluation.rigid_modes, expected.M, expected.K
    np.testing.assert_allclose(found["mass_matrix"], M, rtol=0, atol=1e-14 * np.abs(M).max())
    np.testing.assert_allclose(found["stiffness_matrix"], K, rtol=0, atol=1e-14 * np.abs(K).max())
    joints = Generated(given.kind.model, given.parameters).inverse_kinematics(p)
    np.testing.assert_allclose(found["joint_positions"], joints, rtol=1e-14, atol=1e-15)
    # Poses with a stiff joint are solved in graded form, by NumPy; the others have all digits.
    plain = ~has_stiff_joint(expected.eigenvalues, given.evaluation.first, rigid)
    frequencies = natural_frequencies(expected.eigenvalues)
    np.testing.assert_allclose(
        found["frequencies"][plain, rigid:], frequencies[plain, rigid:], rtol=FREQUENCY
    )
    # Of rigid modes the eigenvalue is known to the rounding of the largest one.
    largest = np.abs(expected.eigenvalues).max(axis=-1, keepdims=True)
    eigenvalues = found["eigenvalues"]
    np.testing.assert_allclose(natural_frequencies(eigenvalues), found["frequencies"], rtol=1e-15)
    assert (np.abs(eigenvalues - expected.eigenvalues) <= EXACT * largest).all()
    shapes = found["shapes"]
    scale = 1 / np.sqrt(np.where(np.diagonal(M, axis1=1, axis2=2) > 0, np.diagonal(M, axis1=1, axis2=2), 1))
    orthogonal = shapes @ M @ np.swapaxes(shapes, -1, -2) - np.eye(shapes.shape[1])
    assert np.abs(orthogonal).max() < EXACT
    residual = (shapes @ K - eigenvalues[..., None] * (shapes @ M)) * scale[:, None]
    assert (
        np.abs(residual).max(axis=(1, 2))
        <= EXACT * np.abs(K * scale[:, None] * scale[:, :, None]).max(axis=(1, 2))
    ).all()
    apart = np.abs(np.diff(expected.eigenvalues, axis=1)) > APART * largest
    alone = np.pad(apart, ((0, 0), (0, 1)), constant_values=True) & np.pad(
        apart, ((0, 0), (1, 0)), constant_values=True
    )
    size = np.abs(expected.shapes).max(axis=-1)
    sign = np.sign((shapes * expected.shapes).sum(axis=-1, keepdims=True))
    assert (np.abs(shapes * sign - expected.shapes).max(axis=-1)[alone] <= SHAPE * size[alone]).all()
    motion = given.evaluation.platform_motion(p)
    np.testing.assert_allclose(
        found["platform_shapes"],
        shapes @ np.swapaxes(motion, -1, -2),
        rtol=0,
        atol=1e-13 * np.abs(found["platform_shapes"]).max(),
    )


@pytest.mark.parametrize("seed", range(4))
@pytest.mark.parametrize("effects", EFFECTS)
@pytest.mark.parametrize("name", NAMES)
def test_modes_agree_with_numpy(name: str, effects: str, seed: int) -> None:
    assert_agrees(case(name, seed, effects))


@pytest.mark.parametrize("effects", ["none", "everything"])
@pytest.mark.parametrize("extreme", EXTREMES)
@pytest.mark.parametrize("name", NAMES)
def test_hard_eigenproblems_agree_with_numpy(name: str, extreme: str, effects: str) -> None:
    for seed in range(4):
        assert_agrees(case(name, seed, effects, extreme))


@pytest.mark.parametrize("name", NAMES)
def test_signs_are_those_of_the_eigensolver(name: str) -> None:
    """Where no two components are nearly as large, the sign of a shape is decided and the same."""
    given = case(name, 3)
    codes, found = results(given, given.poses)
    expected = solve(given.evaluation, given.poses[codes == 0])
    scaled = np.abs(expected.shapes) * np.sqrt(np.diagonal(expected.M, axis1=1, axis2=2))[:, None]
    two = np.sort(scaled, axis=-1)[..., -2:]
    decided = two[..., 0] < 0.99 * two[..., 1]
    decided[:, : given.evaluation.rigid_modes] = False
    assert decided.sum() > 20
    products = (found["shapes"][codes == 0] * expected.shapes).sum(axis=-1)
    assert (products[decided] > 0).all()
