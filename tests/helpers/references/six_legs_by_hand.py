"""Machines with six legs of which a pencil finds everything, and hexaglides that are linear deltas."""

from __future__ import annotations

from typing import Any, NamedTuple

import numpy as np

from helpers.robots.six_legged import Case, Machine, _plain, hexaglide, rotation

WEIGHT = 9.81


class ByHand(NamedTuple):
    """Matrices in l_1..6 s_1..6, frequencies ascending [Hz], forces at s_1..6 [N]."""

    M: np.ndarray
    K: np.ndarray
    free: np.ndarray
    held: np.ndarray
    statics: np.ndarray


PLATFORM_MASS, INERTIA = 2.0, np.array([0.02, 0.03, 0.04])
ARM, LENGTH = 0.1, 0.5
STIFFNESS, MOTOR, TRAVEL = 3e6, 1e-5, 2e-3
BASE = {"mass": 0.3, "center": 0.08, "inertia": 4e-4}
ROD = {"mass": 0.2, "center": 0.07, "inertia": 3e-4}


def orthogonal(*, weight: bool) -> tuple[Case, ByHand]:
    """Two legs along x, two along y, two along z of a platform that is tilted together with all of them.

    Legs along x end at (0, +-d, 0), along y at (0, 0, +-d), along z at (+-d, 0, 0): seen from the platform, each pair
    moves with one translation v and turns with one rotation w, l = v -+ d w, and all six motions are decoupled.  With
    weight, which acts along -z of the platform, the legs are next to massless, and the legs along z carry half of it
    each: sideways they are inverted pendulums.
    """
    light = 1e-12 if weight else 1.0
    along = np.repeat(np.eye(3), 2, axis=0)
    joint = ARM * np.repeat(np.eye(3)[[1, 2, 0]], 2, axis=0) * np.tile([[1.0], [-1.0]], (3, 1))
    position, turn = np.array([0.02, -0.03, 0.4]), np.array([0.3, -0.2, 0.5])
    R = rotation(turn)
    base = position + (joint - LENGTH * along) @ R.T
    leg = {
        "stiffness": STIFFNESS,
        **{f"base_{key}": value * (1 if key == "center" else light) for key, value in BASE.items()},
        **{f"rod_{key}": value * (1 if key == "center" else light) for key, value in ROD.items()},
    }
    machine = {
        "format": 1,
        "name": "orthogonal",
        "mechanism": "hexapod",
        "gravity": -WEIGHT * float(weight) * R[:, 2],
        "platform": {"mass": PLATFORM_MASS, "center": [0.0, 0.0, 0.0], "inertia": INERTIA},
        "leg": leg,
        "motor": {"inertia": MOTOR, "travel": TRAVEL},
        "axis": [{"base": a, "joint": b, "limits": [0.3, 0.7]} for a, b in zip(base, joint, strict=True)],
    }
    case = Case(_plain(machine), (*map(float, position), *map(float, turn)))

    lengthwise = light * ROD["mass"]
    sideways = light * (
        (BASE["mass"] * BASE["center"] ** 2 + BASE["inertia"] + ROD["inertia"]) / LENGTH**2
        + ROD["mass"] * (1 - ROD["center"] / LENGTH) ** 2
    )
    moved = np.full(3, PLATFORM_MASS + 2 * lengthwise + 4 * sideways)
    # the pairs along x, y, z turn with rotations about z, x, y
    turned = INERTIA[[2, 0, 1]] + 2 * ARM**2 * (lengthwise + sideways)
    load = WEIGHT * float(weight) * PLATFORM_MASS
    softer = -load / LENGTH * np.array([1.0, 1.0, 0.0])
    softer_turned = -load / LENGTH * ARM**2 * np.array([1.0, 0.0, 0.0])

    def pairs(translation: np.ndarray, turning: np.ndarray) -> np.ndarray:
        blocks = [
            v / 4 * np.ones((2, 2)) + w / (4 * ARM**2) * np.array([[1, -1], [-1, 1]])
            for v, w in zip(translation, turning, strict=True)
        ]
        found = np.zeros((6, 6))
        for i, block in enumerate(blocks):
            found[2 * i : 2 * i + 2, 2 * i : 2 * i + 2] = block
        return found

    reflected = MOTOR / TRAVEL**2
    M, K = np.zeros((12, 12)), np.zeros((12, 12))
    M[:6, :6], M[6:, 6:] = pairs(moved, turned), reflected * np.eye(6)
    K[:6, :6] = pairs(softer, softer_turned)
    K += STIFFNESS * np.block([[np.eye(6), -np.eye(6)], [-np.eye(6), np.eye(6)]])
    # each motion is a mass on two springs
    masses = np.concatenate([moved, turned / ARM**2])
    stiffness = 2 * STIFFNESS + np.concatenate([softer, softer_turned / ARM**2])

    def sorted_hz(squares: np.ndarray) -> np.ndarray:
        return np.sort(np.sqrt(squares)) / (2 * np.pi)

    return case, ByHand(
        M,
        K,
        # only without weight; with it the rigid-body modes are coupled with the vibrations
        free=sorted_hz(2 * STIFFNESS * (1 / masses + 1 / (2 * reflected))),
        held=sorted_hz(stiffness / masses),
        statics=np.array([0, 0, 0, 0, load / 2, load / 2]),
    )


