"""Frequency responses against motion in time: a sine is integrated until its transient is over."""

from __future__ import annotations

import numpy as np
import pytest
from scipy.integrate import solve_ivp

from helpers.references.motors_by_hand import followers
from helpers.references.response_in_40_digits import ports, size_of
from helpers.robots.one_of_each import FILES, POSES, model_of


@pytest.mark.parametrize("driven", ["force", "motor", "torque"])
@pytest.mark.parametrize("mechanism", FILES)
def test_a_sine_in_time_has_the_amplitude_and_the_phase_of_the_response(mechanism: str, driven: str) -> None:
    """M q'' + C q' + K q = B u from rest, until the transient is below the tolerance, 0.1 %.

    With a prescribed angle u, damping and inertia act on the whole motion.  Losses, which no equation in time has,
    are left out; with free motors, a servo holds the machine in its place.
    """
    friction = {"rail_friction.viscous": 25.0, "drive_friction.viscous": 5e-3}
    servo = {"servo_stiffness.stiffness": 30.0} if driven == "torque" else {}
    drives = "held" if driven != "torque" else "free"
    model, p = model_of(mechanism, {**friction, **servo}, ratio=0.08), POSES[mechanism]
    M, K = model.matrices(p)
    C, none = (matrix[0] for matrix in model.dissipation.matrices(p[None]))
    assert not none.any()
    T, S = followers(model, drives)
    modes = model.modes(p, drives=drives)
    momenta = M @ modes.shapes.T
    C = C + momenta @ np.diag(2 * 0.08 * 2 * np.pi * modes.frequencies) @ momenta.T
    name = {"force": f"force_{model.mechanism.directions[0]}", "motor": "motor_2", "torque": "torque_2"}[
        driven
    ]
    inputs, outputs, B, U, L = ports(model, drives, p)
    b, u = B[:, inputs.index(name)], S @ U[:, inputs.index(name)]
    f = 1.05 * modes.frequencies[0]
    w = 2 * np.pi * f
    m = len(T.T)
    inverse = np.linalg.inv(T.T @ M @ T)
    back, resist = -inverse @ T.T @ K @ T, -inverse @ T.T @ C @ T
    of_sine, of_cosine = inverse @ T.T @ (b - K @ u + w**2 * M @ u), -inverse @ T.T @ (w * C @ u)

    def rates(t: float, state: np.ndarray) -> np.ndarray:
        y, v = state[:m], state[m:]
        push = of_sine * np.sin(w * t) + of_cosine * np.cos(w * t)
        return np.concatenate([v, back @ y + resist @ v + push])

    decay = -np.linalg.eigvals(np.block([[np.zeros((m, m)), np.eye(m)], [back, resist]])).real.max()
    start = np.ceil(10.0 / decay * f) / f
    times = start + np.arange(16) / 16 / f
    found = solve_ivp(
        rates,
        (0.0, times[-1]),
        np.zeros(2 * m),
        "DOP853",
        times,
        rtol=1e-10,
        atol=1e-10 * np.abs(u).max() + 1e-14,
    )
    assert found.success
    motion = L @ (T @ found.y[:m] + np.outer(u, np.sin(w * times)))
    phasors = 2j / 16 * (motion @ np.exp(-1j * w * times))  # of q = Im(H exp(i w t))
    H = model.frf(p, [f], [name], outputs, drives=drives)
    sizes = size_of(H.values, H.units)[:, 0]
    platform = len(model.mechanism.directions)
    for true, response, size in zip(phasors, H.values[0, :, 0], sizes, strict=True):
        assert abs(response - true) <= 1e-3 * size
    first = int(np.abs(phasors[:platform]).argmax())
    ratio = H.values[0, first, 0] / phasors[first]
    assert abs(abs(ratio) - 1.0) < 1e-3
    assert abs(np.angle(ratio)) < 1e-3
