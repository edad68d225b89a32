"""Energy is conserved along a motion of the generated equations, which tests signs and factors of all forces.

M q_ddot + h + grad V_g + grad V_el = 0 without torques, for all nine coordinates, far enough that the mass
matrix, gravity and the velocity forces change.  The belts keep the stiffness and the reference that they have at
the start, as in the model, so the elastic energy is quadratic in the displacements from there.
"""

from __future__ import annotations

import numpy as np
import pytest
from scipy.integrate import solve_ivp

from helpers.generated.generated_functions import TRAVEL
from helpers.robots.sample_robots import Sample, random_robot, sample
from pkmodes_generated.linear_delta import model

DURATION = 0.04
# Of the kinetic energy: the integrator's relative tolerance of 1e-11 with room for some steps that err alike.
# Measured: at most 3.3e-12.
DRIFT = 1e-10
# Robots whose motion stays clear of singular poses for as long, symmetric and not.
ROBOTS = ("published-symmetric", "tower-aside", "random-1", "random-3")


class Motion:
    """Equations of motion of a sample, released from its pose at some velocity."""

    def __init__(self, robot: Sample, *, velocity_forces: bool = True) -> None:
        self.reference, self.q = robot.pose, robot.parameters
        self.x = model.inverse_kinematics(self.reference, self.q)
        self.assembly = np.sign(model.jacobian_condition(self.reference, self.q)[0])
        self.velocity_forces = velocity_forces

    def platform(self, displacement: np.ndarray) -> np.ndarray:
        return model.direct_kinematics(self.x + displacement[..., :3], self.assembly, self.q)

    def rates(self, time: float, state: np.ndarray) -> np.ndarray:
        displacement, velocity = state[:9], state[9:]
        p = self.platform(displacement)
        force = -model.elastic_gradient(self.reference, displacement, self.q)
        force[:3] -= model.gravity_gradient(p, self.q)
        if self.velocity_forces:
            force[:3] -= model.velocity_forces(p, velocity[:3], self.q)
        return np.concatenate([velocity, np.linalg.solve(model.mass_matrix(p, self.q), force)])

    def integrate(self, velocity: np.ndarray) -> np.ndarray:
        """States at a hundred times, one row each."""
        start = np.concatenate([np.zeros(9), velocity])
        times = np.linspace(0.0, DURATION, 100)
        # absolute tolerances a hundred times below what moves: metres and radians of 1e-2, rates of 1
        result = solve_ivp(
            self.rates, (0.0, DURATION), start, method="DOP853", t_eval=times, rtol=1e-11, atol=1e-13
        )
        assert result.success, result.message
        return result.y.T

    def energies(self, states: np.ndarray) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
        """Kinetic, gravitational and elastic, at each state."""
        displacement, velocity = states[:, :9], states[:, 9:]
        p = self.platform(displacement)
        structure, transmission = model.kinetic_energy(p, velocity, self.q)
        return (
            structure + transmission,
            model.gravity_potential(p, self.q),
            model.elastic_potential(self.reference, displacement, self.q),
        )


def _start(robot: Sample) -> np.ndarray:
    """Carriages at up to 1 m/s, pulleys as fast but not in step, so that the belts are strained at once."""
    rng = np.random.default_rng(8)
    x_dot = rng.uniform(-1.0, 1.0, 3)
    radius = robot.parameters.pulley_radius
    pulleys = x_dot / radius * rng.uniform(0.5, 1.5, (2, 3))
    return np.concatenate([x_dot, pulleys.ravel()])


def _drift(motion: Motion, states: np.ndarray) -> float:
    kinetic, weight, strain = motion.energies(states)
    total = kinetic + weight + strain
    return float(np.max(np.abs(total - total[0])) / np.max(kinetic))


@pytest.mark.parametrize("name", ROBOTS)
def test_energy_is_conserved(name: str) -> None:
    robot = sample(name)
    motion = Motion(robot)
    states = motion.integrate(_start(robot))
    kinetic, weight, strain = motion.energies(states)
    # the test is meaningful only if a substantial part of each kind of energy is exchanged
    for energy in (kinetic, weight, strain):
        assert np.ptp(energy) > 1e-3 * np.max(kinetic)
    assert _drift(motion, states) < DRIFT


def test_energy_is_not_conserved_without_velocity_forces() -> None:
    """The check above can detect them: without h the energy drifts by a large fraction."""
    robot = sample("random-1")
    motion = Motion(robot, velocity_forces=False)
    assert _drift(motion, motion.integrate(_start(robot))) > 0.01


def test_travel_that_is_left_is_that_of_both_spans_of_a_carriage_at_any_pose() -> None:
    """Equations 36 and 37 added: l_f,2 + l_f,3 = max - min - l_t."""
    for seed in range(5):
        parameters, pose = random_robot(np.random.default_rng(seed))
        spans = model.belt_spans(pose, parameters)
        np.testing.assert_allclose(TRAVEL(parameters), spans[:, 1] + spans[:, 2], rtol=0, atol=1e-15)
