"""Simulated moves: against the nonlinear rig, closed forms, and linear equations integrated without modes."""

from __future__ import annotations

import re
from functools import partial
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from scipy.integrate import solve_ivp

import pkmodes
from helpers.runs.kept_measurements import KeptMeasurements
from pkmodes.core.base.errors import PkmodesError, PoseError
from pkmodes.machine.response.moves import shaped_command
from pkmodes.machine.shaping import Shaper, shaper
from pkmodes_rig.moves import StraightMove, deviation

ROOT = Path(__file__).parents[3]
ROBOT = ROOT / "robots/linear-delta-2022-identified.toml"
LOW, HIGH = np.array([0.32, -0.1, -0.26]), np.array([0.82, 0.1, -0.18])
STEP = 5e-4


def delta(**values: Any) -> pkmodes.Model:
    return pkmodes.load(ROBOT).with_values({path.replace("__", "."): v for path, v in values.items()})


def random_move(seed: int, model: pkmodes.Model) -> StraightMove:
    rng = np.random.default_rng([20261123, seed])
    while True:
        start, target = rng.uniform(LOW, HIGH, (2, 3))
        move = StraightMove(start, target)
        if move.distance > 0.05 and model.check(np.linspace(start, target, 30)).valid.all():
            return move


def largest(of: np.ndarray, when: np.ndarray) -> float:
    return float(np.linalg.norm(of[when], axis=1).max())


def on_the_rig(move: StraightMove, model: pkmodes.Model, friction: float = 0.0) -> float:
    """Return the largest deviation after a move."""
    time = times(move)
    true = deviation(model.robot.parameters, move.poses, time, move.corners, friction)
    return largest(true, time >= move.duration)


def simulated(move: StraightMove, model: pkmodes.Model) -> float:
    """Return the largest deviation after a move."""
    time = times(move)
    return largest(model.simulate(time, move.poses(time)).deviation, time >= move.duration)


def times(move: StraightMove) -> np.ndarray:
    return np.arange(0.0, move.duration + 0.08, STEP)


def of(move: StraightMove, model: pkmodes.Model, friction: float = 0.0) -> list[object]:
    """What `on_the_rig` depends on."""
    return [model.robot.parameters, move.start, move.target, move.speed, move.acceleration, friction, STEP]


@pytest.fixture(scope="module")
def kept(pytestconfig: pytest.Config) -> KeptMeasurements:
    return KeptMeasurements("moves", "pkmodes_rig.moves", pytestconfig)


def test_what_is_kept_is_what_the_rig_measures(kept: KeptMeasurements) -> None:
    model = delta()
    move = random_move(0, model)
    measured = on_the_rig(move, model)
    assert kept.value("move 0", of(move, model), lambda: measured) == pytest.approx(measured, rel=1e-6)


def test_the_largest_deviation_after_a_move_is_that_of_the_nonlinear_rig(kept: KeptMeasurements) -> None:
    """Motors prescribed, 1 m/s and 15 m/s^2, no damping; the rig has Coriolis forces and belts of changing length."""
    model = delta()
    moves = [random_move(seed, model) for seed in range(20)]
    true = [
        kept.value(f"move {k}", of(move, model), partial(on_the_rig, move, model))
        for k, move in enumerate(moves)
    ]
    np.testing.assert_allclose([simulated(move, model) for move in moves], true, rtol=0.05)


def test_friction_on_the_rails_acts_as_on_the_rig(kept: KeptMeasurements) -> None:
    model = delta(effects__rail_friction__viscous=40.0)
    move = random_move(1, model)
    true = kept.value("friction", of(move, model, 40.0), lambda: on_the_rig(move, model, 40.0))
    found = simulated(move, model)
    assert found < 0.9 * simulated(move, delta())
    assert found == pytest.approx(true, rel=0.05)


def test_a_vibration_keeps_its_action_where_the_pose_changes_slowly(kept: KeptMeasurements) -> None:
    """Excited at one pose and carried 0.4 m further: the rig is reached by the canonical transformation alone.

    With rates in the place of momenta, the amplitude would differ.
    """
    model = delta()
    start, target = np.array([0.35, 0.0, -0.2]), np.array([0.8, 0.0, -0.2])
    ramp, slow = 0.004, 0.45
    duration = (target - start)[0] / slow + ramp
    time = np.arange(0.0, duration - ramp, 1e-3)
    a = slow / ramp

    def command(t: float) -> np.ndarray:
        travel = 0.5 * a * t**2 if t < ramp else slow * (t - 0.5 * ramp)
        return start + np.array([travel, 0.0, 0.0])

    found = model.simulate(time, np.array([command(t) for t in time])).deviation
    first_and_last = time < 0.1, time > time[-1] - 0.15

    def measured() -> list[float]:
        true = deviation(model.robot.parameters, command, time, np.array([ramp]))
        return [largest(true, when) for when in first_and_last]

    true = kept.value("slow", [model.robot.parameters, start, target, ramp, slow, time], measured)
    np.testing.assert_allclose([largest(found, when) for when in first_and_last], true, rtol=0.05)


