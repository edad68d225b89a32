"""The software with effects against the virtual test rig, whose physics is MuJoCo's and shares no formula with it.

The rig takes M and K from bodies, joints and springs without differencing, so both sides must agree up to rounding.
Then the rig itself is tested: against `mujoco_engine`, the reference of the base model, against energies of displaced
robots, and for the response to causes outside the catalogue.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import replace
from functools import cache
from itertools import product

import numpy as np
import pytest

import pkmodes
from helpers.robots.dissipating import dissipating
from pkmodes.core.mechanism.registry import mechanism
from pkmodes_rig.engine import EFFECTS, OUTSIDE, Rig, TrueModes, true_modes
from pkmodes_rig.mujoco_engine import Engine
from pkmodes_rig.robots import POSES, ROBOTS, read

CATALOGUE = mechanism("linear_delta").effects

#: Entries of M and K relative to the roots of their diagonals.  Worst found: 3e-15.
EXACT = 1e-13

#: Frequencies, relative; for a rigid-body mode, squared and relative to the square of the first vibration mode.
#: Worst found: 8e-13; if some modes are much faster than the others, they set the rounding.
FREQUENCY = 1e-11

#: Strengths that change a frequency of the published robot by a few per cent; `adapted` to the other robots.
STRENGTHS: dict[str, dict[str, float]] = {
    "payload": {"mass": 0.25},
    "belt_mass": {"linear_density": 0.06},
    "gearbox_inertia": {"inertia": 2e-4},
    "servo_stiffness": {"stiffness": 40.0},
    "belt_end_compliance": {"compliance": 1e-6},
    "axis_belt_stiffness": {"factor_1": 0.1, "factor_2": -0.2, "factor_3": 0.05},
    "belt_tension_stiffness": {"coefficient": 0.005, "tension": 40.0},
    "cable_stiffness": {"stiffness": 5e4},
    "gearbox_compliance": {"compliance": 1e-3},
    "link_compliance": {"compliance": 2e-6},
    "clamp_compliance": {"compliance": 1e-6},
    "frame_compliance": {"compliance": 4e-8},
}
RELEASED = ("gearbox_compliance", "link_compliance", "clamp_compliance", "frame_compliance")

#: Strengths of the causes outside the catalogue.
STRANGE = {
    "tuned_absorber": 0.05,
    "directional_cable": 5e4,
    "hose": 5e4,
    "worn_belt": 0.3,
    "bellows": 2e4,
    "rocking_frame": 1e-6,
    "rod_taper": 0.9,
    "one_gearbox": 1e-3,
    "one_servo": 40.0,
    "one_span": 3e-6,
    "leaning_frame": 4e-8,
    "pulley_mount": 2e-6,
}

CASES = [(robot, pose) for robot in ROBOTS for pose in (0, 6)]
robots_and_poses = pytest.mark.parametrize(("robot", "pose"), CASES)


def adapted(robot: str, strengths: Mapping[str, float]) -> dict[str, float]:
    """Scale strengths on rotations by the pulley radius, that is by their action on the belt."""
    ratio = (read(robot).parameters.pulley_radius[0] / read("published").parameters.pulley_radius[0]) ** 2
    by = {
        "gearbox_inertia.inertia": ratio,
        "servo_stiffness.stiffness": ratio,
        "gearbox_compliance.compliance": 1 / ratio,
        "one_gearbox": 1 / ratio,
        "one_servo": ratio,
    }
    return {name: value * by.get(name, 1.0) for name, value in strengths.items()}


def chosen(robot: str, *names: str) -> dict[str, float]:
    strengths = {f"{name}.{key}": value for name in names for key, value in STRENGTHS[name].items()}
    return adapted(robot, strengths)


def place(robot: str, pose: int) -> np.ndarray:
    return POSES[robot]["scattered"][pose]


@cache
def both(robot: str, pose: int, names: tuple[str, ...]) -> tuple[pkmodes.Modes, TrueModes]:
    """Evaluate a robot file with these effects by the software and by the rig."""
    declared = read(robot, chosen(robot, *names))
    found = pkmodes.Model(declared).modes(place(robot, pose))
    return found, true_modes(declared.parameters, place(robot, pose), declared.effects)


def assert_equal(found: np.ndarray, expected: np.ndarray, tolerance: float = EXACT) -> None:
    """Compare symmetric matrices with mixed units: each entry relative to the roots of its diagonal entries."""
    size = np.sqrt(np.abs(np.diag(expected)))
    scale = np.outer(size, size)
    rest = scale == 0  # a coordinate without inertia has no coupling inertia either
    assert not np.any(found[rest])
    assert not np.any(expected[rest])
    error = np.abs(found - expected)[~rest] / scale[~rest]
    assert error.max() < tolerance, f"{error.max():.1e} of the diagonal"


def assert_same_modes(found: pkmodes.Modes, expected: TrueModes) -> None:
    assert found.rigid_modes == expected.rigid
    f, true = found.frequencies, expected.frequencies
    assert f.shape == true.shape
    np.testing.assert_allclose(f[3:], true[3:], rtol=FREQUENCY)
    np.testing.assert_allclose(
        f[:3] * abs(f[:3]), true[:3] * abs(true[:3]), rtol=0, atol=FREQUENCY * f[3] ** 2
    )
    shapes = np.concatenate([found.shapes, found.platform_shapes], axis=1)[3:]
    names = *found.coordinates, "p_x", "p_y", "p_z"
    components = np.array([expected.shapes[name] for name in names]).T[3:]
    # Shapes of close modes mix by their rounding over their distance.
    gaps = np.diff(true, prepend=-np.inf, append=np.inf)
    nearest = np.minimum(gaps[:-1], gaps[1:])[3:] / true[3:]
    for shape, other, gap in zip(shapes, components, np.minimum(nearest, 1.0), strict=True):
        sign = np.sign(shape @ other)
        assert np.abs(shape - sign * other).max() < 10 * FREQUENCY / gap * np.abs(other).max()


def test_every_effect_that_moves_frequencies_has_a_strength_here() -> None:
    moving = CATALOGUE.keys() - set(dissipating("linear_delta"))
    assert {path.split(".")[0] for path in EFFECTS} == STRENGTHS.keys() == moving
    assert OUTSIDE.keys() == {*STRANGE, "thermal_drift"}


# The software ------------------------------------------------------------------------------------------------


def test_each_effect_alone(subtests: pytest.Subtests) -> None:
    for name, (robot, pose) in product([None, *STRENGTHS], CASES):
        with subtests.test(f"{name}, {robot}, {pose}"):
            found, expected = both(robot, pose, (name,) if name else ())
            assert found.coordinates == expected.coordinates
            assert_equal(found.mass_matrix, expected.mass_matrix)
            assert_equal(found.stiffness_matrix, expected.stiffness_matrix)
            assert_same_modes(found, expected)
            if name:  # at a strength that changes the result noticeably
                without = both(robot, pose, ())[1]
                assert np.abs(expected.frequencies[3:9] / without.frequencies[3:9] - 1).max() > 5e-3


def test_all_effects_together(subtests: pytest.Subtests) -> None:
    for robot, pose in CASES:
        with subtests.test(f"{robot}, {pose}"):
            found, expected = both(robot, pose, tuple(STRENGTHS))
            assert found.coordinates == expected.coordinates
            assert len(expected.coordinates) == 21
            assert_equal(found.mass_matrix, expected.mass_matrix)
            assert_equal(found.stiffness_matrix, expected.stiffness_matrix)
            assert_same_modes(found, expected)


def test_some_effects_together(subtests: pytest.Subtests) -> None:
    for seed in range(12):
        with subtests.test(seed=seed):
            rng = np.random.default_rng(seed)
            names = tuple(name for name in STRENGTHS if rng.random() < (0.7 if name in RELEASED else 0.4))
            found, expected = both(list(ROBOTS)[seed % 3], int(rng.integers(12)), names)
            assert found.coordinates == expected.coordinates
            assert_equal(found.mass_matrix, expected.mass_matrix)
            assert_equal(found.stiffness_matrix, expected.stiffness_matrix)
            assert_same_modes(found, expected)


@robots_and_poses
@pytest.mark.parametrize("names", [("link_compliance",), ("frame_compliance",), RELEASED], ids="+".join)
def test_weight_takes_part_in_what_is_released(robot: str, pose: int, names: tuple[str, ...]) -> None:
    """Compare the weights' stiffness alone: next to the springs its errors would not show."""
    declared = read(robot, chosen(robot, *names))
    rig = Rig(declared.parameters, place(robot, pose), declared.effects)
    lifted = declared.parameters._replace(gravity=np.zeros(3))
    weightless = pkmodes.Model(replace(declared, parameters=lifted)).modes(place(robot, pose))
    found = both(robot, pose, names)[0].stiffness_matrix - weightless.stiffness_matrix
    expected = rig.weight_hessian()
    # The difference leaves rounding of the springs' stiffness.
    size = np.sqrt(np.diag(weightless.stiffness_matrix))
    assert np.all(np.abs(found - expected) < 1e-14 * np.outer(size, size) + 1e-12 * np.abs(expected).max())