def vertical() -> tuple[Case, np.ndarray]:
    """Six vertical legs of equal length, and the derivatives of their lengths by the motion of the platform.

    Row j is (0, 0, 1, y_j, -x_j, 0): of x, y and a rotation about z the legs know nothing.
    """
    case, _ = orthogonal(weight=False)
    angles = np.radians([-15.0, 15.0, 105.0, 135.0, 225.0, 255.0])
    joint = ARM * np.stack([np.cos(angles), np.sin(angles), np.zeros(6)], axis=1)
    legs = [{"base": b.tolist(), "joint": b.tolist(), "limits": [0.3, 0.7]} for b in joint]
    machine = {**case.machine, "name": "vertical", "axis": legs}
    rows = np.zeros((6, 6))
    rows[:, 2], rows[:, 3], rows[:, 4] = 1, joint[:, 1], -joint[:, 0]
    return Case(machine, (0.0, 0.0, LENGTH, 0.0, 0.0, 0.0)), rows


class Pairs(NamedTuple):
    """A linear delta at a pose, and the hexaglide that has two parallel rods in place of each of its linkages.

    What both rods of an axis, their carriages, belts, pulleys and motors are together is what the delta has there.
    While the carriages of a pair move alike, the platform does not turn, and the hexaglide is the delta.
    """

    delta: Machine
    position: tuple[float, ...]
    six: Case


#: Value of one of a pair, as a part of that of the delta, by table and key.
HALVES = {
    ("link", "mass"): 0.5,
    ("carriage", "mass"): 0.5,
    ("belt", "width"): 0.5,
    ("pulley", "inertia"): 0.5,
    ("motor", "inertia"): 0.5,
    ("effects.gearbox_inertia", "inertia"): 0.5,
    ("effects.servo_stiffness", "stiffness"): 0.5,
    ("effects.belt_mass", "linear_density"): 0.5,
    ("effects.belt_end_compliance", "compliance"): 2.0,
    ("effects.gearbox_compliance", "compliance"): 2.0,
    ("effects.link_compliance", "compliance"): 2.0,
    ("effects.clamp_compliance", "compliance"): 2.0,
}