def held_matrices(model: pkmodes.Model, pose: np.ndarray) -> tuple[np.ndarray, ...]:
    """M, K, the motion of the held coordinates, and the platform per coordinate, written out for a linear delta."""
    M, K = model.matrices(pose)
    names, q = list(model.coordinates), model.robot.parameters
    driven = [names.index(f"theta_{j + 1}_{1 if q.drive[j][0] else 2}") for j in range(3)]
    kept = [i for i in range(9) if i not in driven]
    jacobian = model.platform_jacobian(pose)
    rigid = np.zeros((9, 3))
    rigid[:3] = np.linalg.inv(jacobian)
    for k in range(6):
        rigid[3 + k] = rigid[k % 3] / q.pulley_radius[k % 3]
    platform = np.zeros((3, 9))
    platform[:, :3] = jacobian
    return M[np.ix_(kept, kept)], K[np.ix_(kept, kept)], (M @ rigid)[kept], platform[:, kept]


def test_a_small_motion_is_that_of_the_equations_at_the_pose_integrated_without_modes() -> None:
    model, pose, zeta = delta(), np.array([0.6, 0.05, -0.22]), 0.02
    M, K, momentum, platform = held_matrices(model, pose)
    values, vectors = np.linalg.eig(np.linalg.solve(M, K))
    damping = 2.0 * zeta * M @ vectors @ np.diag(np.sqrt(values)) @ np.linalg.inv(vectors)
    time, size = np.arange(0.0, 0.2, 2e-4), 1e-6
    direction, omega = np.array([1.0, -0.5, 0.3]), 2.0 * np.pi * 25.0

    def rates(t: float, state: np.ndarray) -> np.ndarray:
        y, y_dot = np.split(state, 2)
        acceleration = size * omega**2 * np.cos(omega * t) * direction
        return np.concatenate([y_dot, np.linalg.solve(M, -damping @ y_dot - K @ y - momentum @ acceleration)])

    expected = solve_ivp(
        rates, (0.0, time[-1]), np.zeros(12), method="DOP853", t_eval=time, rtol=1e-10, atol=1e-16
    )
    poses = pose + size * (1.0 - np.cos(omega * time))[:, None] * direction
    found = model.simulate(time, poses, damping=zeta).deviation
    true = (platform @ expected.y[:6]).T
    # The command is a polygon: of the amplitude, (omega h)^2 / 24 = 4e-5 is missing, and a mode at 40 Hz has as much.
    assert np.abs(found - true).max() < 1e-3 * np.abs(true).max()


def test_the_platform_lags_as_friction_and_stiffness_say_at_constant_speed() -> None:
    """Viscous friction b on every rail: the belts stretch until they balance it."""
    friction, speed, pose = 50.0, 1e-4, np.array([0.6, 0.0, -0.22])
    model = delta(effects__rail_friction__viscous=friction, damping__ratio=0.3)
    _, K, _, platform = held_matrices(model, pose)
    force = np.zeros(6)
    force[:3] = -friction * np.linalg.inv(model.platform_jacobian(pose))[:, 0] * speed
    lag = platform @ np.linalg.solve(K, force)
    time = np.linspace(0.0, 1.0, 2001)
    poses = pose + np.outer(speed * (time - 1.0), [1.0, 0.0, 0.0])
    found = model.simulate(time, poses).deviation[-1]
    assert found == pytest.approx(lag, rel=2e-3, abs=1e-3 * np.abs(lag).max())


@pytest.mark.parametrize("name", ["clavel-delta", "corexy-printer"])
def test_other_mechanisms_ring_at_their_held_modes(name: str) -> None:
    model = pkmodes.load(ROOT / f"robots/{name}.toml")
    pose = {"clavel-delta": [0.0, 0.0, -0.4], "corexy-printer": [0.15, 0.15]}[name]
    fields = ("frequencies", "vibration_amplitudes")
    modes = model.modes(pose, drives="held", fields=fields)
    time = np.linspace(0.0, 0.25, 5001)
    step = np.zeros(len(pose))
    step[0] = 1e-6
    poses = np.array(pose) + step * np.minimum(0.5 * time**2 / time[-1] ** 2, 1.0)[:, None]
    found = model.simulate(time, poses).deviation
    # A step of the acceleration excites every mode with its amplitude, about a static deviation as large.
    acceleration = 1e-6 / time[-1] ** 2
    bound = acceleration * modes.vibration_amplitudes[:, 0].sum()
    size = np.linalg.norm(found, axis=1).max()
    assert 0.5 * bound < size < 2.0 * bound
    lowest = int(np.argmax(modes.vibration_amplitudes[:, 0]))
    along = found[:, 0] - found[:, 0].mean()
    spectrum = np.abs(np.fft.rfft(along * np.hanning(len(along)), 16 * len(along)))
    peak = np.fft.rfftfreq(16 * len(along), time[1])[3 * 16 :][np.argmax(spectrum[3 * 16 :])]
    assert peak == pytest.approx(modes.frequencies[lowest], rel=0.03)


