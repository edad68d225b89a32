"""Cartesian gantry and bed slinger: M, K, torques, damping and modes against sums of squares from their contract.

Every energy is a sum of weight/2 (row . q)^2, written here from mechanisms.md and effects.md, which name the bodies,
the belts and what each effect adds.
"""

from __future__ import annotations

from functools import cache
from typing import NamedTuple

import mpmath
import numpy as np
import pytest

import pkmodes
from helpers.robots.one_of_each import load_free
from helpers.robots.sample_mechanisms import TYPICAL, effect_names, sample
from helpers.robots.sample_mechanisms import model as generated
from pkmodes.core.mechanism.registry import mechanism
from pkmodes.core.robot.robot import Robot

NAMES = ("cartesian", "bed_slinger")
SEEDS = range(3)
#: Entries are sums of some ten terms of one sign.
SAME = 1e-12
CASES = [
    pytest.param(name, chosen, id=f"{name}-{label}")
    for name in NAMES
    for label, chosen in {
        "nothing": (),
        "everything": tuple(effect_names(name)),
        **{effect: (effect,) for effect in effect_names(name)},
    }.items()
]


class Expected(NamedTuple):
    """Matrices in all coordinates, and torques."""

    M: np.ndarray
    K: np.ndarray
    viscous: np.ndarray
    loss: np.ndarray
    platform: np.ndarray
    motors: np.ndarray
    torques: np.ndarray


@cache
def made(name: str, seed: int, chosen: tuple[str, ...]) -> tuple[pkmodes.Model, np.ndarray]:
    """A robot without symmetry in a plane that is not level, with the chosen effects, and a pose."""
    parameters, p = sample(name, seed)
    effects = {
        f"{effect}.{p.name}": TYPICAL[f"{effect}_{p.name}"]
        for effect in chosen
        for p in mechanism(name).effects[effect].parameters
        if not p.in_place_of
    }
    return pkmodes.Model(Robot(f"{name}-{seed}", name, f"{name}.toml", parameters, {}, effects)), p


