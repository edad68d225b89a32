"""The campaign of examples/hexapod: a hammer and three accelerometers on a platform that turns, one leg of it softer.

    python -m pkmodes_rig.signals.tapped_hexapod examples/hexapod

Mass and stiffness are those of the 60-digit oracle, which has them from the contract of robot files.  The folder has
the robot file, which does not declare the softer leg.
"""

from __future__ import annotations

import argparse
import tomllib
from collections.abc import Iterator, Mapping
from pathlib import Path
from typing import Any, NamedTuple

import numpy as np

from helpers.references.oracle_six_legged import Hexapod
from helpers.robots.six_legged import rotation
from pkmodes.core.robot.reading import robot_from_document
from pkmodes_rig.signals import universal

SEED = 39
#: What the robot file does not say, and by how much what it calls uncertain is off.
FACTOR = {3: -0.25}
OFF: Mapping[str, Any] = {"mass": 0.008, "inertia": (-0.015, 0.02, 0.01), "stiffness": -0.04}
#: Position [m] and rotation vector [rad] of each pose; the file states millimetres and degrees.
POSES: Mapping[str, tuple[float, ...]] = {
    label: (*np.array(pose[:3]) / 1e3, *np.radians(pose[3:]))
    for label, pose in {
        "P1": (0, 0, 232, 0, 0, 0),
        "P2": (20, 0, 235, 4, 6, 0),
        "P3": (-15, 18, 240, -5, 3, 8),
        "P4": (-10, -20, 228, 6, -5, -6),
        "P5": (12, -14, 245, -3, -7, 10),
        "P6": (0, 22, 250, 8, 0, -9),
        "P7": (-22, 4, 236, 0, 8, 5),
        "P8": (8, 10, 226, -6, -4, 3),
    }.items()
}
#: Accelerometers with three axes, by node: where they are glued to the platform, in its axes [m].
GLUED: Mapping[int, tuple[float, float, float]] = {
    1: (0.110, 0.0, 0.03),
    2: (-0.055, 0.095, 0.03),
    3: (-0.055, -0.095, 0.03),
}
#: Where the hammer hits an oblique face of the platform [m], and in which direction.
HIT, BLOW = (0.060, -0.080, 0.025), (-0.36, 0.48, -0.80)
HAMMER = (4, -3)
#: Loss factor of each leg; scatter of a leg's stiffness from file to file, as its screw stands anew.
LOSSES, SCATTER = (0.016, 0.018, 0.024, 0.017, 0.020, 0.016), 0.001
REPEATS, AVERAGES = 2, 5
#: Length of a record [s]; last line [Hz]; largest force [N] and duration [s] of a blow.
SECONDS, LOWEST, HIGHEST, FORCE, CONTACT = 2.0, 60.0, 500.0, (80.0, 160.0), 0.0012
#: One-sided power spectral density of the accelerometers' noise [(m/s^2)^2/Hz].
NOISE = 4e-6


class Still(NamedTuple):
    """The machine at a pose, its motors at rest: by the lengths of its legs."""

    M: np.ndarray
    K: np.ndarray
    #: Of each leg's transmission [N/m].
    springs: np.ndarray
    #: What each channel reads, in the order of the files; what the hammer drives.
    channels: np.ndarray
    blow: np.ndarray


def machine(parameters: Any) -> dict[str, Any]:
    """Return what the oracle takes, with the true values."""
    p = parameters
    leg = ("base_mass", "base_center", "base_inertia", "rod_mass", "rod_center", "rod_inertia")
    return {
        "mechanism": "hexapod",
        "gravity": p.gravity.tolist(),
        "platform": {
            "mass": p.platform_mass * (1 + OFF["mass"]),
            "center": p.platform_center.tolist(),
            "inertia": (p.platform_inertia * (1 + np.array(OFF["inertia"]))).tolist(),
        },
        "leg": {
            "stiffness": float(p.leg_stiffness[0]) * (1 + OFF["stiffness"]),
            **{key: float(getattr(p, f"leg_{key}")[0]) for key in leg},
        },
        "motor": {"inertia": float(p.motor_inertia[0]), "travel": float(p.motor_travel[0])},
        "axis": [
            {"base": base.tolist(), "joint": joint.tolist()}
            for base, joint in zip(p.base, p.joint, strict=True)
        ],
        "effects": {"axis_leg_stiffness": {f"factor_{j}": value for j, value in FACTOR.items()}},
    }