def test_stiff_joints_change_nothing_and_a_robot_at_rest_rests() -> None:
    time = np.arange(0.0, 0.2, 1e-3)
    move = StraightMove(np.array([0.4, 0.0, -0.22]), np.array([0.45, 0.02, -0.2]))
    plain = delta().simulate(time, move.poses(time), damping=0.01).deviation
    stiff = delta(effects__link_compliance__compliance=1e-20).simulate(time, move.poses(time), damping=0.01)
    assert np.abs(stiff.deviation - plain).max() < 1e-4 * np.abs(plain).max()
    assert not delta().simulate(time, np.tile([0.4, 0.0, -0.22], (len(time), 1))).deviation.any()


def test_parts_and_uneven_times_give_the_same_motion(monkeypatch: pytest.MonkeyPatch) -> None:
    model = delta(damping__ratio=0.01)
    move = random_move(3, model)
    time = np.arange(0.0, 0.3, 1e-3)
    whole = model.simulate(time, move.poses(time)).deviation
    monkeypatch.setattr("pkmodes.machine.response.path_vibration.SAMPLES_AT_ONCE", 37)
    np.testing.assert_allclose(model.simulate(time, move.poses(time)).deviation, whole, rtol=0, atol=1e-12)
    finer = np.union1d(time, np.arange(0.1, 0.15, 2.5e-4))
    other = model.simulate(finer, move.poses(finer)).deviation[np.isin(finer, time)]
    assert np.abs(other - whole).max() < 0.01 * np.abs(whole).max()


def test_a_fixed_shaper_is_the_sum_of_delayed_commands() -> None:
    time = np.arange(0.0, 0.5, 1e-3)
    command = np.stack([np.sin(7.0 * time), time**2], axis=-1)
    one = shaper("2hump_ei", 31.0, 0.02)
    expected = sum(
        a * np.stack([np.interp(time - d, time, c) for c in command.T], axis=-1)
        for a, d in zip(one.amplitudes, one.delays, strict=True)
    )
    np.testing.assert_allclose(shaped_command(time, command, one), expected, rtol=0, atol=2e-6)


def test_a_following_shaper_delivers_all_of_the_command() -> None:
    model = delta(damping__ratio=0.01)
    move = random_move(5, model)
    time = np.arange(0.0, move.duration + 0.1, 1e-3)
    poses = move.poses(time)
    shaped = shaped_command(time, poses, model.shaper("zv*zv*zv", poses))
    np.testing.assert_allclose(shaped[-1], move.target, rtol=0, atol=1e-12)
    np.testing.assert_allclose(shaped[0], move.start, rtol=0, atol=1e-15)


TIME = np.linspace(0.0, 0.1, 11)
REST = np.tile([0.5, 0.0, -0.22], (11, 1))


