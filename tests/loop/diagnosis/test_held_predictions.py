"""Modes of a structure whose motors are held in some setups: those of the model, with derivatives by differences."""

from __future__ import annotations

import numpy as np
import pytest

import pkmodes
from helpers.diagnoses.robot_structures import declared, index, structure_at
from helpers.robots.one_of_each import FILES, ROBOTS
from pkmodes.loop.updating.robot_structure import RobotStructure

PLACES = {
    "linear_delta": [[0.55, 0.06, -0.26], [0.5, -0.05, -0.24], [0.71, -0.04, -0.25]],
    "rotary_delta": [[0.1, 0.05, -0.5], [0.02, -0.03, -0.55], [0.05, 0.02, -0.6]],
    "corexy": [[0.1, 0.05], [0.15, 0.2], [0.22, 0.11]],
}
DRIVES = (("held",) * 3, ("free", "held", "held"), ("held", "free", "held"))
BACKENDS = ["numpy", pytest.param("compiled", marks=pytest.mark.compiler)]


@pytest.fixture(params=BACKENDS)
def _backend(request: pytest.FixtureRequest, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setenv("PKMODES_BACKEND", request.param)


def structure(mechanism: str, drives: tuple[str, ...], **values: float) -> RobotStructure:
    robot = pkmodes.read_robot(ROBOTS / FILES[mechanism]).with_values(values)
    return structure_at(robot, PLACES[mechanism], drives=drives)


@pytest.mark.usefixtures("_backend")
@pytest.mark.parametrize("drives", DRIVES)
@pytest.mark.parametrize("mechanism", FILES)
def test_modes_are_those_of_the_model(mechanism: str, drives: tuple[str, ...]) -> None:
    one = structure(mechanism, drives)
    found = one.predict(declared(one), ())
    model = pkmodes.Model(one.robot)
    assert found.rigid == (0 if "free" not in drives else model.mechanism.rigid_modes)
    for k, word in enumerate(drives):
        modes = model.modes(PLACES[mechanism][k], drives=word)
        elastic = slice(found.rigid, found.rigid + len(modes.frequencies) - modes.rigid_modes)
        expected = (2 * np.pi * modes.frequencies[modes.rigid_modes :]) ** 2
        # Both solvers err by rounding of the largest eigenvalue.
        np.testing.assert_allclose(found.eigenvalues[k, elastic], expected, atol=1e-11 * expected[-1])
        places = [one.channels.index(name) for name in modes.coordinates]
        shapes = modes.shapes[modes.rigid_modes :]
        scale = np.abs(shapes).max()
        np.testing.assert_allclose(
            np.abs(found.shapes[k, elastic][:, places]), np.abs(shapes), atol=1e-7 * scale
        )
        moved = [one.channels.index(f"p_{name}") for name in model.mechanism.directions]
        shapes = modes.platform_shapes[modes.rigid_modes :]
        np.testing.assert_allclose(
            np.abs(found.shapes[k, elastic][:, moved]), np.abs(shapes), atol=1e-7 * np.abs(shapes).max()
        )


RELEASED = {
    "linear_delta": {"gearbox_compliance": 2e-3, "clamp_compliance": 1e-6, "link_compliance": 1e-7},
    "rotary_delta": {"link_compliance": 1e-7, "frame_compliance": 1e-7},
    "corexy": {"gearbox_compliance": 2e-3, "clamp_compliance": 1e-6, "frame_compliance": 1e-7},
}


@pytest.mark.usefixtures("_backend")
@pytest.mark.parametrize("drives", DRIVES[:2])
@pytest.mark.parametrize("released", [False, True])
@pytest.mark.parametrize("mechanism", FILES)
def test_derivatives_are_those_of_differences(
    mechanism: str, released: bool, drives: tuple[str, ...]
) -> None:
    compliances = RELEASED[mechanism] if released else {}
    given = {f"effects.{name}.compliance": value for name, value in compliances.items()}
    one = structure(mechanism, drives)
    values = np.array([given.get(p.name, p.value) for p in one.parameters])
    moving = [i for i, value in enumerate(values) if value != 0.0]
    first = one.predict(values, moving, shape_rates=True)
    along = np.asarray(first.shape_rates)
    elastic = (np.abs(first.eigenvalues) > 10.0) & (first.eigenvalues < 1e30)
    elastic[:, : first.rigid] = False
    # Modes that are nearly equal turn fast.
    gaps = np.minimum(
        *(
            np.diff(first.eigenvalues, axis=1, **{end: sign * np.inf})
            for end, sign in (("prepend", -1.0), ("append", 1.0))
        )
    )
    apart_enough = (np.abs(gaps) > 5e-3 * np.abs(first.eigenvalues))[elastic]
    size, scale = first.eigenvalues[elastic].max(), np.abs(first.shapes).max(axis=(0, 1)) + 1e-30
    for t, i in enumerate(moving):
        step = 1e-5 * values[i] * np.eye(len(values))[i]
        ahead, behind = one.predict(values + step, ()), one.predict(values - step, ())
        expected = ((ahead.eigenvalues - behind.eigenvalues) / 2e-5)[elastic]
        found, name = values[i] * first.rates[..., t][elastic], one.parameters[i].name
        # Curvature, which is large for modes that are nearly equal, and rounding of the largest eigenvalue.
        apart = np.abs(found - expected) - 1e-5 * np.abs(expected)
        assert (apart <= 1e-6 * first.eigenvalues[elastic] + 1e-10 * size).all(), name
        ahead_of, behind_of = (
            other.shapes * np.sign(np.sum(other.shapes * first.shapes, axis=-1))[..., None]
            for other in (ahead, behind)
        )
        turned = ((ahead_of - behind_of) / 2e-5 / scale)[elastic]
        found = (values[i] * along[..., t] / scale)[elastic]
        found, turned = found[apart_enough], turned[apart_enough]
        np.testing.assert_allclose(found, turned, atol=1e-3 * np.abs(turned).max() + 1e-4, err_msg=name)


@pytest.mark.usefixtures("_backend")
@pytest.mark.parametrize("drives", DRIVES[:2])
@pytest.mark.parametrize("mechanism", FILES)
def test_derivatives_by_an_absent_compliance_are_those_of_a_small_one(
    mechanism: str, drives: tuple[str, ...]
) -> None:
    one = structure(mechanism, drives)
    values = declared(one)
    for effect, compliance in RELEASED[mechanism].items():
        i, small = index(one, f"effects.{effect}.compliance"), 1e-3 * compliance
        first = one.predict(values, [i])
        elastic = (np.abs(first.eigenvalues) > 10.0) & (first.eigenvalues < 1e30)
        elastic[:, : first.rigid] = False
        two = [one.predict(values + k * small * np.eye(len(values))[i], ()).eigenvalues for k in (1, 2)]
        for k in range(len(drives)):
            lowest, twice = (part[k, first.rigid :][: elastic[k].sum()] for part in two)
            now = first.eigenvalues[k][elastic[k]]
            expected = (4.0 * lowest - 3.0 * now - twice) / (2.0 * small)
            found = first.rates[k, elastic[k], 0]
            np.testing.assert_allclose(found, expected, rtol=1e-3, atol=1e-4 * np.abs(expected).max())


@pytest.mark.usefixtures("_backend")
@pytest.mark.parametrize("drives", DRIVES)
@pytest.mark.parametrize("mechanism", FILES)
def test_several_sets_of_values_are_evaluated_as_each_alone(mechanism: str, drives: tuple[str, ...]) -> None:
    one = structure(mechanism, drives)
    values = declared(one) * np.array([1.0, 1.001, 0.999, 1.0])[:, None]
    values[3, index(one, "effects.payload.mass")] = 0.1
    by = [[0, 1, 2], [2, 3, 4], [0], list(range(len(one.parameters)))]
    batches = one.predict_many(values, by, shape_rates=True)
    assert sorted(k for batch in batches for k in batch.sets.tolist()) == [0, 1, 2, 3]
    for sets, found in batches:
        for place, k in enumerate(sets.tolist()):
            alone, count = one.predict(values[k], by[k], shape_rates=True), len(drives)
            part = slice(count * place, count * (place + 1))
            np.testing.assert_allclose(found.eigenvalues[part], alone.eigenvalues, rtol=1e-9, atol=1e-6)
            size = len(by[k])
            for a, b in (
                (found.rates[part][..., :size], alone.rates),
                (np.abs(found.shapes[part]), np.abs(alone.shapes)),
            ):
                np.testing.assert_allclose(a, b, atol=1e-7 * np.abs(b).max())


def test_held_motors_make_what_is_at_the_motors_invisible() -> None:
    one = structure("linear_delta", ("held",) * 3)
    at_motors = ["effects.gearbox_inertia.inertia", "effects.servo_stiffness.stiffness", "motor.inertia"]
    found = one.predict(declared(one), [index(one, name) for name in at_motors])
    assert (np.abs(found.rates) <= 1e-12 * found.eigenvalues.max()).all()
    mixed = structure("linear_delta", ("free", "held", "held"))
    rates = mixed.predict(declared(mixed), [index(mixed, name) for name in at_motors]).rates
    assert (np.abs(rates[0, mixed.robot.mechanism.rigid_modes :]).max(axis=0) > 0.0).all()


def test_proposed_measurements_have_the_usual_drives() -> None:
    for drives, usual in ((DRIVES[0], "held"), (DRIVES[1], "held"), (("free", "free", "held"), "free")):
        one = structure("corexy", drives)
        points, there = one.elsewhere(2)
        modes = pkmodes.Model(one.robot).modes(points[0], drives=usual)
        (_, loaded), *_ = there.loaded()
        for other in (there, loaded):
            assert other.predict(declared(other), ()).rigid == modes.rigid_modes
        expected = (2 * np.pi * modes.frequencies[modes.rigid_modes :]) ** 2
        found = there.predict(declared(there), ()).eigenvalues[0, modes.rigid_modes :]
        np.testing.assert_allclose(found, expected, rtol=1e-9)
