"""What agreement of the compiled evaluator with generated NumPy and LAPACK means."""

from __future__ import annotations

import numpy as np

from helpers.references.numpy_modes import solve
from helpers.robots.lane_samples import Case, results
from pkmodes.core.linalg.eigen import has_stiff_joint, natural_frequencies
from pkmodes.core.linalg.statics import step_amplitudes
from pkmodes.core.mechanism.generated import Generated
from pkmodes.core.mechanism.poses import check_poses
from pkmodes.core.system.strain_free import strain_free_motions

#: Largest errors: of frequencies of vibration, relative; of the shapes of separate modes, relative to the largest
#: component; of eigenvalues relative to the largest; of M-orthogonality; of the scaled residual relative to K.
LIMITS = {"frequency": 1e-10, "shape": 1e-8, "eigenvalue": 1e-12, "orthogonality": 1e-12, "residual": 1e-12}
#: Modes closer than this, relative to the highest eigenvalue, may be any basis of their space.
APART = 1e-6

Errors = dict[str, np.ndarray]


def assert_agrees(given: Case) -> None:
    for name, error in errors(given)[0].items():
        assert error.max(initial=0.0) <= LIMITS[name], name


def errors(given: Case) -> tuple[Errors, Errors]:
    """Compare the two back ends at the poses of a case.

    What has no eigenproblem is asserted to rounding: codes, matrices, positions, motions of the platform.

    Returns
    -------
    compiled, numpy : dict of str to ndarray
        Errors of each pose by name of `LIMITS`; of NumPy only those of its own equations.
    """
    codes, found = results(given, given.poses)
    checked = check_poses(given.poses, given.mechanism, given.parameters, "nan")
    np.testing.assert_array_equal(codes, checked.codes)
    valid = codes == 0
    assert valid.sum() > len(valid) / 2
    p, found = given.poses[valid], {name: array[valid] for name, array in found.items()}
    expected = solve(given.evaluation, p)
    rigid, M, K = given.evaluation.rigid_modes, expected.M, expected.K
    np.testing.assert_allclose(found["mass_matrix"], M, rtol=0, atol=1e-14 * np.abs(M).max())
    np.testing.assert_allclose(found["stiffness_matrix"], K, rtol=0, atol=1e-14 * np.abs(K).max())
    joints = Generated(given.mechanism.model, given.parameters).inverse_kinematics(p)
    np.testing.assert_allclose(found["joint_positions"], joints, rtol=1e-14, atol=1e-15)
    eigenvalues, shapes = found["eigenvalues"], found["shapes"]
    np.testing.assert_allclose(natural_frequencies(eigenvalues), found["frequencies"], rtol=1e-15)
    motion = given.evaluation.platform_motion(p)
    np.testing.assert_allclose(
        found["platform_motion"], motion, rtol=1e-14, atol=1e-14 * np.abs(motion).max()
    )
    _assert_statics_agree(given, p, found)
    _assert_amplitudes_agree(given, p, found, M @ strain_free_motions(given.evaluation, p))
    moved = found["platform_shapes"] - shapes @ np.swapaxes(motion, -1, -2)
    assert (np.abs(moved) <= 1e-12 * (np.abs(shapes) @ np.abs(np.swapaxes(motion, -1, -2)))).all()
    own = _of_equations(M, K, eigenvalues, shapes)
    # Poses with a stiff joint are solved in graded form, by NumPy; the others have all digits.
    plain = ~has_stiff_joint(expected.eigenvalues, given.evaluation.base_count, rigid)
    frequencies = natural_frequencies(expected.eigenvalues)[plain, rigid:]
    own["frequency"] = np.abs(found["frequencies"][plain, rigid:] / frequencies - 1.0).max(
        axis=1, initial=0.0
    )
    largest = np.abs(expected.eigenvalues).max(axis=-1, keepdims=True)
    own["eigenvalue"] = (np.abs(eigenvalues - expected.eigenvalues) / largest).max(axis=1)
    apart = np.abs(np.diff(expected.eigenvalues, axis=1)) > APART * largest
    alone = np.pad(apart, ((0, 0), (0, 1)), constant_values=True) & np.pad(
        apart, ((0, 0), (1, 0)), constant_values=True
    )
    size = np.abs(expected.shapes).max(axis=-1)
    sign = np.sign((shapes * expected.shapes).sum(axis=-1, keepdims=True))
    turned = np.abs(shapes * sign - expected.shapes).max(axis=-1) / size
    own["shape"] = np.where(alone, turned, 0.0).max(axis=1)
    return own, _of_equations(M, K, expected.eigenvalues, expected.shapes)


def _assert_statics_agree(given: Case, p: np.ndarray, found: dict[str, np.ndarray]) -> None:
    base = Generated(given.mechanism.model, given.parameters)
    torques, rotations = given.evaluation.statics(p)
    expected = {
        "static_torque": torques,
        "static_rotation": rotations,
        "platform_jacobian": base.platform_jacobian(p),
        "elastic_stiffness": base.elastic_hessian(p),
    }
    for name, values in expected.items():
        largest = np.abs(values).max(initial=0.0)
        np.testing.assert_allclose(found[name], values, rtol=0.0, atol=1e-13 * largest, err_msg=name)


def _assert_amplitudes_agree(
    given: Case, p: np.ndarray, found: dict[str, np.ndarray], momenta: np.ndarray
) -> None:
    """With the modes that were found, to the rounding of sums times the conditions of D_p and of springs."""
    linear, rigid = slice(len(given.mechanism.directions)), given.evaluation.rigid_modes
    parts = found["eigenvalues"], found["shapes"], found["platform_shapes"][..., linear]
    expected = step_amplitudes(*parts, momenta[..., linear])[:, rigid:]
    size = step_amplitudes(parts[0], np.abs(parts[1]), parts[2], np.abs(momenta[..., linear]))[:, rigid:]
    amplitudes = found["vibration_amplitudes"]
    assert np.isnan(amplitudes[:, :rigid]).all()
    assert (np.abs(amplitudes[:, rigid:] - expected) <= 1e-11 * size).all()


def _of_equations(M: np.ndarray, K: np.ndarray, eigenvalues: np.ndarray, shapes: np.ndarray) -> Errors:
    """Return the errors of phi^T M phi = 1 and of K phi = lambda M phi."""
    diagonal = np.diagonal(M, axis1=1, axis2=2)
    scale = 1 / np.sqrt(np.where(diagonal > 0, diagonal, 1))
    orthogonal = np.abs(shapes @ M @ np.swapaxes(shapes, -1, -2) - np.eye(shapes.shape[1]))
    residual = np.abs((shapes @ K - eigenvalues[..., None] * (shapes @ M)) * scale[:, None])
    stiffest = np.abs(K * scale[:, None] * scale[:, :, None]).max(axis=(1, 2))
    return {"orthogonality": orthogonal.max(axis=(1, 2)), "residual": residual.max(axis=(1, 2)) / stiffest}