def expected(model: pkmodes.Model, p: np.ndarray) -> Expected:
    """What the contract says of the robot of a model."""
    q, names, slings = model.robot.parameters, model.coordinates, model.mechanism.name == "bed_slinger"
    n = len(names)

    def value(path: str) -> float:
        return float(model.robot.effects.get(path, 0.0))

    def row(**factors: float) -> np.ndarray:
        return np.array([factors.get(name, 0.0) for name in names])

    def total(squares: list[tuple[float, np.ndarray]]) -> np.ndarray:
        return sum((weight * np.outer(a, a) for weight, a in squares), np.zeros((n, n)))

    # Every body moves with u and, along its own slide, relative to it.
    x, y, still_x, still_y = row(x=1, u_x=1), row(y=1, u_y=1), row(u_x=1), row(u_y=1)
    racked = row(
        y=1, u_y=1, psi_b=p[0] - value("gantry_racking.center")
    )  # the head at x on a beam that turns
    head = (x, still_y) if slings else (x, racked)
    other, load = (still_x, y), value("payload.mass")
    carrier = other if slings else head
    other_mass = q.bed_mass if slings else q.beam_mass
    T = [
        (mass, a) for mass, of in ((q.toolhead_mass, head), (other_mass, other), (load, carrier)) for a in of
    ]
    T += [(value("frame_compliance.mass"), a) for a in (still_x, still_y)]
    T.append((value("gantry_racking.inertia"), row(psi_b=1)))
    platform = (x, y) if slings else head
    V = [(value("cable_stiffness.stiffness"), a) for a in platform]
    R = [(value("rail_friction.viscous"), row(**{one: 1})) for one in ("x", "y")]
    V_loss, motors = [], []
    for i, slide in enumerate(("x", "y")):
        j, radius = i + 1, q.pulley_radius[i]
        pulley, motor = row(**{f"theta_{j}": 1}), row(**{f"theta_{j}": 1, f"psi_{j}": 1})
        motors.append(motor)
        T.append((q.pulley_inertia[i] + value("gearbox_inertia.inertia"), pulley))
        T.append((q.gear_ratio[i] ** 2 * q.motor_inertia[i], motor))
        V.append((value("servo_stiffness.stiffness"), motor))
        R.append((value("drive_friction.viscous"), motor))
        clamp = row(**{slide: 1, f"eps_{j}": 1})
        modulus = q.belt_width[i] * q.belt_specific_stiffness[i]
        modulus *= 1 + value(f"axis_belt_stiffness.factor_{j}")
        modulus *= 1 + value("belt_tension_stiffness.coefficient") * value("belt_tension_stiffness.tension")
        for length in (q.axis_lengths[i, 0] + p[i], q.axis_lengths[i, 1] - p[i]):
            k = 1 / (length / modulus + value("belt_end_compliance.compliance"))
            V.append((k, clamp + radius * pulley))
            V_loss.append((value("belt_loss.loss_factor") * k**2 * length / modulus, clamp + radius * pulley))
            # The run moves linearly from one end to the other: a^2 + a b + b^2 = 3/4 (a + b)^2 + 1/4 (a - b)^2.
            a, b, mass = clamp, -radius * pulley, value("belt_mass.linear_density") * length
            T += [(mass / 4, a + b), (mass / 12, a - b)]
    for effect, released in (
        ("gearbox_compliance", ("psi_1", "psi_2")),
        ("clamp_compliance", ("eps_1", "eps_2")),
        ("frame_compliance", ("u_x", "u_y")),
        ("gantry_racking", ("psi_b",)),
    ):
        if compliance := value(f"{effect}.compliance"):
            V += [(1 / compliance, row(**{one: 1})) for one in released]
            if effect == "gearbox_compliance":
                V_loss += [
                    (value("reducer_loss.loss_factor") / compliance, row(**{one: 1})) for one in released
                ]
    K = total(V)
    if "psi_b" in names:  # the weight -m g_y (y + psi_b (x - center)) of what slides along the beam
        at = [names.index("x"), names.index("psi_b")], [names.index("psi_b"), names.index("x")]
        K[at] -= (q.toolhead_mass + load) * q.gravity[1]
    # Virtual work: tau dtheta + g m dx = 0 with dx = -R dtheta.
    moved = [q.toolhead_mass, other_mass] if slings else [q.toolhead_mass, q.toolhead_mass + other_mass]
    moved = np.array(moved) + (np.array([0.0, load]) if slings else load)
    torques = q.pulley_radius * q.gravity[:2] * moved
    return Expected(total(T), K, total(R), total(V_loss), np.array(platform), np.array(motors), torques)


def frequencies(of: Expected, drives: str) -> np.ndarray:
    """Frequencies of all modes, coordinates without inertia condensed, motors free or held [Hz]; with 30 digits."""
    n, motors = len(of.M), [int(np.flatnonzero(row)[-1]) for row in of.motors]
    Z = np.eye(n)
    if drives == "held":  # each motor's last coordinate follows, theta = 0 or psi = -theta
        for row, last in zip(of.motors, motors, strict=True):
            Z[last] = -row
            Z[last, last] = 0.0
        Z = np.delete(Z, motors, axis=1)
    M, K = Z.T @ of.M @ Z, Z.T @ of.K @ Z
    light = np.diag(M) == 0.0
    heavy = ~light
    with mpmath.workdps(30):

        def block(matrix: np.ndarray, rows: np.ndarray, columns: np.ndarray) -> mpmath.matrix:
            return mpmath.matrix(matrix[np.ix_(rows, columns)].tolist())

        K_c = block(K, heavy, heavy)
        if light.any():
            K_c -= block(K, heavy, light) * block(K, light, light) ** -1 * block(K, light, heavy)
        L = mpmath.cholesky(block(M, heavy, heavy)) ** -1
        squares = mpmath.eigsy(L * K_c * L.T, eigvals_only=True)
        return np.array([float(mpmath.sqrt(max(s, 0)) / (2 * mpmath.pi)) for s in sorted(squares)])


def assert_close(found: np.ndarray, wanted: np.ndarray) -> None:
    """Each entry to its size beside the diagonal ones of its row and column: metres and radians mix."""
    size = np.sqrt(np.abs(np.diag(wanted)))
    np.testing.assert_array_less(np.abs(found - wanted), SAME * np.outer(size, size) + 1e-300)


