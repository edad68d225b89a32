"""Modes of the oracles' matrices in 60 digits, and the model of `pkmodes` for the same robot."""

from __future__ import annotations

from dataclasses import replace
from pathlib import Path
from typing import Any

import numpy as np

import pkmodes
from helpers.references.high_precision import solved
from helpers.references.high_precision_mechanisms import HighPrecision, mp
from helpers.robots.one_of_each import load_free
from helpers.robots.sample_mechanisms import Sample, description, oracle

FILES = {"rotary_delta": "clavel-delta.toml", "corexy": "corexy-printer.toml"}
ROBOTS = Path(__file__).parents[3] / "robots"


def free(name: str, chosen: Any) -> dict[str, float]:
    """Return the compliances of the joints that the chosen effects release, by coordinate."""
    found = {}
    for effect in description(name)["effects"]:
        for c in effect["coordinates"]:  # what yields in series adds up
            own = f"compliance_{c['name'].removeprefix('u_')}"
            fields = (f"{effect['name']}_{name}" for name in ("compliance", own))
            compliance = sum(getattr(chosen, field, 0.0) for field in fields)
            found |= {c["name"]: compliance} if compliance else {}
    return found


def exact(name: str, robot: Sample, chosen: Any) -> tuple[HighPrecision, Any, list[int]]:
    """Return the oracle, its modes, and which coordinates are free."""
    it, released = oracle(name, robot, chosen), free(name, chosen)
    kept = [i for i, c in enumerate(it.coordinates) if i < it.base or c in released]
    M, K = it.mass_matrix(), it.elastic_hessian() + it.gravity_hessian()
    for i in kept[it.base :]:
        K[i, i] += 1 / mp.mpf(released[it.coordinates[i]])
    # differences leave 1e-24 where a clamp has no inertia
    M[np.abs(M.astype(float)) < 1e-18] = mp.mpf(0)
    return it, solved(*(mp.matrix(a[np.ix_(kept, kept)].tolist()) for a in (M, K))), kept


def model_of(name: str, robot: Sample, chosen: Any) -> pkmodes.Model:
    parameters = robot.parameters
    if name == "rotary_delta":  # which do not affect modes
        parameters = parameters._replace(limits=np.tile([-np.pi, np.pi], (3, 1)))
    values, constants = {}, {}
    for effect in description(name)["effects"]:
        for parameter in effect["parameters"]:
            value = getattr(chosen, f"{effect['name']}_{parameter['name']}")
            path = f"{effect['name']}.{parameter['name']}"
            if not parameter["fitted"] and not path.startswith("belt_tension"):
                constants[path] = value or {"frame_compliance.mass": 50.0}.get(path, 0.0)
            if value:
                values[f"{effect['name']}.{parameter['name']}"] = value
    read = load_free(FILES[name]).robot
    return pkmodes.Model(replace(read, parameters=parameters, effects=values, constants=constants))