def still(one: dict[str, Any], pose: tuple[float, ...]) -> Still:
    """Return the machine at a pose."""
    found = Hexapod(one, pose).result()
    legs = slice(0, 6)
    R, motion = rotation(pose[3:]), found.platform[:, legs]

    def along(direction: np.ndarray, place: tuple[float, ...]) -> np.ndarray:
        d = R @ direction
        return np.concatenate([d, np.cross(R @ np.array(place), d)]) @ motion

    channels = [along(axis, place) for place in GLUED.values() for axis in np.eye(3)]
    springs = [one["leg"]["stiffness"] * (1 + FACTOR.get(j + 1, 0.0)) for j in range(6)]
    hammer = along(np.array(BLOW) / np.linalg.norm(BLOW), HIT)
    return Still(found.M[legs, legs], found.K[legs, legs], np.array(springs), np.array(channels), hammer)


def functions(at: Still, lines: np.ndarray, rng: np.random.Generator) -> np.ndarray:
    """Return H1 of some blows, accelerations per force, shape (lines, channels)."""
    changed = at.springs * rng.normal(scale=SCATTER, size=6)
    complex_springs = np.diag(changed + 1j * np.array(LOSSES) * at.springs)
    square = (2 * np.pi * lines)[:, None, None] ** 2
    motion = np.linalg.solve(at.K + complex_springs - square * at.M, at.blow[:, None])[:, :, 0]
    exact = -square[:, 0] * motion @ at.channels.T
    # half a sine of some height and length
    height, length = rng.uniform(*FORCE, (AVERAGES, 1)), CONTACT * rng.uniform(0.9, 1.1, (AVERAGES, 1))
    force = height * 2 * length / np.pi * np.cos(np.pi * lines * length) / (1 - (2 * lines * length) ** 2)
    size = np.sqrt(NOISE * SECONDS / 4)  # of the real and of the imaginary part
    noise = size * rng.standard_normal((AVERAGES, *exact.shape, 2)) @ np.array([1, 1j])
    heard = exact * force[:, :, None] + noise
    return np.sum(heard * force[:, :, None], axis=0) / np.sum(force**2, axis=0)[:, None]


def files(folder: Path, poses: Mapping[str, tuple[float, ...]] = POSES) -> Iterator[tuple[str, bytes]]:
    """Yield the name and contents of each file, for the robot file in the folder."""
    document = tomllib.loads((folder / "robot.toml").read_text(encoding="utf-8"))
    one = machine(robot_from_document(document, "robot.toml").parameters)
    lines = np.arange(LOWEST, HIGHEST + 0.1, 1.0 / SECONDS)
    for number, (label, pose) in enumerate(poses.items()):
        at = still(one, pose)
        for repeat in range(REPEATS):
            H = functions(at, lines, np.random.default_rng([SEED, number, repeat]))
            places = [(node, axis) for node in GLUED for axis in (1, 2, 3)]
            parts = [
                universal.dataset(universal.FRF, place, HAMMER, LOWEST, 1.0 / SECONDS, column)
                for place, column in zip(places, H.T, strict=True)
            ]
            yield f"{label}_{repeat + 1}.uff", b"".join(parts)


def main() -> None:
    """Write the measurements of the example."""
    parser = argparse.ArgumentParser(description="Write the measurements of a hexapod that is tapped.")
    parser.add_argument("folder", type=Path, help="has robot.toml")
    folder = parser.parse_args().folder
    for name, contents in files(folder):
        (folder / name).write_bytes(contents)


if __name__ == "__main__":
    main()
