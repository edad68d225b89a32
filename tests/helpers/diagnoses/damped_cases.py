"""Frequencies and damping ratios of machines of the virtual rig, whose joints dissipate as the rig describes them."""

from __future__ import annotations

from collections.abc import Mapping
from functools import cache
from typing import Any

import numpy as np

from pkmodes.loop.diagnosis.verdict.result import Diagnosis
from pkmodes.loop.measured.measurements import Measurements
from pkmodes_rig import TrueModes
from pkmodes_rig.dissipation import coulomb_ratios, damping_ratios
from studies.specimens import MACHINES, Specimen, robot_of

#: Poses, and the most modes at each.
POSES, MODES = 8, 6
#: Standard deviations of ln f and ln zeta, which are stated.
SIGMA, SCATTER = 0.002, 0.05
#: Amplitude of the platform in every mode, for Coulomb friction [m sqrt(kg)].
AMPLITUDE = 1e-4


@cache
def _true(machine: str, drives: str, effects: tuple[tuple[str, float], ...]) -> tuple[TrueModes, ...]:
    return tuple(Specimen(machine, dict(effects), drives=drives).modes(MACHINES[machine].points[:POSES]))


def columns(
    losses: Mapping[str, float],
    *,
    machine: str = "published",
    drives: str = "free",
    effects: Mapping[str, float] = {},
    coulomb: float = 0.0,
    scatter: float = SCATTER,
    seed: int = 11,
) -> dict[str, np.ndarray]:
    """Return pose, frequency and damping of each measured mode, and whether the motors are held."""
    rng, parameters = np.random.default_rng(seed), Specimen(machine).built().parameters
    name, points = robot_of(machine).mechanism_name, MACHINES[machine].points[:POSES]
    rows = []
    for k, (p, at) in enumerate(zip(points, _true(machine, drives, tuple(effects.items())), strict=True)):
        ratio = damping_ratios(name, parameters, p, at, losses)
        if coulomb:
            moved = np.abs([at.shapes[c] for c in ("p_x", "p_y", "p_z") if c in at.shapes]).max(axis=0)
            ratio = ratio + coulomb_ratios(name, at, coulomb, AMPLITUDE / moved)
        some = slice(at.rigid, at.rigid + MODES)
        rows += [(k, f, z, at.held) for f, z in zip(at.frequencies[some], ratio[some], strict=True)]
    pose, frequency, damping, held = (np.array(column) for column in zip(*rows, strict=True))
    frequency = frequency * np.exp(rng.normal(0.0, SIGMA, len(pose)))
    damping = damping * np.exp(rng.normal(0.0, scatter, len(pose)))
    return {"pose": pose, "frequency": frequency, "damping": damping, "held": held}


def made(
    rows: Mapping[str, np.ndarray],
    *,
    machine: str = "published",
    sigma: np.ndarray | None = None,
    stated: bool = True,
    shapes: Mapping[str, np.ndarray] | None = None,
    **settings: np.ndarray,
) -> Measurements:
    """Return measurements of rows, which may lack damping; `settings` by path with underscores for dots."""
    pose, damping = rows["pose"], rows.get("damping")
    if sigma is None and stated and damping is not None:
        sigma = SCATTER * damping
    return Measurements.from_rows(
        [f"P{k + 1}" for k in pose],
        rows["frequency"],
        SIGMA * rows["frequency"],
        points=MACHINES[machine].points[pose],
        damping=damping,
        damping_sigma=sigma,
        shapes=shapes,
        drives=["held" if held else "free" for held in rows["held"]],
        components=dict.fromkeys(MACHINES[machine].components, "m"),
        settings={path.replace("__", "."): value for path, value in settings.items()} or None,
    )


def bare(rows: Mapping[str, np.ndarray]) -> dict[str, np.ndarray]:
    """Rows without damping."""
    return {name: column for name, column in rows.items() if name != "damping"}


def strange(rows: Mapping[str, np.ndarray]) -> dict[str, np.ndarray]:
    """Rows in which each mode has a damping of its own, like that of no joint."""
    own = np.array([1.0, 6.0, 0.3, 4.0, 0.2, 2.0])
    return {**rows, "damping": rows["damping"] * np.resize(own, len(rows["pose"]))}


def of_frequencies(found: Diagnosis) -> dict[str, Any]:
    """All that is said of frequencies and shapes."""
    content: Any = found.as_json()
    rows = [{key: row[key] for key in row if "damping" not in key} for row in content["rows"]]
    return {**content, "damping": None, "rows": rows}


def measured(losses: Mapping[str, float], *, machine: str = "published", **options: object) -> Measurements:
    """Return measured modes of a machine with losses as for `pkmodes_rig.dissipation.damping_ratios`."""
    return made(columns(losses, machine=machine, **options), machine=machine)  # type: ignore[arg-type]
