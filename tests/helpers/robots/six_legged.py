"""Random hexapods and hexaglides with one pose each: robot files by their contract, plausible and without symmetry.

A machine is the contents of its robot file, with bare SI numbers: the oracles read it as it is, and `toml_text` gives
the file.  The same seed gives the same machine.
"""

from __future__ import annotations

from collections.abc import Iterable
from itertools import combinations
from typing import Any, NamedTuple

import numpy as np
import tomlkit

Machine = dict[str, Any]

#: Largest condition number of the Jacobian from platform to drives, rotations times a length of the platform.
LARGEST_CONDITION = 20.0
#: Least distance between two legs, relative to the radius of the platform.
CLEARANCE = 0.08
LEGS = range(6)


class Case(NamedTuple):
    """A machine, and a pose of it: position [m] and rotation vector [rad]."""

    machine: Machine
    pose: tuple[float, ...]


def toml_text(machine: Machine) -> str:
    return tomlkit.dumps(machine)


def with_effects(case: Case, names: Iterable[str]) -> Case:
    """The same with some of the effects that `effects` draws for its mechanism."""
    chosen = effects(case)
    return Case({**case.machine, "effects": {name: chosen[name] for name in names}}, case.pose)


def drawn(name: str, seed: int) -> Case:
    """A machine with effects drawn at random: none for seed 0, all for seed 1."""
    case = MACHINES[name](seed)
    chosen, rng = list(effects(case)), np.random.default_rng([seed, 7])
    likely = {0: 0.0, 1: 1.0}.get(seed, 0.5)
    return with_effects(case, [effect for effect in chosen if rng.random() < likely])


def rotation(vector: Any) -> np.ndarray:
    """Rotation matrix of a rotation vector, by Rodrigues' formula."""
    angle = float(np.linalg.norm(vector))
    if angle == 0:
        return np.eye(3)
    x, y, z = np.asarray(vector) / angle
    cross = np.array([[0, -z, y], [z, 0, -x], [-y, x, 0]])
    return np.asarray(np.eye(3) + np.sin(angle) * cross + (1 - np.cos(angle)) * cross @ cross)


def hexapod(seed: int) -> Case:
    """A Stewart platform with irregular joints, standing or hanging, its platform moved and tilted."""
    rng = np.random.default_rng([seed, 6])
    while True:
        radius = 10 ** rng.uniform(-1, 0.3)
        platform = radius * rng.uniform(0.4, 0.85)
        height = radius * rng.uniform(0.7, 1.7) * rng.choice([-1, 1])
        base, joint = _two_hexagons(rng, radius, platform)
        pose = _pose(rng, radius * np.array([0.15, 0.15, 0]) + [0, 0, 0.1 * radius], [0, 0, height])
        ends = pose[:3] + joint @ rotation(pose[3:]).T
        along = ends - base
        length = np.linalg.norm(along, axis=1)
        arms = ends - pose[:3]
        J = np.hstack([along, np.cross(arms, along) / platform]) / length[:, None]
        if np.linalg.cond(J) < LARGEST_CONDITION and _nearest(base, ends) > CLEARANCE * platform:
            break
    mass = 10 ** rng.uniform(-0.5, 1.5)

    def leg(j: int) -> Machine:
        rod_mass, base_mass = mass * rng.uniform(0.03, 0.2, 2)
        reach = length[j] * 0.4
        return {
            "stiffness": 10 ** rng.uniform(6, 8),
            "base_mass": base_mass,
            "base_center": reach * rng.uniform(0.2, 0.8),
            "base_inertia": base_mass * (reach * rng.uniform(0.2, 0.5)) ** 2,
            "rod_mass": rod_mass,
            "rod_center": reach * rng.uniform(0.2, 0.8),
            "rod_inertia": rod_mass * (reach * rng.uniform(0.2, 0.5)) ** 2,
        }

    def motor() -> Machine:
        travel = 10 ** rng.uniform(-3.3, -2.5)
        return {"inertia": mass * rng.uniform(0.2, 3) * travel**2, "travel": travel}

    axes = [
        {"base": base[j], "joint": joint[j], "limits": length[j] * np.array([0.7, 1.3])}
        | _sometimes(rng, leg=leg(j), motor=motor())
        for j in LEGS
    ]
    shortest = int(np.argmin(length))
    return _case("hexapod", rng, seed, mass, platform, pose, leg=leg(shortest), motor=motor(), axis=axes)