# The rig -----------------------------------------------------------------------------------------------------


def test_without_effects_the_rig_is_the_engine_of_the_base_model(subtests: pytest.Subtests) -> None:
    for robot, pose in CASES:
        with subtests.test(f"{robot}, {pose}"):
            parameters, p = read(robot).parameters, place(robot, pose)
            engine, rig = Engine(parameters, p), true_modes(parameters, p)
            belt = np.concatenate([np.ones(3), np.tile(1 / parameters.pulley_radius, 2)])
            assert_equal(rig.mass_matrix, engine.mass_matrix())
            K = engine.hessian(0.007 * engine.length_scale() * belt)
            assert_equal(rig.stiffness_matrix, K, 1e-11)
            gravity = rig.stiffness_matrix - Rig(parameters, p).elastic_stiffness()
            with engine.without_belts():
                expected = engine.hessian(0.007 * engine.length_scale() * belt)
            assert np.abs(gravity - expected).max() < 1e-10 * np.abs(expected).max()  # differences of forces


@robots_and_poses
def test_the_rigs_weights_by_energies_of_the_displaced_robot(robot: str, pose: int) -> None:
    """Compare the Hessian, computed without differences, with its definition by differences of the energy."""
    parameters = read(robot).parameters
    rig = Rig(parameters, place(robot, pose), chosen(robot, *STRENGTHS), adapted(robot, STRANGE))
    H, here = rig.weight_hessian(), rig.weight_energy()
    size = np.array([0.1 if name == "rock" else 1.0 for name in rig.coordinates])
    size[[name.startswith(("theta", "psi", "mount")) for name in rig.coordinates]] = 0.0
    rng = np.random.default_rng(pose)
    h = 0.012 * parameters.link_length.min()
    for _ in range(6):
        direction = rng.normal(size=len(size)) * size
        direction /= np.linalg.norm(direction)
        curvature = 0.0
        for k, weight in enumerate((8 / 5, -1 / 5, 8 / 315, -1 / 560), start=1):
            for sign in (1, -1):
                rig.move(sign * k * h * direction)
                curvature += weight * (rig.weight_energy() - here) / h**2
        assert curvature == pytest.approx(direction @ H @ direction, abs=1e-7 * np.abs(H).max())


