"""Small motions of the rig, against the nonlinear equations, the derived model and textbook formulas."""

from __future__ import annotations

import numpy as np
import pytest
from scipy.integrate import solve_ivp

import pkmodes
from pkmodes_rig import POSES, ROBOTS, read, true_modes
from pkmodes_rig.engine import TrueModes
from pkmodes_rig.moves import _Motion
from pkmodes_rig.robots import PUBLISHED
from pkmodes_rig.signals.analyser import averaged
from pkmodes_rig.signals.excitation import multisine
from pkmodes_rig.signals.integration import responses, responses_with_friction
from pkmodes_rig.signals.small_motion import Losses, SmallMotion, small_motion

POSE = np.array([0.62, 0.03, -0.25])
STEP = 1.0 / 4096.0
RAILS = ("x_1", "x_2", "x_3")


def oscillator(frequency: float, mass: float, coulomb: float = 0.0, ratio: float = 0.0) -> SmallMotion:
    modes = TrueModes(np.array([frequency]), 0, {"x": np.array([mass**-0.5])}, np.eye(1), np.eye(1), ("x",))
    return small_motion(modes, Losses(ratio, coulomb={"x": coulomb}))


def displaced(machine: SmallMotion, modes: TrueModes, displacements: np.ndarray) -> np.ndarray:
    """Modal state at rest with these displacements of the first coordinates."""
    q = np.zeros(len(modes.coordinates))
    q[: len(displacements)] = displacements
    return np.append(np.linalg.solve(machine.rows(modes.coordinates), q), np.zeros(len(q)))


def test_a_free_decay_is_that_of_the_nonlinear_equations() -> None:
    """MuJoCo's nonlinear equations with friction at the rails, integrated by a method of order eight."""
    parameters, friction, begin = read("published").parameters, 20.0, np.array([1e-6, -2e-6, 0.5e-6])
    modes = true_modes(parameters, POSE, held=True)
    machine = small_motion(modes, Losses(0.0, dict.fromkeys(RAILS, friction)))
    t = STEP * np.arange(300)
    still = np.zeros((len(t), 1)), np.zeros((1, len(machine.eigenvalues)))
    linear = responses(machine, STEP, *still, machine.rows(RAILS), displaced(machine, modes, begin))
    motion = _Motion(parameters, lambda _: POSE, friction)
    state = np.append(begin, np.zeros(9))
    found = solve_ivp(motion.rates, (0.0, t[-1]), state, "DOP853", t, rtol=1e-9, atol=1e-15)
    nonlinear = np.array([motion.rates(time, s)[6:9] for time, s in zip(t, found.y.T, strict=True)])
    # What is left is quadratic in the amplitude: some 1e-6 m beside lengths of some 0.1 m.
    np.testing.assert_allclose(linear, nonlinear, rtol=0, atol=3e-5 * np.abs(nonlinear).max())


def test_frequency_responses_are_those_of_the_derived_model() -> None:
    viscous, f = 8.0, np.arange(20.0, 60.0, 0.5)
    robot = read("published")
    document = pkmodes.load(str(PUBLISHED)).with_values(
        {"damping.ratio": 0.02, "effects.rail_friction.viscous": viscous}
    )
    outputs = ["p_x", "p_y", "p_z", "x_1"]
    expected = document.frf(POSE, f, ["force_y"], outputs, drives="held", quantity="acceleration")
    machine = small_motion(
        true_modes(robot.parameters, POSE, held=True), Losses(0.02, dict.fromkeys(RAILS, viscous))
    )
    block = round(2.0 / STEP)
    period = multisine(np.random.default_rng(5), STEP, block, (5.0, 400.0), 5.0)
    force = np.tile(period, 4)
    motion = responses(machine, STEP, force[:, None], machine.rows(["p_y"]), machine.rows(outputs))
    made = averaged(STEP, force, motion, block, 60.0)
    H = made.values[np.searchsorted(made.frequencies, f - 1e-6), :, 0]
    of_model = expected.values[:, :, 0]
    # Forces are linear between samples: at 60 Hz that takes (pi 60 / 4096)^2 / 3 = 7e-4 off their lines, but off
    # the measured force too; the transient has died out to exp(-2 pi 30 0.02 2) = 5e-4.
    np.testing.assert_allclose(H, of_model, rtol=0, atol=2e-3 * np.abs(of_model).max())


def test_coulomb_friction_takes_the_same_from_every_cycle() -> None:
    """The amplitude falls along a straight line, by 4 F / k a cycle (den Hartog, Mechanical Vibrations)."""
    frequency, mass, friction = 20.0, 2.0, 3.0
    stiffness = mass * (2.0 * np.pi * frequency) ** 2
    machine = oscillator(frequency, mass, friction)
    begin = 20.0 * friction / stiffness  # five cycles
    state = np.array([begin * np.sqrt(mass), 0.0])
    step = 1.0 / 40960.0
    count = round(7.0 / frequency / step)
    (a,) = responses_with_friction(
        [machine], step, [np.zeros((count, 1))], [np.zeros((1, 1))], [machine.rows(["x"])], state
    )
    cycle = round(1.0 / frequency / step)
    # At the turning points the acceleration is -(k x - F) / m, as friction already opposes the return.
    turns = -a[1 : 4 * cycle : cycle, 0] * mass
    expected = stiffness * begin - friction - 4.0 * friction * np.arange(4)
    np.testing.assert_allclose(turns, expected, rtol=0, atol=0.01 * friction)
    assert np.abs(a[-cycle:]).max() < 1e-9  # it sticks


def test_friction_that_is_too_weak_to_feel_changes_nothing() -> None:
    modes = true_modes(read("tower").parameters, np.array([0.01, 0.02, 0.2]))
    weak = Losses(0.01, {"x_1": 2.0}, dict.fromkeys(RAILS, 1e-12))
    machine = small_motion(modes, weak)
    rng = np.random.default_rng(1)
    force = rng.standard_normal((2000, 2))
    into, rows = machine.rows(["p_x", "x_2"]), machine.rows(["p_z", "x_1"])
    (rubbed,) = responses_with_friction([machine], STEP, [force], [into], [rows])
    free = responses(machine, STEP, force, into, rows)
    np.testing.assert_allclose(rubbed, free, rtol=0, atol=1e-9 * np.abs(free).max())


@pytest.mark.parametrize("name", list(ROBOTS))
def test_light_damping_leaves_the_frequencies_and_halves_the_loss_factor(name: str) -> None:
    """Modal ratios, and half the loss factor where all the stiffness has it (Nashif, Jones, Henderson, 1985)."""
    modes = true_modes(read(name).parameters, POSES[name]["scattered"][0])
    machine = small_motion(modes, Losses(0.003, factor=0.01), np.ones(len(modes.frequencies)))
    truth = machine.truth
    np.testing.assert_allclose(truth.ratios, 0.003 + 0.005, rtol=1e-9)
    np.testing.assert_allclose(truth.frequencies, modes.frequencies[modes.rigid :], rtol=1e-9)
    np.testing.assert_allclose(truth.natural, modes.frequencies[modes.rigid :], rtol=1e-9)