def hexaglide(seed: int) -> Case:
    """Rods of any direction around a platform, then rails through their far ends: parallel, in pairs, or any."""
    rng = np.random.default_rng([seed, 9])
    radius = 10 ** rng.uniform(-1.3, -0.3)
    rails = rng.choice(["parallel", "pairs", "any"])
    while True:
        _, joint = _two_hexagons(rng, radius, radius)
        pose = _pose(rng, np.full(3, radius), np.zeros(3))
        arms = joint @ rotation(pose[3:]).T
        ends = pose[:3] + arms
        common = radius * rng.uniform(2.5, 6)
        lengths = common * rng.uniform(0.9, 1.1, 6)
        rods = _units(rng.normal(size=(6, 3)) + 0.8 * _units(arms))  # from the platform joint to the carriage
        count = {"parallel": 1, "pairs": 3, "any": 6}[rails]
        direction = np.repeat(_units(rng.normal(size=(count, 3))), 6 // count, axis=0)
        cosine = np.sum(rods * direction, axis=1)
        if np.abs(cosine).min() < 0.35:
            continue
        carriages = ends + lengths[:, None] * rods
        J = np.hstack([rods, np.cross(arms, rods) / radius]) / cosine[:, None]
        if np.linalg.cond(J) < LARGEST_CONDITION and _nearest(carriages, ends) > CLEARANCE * radius:
            break
    mass = 10 ** rng.uniform(-0.5, 1.2)
    at = common * rng.uniform(-0.5, 0.5, 6)
    spare = common * rng.uniform(0.6, 1.2, (6, 2))
    driven = rng.permutation([1, 2, *rng.integers(1, 3, 4)])

    def link() -> Machine:
        return {"mass": mass * rng.uniform(0.03, 0.2)}

    def carriage() -> Machine:
        return {"mass": mass * rng.uniform(0.2, 0.8), "length": common * rng.uniform(0.05, 0.3)}

    def belt() -> Machine:
        return {"specific_stiffness": rng.uniform(0.5e6, 4e6), "width": rng.uniform(0.006, 0.03)}

    pulley_radius = rng.uniform(0.01, 0.06)

    def pulley() -> Machine:
        factor = rng.uniform(0.7, 1.4)
        return {
            "radius": pulley_radius * factor,
            "inertia": mass * rng.uniform(0.02, 0.2) * pulley_radius**2,
        }

    def motor() -> Machine:
        ratio = float(rng.integers(1, 12))
        return {
            "inertia": mass * rng.uniform(0.1, 1) * pulley_radius**2 / ratio**2,
            "gear_ratio": ratio,
        }

    axes = [
        {
            "origin": carriages[j] - at[j] * direction[j],
            "direction": direction[j],
            "joint": joint[j],
            "limits": [at[j] - spare[j, 0], at[j] + spare[j, 1]],
            "driven_pulley": int(driven[j]),
            "branch": int(np.sign(cosine[j])),
            "link": {"length": lengths[j]},
        }
        | _sometimes(rng, carriage=carriage(), belt=belt(), pulley=pulley(), motor=motor())
        for j in LEGS
    ]
    shared = {
        "link": {"length": common, **link()},
        "carriage": carriage(),
        "belt": belt(),
        "pulley": pulley(),
        "motor": motor(),
    }
    return _case("hexaglide", rng, seed, mass, radius, pose, **shared, axis=axes)


def effects(case: Case) -> Machine:
    """Every effect that applies to a machine without dissipating, of a size that changes its modes."""
    machine = case.machine
    mass = machine["platform"]["mass"]
    size = float(np.abs([axis["joint"] for axis in machine["axis"]]).max())
    offset = [0.3 * size, -0.2 * size, 0.15 * size]
    found: Machine = {"payload": {"mass": 0.3 * mass, "offset": offset}}
    found["cable_stiffness"] = {"stiffness": 3e3 * mass}
    found["frame_compliance"] = {"compliance": 3e-7 / mass}
    factors = {f"factor_{j + 1}": value for j, value in enumerate((0.05, -0.1, 0.15, -0.07, 0.02, -0.12))}
    if machine["mechanism"] == "hexapod":
        inertia = machine["motor"]["inertia"] / machine["motor"]["travel"] ** 2
        found["gearbox_inertia"] = {"inertia": 0.3 * inertia}
        found["servo_stiffness"] = {"stiffness": 0.2 * machine["leg"]["stiffness"]}
        found["axis_leg_stiffness"] = factors
        return found
    square = machine["pulley"]["radius"] ** 2
    stiffness = machine["belt"]["width"] * machine["belt"]["specific_stiffness"] / machine["link"]["length"]
    found["gearbox_inertia"] = {"inertia": 0.1 * mass * square}
    found["servo_stiffness"] = {"stiffness": 0.2 * stiffness * square}
    found["axis_belt_stiffness"] = factors
    found["belt_mass"] = {"linear_density": 0.05 * mass / machine["link"]["length"]}
    found["belt_end_compliance"] = {"compliance": 0.2 / stiffness}
    found["belt_tension_stiffness"] = {"tension": 45.0, "coefficient": 2e-3}
    found["gearbox_compliance"] = {"compliance": 0.5 / (stiffness * square)}
    found["link_compliance"] = {"compliance": 0.05 / stiffness}
    found["clamp_compliance"] = {"compliance": 0.1 / stiffness}
    return found


def _two_hexagons(rng: np.random.Generator, outer: float, inner: float) -> tuple[np.ndarray, np.ndarray]:
    """Joints of the base and of the platform: pairs a third of a turn apart, offset by a sixth, all irregular."""
    half, other = np.radians(rng.uniform(8, 25, 2))
    thirds = np.repeat(np.radians([0.0, 120.0, 240.0]), 2)
    side = np.tile([-1.0, 1.0], 3)
    # leg j leaves one side of a pair of the base for the pair of the platform on that side
    base = _circle(thirds + side * half)
    platform = _circle(thirds + side * (np.pi / 3 - other))
    return (
        outer * (base + rng.normal(scale=0.04, size=(6, 3))),
        inner * (platform + rng.normal(scale=0.05, size=(6, 3))),
    )


def _circle(angles: np.ndarray) -> np.ndarray:
    return np.stack([np.cos(angles), np.sin(angles), np.zeros(6)], axis=1)


def _pose(rng: np.random.Generator, spread: Any, middle: Any) -> np.ndarray:
    tilt = _units(rng.normal(size=(1, 3)))[0] * np.radians(rng.uniform(2, 35))
    return np.concatenate([middle + np.asarray(spread) * rng.uniform(-1, 1, 3), tilt])


def _units(vectors: np.ndarray) -> np.ndarray:
    return np.asarray(vectors / np.linalg.norm(vectors, axis=-1, keepdims=True))


def _nearest(starts: np.ndarray, ends: np.ndarray) -> float:
    """Least distance between two of the segments, at a grid of points on each."""
    along = np.linspace(0, 1, 41)[:, None, None]
    points = starts + along * (ends - starts)
    gaps = [
        np.linalg.norm(points[:, None, i] - points[None, :, j], axis=-1).min()
        for i, j in combinations(LEGS, 2)
    ]
    return float(min(gaps))


def _sometimes(rng: np.random.Generator, **tables: Machine) -> Machine:
    """Some of the values, to override those shared by all axes."""
    found = {
        name: {key: value for key, value in table.items() if rng.random() < 0.3}
        for name, table in tables.items()
    }
    return {name: table for name, table in found.items() if table}


def _platform(rng: np.random.Generator, mass: float, size: float) -> Machine:
    """A body of any shape: moments and products are those of a cloud of points, so that they are of a real body."""
    spread = rng.normal(size=(3, 3)) * size * rng.uniform(0.15, 0.4)
    moments = mass * spread @ spread.T
    inertia = np.trace(moments) * np.eye(3) - moments
    return {
        "mass": mass,
        "center": size * rng.uniform(-0.3, 0.3, 3),
        "inertia": np.diag(inertia),
        "products": [inertia[0, 1], inertia[0, 2], inertia[1, 2]],
    }


def _case(
    mechanism: str, rng: np.random.Generator, seed: int, mass: float, size: float, pose: Any, **tables: Any
) -> Case:
    down = np.array([0.0, 0.0, -1.0]) if rng.random() < 0.5 else _units(rng.normal(size=(1, 3)))[0]
    machine = {
        "format": 1,
        "name": f"{mechanism}-{seed}",
        "mechanism": mechanism,
        "gravity": 9.81 * down,
        "platform": _platform(rng, mass, size),
        "frame": {"mass": mass * rng.uniform(5, 20)},
        **tables,
    }
    return Case(_plain(machine), tuple(float(value) for value in pose))


def _plain(value: Any) -> Any:
    """Arrays and numbers of NumPy as those of Python."""
    if isinstance(value, dict):
        return {key: _plain(entry) for key, entry in value.items()}
    if isinstance(value, np.ndarray | list | tuple):
        return [_plain(entry) for entry in value]
    return value.item() if isinstance(value, np.generic) else value


MACHINES = {"hexapod": hexapod, "hexaglide": hexaglide}
