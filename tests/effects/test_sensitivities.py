"""Exact sensitivities along every parameter path, compared with differences and complex steps.

The references are in `sensitivity_references`; every robot of `CASES` is tested at generic poses, and one of each
kind with repeated modes, nearly equal modes, or a coordinate without inertia.
"""

from __future__ import annotations

from functools import cache

import numpy as np
import pytest
from mpmath import cholesky, eigsy, matrix, mpf, workdps

import pkmodes
from pkmodes.evaluation import SystemOfEffects
from pkmodes.robot.paths import ParameterPath, moved, paths, resolve
from pkmodes.robot.robot import Robot
from pkmodes.sensitivity.matrices import MatrixDerivatives
from pkmodes.sensitivity.sensitivities import TOGETHER, Sensitivities
from pkmodes_generated.linear_delta import extended
from sample_robots import published, random_robot, tower_printer
from sensitivity_references import (
    AHEAD,
    CENTRAL,
    JOINTS,
    Rates,
    ahead,
    at_poses,
    by_complex_steps,
    by_differences,
    eigenvalues,
    is_locked,
    robot_of,
    size,
)

Array = np.ndarray

#: All effects, with sizes that change every frequency and make no two of them equal by chance.
LARGE = {
    "payload.mass": 0.35,
    "belt_mass.linear_density": 0.06,
    "gearbox_inertia.inertia": 2e-4,
    "servo_stiffness.stiffness": 500.0,
    "belt_end_compliance.compliance": 1e-6,
    "axis_belt_stiffness.factor_1": 0.05,
    "axis_belt_stiffness.factor_2": -0.1,
    "axis_belt_stiffness.factor_3": 0.02,
    "belt_tension_stiffness.coefficient": 0.005,
    "belt_tension_stiffness.tension": 30.0,
    "cable_stiffness.stiffness": 1e3,
    "gearbox_compliance.compliance": 1e-3,
    "link_compliance.compliance": 1e-7,
    "clamp_compliance.compliance": 1e-6,
    "frame_compliance.compliance": 1e-7,
    "frame_compliance.mass": 40.0,
}
#: The same for the small printer, whose axes stay identical: at its centre it keeps its repeated eigenvalues.
SMALL = {
    "payload.mass": 0.1,
    "belt_mass.linear_density": 0.02,
    "gearbox_inertia.inertia": 1e-6,
    "servo_stiffness.stiffness": 1.0,
    "belt_end_compliance.compliance": 1e-5,
    "axis_belt_stiffness.factor_1": 0.05,
    "axis_belt_stiffness.factor_2": 0.05,
    "axis_belt_stiffness.factor_3": 0.05,
    "belt_tension_stiffness.coefficient": 0.005,
    "belt_tension_stiffness.tension": 20.0,
    "cable_stiffness.stiffness": 1e3,
    "gearbox_compliance.compliance": 0.5,
    "link_compliance.compliance": 1e-6,
    "clamp_compliance.compliance": 1e-5,
    "frame_compliance.compliance": 1e-5,
    "frame_compliance.mass": 4.0,
}
CLAMP = "clamp_compliance.compliance"
GENERIC, MIRROR, CENTRE, ASIDE = (
    [0.6, 0.03, -0.245],
    [0.62, 0.0, -0.245],
    [0.0, 0.0, 0.1],
    [0.05, -0.03, 0.17],
)
#: Found by search: two frequencies within a few parts in ten thousand of each other.
CROSSING = {"published": [0.579, 0.047, -0.279], "published-active": [0.638, 0.028, -0.263]}
CASES = [f"{robot}{kind}" for robot in ("published", "tower", "random") for kind in ("", "-active", "-clamp")]


class Case:
    """A robot with its poses, its sensitivities and its modes."""

    def __init__(self, name: str) -> None:
        kind, _, detail = name.partition("-")
        if kind == "random":
            parameters, pose = random_robot(np.random.default_rng(12))
            poses = [pose]
        elif kind == "tower":
            parameters, poses = tower_printer().parameters, [CENTRE, ASIDE]
        else:
            parameters, poses = published().parameters, [GENERIC, MIRROR]
            poses += [CROSSING[name]] if name in CROSSING else []
        self.typical = SMALL if kind == "tower" else LARGE
        effects = {"": {}, "active": self.typical, "clamp": {CLAMP: self.typical[CLAMP]}}[detail]
        self.robot, self.poses = robot_of(parameters, effects), np.array(poses)
        self.names = [p for p in paths(self.robot) if p != "axis.joint_radius" or parameters.joint.any()]
        self.moves = [resolve(self.robot, path) for path in self.names]
        self.sizes = np.array([size(self.robot, move, self.typical) for move in self.moves])
        self.found: Sensitivities = pkmodes.Model(self.robot).sensitivities(self.poses, self.names)
        self.here = at_poses(self.robot, self.poses, self.found.groups)