@pytest.mark.parametrize("robot", ROBOTS)
@pytest.mark.parametrize("kind", STRANGE)
def test_what_is_outside_the_catalogue_shows_and_vanishes(robot: str, kind: str) -> None:
    parameters, p = read(robot).parameters, place(robot, 0)
    base = true_modes(parameters, p)
    absent = true_modes(parameters, p, {}, {kind: 0.0})
    np.testing.assert_array_equal(absent.frequencies, base.frequencies)
    strength = adapted(robot, STRANGE)[kind]
    present = true_modes(parameters, p, {}, {kind: strength})
    single = ("tuned_absorber", "rocking_frame", "leaning_frame", "one_gearbox")
    added = 3 if kind == "pulley_mount" else int(kind in single)
    assert len(present.frequencies) == 9 + added
    assert present.rigid == {"directional_cable": 2, "hose": 2, "one_servo": 2, "bellows": 0}.get(kind, 3)
    assert np.abs(present.frequencies[3:9] / base.frequencies[3:9] - 1).max() > 2e-3
    small = true_modes(parameters, p, {}, {kind: 1e-6 * strength})
    kept = small.frequencies[3:9]
    if kind == "tuned_absorber":  # remains, at its own frequency, and pairs with no mode
        place_of_it = int(np.argmin(np.abs(small.frequencies - 60.0)))
        kept = np.delete(small.frequencies, place_of_it)[3:9]
    np.testing.assert_allclose(kept, base.frequencies[3:9], rtol=2e-3 if kind == "tuned_absorber" else 1e-5)


def test_one_soft_gearbox_of_three_is_between_none_and_all() -> None:
    parameters, p = read("asymmetric").parameters, place("asymmetric", 0)
    c = STRANGE["one_gearbox"]
    all_three = true_modes(parameters, p, {"gearbox_compliance.compliance": c})
    one = true_modes(parameters, p, {}, {"one_gearbox": c})
    i = one.coordinates.index("psi_2")
    k = all_three.coordinates.index("psi_2")
    assert one.mass_matrix[i, i] == all_three.mass_matrix[k, k]
    assert one.stiffness_matrix[i, i] == all_three.stiffness_matrix[k, k] == pytest.approx(1 / c)


@pytest.mark.parametrize("name", ["payload.weight", "paylod.mass"])
def test_the_rig_refuses_what_it_does_not_know(name: str) -> None:
    with pytest.raises(ValueError, match=name):
        true_modes(read("tower").parameters, place("tower", 0), {name: 1.0})