@pytest.mark.parametrize(("name", "chosen"), CASES)
def test_matrices_and_torques_are_those_of_the_contract(name: str, chosen: tuple[str, ...]) -> None:
    for seed in SEEDS:
        model, p = made(name, seed, chosen)
        of = expected(model, p)
        modes = model.modes(p)
        assert_close(modes.mass_matrix, of.M)
        assert_close(modes.stiffness_matrix, of.K)
        np.testing.assert_allclose(model.statics(p).torques, of.torques, rtol=SAME)
        for m, shape in enumerate(modes.shapes):
            np.testing.assert_allclose(modes.platform_shapes[m], of.platform @ shape, rtol=SAME, atol=1e-14)
        viscous, loss = model.dissipation.matrices(p[None])
        assert_close(viscous[0], of.viscous)
        assert_close(loss[0], of.loss)


@pytest.mark.parametrize("backend", ["numpy", pytest.param("compiled", marks=pytest.mark.compiler)])
@pytest.mark.parametrize("drives", ["free", "held"])
@pytest.mark.parametrize(("name", "chosen"), CASES)
def test_frequencies_are_those_of_the_contract(
    name: str, chosen: tuple[str, ...], drives: str, backend: str
) -> None:
    model, p = made(name, 0, chosen)
    wanted = frequencies(expected(model, p), drives)
    found = model.frequencies(p, drives=drives, backend=backend)
    assert len(found) == len(wanted)
    rigid = wanted < 1e-5 * wanted.max()  # an eigenvalue has the absolute error of the largest one
    falls = 1e-5 if "gantry_racking" in chosen else 0.0  # the weight on a beam that racks
    assert (np.abs(found[rigid]) < (1e-7 + falls) * wanted.max()).all()
    np.testing.assert_allclose(found[~rigid], wanted[~rigid], rtol=SAME)


@pytest.mark.parametrize("name", NAMES)
def test_a_level_plane_needs_no_torque(name: str) -> None:
    model, p = made(name, 0, tuple(effect_names(name)))
    level = model.robot.parameters._replace(gravity=np.array([0.0, 0.0, -9.81]))
    robot = Robot("level", name, "level.toml", level, {}, model.robot.effects)
    np.testing.assert_array_equal(np.abs(pkmodes.Model(robot).statics(p).torques), 0.0)


def test_a_print_slows_the_bed_down_and_not_the_tool_head() -> None:
    """Each slide of a bed slinger is a mass m and a rotor I on one spring: omega^2 = k (1/m + R^2/I)."""
    model = load_free("bed-slinger.toml")
    q, p = model.robot.parameters, np.array([0.1, 0.15])
    k = (q.belt_width * q.belt_specific_stiffness)[:, None] / (q.axis_lengths + p[:, None] * [1, -1])
    rotors = q.pulley_inertia + q.gear_ratio**2 * q.motor_inertia
    for load in (0.0, 1.0):
        masses = np.array([q.toolhead_mass, q.bed_mass + load])
        squares = k.sum(axis=1) * (1 / masses + q.pulley_radius**2 / rotors)
        found = model.with_values({"effects.payload.mass": load}).frequencies(p)[2:]
        np.testing.assert_allclose(found, np.sort(np.sqrt(squares)) / (2 * np.pi), rtol=SAME)
        held = model.with_values({"effects.payload.mass": load}).frequencies(p, drives="held")
        alone = np.sqrt(k.sum(axis=1) / masses) / (2 * np.pi)
        np.testing.assert_allclose(held, np.sort(alone), rtol=SAME)


@pytest.mark.parametrize("name", NAMES)
def test_runs_have_a_length_in_the_whole_workspace(name: str) -> None:
    q = made(name, 0, ())[0].robot.parameters
    corners = [(q.axis_lengths[i, 0] + q.workspace[i], q.axis_lengths[i, 1] - q.workspace[i]) for i in (0, 1)]
    least = np.array([[min(run) for run in runs] for runs in corners])
    np.testing.assert_allclose(generated(name).run_margin(q), least, rtol=1e-14)


def test_a_pose_outside_names_what_is_beyond_its_travel() -> None:
    printer = pkmodes.load("robots/bed-slinger.toml")
    with pytest.raises(pkmodes.PoseError, match=r"the bed is beyond the upper end of its travel by 0\.04 m"):
        printer.modes([0.1, 0.25])
    with pytest.raises(pkmodes.PoseError, match="the tool head is beyond the lower end of its travel"):
        printer.modes([-0.01, 0.1])