DELTA_EFFECTS: dict[str, dict[str, float]] = {
    "payload": {"mass": 0.35},
    "cable_stiffness": {"stiffness": 700.0},
    "frame_compliance": {"compliance": 2e-6},
    "gearbox_inertia": {"inertia": 3e-4},
    "servo_stiffness": {"stiffness": 20.0},
    "axis_belt_stiffness": {"factor_1": 0.05, "factor_2": -0.1, "factor_3": 0.15},
    "belt_mass": {"linear_density": 0.1},
    "belt_end_compliance": {"compliance": 3e-6},
    "belt_tension_stiffness": {"tension": 45.0, "coefficient": 2e-3},
    "gearbox_compliance": {"compliance": 2e-3},
    "link_compliance": {"compliance": 3e-7},
    "clamp_compliance": {"compliance": 4e-6},
}


def pairs(seed: int, *, effects: bool) -> Pairs:
    """Three of the six rods of a random hexaglide, and their platform, which does not turn."""
    while True:
        drawn, pose = hexaglide(seed)
        rng = np.random.default_rng([seed, 3])
        R = rotation(pose[3:])
        axes = [{**axis, "joint": (R @ axis["joint"]).tolist()} for axis in drawn["axis"][::2]]
        if np.linalg.cond(_rods(drawn, axes, pose)) < 6:
            break
        seed += 1000
    mass = {"mass": drawn["platform"]["mass"]}
    delta = {**drawn, "name": "delta", "mechanism": "linear_delta", "platform": mass, "axis": axes}
    size = float(np.abs([axis["joint"] for axis in axes]).max())
    apart = rng.normal(size=(3, 3)) * size * 0.4
    halved = _scaled(delta)
    doubled = [
        {
            **axis,
            "origin": (axis["origin"] + side * w).tolist(),
            "joint": (axis["joint"] + side * w).tolist(),
        }
        for axis, w in zip(halved["axis"], apart, strict=True)
        for side in (1, -1)
    ]
    six = {
        **halved,
        "name": "pairs",
        "mechanism": "hexaglide",
        "platform": drawn["platform"],
        "axis": doubled,
    }
    if effects:
        delta = {**delta, "effects": DELTA_EFFECTS}
        given = {
            name: {key: value * HALVES.get((f"effects.{name}", key), 1.0) for key, value in table.items()}
            for name, table in DELTA_EFFECTS.items()
        }
        factors = DELTA_EFFECTS["axis_belt_stiffness"]
        given["axis_belt_stiffness"] = {f"factor_{j + 1}": factors[f"factor_{j // 2 + 1}"] for j in range(6)}
        six = {**six, "effects": given}
    return Pairs(delta, pose[:3], Case(six, (*pose[:3], 0.0, 0.0, 0.0)))


def _rods(machine: Machine, axes: list[Machine], pose: Any) -> np.ndarray:
    found = []
    for axis in axes:
        n = np.array(axis["direction"])
        r = pose[:3] + np.array(axis["joint"]) - axis["origin"]
        across = r - (r @ n) * n
        length = axis.get("link", {}).get("length", machine["link"]["length"])
        rod = across - axis["branch"] * np.sqrt(length**2 - across @ across) * n
        found.append(rod / abs(rod @ n))
    return np.array(found)


def _scaled(machine: Machine) -> Machine:
    def table(name: str, values: Any) -> Any:
        if not isinstance(values, dict):
            return values
        return {
            key: value * HALVES[name, key] if (name, key) in HALVES else value
            for key, value in values.items()
        }

    found = {name: table(name, values) for name, values in machine.items()}
    found["axis"] = [{name: table(name, values) for name, values in axis.items()} for axis in machine["axis"]]
    return found


def together(six: tuple[str, ...], delta: tuple[str, ...]) -> np.ndarray:
    """Coordinates of the hexaglide by those of the delta: both of a pair are the one of their axis."""
    found = np.zeros((len(six), len(delta)))
    for row, name in zip(found, six, strict=True):
        stem, number, *rest = name.split("_")
        if number.isdigit():
            number = str((int(number) + 1) // 2)
        row[delta.index("_".join([stem, number, *rest]))] = 1.0
    return found
