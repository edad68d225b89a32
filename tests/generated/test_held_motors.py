"""Modes with held motors: against rigs with locked rotors, stiff servos, and the zeros of a free drive."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any

import numpy as np
import pytest
from scipy.linalg import eigvals

import pkmodes
from helpers.robots.one_of_each import FILES, POSES, ROBOTS, load_free
from pkmodes_rig import true_modes
from pkmodes_rig.corexy import corexy
from pkmodes_rig.rotary_delta import rotary_delta

RIGS: dict[str, Any] = {"linear_delta": true_modes, "rotary_delta": rotary_delta, "corexy": corexy}
FRAME = {"frame_compliance.compliance": 1e-7, "frame_compliance.mass": 50.0}
WINDING = {"gearbox_compliance.compliance": 2e-3}
CASES: list[tuple[str, Mapping[str, float]]] = [
    *((mechanism, {}) for mechanism in FILES),
    *((mechanism, {"payload.mass": 0.2, "cable_stiffness.stiffness": 3e3, **FRAME}) for mechanism in FILES),
    *((mechanism, WINDING) for mechanism in ("linear_delta", "corexy")),
    *(
        (
            mechanism,
            {**WINDING, "gearbox_inertia.inertia": 2e-5, "clamp_compliance.compliance": 1e-6, **FRAME},
        )
        for mechanism in ("linear_delta", "corexy")
    ),
    ("linear_delta", {**WINDING, "belt_mass.linear_density": 0.03, "clamp_compliance.compliance": 1e-6}),
    ("rotary_delta", {"link_compliance.compliance": 1e-7, "axis_reducer_stiffness.factor_2": -0.2}),
]


def model_of(mechanism: str, effects: Mapping[str, float]) -> pkmodes.Model:
    plain = load_free(FILES[mechanism])
    values = {f"effects.{name}": value for name, value in effects.items() if name != "frame_compliance.mass"}
    if "frame_compliance.compliance" in effects:
        values["frame.mass"] = effects["frame_compliance.mass"]
    return plain.with_values(values)


@pytest.mark.parametrize("backend", ["numpy", pytest.param("compiled", marks=pytest.mark.compiler)])
@pytest.mark.parametrize(("mechanism", "effects"), CASES)
def test_modes_are_those_of_a_rig_with_locked_rotors(
    mechanism: str, effects: Mapping[str, float], backend: str
) -> None:
    model, p = model_of(mechanism, effects), POSES[mechanism]
    rig = RIGS[mechanism](model.robot.parameters, p, effects, held=True)
    modes = model.modes(p, drives="held", backend=backend)
    assert modes.drives == "held"
    assert modes.rigid_modes == rig.rigid == 0
    free = model.modes(p, backend=backend)
    assert len(free.frequencies) - len(modes.frequencies) == len(model.mechanism.drives)
    # Rounding of the rigs, at most 3e-12 here; of shapes, over the distance of their eigenvalues.
    assert modes.frequencies == pytest.approx(rig.frequencies, rel=1e-10)
    assert modes.coordinates == free.coordinates
    gaps = np.diff(modes.frequencies, prepend=0.0, append=np.inf) / modes.frequencies.max()
    for i in np.flatnonzero(np.minimum(gaps[:-1], gaps[1:]) > 1e-4):
        true = np.array([rig.shapes[name][i] if name in rig.shapes else 0.0 for name in modes.coordinates])
        sign = np.sign(true @ modes.shapes[i])
        assert modes.shapes[i] == pytest.approx(sign * true, abs=1e-10 * np.abs(true).max())
        moved = [rig.shapes[f"p_{axis}"][i] for axis in model.mechanism.directions]
        scale = np.abs(moved).max()
        assert modes.platform_shapes[i] == pytest.approx(sign * np.array(moved), abs=1e-10 * scale)


def motor_angles(model: pkmodes.Model) -> np.ndarray:
    """The angle of each motor per unit of each coordinate, as docs/model.md says, (drives, n)."""
    names, parameters = model.coordinates, model.robot.parameters
    if model.robot.mechanism_name == "linear_delta":
        driven = [f"theta_{j}_{np.argmax(drive) + 1}" for j, drive in enumerate(parameters.drive, 1)]
    else:
        driven = [q for q in names if q.startswith("phi_" if "phi_1" in names else "theta_")]
    return np.array(
        [[q == rotor or q == f"psi_{j}" for q in names] for j, rotor in enumerate(driven, 1)], float
    )


@pytest.mark.parametrize(("mechanism", "effects"), CASES[:8])
def test_held_frequencies_are_the_zeros_of_free_torques_to_motor_angles(
    mechanism: str, effects: Mapping[str, float]
) -> None:
    """At a zero, torques move the machine and no motor: the finite eigenvalues of a pencil with constraints."""
    model, p = model_of(mechanism, effects), POSES[mechanism]
    M, K = model.matrices(p)
    D = motor_angles(model)
    scale = 1.0 / np.sqrt(np.diag(M) + np.diag(K) / np.diag(K).max())
    M, K, D = M * np.outer(scale, scale), K * np.outer(scale, scale), D * scale
    none = np.zeros((len(D), len(D)))
    stiff = K.max()
    zeros = eigvals(np.block([[K / stiff, D.T], [D, none]]), np.block([[M, 0.0 * D.T], [0.0 * D, none]]))
    found = model.frequencies(p, drives="held")
    real = zeros[np.isfinite(zeros)].real * stiff
    near = np.sort(np.sqrt(np.abs(real)) / (2 * np.pi))
    for frequency in found[found < 2e3]:
        assert np.abs(near - frequency).min() < 1e-5 * frequency


@pytest.mark.parametrize("effects", [{}, WINDING])
@pytest.mark.parametrize("mechanism", ["linear_delta", "corexy"])
def test_a_servo_becomes_a_held_motor_as_its_stiffness_grows(
    mechanism: str, effects: Mapping[str, float]
) -> None:
    """The error falls as 1 / k.  It acts on the motor: with a gearbox that winds up, too."""
    p, held = POSES[mechanism], model_of(mechanism, effects).frequencies(POSES[mechanism], drives="held")
    lowest = held[:2]
    errors = []
    for stiffness in (1e4, 1e5, 1e6):
        model = model_of(mechanism, {**effects, "servo_stiffness.stiffness": stiffness})
        errors.append(lowest - model.frequencies(p)[:2])
        # A servo does not act on a motor that is held.
        assert model.frequencies(p, drives="held") == pytest.approx(held, rel=1e-12)
    first, second, third = errors
    assert (third > 0.0).all()
    assert first / second == pytest.approx(10.0, rel=0.05)
    assert second / third == pytest.approx(10.0, rel=0.05)


@pytest.mark.parametrize("effects", [{}, WINDING])
def test_the_inertia_of_a_held_motor_has_no_influence(effects: Mapping[str, float]) -> None:
    model, p = model_of("linear_delta", effects), POSES["linear_delta"]
    heavy = model.with_values({"motor.inertia": 3.0, "motor.gear_ratio": 7.0})
    np.testing.assert_array_equal(heavy.frequencies(p, drives="held"), model.frequencies(p, drives="held"))
    assert heavy.frequencies(p)[3] != model.frequencies(p)[3]


def test_matrices_are_those_of_all_coordinates_and_shapes_solve_them_but_for_the_torques_of_the_motors() -> (
    None
):
    model, p = model_of("linear_delta", WINDING), POSES["linear_delta"]
    modes, D = model.modes(p, drives="held"), motor_angles(model)
    np.testing.assert_array_equal(modes.mass_matrix, model.modes(p).mass_matrix)
    assert np.abs(modes.shapes @ D.T).max() < 1e-14 * np.abs(modes.shapes).max()
    gram = modes.shapes @ modes.mass_matrix @ modes.shapes.T
    np.testing.assert_allclose(gram, np.eye(len(gram)), atol=1e-12)
    forces = modes.shapes @ modes.stiffness_matrix
    for frequency, shape, force in zip(modes.frequencies, modes.shapes, forces, strict=True):
        left = force - (2 * np.pi * frequency) ** 2 * shape @ modes.mass_matrix
        torques = np.linalg.lstsq(D.T, left, rcond=None)[0]
        np.testing.assert_allclose(left, torques @ D, atol=1e-9 * np.abs(force).max())


@pytest.mark.parametrize("backend", ["numpy", pytest.param("compiled", marks=pytest.mark.compiler)])
def test_a_stiff_gearbox_is_none(backend: str) -> None:
    p = POSES["linear_delta"]
    rigid = model_of("linear_delta", {}).frequencies(p, drives="held", backend=backend)
    stiff = model_of("linear_delta", {"gearbox_compliance.compliance": 1e-13})
    found = stiff.frequencies(p, drives="held", backend=backend)
    assert found[: len(rigid)] == pytest.approx(rigid, rel=1e-9)
    assert len(found) == len(rigid) + 3


def test_a_batch_has_the_modes_of_its_poses_and_says_which_cannot_be_evaluated() -> None:
    model, p = model_of("linear_delta", {}), POSES["linear_delta"]
    poses = np.stack([p, p + [9.0, 0.0, 0.0], p + [0.01, 0.0, 0.0]])
    modes = model.modes(poses, "nan", drives="held", backend="numpy")
    compiled = model.modes(poses, "nan", drives="held")
    assert modes.valid.tolist() == compiled.valid.tolist() == [True, False, True]
    assert np.isnan(compiled.shapes[1]).all()
    np.testing.assert_allclose(compiled.shapes, modes.shapes, atol=1e-9)
    np.testing.assert_allclose(compiled.frequencies[0], model.frequencies(p, drives="held"), rtol=1e-13)
    out = np.empty((3, 6))
    assert model.frequencies(poses, "nan", drives="held", out=out) is out


@pytest.mark.parametrize("drives", ["locked", True, "Held"])
def test_other_words_for_what_the_motors_do_are_refused(drives: object) -> None:
    with pytest.raises(pkmodes.PkmodesError, match=r'expected "free" or "held", found .* \(drives\)'):
        pkmodes.load(ROBOTS / FILES["corexy"]).frequencies([0.1, 0.1], drives=drives)