@cache
def case(name: str) -> Case:
    return Case(name)


def system_of(robot: Robot) -> SystemOfEffects:
    return SystemOfEffects.of(robot)


def assert_matrices(case: Case, i: int, t: slice, expected: Rates, relative: float, rounding: Array) -> None:
    """Scale the coordinates so that all entries of K, and of M times the largest eigenvalue, are of order one."""
    pose, found = case.here[i], case.found
    unit = np.outer(pose.scale, pose.scale)
    locked = np.array([is_locked(case.robot, move) for move in case.moves[t]])
    largest = np.abs(pose.eigenvalues).max()
    for values, reference, factor in (
        (found.mass_matrix[i, t], expected.M, largest),
        (found.stiffness_matrix[i, t], expected.K, 1.0),
    ):
        assert np.isnan(values[locked]).all()
        error = (np.abs(values - reference) * unit * factor)[~locked].max(axis=(1, 2), initial=0.0)
        scale = (np.abs(reference) * unit * factor)[~locked].max(axis=(1, 2), initial=0.0)
        assert_small(error, relative * scale + rounding[~locked], "matrices")


def assert_modes(case: Case, i: int, t: slice, expected: Rates, relative: float, rounding: Array) -> None:
    """Compare errors with each mode's derivative and, below it, with rounding of the largest eigenvalue.

    Rounding of shapes is amplified by their condition number, the largest eigenvalue over the gap.
    """
    pose, found = case.here[i], case.found
    floor = (rounding * expected.largest)[:, None]
    error = np.abs(found.eigenvalues[i, t] - expected.eigenvalues)
    paths = case.names[t]
    assert_small(error, relative * np.abs(expected.eigenvalues) + floor, "eigenvalues", paths)
    error, scale, shape = (
        np.abs(s / pose.scale).max(axis=-1)
        for s in (found.shapes[i, t] - expected.shapes, expected.shapes, pose.shapes)
    )
    assert_small(error, relative * scale + 100 * floor / pose.gaps * shape, "shapes", paths)


def assert_small(error: Array, bound: Array, what: str, rows: list[str] | None = None) -> None:
    bad = np.argwhere(~(error <= bound))
    assert not len(bad), (
        what,
        bad,
        [rows[i[0]] for i in bad if rows],
        error[tuple(bad[0])],
        bound[tuple(bad[0])],
    )


@pytest.mark.parametrize("name", CASES)
def test_derivatives_equal_complex_steps(name: str) -> None:
    it = case(name)
    for i, pose in enumerate(it.here):
        expected = by_complex_steps(pose, it.moves, it.sizes)
        assert_matrices(it, i, slice(None), expected, 1e-11, 1e-14 / it.sizes)
        assert_modes(it, i, slice(None), expected, 1e-8, 1e-14 / it.sizes)


@pytest.mark.parametrize("name", CASES)
def test_derivatives_equal_differences_of_the_modes(name: str) -> None:
    """Steps are small compared with the smallest gap, so truncation stays below a millionth."""
    it = case(name)
    gap = min((pose.gaps[3:] / np.abs(pose.eigenvalues[3:])).min() for pose in it.here)
    for t, (move, scale) in enumerate(zip(it.moves, it.sizes, strict=True)):
        at, step, stencil = slice(t, t + 1), min(1e-5, 0.01 * gap) * scale, CENTRAL
        if is_locked(it.robot, move):
            step, stencil = min(ahead(pose, move) for pose in it.here), AHEAD
        elif move.path == "effects.belt_mass.linear_density" and name.endswith("-clamp"):
            # It adds the modes of the clamps: far away, but not so far that their rounding dominates.
            step, stencil = (
                2e-3 * it.robot.parameters.pulley_inertia[0] / it.robot.parameters.pulley_radius[0] ** 2,
                AHEAD,
            )
        for i, expected in enumerate(by_differences(it.here, move, step, stencil)):
            rounding = np.array([1e-14 / step])
            assert_matrices(it, i, at, expected, 1e-6, rounding)
            assert_modes(it, i, at, expected, 1e-6, rounding)


