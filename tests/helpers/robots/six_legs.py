"""Six legs by hand, from nothing but the joints of the robot file: lengths, and what they do to the platform."""

from __future__ import annotations

from pathlib import Path

import numpy as np
from scipy.spatial.transform import Rotation

import pkmodes

FILE = Path(__file__).resolve().parents[3] / "robots" / "hexapod.toml"
#: A pose without symmetry.
POSE = np.array([0.012, -0.02, 0.255, 0.11, -0.06, 0.15])


def hexapod(values: dict[str, float | str] | None = None) -> pkmodes.Model:
    return pkmodes.load(FILE).with_values(values or {})


def lengths(model: pkmodes.Model, position: np.ndarray, rotation: Rotation) -> np.ndarray:
    """l_j = |p + R b_j - a_j| (docs/model.md)."""
    of = model.robot.parameters
    return np.linalg.norm(position + rotation.apply(np.array(of.joint)) - of.base, axis=1)


def motion(model: pkmodes.Model, pose: np.ndarray) -> np.ndarray:
    """Displacement and small rotation about base axes per change of each leg, (6, 6): u_j and r_j x u_j, inverted."""
    of, turned = model.robot.parameters, Rotation.from_rotvec(np.array(pose[3:]))
    levers = turned.apply(np.array(of.joint))
    u = pose[:3] + levers - of.base
    u /= np.linalg.norm(u, axis=1, keepdims=True)
    return np.linalg.inv(np.hstack([u, np.cross(levers, u)]))
