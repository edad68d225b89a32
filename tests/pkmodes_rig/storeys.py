"""Storey frames on the virtual test rig: true modes of masses sliding on springs, computed with MuJoCo.

Every floor is a body that slides relative to the floor below, and its storey is the spring in between, so the
coordinates are the storey drifts.  The engine supplies inertia, spring forces and the motion of every floor; no
formula of the diagnosed models is used.
"""

from __future__ import annotations

import xml.etree.ElementTree as ET
from collections.abc import Mapping, Sequence

import mujoco
import numpy as np
from scipy.linalg import eigh

from pkmodes_rig.engine import TrueModes
from pkmodes_rig.mujoco_engine import _add as add
from pkmodes_rig.mujoco_engine import _mass as inertial


def channels(storeys: int) -> tuple[str, ...]:
    """Return the names of the floor displacements."""
    return tuple(f"floor {i}" for i in range(1, storeys + 1))


def storey_modes(
    masses: Sequence[float],
    stiffnesses: Sequence[float],
    *,
    braces: Mapping[tuple[int, int], float] = {},
    absorbers: Mapping[int, tuple[float, float]] = {},
) -> TrueModes:
    """Compute the modes of a frame that is fixed to the ground and moves in one direction.

    Parameters
    ----------
    masses, stiffnesses : sequence of float
        Mass of each floor [kg] and stiffness of the storey below it [N/m].
    braces : mapping of (int, int) to float
        Stiffness of springs between two floors, numbered from 1, with 0 for the ground [N/m].
    absorbers : mapping of int to (float, float)
        Mass [kg] and stiffness [N/m] of an oscillator on a floor.

    Returns
    -------
    TrueModes
        No rigid-body mode; shapes at `channels`.
    """
    root = ET.Element("mujoco")
    add(root, "compiler", boundmass=0.0, boundinertia=0.0, balanceinertia="false")
    add(root, "option", gravity=np.zeros(3), jacobian="dense")
    below = ET.SubElement(root, "worldbody")
    tendons = ET.SubElement(root, "tendon")
    for floor, (mass, stiffness) in enumerate(zip(masses, stiffnesses, strict=True), start=1):
        below = _sliding(below, f"floor {floor}", mass, stiffness)
        if floor in absorbers:
            _sliding(below, f"absorber {floor}", *absorbers[floor])
    for (low, high), stiffness in braces.items():
        brace = add(tendons, "fixed", stiffness=stiffness, springlength=0.0)
        for floor in range(low + 1, high + 1):
            add(brace, "joint", joint=f"floor {floor}", coef=1.0)
    return _solved(mujoco.MjModel.from_xml_string(ET.tostring(root, encoding="unicode")), len(masses))


def _sliding(below: ET.Element, name: str, mass: float, stiffness: float) -> ET.Element:
    body = add(below, "body", name=name)
    add(body, "joint", name=name, type="slide", axis=np.array([1.0, 0.0, 0.0]), stiffness=stiffness)
    inertial(body, mass, np.ones(3))  # does not rotate: any inertia will do
    return body


def _solved(model: mujoco.MjModel, storeys: int) -> TrueModes:
    data = mujoco.MjData(model)
    mujoco.mj_forward(model, data)
    M, K = np.zeros((2, model.nv, model.nv))
    for i, unit in enumerate(np.eye(model.nv)):
        mujoco.mj_mulM(model, data, M[i], unit)
    for i, unit in enumerate(np.eye(model.nv)):
        data.qpos[:] = unit
        mujoco.mj_forward(model, data)
        K[i] = -data.qfrc_passive
    data.qpos[:] = 0.0
    mujoco.mj_forward(model, data)
    motion, jacobian = np.zeros((storeys, model.nv)), np.zeros((3, model.nv))
    for i, name in enumerate(channels(storeys)):
        body = mujoco.mj_name2id(model, mujoco.mjtObj.mjOBJ_BODY, name)
        mujoco.mj_jacBody(model, data, jacobian, None, body)
        motion[i] = jacobian[0]
    eigenvalues, vectors = eigh(K, M)
    names = [mujoco.mj_id2name(model, mujoco.mjtObj.mjOBJ_JOINT, i) for i in range(model.njnt)]
    return TrueModes(
        frequencies=np.sqrt(eigenvalues) / (2 * np.pi),
        rigid=0,
        shapes=dict(zip(channels(storeys), motion @ vectors, strict=True)),
        mass_matrix=M,
        stiffness_matrix=K,
        coordinates=tuple(names),
    )