@pytest.mark.parametrize("name", CASES)
def test_frequencies_follow_from_their_definition(name: str) -> None:
    it = case(name)
    for i, pose in enumerate(it.here):
        f = np.sqrt(np.abs(pose.eigenvalues)) / (2 * np.pi)
        still = np.abs(pose.eigenvalues) < 1e-12 * np.abs(pose.eigenvalues).max()
        assert still.sum() == (name in ("published", "published-clamp", "tower", "tower-clamp")), (
            "a mode at 0 Hz"
        )
        expected = it.found.eigenvalues[i] / np.where(still, np.nan, 8 * np.pi**2 * f)
        np.testing.assert_allclose(it.found.frequencies[i], expected, rtol=1e-12)


def test_frequencies_of_unstable_modes_are_negative_and_so_differentiated() -> None:
    it = case("random")
    gravity = [
        (resolve(it.robot, f"gravity.{x}"), -2 * it.robot.parameters.gravity[k]) for k, x in enumerate("xyz")
    ]
    signs = set()
    for robot in (it.robot, moved(it.robot, gravity)):
        model, mass = pkmodes.Model(robot), resolve(robot, "platform.mass")
        f = model.modes(it.poses).frequencies[0]
        difference = sum(
            weight
            / 1e-2
            * pkmodes.Model(moved(robot, [(mass, multiple * 1e-2)])).modes(it.poses).frequencies[0]
            for multiple, weight in CENTRAL.items()
        )
        found = model.sensitivities(it.poses, ["platform.mass"]).frequencies[0, 0]
        np.testing.assert_allclose(found, difference, rtol=1e-6)
        signs |= set(np.sign(f))
    assert signs == {-1.0, 1.0}


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
            robot = moved(it.robot, [(move, multiple * step)])
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
    poses = np.zeros((TOGETHER + 1, 3)) + np.linspace(0.05, 0.2, TOGETHER + 1)[:, None] * [0.0, 0.0, 1.0]
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


@pytest.mark.parametrize("name", CASES)
def test_eigenvalues_alone_are_those_of_the_whole(name: str) -> None:
    it = case(name)
    derivatives = MatrixDerivatives(system_of(it.robot), it.poses, [it.moves])
    values, shapes = (
        np.array([getattr(pose, field) for pose in it.here]) for field in ("eigenvalues", "shapes")
    )
    found = np.swapaxes(derivatives.eigenvalues(values, shapes), 1, 2)
    for i, pose in enumerate(it.here):
        floor = 1e-14 * np.abs(pose.eigenvalues).max() / it.sizes
        for members in pose.members:
            a, b = found[i][:, members], it.found.eigenvalues[i][:, members]
            # In a group they are along its basis: only their sum equals that of the branches.
            error = np.abs(a.sum(axis=1) - b.sum(axis=1))
            assert_small(error, 1e-9 * np.abs(b).max(axis=1) + 2 * floor, "sums")


@pytest.mark.parametrize("name", ["random", "random-active", "published-clamp"])
def test_moving_all_joints_is_moving_the_platform(name: str) -> None:
    it, step = case(name), 1e-5
    for k in range(3):
        shift = ParameterPath("pose", 0.0, "m", {("joint", (j, k)): 1.0 for j in range(3)})
        derivatives = MatrixDerivatives(system_of(it.robot), it.poses[:1], [[shift]])
        pose = it.here[0]
        found = derivatives.eigenvalues(pose.eigenvalues[None], pose.shapes[None])[0, :, 0]
        unit, difference = np.eye(3)[k], np.zeros(len(found))
        for multiple, weight in CENTRAL.items():
            at = it.poses[0] + multiple * step * unit
            difference += weight / step * eigenvalues(pkmodes.Model(it.robot).modes(at).frequencies)
        floor = 1e-14 * np.abs(pose.eigenvalues).max() / step
        assert_small(np.abs(found - difference), 1e-7 * np.abs(difference) + floor, "shift")


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
    """The compliance of a locked joint lowers or keeps every elastic eigenvalue: the rate is -|B phi|^2."""
    for name in ("published", "tower", "random"):
        it = case(name)
        locked = [t for t, move in enumerate(it.moves) if is_locked(it.robot, move)]
        assert (it.found.eigenvalues[:, locked] <= 0.0).all()