@pytest.mark.parametrize(
    ("time", "poses", "options", "message"),
    [
        (TIME[::-1], REST, {}, "expected ascending times, found 0.09 s after 0.1 s, at index 1 (time); sort"),
        (np.zeros(11), REST, {}, "expected ascending times, found 0 s after 0 s"),
        ("now", REST, {}, 'expected times in s, found "now" (time)'),
        (1j * TIME, REST, {}, "expected times in s, found [0.+0.j"),
        ([0.0], REST[:1], {}, "expected at least two times in s"),
        ([0.0, np.nan], REST[:2], {}, "expected finite times in s, found nan at index 1 (time)"),
        (np.ma.masked_equal([0.0, 1.0], 1.0), REST[:2], {}, "found nan at index 1 (time)"),
        (TIME, REST[:5], {}, "expected poses of shape (11, 3), one for each time, found (5, 3)"),
        (TIME, "there", {}, 'expected a pose x, y, z for each time, found "there" (poses)'),
        (TIME, 1j * REST, {}, "expected a pose x, y, z for each time"),
        (
            TIME,
            REST,
            {"damping": 1.0},
            "expected a damping ratio of at least 0 and below 1, found 1.0 (damping)",
        ),
        (TIME, REST, {"damping": "2 %"}, "expected a damping ratio"),
        (
            TIME,
            REST,
            {"shaper": Shaper(np.ones((3, 1)), np.zeros((3, 1)))},
            "expected impulses of shape (n,), or (11, n) for as many times, found (3, 1) (shaper)",
        ),
        (
            TIME,
            REST,
            {"shaper": Shaper(np.full((11, 2), 0.5), np.linspace(0.5, 0.0, 11)[:, None] * [0.0, 1.0])},
            "the delays shorten faster than time passes at 0 s (shaper)",
        ),
        *(
            (TIME, REST, {"shaper": given}, message)
            for given, message in (
                ("zv", "expected a shaper with as many amplitudes as delays"),
                (Shaper(np.array([0.5, 0.5]), np.array([0.0])), "as many amplitudes as delays"),
                (
                    Shaper(np.array([0.7, 0.7]), np.array([0.0, 0.01])),
                    "with the sum 1, found 0.7, 0.7 (shaper)",
                ),
                (Shaper(np.array([-0.5, 1.5]), np.array([0.0, 0.01])), "amplitudes that are not negative"),
                (Shaper(np.array([np.nan, 0.5]), np.array([0.0, 0.01])), "amplitudes that are not negative"),
                (Shaper(np.array([0.5, 0.5]), np.array([0.01, 0.0])), "delays in s that ascend from 0"),
                (Shaper(np.array([0.5, 0.5]), np.array([-0.01, 0.0])), "delays in s that ascend from 0"),
                (Shaper(np.array([0.5, 0.5]), np.array([0.0, np.inf])), "delays in s that ascend from 0"),
                (Shaper(np.empty(0), np.empty(0)), "expected a shaper with impulses, found none"),
            )
        ),
    ],
)
def test_bad_input_is_refused(time: Any, poses: Any, options: dict[str, Any], message: str) -> None:
    with pytest.raises(PkmodesError) as error:
        delta().simulate(time, poses, **options)
    assert message in str(error.value)


def test_a_path_out_of_the_workspace_is_refused_with_time_and_pose() -> None:
    poses = REST + np.linspace(0.0, 1.5, 11)[:, None] * np.array([1.0, 0.0, 0.0])
    with pytest.raises(PoseError) as error:
        delta().simulate(TIME, poses)
    found = re.search(
        r"the path leaves the workspace at ([\d.]+) s, \[([\d.]+), 0, -0.22\] m: ", str(error.value)
    )
    assert found is not None
    time, x = float(found[1]), float(found[2])
    assert x == pytest.approx(0.5 + 15.0 * time, abs=1e-5)
    # Between the samples, too: the first place along the straight line.
    assert not delta().check([x, 0.0, -0.22]).valid
    assert delta().check([x - 0.0035, 0.0, -0.22]).valid


def test_a_straight_line_through_poses_out_of_the_workspace_is_refused() -> None:
    with pytest.raises(PoseError, match=r"leaves the workspace at 0\.07"):
        delta().simulate([0.0, 0.05, 0.1], [[0.6, 0.0, -0.245], [0.6, 0.0, -0.245], [0.6, 0.0, 0.245]])


def test_a_command_with_few_samples_is_that_line_with_many() -> None:
    model = delta(damping__ratio=0.01)
    few = np.array([0.0, 0.2, 0.25, 0.3])
    ends = np.array([[0.4, 0.0, -0.22], [0.55, 0.05, -0.2], [0.55, 0.05, -0.2], [0.55, 0.05, -0.2]])
    many = np.union1d(np.linspace(0.0, 0.3, 1201), few)
    poses = np.stack([np.interp(many, few, component) for component in ends.T], axis=-1)
    expected = model.simulate(many, poses).deviation[np.isin(many, few)]
    found = model.simulate(few, ends).deviation
    assert np.abs(found - expected).max() < 1e-3 * np.abs(expected).max()


def test_long_steps_keep_their_vibration() -> None:
    """Without damping a mode of 30 Hz rings on for ever."""
    model = delta()
    ends = np.array([[0.6, 0.0, -0.22]] + [[0.61, 0.0, -0.22]] * 4)
    found = model.simulate([0.0, 10.0, 20.0, 30.0, 40.0], ends).deviation
    finer = np.union1d(np.arange(0.0, 40.0, 0.05), [10.0, 20.0, 30.0, 40.0])
    poses = np.stack([np.interp(finer, np.arange(5) * 10.0, component) for component in ends.T], axis=-1)
    expected = model.simulate(finer, poses).deviation[np.isin(finer, np.arange(5) * 10.0)]
    assert np.abs(expected).max() > 1e-7
    np.testing.assert_allclose(found, expected, rtol=0, atol=0.02 * np.abs(expected).max())
