"""Energy is conserved along a motion computed with the generated equations of the rotary delta.

M q_ddot + h + grad V_g + grad V_el = 0 without torques, for all six coordinates, far enough that the mass matrix,
gravity and the velocity forces change: this tests signs and factors of all forces at once.
"""

from __future__ import annotations

import numpy as np
import pytest
from scipy.integrate import solve_ivp

from helpers.robots.sample_mechanisms import Sample, sample
from helpers.robots.symmetric_rotary_delta import clavel
from pkmodes_generated.rotary_delta import model

DURATION = 0.06
#: Of the kinetic energy: the integrator's relative tolerance of 1e-11 with room for steps with correlated errors.
#: Measured: at most 1.2e-11.
DRIFT = 1e-10
ROBOTS = {"clavel": clavel((0.06, 0.03, -0.5))} | {
    f"random-{seed}": sample("rotary_delta", seed) for seed in (0, 2)
}


class Motion:
    """Equations of motion of a robot that is released from its pose with some velocity."""

    def __init__(self, robot: Sample, *, velocity_forces: bool = True) -> None:
        self.reference, self.q = robot.pose, robot.parameters
        self.theta = model.inverse_kinematics(self.reference, self.q)
        self.assembly = np.sign(model.jacobian_condition(self.reference, self.q)[0])
        self.velocity_forces = velocity_forces

    def platform(self, displacement: np.ndarray) -> np.ndarray:
        theta = self.theta + displacement[..., :3]
        return np.asarray(model.direct_kinematics(theta, self.assembly, self.q))

    def rates(self, time: float, state: np.ndarray) -> np.ndarray:
        displacement, velocity = state[:6], state[6:]
        p = self.platform(displacement)
        force = -model.elastic_gradient(self.reference, displacement, self.q)
        force[:3] -= model.gravity_gradient(p, self.q)
        if self.velocity_forces:
            force[:3] -= model.velocity_forces(p, velocity[:3], self.q)
        return np.concatenate([velocity, np.linalg.solve(model.mass_matrix(p, self.q), force)])

    def energies(self) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
        """Return kinetic, gravitational and elastic energy at fifty times, for arms at a few radians per second."""
        rng = np.random.default_rng(8)
        speed = rng.uniform(-4.0, 4.0, 3)
        start = np.concatenate([np.zeros(6), speed, speed * rng.uniform(0.5, 1.5, 3)])
        # absolute tolerances a hundred times below the motion: radians of 1e-2, rates of 1
        result = solve_ivp(
            self.rates,
            (0.0, DURATION),
            start,
            method="DOP853",
            t_eval=np.linspace(0.0, DURATION, 50),
            rtol=1e-11,
            atol=1e-13,
        )
        assert result.success, result.message
        displacement, velocity = result.y.T[:, :6], result.y.T[:, 6:]
        p = self.platform(displacement)
        structure, transmission = model.kinetic_energy(p, velocity, self.q)
        strain = model.elastic_potential(self.reference, displacement, self.q)
        return structure + transmission, model.gravity_potential(p, self.q), strain


def drift(energies: tuple[np.ndarray, ...]) -> float:
    total = sum(energies)
    return float(np.max(np.abs(total - total[0])) / np.max(energies[0]))


@pytest.mark.parametrize("name", ROBOTS)
def test_energy_is_conserved(name: str) -> None:
    energies = Motion(ROBOTS[name]).energies()
    # the test is meaningful only if every kind of energy changes substantially
    for energy in energies:
        assert np.ptp(energy) > 1e-3 * np.max(energies[0])
    assert drift(energies) < DRIFT


def test_energy_is_not_conserved_without_velocity_forces() -> None:
    """The check above can detect them."""
    assert drift(Motion(ROBOTS["random-0"], velocity_forces=False).energies()) > 1e-3