def same(a: Sensitivities, b: Sensitivities, i: object, j: object) -> None:
    for field in ("mass_matrix", "stiffness_matrix", "eigenvalues", "frequencies", "shapes", "groups"):
        x, y = getattr(a, field)[i], getattr(b, field)[j]
        np.testing.assert_allclose(x, y, rtol=1e-9, atol=1e-9 * np.nanmax(np.abs(x)) if x.size else 0.0)


def test_results_have_the_shape_of_the_poses() -> None:
    it = case("published-active")
    model, names = pkmodes.Model(it.robot), it.names[:5]
    one = model.sensitivities(GENERIC, names)
    assert one.mass_matrix.shape == one.stiffness_matrix.shape == (5, 21, 21)
    assert one.eigenvalues.shape == one.frequencies.shape == (5, 21)
    assert one.shapes.shape == (5, 21, 21)
    assert one.groups.shape == (21,)
    assert one.valid.shape == ()
    grid = np.array(GENERIC) + np.array([[0.0, 0.01, 0.02], [0.03, 0.04, 0.05]])[..., None] * [1.0, 0.2, 0.1]
    many = model.sensitivities(grid, names)
    assert many.shapes.shape == (2, 3, 5, 21, 21)
    assert many.groups.shape == (2, 3, 21)
    assert many.valid.tolist() == [[True] * 3] * 2
    same(many, one, (0, 0), ())
    same(many, model.sensitivities(grid[1, 2], names), (1, 2), ())
    same(many, model.sensitivities(grid.reshape(6, 3), names), (1,), slice(3, 6))


def test_bad_poses_are_refused_or_nan() -> None:
    model = pkmodes.Model(case("published").robot)
    found = model.sensitivities([GENERIC, [9.0, 9.0, 9.0], GENERIC], ["link.mass"], on_error="nan")
    assert found.valid.tolist() == [True, False, True]
    assert (found.groups[1] == -1).all()
    for field in ("mass_matrix", "stiffness_matrix", "eigenvalues", "frequencies", "shapes"):
        assert np.isnan(getattr(found, field)[1]).all()
    same(found, model.sensitivities(GENERIC, ["link.mass"]), 2, ())
    none = model.sensitivities([[9.0, 9.0, 9.0]], ["link.mass"], on_error="nan")
    assert none.shapes.shape == (1, 1, 9, 9)
    assert np.isnan(none.shapes).all()
    with pytest.raises(pkmodes.PoseError, match="out of reach"):
        model.sensitivities([GENERIC, [9.0, 9.0, 9.0]])
    with pytest.raises(pkmodes.PoseError, match="at least one pose"):
        model.sensitivities(np.zeros((0, 3)))


def test_no_parameters_give_arrays_without_any() -> None:
    found = pkmodes.Model(case("published").robot).sensitivities([GENERIC], [])
    assert found.parameters == found.units == ()
    assert found.values.shape == (0,)
    assert found.mass_matrix.shape == found.stiffness_matrix.shape == found.shapes.shape == (1, 0, 9, 9)
    assert found.eigenvalues.shape == found.frequencies.shape == (1, 0, 9)
    assert found.groups.tolist() == [list(range(9))]


def test_a_mass_matrix_that_cannot_be_solved_is_named_as_modes_name_it() -> None:
    parameters = published().parameters._replace(carriage_mass=np.zeros(3), link_mass=np.zeros(3))
    robot = robot_of(parameters, {"link_compliance.compliance": 1e-7})
    for ask in ("modes", "sensitivities"):
        with pytest.raises(pkmodes.PoseError, match="mass matrix is not positive definite"):
            getattr(pkmodes.Model(robot), ask)(GENERIC)


@pytest.mark.parametrize("close", [-1e-3, 1.0, float("nan"), "1e-6", None])
def test_a_bad_fraction_is_refused(close: object) -> None:
    with pytest.raises(pkmodes.PkmodesError, match="expected a fraction below 1"):
        pkmodes.Model(case("published").robot).sensitivities(GENERIC, [], close=close)
