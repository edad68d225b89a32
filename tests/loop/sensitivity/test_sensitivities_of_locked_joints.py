"""Sensitivities by the compliances of joints: from zero, where the joint is locked, and without inertia."""

from __future__ import annotations

import numpy as np
import pytest
from mpmath import cholesky, eigsy, matrix, mpf, workdps

from helpers.references.sensitivity_references import JOINTS, is_locked
from helpers.robots.sensitivity_cases import CLAMP, Array, assert_small, case, system_of
from pkmodes_generated.linear_delta import extended


def test_a_massless_clamp_is_differentiated_with_its_condensed_coordinate() -> None:
    it = case("published-clamp")
    assert it.found.eigenvalues.shape[-1] == 9
    assert it.found.shapes.shape[-2:] == (9, 12)
    t = it.names.index(f"effects.{CLAMP}")
    elastic = it.found.eigenvalues[:, t, 3:]
    assert (elastic < 0.0).all(), "more compliance, lower frequencies"
    assert (np.abs(it.found.shapes[:, t, 3:, 9:]).max(axis=-1) > 0.0).all()


def test_a_joints_compliance_is_nan_in_the_matrices_only_while_it_is_locked() -> None:
    for name in ("published", "published-active", "published-clamp"):
        it = case(name)
        for t, move in enumerate(it.moves):
            locked = is_locked(it.robot, move)
            assert np.isnan(it.found.mass_matrix[:, t]).all() == locked
            assert np.isnan(it.found.stiffness_matrix[:, t]).any() == locked
            assert np.isfinite(it.found.eigenvalues[:, t]).all()
            assert np.isfinite(it.found.shapes[:, t]).all()
    assert sum(is_locked(case("published").robot, move) for move in case("published").moves) == len(JOINTS)


@pytest.mark.parametrize("joint", JOINTS)
@pytest.mark.parametrize("name", ["published", "tower", "random"])
def test_compliances_from_zero_equal_stiff_joints_in_high_precision(name: str, joint: str) -> None:
    """With 60 digits the joint can be so stiff that its compliance serves as a difference step."""
    it, i = case(name), len(case(name).here) - 1
    M, K = (whole[i] for whole in system_of(it.robot).all_coordinates(it.poses))
    kept = [*range(9), *(extended.COORDINATES.index(q) for q in JOINTS[joint])]
    c = 1e-15 * it.typical[joint]
    with workdps(60):
        values = [solved(M[np.ix_(kept, kept)], K[np.ix_(kept, kept)], multiple * c) for multiple in (1, 2)]
        values.insert(0, solved(M[:9, :9], K[:9, :9], 0.0))
        expected = [float((-3 * a + 4 * b - d) / (2 * mpf(c))) for a, b, d in zip(*values, strict=False)]
    found = it.found.eigenvalues[i, it.names.index(f"effects.{joint}")]
    floor = 1e-14 * np.abs(it.here[i].eigenvalues).max() / it.typical[joint]
    assert_small(np.abs(found - expected), 1e-8 * np.abs(expected) + floor, "eigenvalues")


def solved(M: Array, K: Array, compliance: float) -> list[mpf]:
    """Return ascending eigenvalues with a spring at the last three coordinates; their inertia is of second order."""
    a, b = matrix(M.tolist()), matrix(K.tolist())
    for r in range(9, len(M)):
        a[r, r] += 100
        b[r, r] += 1 / mpf(compliance)
    inverse = cholesky(a) ** -1
    return sorted(eigsy(inverse * b * inverse.T, eigvals_only=True))


def test_joints_only_soften() -> None:
    """The compliance of a locked joint lowers or keeps every elastic eigenvalue: the rate is -|B phi|^2.

    It is zero but for rounding where the mode does not strain the joint.
    """
    for name in ("published", "tower", "random"):
        it = case(name)
        locked = [t for t, move in enumerate(it.moves) if is_locked(it.robot, move)]
        rates = it.found.eigenvalues[:, locked]
        assert (rates <= 1e-16 * np.abs(rates).max(axis=-1, keepdims=True)).all()
