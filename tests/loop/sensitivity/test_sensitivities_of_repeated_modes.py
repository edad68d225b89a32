"""Sensitivities of modes whose eigenvalues are equal or nearly so: groups, their branches and their shapes."""

from __future__ import annotations

import numpy as np
import pytest

import pkmodes
from helpers.references.sensitivity_references import AHEAD, eigenvalues
from helpers.robots.sensitivity_cases import CROSSING, assert_small, case
from pkmodes.loop.sensitivity.paths import change_quantities
from pkmodes.loop.sensitivity.sensitivities import POSES_PER_PART


@pytest.mark.parametrize("name", CROSSING)
def test_modes_that_nearly_meet_are_apart(name: str) -> None:
    it = case(name)
    f = np.sqrt(np.abs(it.here[-1].eigenvalues))
    gap = np.diff(f)[3:] / f[4:]
    assert 1e-4 < gap.min() < 1e-3
    assert it.found.groups[-1].tolist() == list(range(len(f)))


@pytest.mark.parametrize(
    ("name", "singles", "pairs"), [("tower", 3, 3), ("tower-clamp", 3, 3), ("tower-active", 7, 7)]
)
def test_threefold_symmetry_makes_pairs(name: str, singles: int, pairs: int) -> None:
    """Three equal axes give one mode that is equal on all axes and a pair; so do u_z, and u_x with u_y."""
    centre, aside = case(name).found.groups
    sizes = np.bincount(centre)
    assert sorted(sizes) == [1] * singles + [2] * pairs
    assert aside.tolist() == list(range(len(aside)))


@pytest.mark.parametrize("name", ["tower", "tower-active"])
def test_a_group_splits_into_the_branches_that_sorting_shows(name: str) -> None:
    """For larger parameter values the sorted eigenvalues leave the repeated one with ascending derivatives."""
    it, pose = case(name), case(name).here[0]
    split = 0
    for t, (move, scale) in enumerate(zip(it.moves, it.sizes, strict=True)):
        if move.value == 0.0:  # of effects: their one-sided differences are above
            continue
        step, difference = 2e-6 * scale, np.zeros(len(pose.eigenvalues))
        for multiple, weight in AHEAD.items():
            robot = change_quantities(it.robot, [(move, multiple * step)])
            difference += weight / step * eigenvalues(pkmodes.Model(robot).modes(it.poses[0]).frequencies)
        error = np.abs(it.found.eigenvalues[0, t] - difference)
        floor = 1e-14 * np.abs(pose.eigenvalues).max() / step
        assert_small(error, 1e-6 * np.abs(difference) + floor, move.path)
        split += any(
            np.ptp(it.found.eigenvalues[0, t, m]) > 1e-3 * np.abs(pose.eigenvalues[m[0]]) / scale
            for m in pose.members
            if len(m) > 1
        )
    assert split > 30


@pytest.mark.parametrize("name", CROSSING)
def test_modes_may_be_grouped_though_they_are_apart(name: str) -> None:
    """Determined for the group are the mean of its eigenvalues and the change of shapes out of the group."""
    it, pose = case(name), case(name).here[-1]
    close = pkmodes.Model(it.robot).sensitivities(it.poses[-1], it.names, close=2e-3)
    apart_values, apart_shapes = it.found.eigenvalues[-1], it.found.shapes[-1]
    (number,) = np.flatnonzero(np.bincount(close.groups) == 2)
    members = np.flatnonzero(close.groups == number)
    others = np.flatnonzero(close.groups != number)
    np.testing.assert_allclose(close.eigenvalues[:, others], apart_values[:, others], rtol=1e-12, atol=0)
    error = np.abs((close.shapes - apart_shapes)[:, others] / pose.scale).max(axis=-1)
    scale = np.abs(apart_shapes[:, others] / pose.scale).max(axis=-1)
    assert_small(error, 1e-8 * scale + 1e-9 / it.sizes[:, None], "shapes of others")
    size = np.abs(apart_values[:, members]).sum(axis=1)
    difference = np.abs(close.eigenvalues[:, members].sum(axis=1) - apart_values[:, members].sum(axis=1))
    assert (difference <= 1e-11 * size).all()
    assert (np.diff(close.eigenvalues[:, members]) >= 0.0).all()
    phi = pose.shapes[members]
    outside = apart_shapes[:, members] - apart_shapes[:, members] @ pose.M @ phi.T @ phi
    own = np.einsum("tgi,ij,gj->tg", apart_shapes[:, members], pose.M, phi)
    expected = outside + own[..., None] * phi
    scale = np.abs(apart_shapes[:, members] / pose.scale).max(axis=(1, 2))
    error = np.abs((close.shapes[:, members] - expected) / pose.scale).max(axis=(1, 2))
    assert_small(error, 1e-8 * scale + 1e-12 * np.abs(phi / pose.scale).max() / it.sizes, "shapes")


@pytest.mark.parametrize("name", ["tower", "tower-active"])
def test_shapes_of_a_group_belong_to_those_of_modes(name: str) -> None:
    """Repeated modes have an arbitrary basis, but the same one for modes and sensitivities."""
    robot, wanted = case(name).robot, ["platform.mass", "axis.1.link.length"]
    poses = np.zeros((POSES_PER_PART + 1, 3)) + np.linspace(0.05, 0.2, POSES_PER_PART + 1)[:, None] * [
        0.0,
        0.0,
        1.0,
    ]
    model = pkmodes.Model(robot)
    modes, found = model.modes(poses), model.sensitivities(poses, wanted)
    for i in range(len(poses)):
        M, phi, scale = modes.mass_matrix[i], modes.shapes[i], np.sqrt(np.diagonal(modes.mass_matrix[i]))
        inner = phi @ M @ np.swapaxes(found.shapes[i], -1, -2)  # (T, j, i)
        norms = -0.5 * np.einsum("ia,tab,ib->ti", phi, found.mass_matrix[i], phi)
        size = np.abs(found.shapes[i] * scale).max(axis=(-1, -2))
        for t in range(len(wanted)):
            same = found.groups[i][:, None] == found.groups[i]
            np.testing.assert_allclose(inner[t][same], np.diag(norms[t])[same], rtol=0, atol=1e-9 * size[t])
