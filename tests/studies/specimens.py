"""Specimens of the suites: machines on the rig, how they differ from their declaration, and how their files are read.

The rigs (`pkmodes_rig.engine`, `pkmodes_rig.corexy`, `pkmodes_rig.rotary_delta`) share no code with the model.
"""

from __future__ import annotations

import tempfile
import tomllib
from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass, field, replace
from functools import cache
from pathlib import Path
from typing import TypeVar

import numpy as np

from pkmodes import updating
from pkmodes.core.mechanism.registry import mechanism
from pkmodes.core.robot.reading import read_robot, robot_from_document
from pkmodes.core.robot.robot import Robot
from pkmodes.loop.measured.measurements import Measurements
from pkmodes.loop.measured.reading import read_measurements
from pkmodes.loop.sensitivity.paths import change_quantities, resolve
from pkmodes.loop.updating.channels import channels as channels_of
from pkmodes_rig import (
    BASE_RIGID,
    POSES,
    SENSORS,
    TrueModes,
    corexy,
    held_at,
    hexaglide,
    hexapod,
    rotary_delta,
    true_modes,
)
from pkmodes_rig import ROBOTS as DELTAS
from pkmodes_rig.robots import declared, with_effects
from studies.sizes import UNEQUAL

T = TypeVar("T")

ROBOTS = Path(__file__).resolve().parents[2] / "robots"
#: Sensor channels of a linear delta.
CHANNELS = tuple(channels_of(mechanism("linear_delta")))
#: Standard deviation of ln f, and the number of modes of a linear delta that are sought beyond the first three.
SIGMA, MODES = 0.002, 6
#: Band that is searched for modes of the other mechanisms: lowest frequency [Hz], and highest relative to the highest
#: frequency of the declared model at any pose.
LOWEST, HIGHEST = 2.0, 1.25


@dataclass(frozen=True)
class Kind:
    """A machine on the rig.

    Attributes
    ----------
    file : str
        The robot's file in ``robots/``; empty for a linear delta of the rig.
    rig : callable
        Returns the true modes for parameters, pose, effects and outside causes.
    rigid : int
        Number of modes that strain nothing.
    components, shapes : tuple of str
        Components of a pose, and sensor channels.
    points : ndarray, shape (12, d)
        Poses.
    uncertain : mapping
        Relative uncertainties of values whose file declares none, by the text that declares them.
    """

    file: str
    rig: Callable[..., TrueModes]
    rigid: int
    components: tuple[str, ...]
    shapes: tuple[str, ...]
    points: np.ndarray
    uncertain: Mapping[str, str] = field(default_factory=dict)


def spread(count: int, low: Sequence[float], high: Sequence[float]) -> np.ndarray:
    """Return poses that fill a box evenly, none on a plane of symmetry (Roberts' sequence R_d)."""
    d = len(low)
    golden = 2.0
    for _ in range(60):
        golden = (1.0 + golden) ** (1.0 / (d + 1))
    unit = (0.5 + np.outer(np.arange(1, count + 1), golden ** -np.arange(1.0, d + 1))) % 1.0
    return np.round(low + unit * (np.array(high) - low), 3)


KINDS = {
    "rotary_delta": Kind(
        "clavel-delta.toml",
        rotary_delta,
        3,
        ("x", "y", "z"),
        ("theta_1", "theta_2", "theta_3", "p_x", "p_y", "p_z"),
        spread(12, (-0.15, -0.15, -0.62), (0.15, 0.15, -0.42)),
    ),
    "corexy": Kind(
        "corexy-printer.toml",
        corexy,
        2,
        ("x", "y"),
        ("x", "y", "p_x", "p_y"),
        spread(12, (0.0, 0.0), (0.3, 0.3)),
    ),
}


#: What a platform that turns measures; sensors on the legs or carriages come before it.
PLATFORM = ("p_x", "p_y", "p_z", "r_x", "r_y", "r_z")
#: Machines with six legs; all poses of these boxes [m, rad] can be reached.
SIX_LEGGED = {
    "hexapod": Kind(
        "hexapod.toml",
        hexapod,
        6,
        ("x", "y", "z", "rx", "ry", "rz"),
        (*(f"l_{j}" for j in range(1, 7)), *PLATFORM),
        spread(12, (-0.018, -0.018, 0.232, -0.1, -0.1, -0.15), (0.018, 0.018, 0.252, 0.1, 0.1, 0.15)),
        {
            '[platform]\nmass = "6 kg"': "1 %",
            '[leg]\nstiffness = "1.2e7 N/m"': "2 %",
            '[motor]\ninertia = "6e-6 kg*m^2"': "2 %",
        },
    ),
    "hexaglide": Kind(
        "hexaglide.toml",
        hexaglide,
        6,
        ("x", "y", "z", "rx", "ry", "rz"),
        (*(f"x_{j}" for j in range(1, 7)), *PLATFORM),
        spread(12, (-0.08, -0.08, 0.1, -0.25, -0.25, -0.25), (0.08, 0.08, 0.35, 0.25, 0.25, 0.25)),
        {
            '[platform]\nmass = "1.1 kg"': "1 %",
            'specific_stiffness = "2.2e6 N/m"': "2 %",
            '[motor]\ninertia = "1.2e-5 kg*m^2"': "2 %",
        },
    ),
}
#: All of these, and the linear deltas of the rig, by name.
MACHINES = (
    KINDS
    | SIX_LEGGED
    | {
        name: Kind("", true_modes, BASE_RIGID, ("x", "y", "z"), SENSORS, np.array(POSES[name]["scattered"]))
        for name in DELTAS
    }
)


@dataclass(frozen=True)
class Specimen:
    """True state of a machine on the rig.

    Attributes
    ----------
    machine : str
        One of `MACHINES`, whose file is declared.
    effects : mapping
        Parameters of the catalogue's effects in SI units, by ``"<effect>.<parameter>"``.
    values : mapping
        True values in SI units, by dotted path, where they are not the declared ones.
    outside : mapping
        Sizes of causes outside the catalogue.
    drives : str
        What the motors do in the test: ``free``, ``held``, or ``mixed``, see `pkmodes_rig.held_at`.
    """

    machine: str
    effects: Mapping[str, float] = field(default_factory=dict)
    values: Mapping[str, float] = field(default_factory=dict)
    outside: Mapping[str, float] = field(default_factory=dict)
    drives: str = "free"

    @property
    def sizes(self) -> dict[str, float]:
        """True values of all that differs from the declaration and can be named, by parameter of the diagnosis."""
        return {**self.values, **{f"effects.{name}": value for name, value in self.effects.items()}}

    def built(self) -> Robot:
        """Return the robot with its true values."""
        declared = robot_of(self.machine)
        paths = [(resolve(declared, path), value) for path, value in self.values.items()]
        return change_quantities(declared, [(path, value - path.value) for path, value in paths])

    def modes(self, points: Sequence[np.ndarray] | np.ndarray) -> list[TrueModes]:
        """Return the true modes at some poses."""
        robot = self.built()
        effects, rig = {**robot.constants, **self.effects}, MACHINES[self.machine].rig
        held = held_at(self.drives, len(points))
        return [
            rig(robot.parameters, p, effects, self.outside, held=h) for p, h in zip(points, held, strict=True)
        ]


@cache
def robot_of(machine: str) -> Robot:
    """Return the declared robot."""
    if machine not in DELTAS and not MACHINES[machine].uncertain:
        return replace(read_robot(ROBOTS / MACHINES[machine].file), drives="free")
    return robot_from_document(tomllib.loads(text_of(machine)), machine)


def text_of(machine: str) -> str:
    """Return the text of the robot file."""
    if machine in DELTAS:
        return with_effects(machine, {})
    file, uncertain = ROBOTS / MACHINES[machine].file, MACHINES[machine].uncertain
    return declared(file, uncertain)


@cache
def band(machine: str) -> tuple[float, float]:
    """Return the frequency band that is searched for modes [Hz]."""
    highest = [modes.frequencies[-1] for modes in Specimen(machine).modes(MACHINES[machine].points)]
    return LOWEST, float(f"{HIGHEST * max(highest):.3g}")


def effects_of(name: str) -> list[str]:
    """Return the effects of a mechanism in the suites.

    Left out are those that only dissipate, and those that do nothing where no tension and no inertia of a beam are
    declared.
    """
    left_out = ("belt_tension_stiffness", "gantry_racking")
    return [effect for effect in mechanism(name).conservative_effects if effect not in left_out]


def with_effect(machine: str, effect: str, size: float, parts: Sequence[float] = UNEQUAL) -> Specimen:
    """Return a machine with one effect of the catalogue; the factors of a group have these parts of the size."""
    described = robot_of(machine).mechanism.effects[effect]
    fitted = [p.name for p in described.forms[effect]]
    sizes = [size * part for part in parts] if len(fitted) > 1 else [size]
    return Specimen(machine, {f"{effect}.{name}": s for name, s in zip(fitted, sizes, strict=False)})


def with_wrong(machine: str, path: str, change: float) -> Specimen:
    """Return a machine with one wrong declared value, by this change in SI units."""
    return Specimen(machine, values={path: resolve(robot_of(machine), path).value + change})


def with_outside(machine: str, kind: str, size: float) -> Specimen:
    """Return a machine with one cause outside the catalogue."""
    return Specimen(machine, outside={kind: size})


def measurements(text: str, channels: Sequence[str] = CHANNELS) -> Measurements:
    """Read the text of a measurement file with these channels, by default those of a linear delta."""
    return _from_file(text, lambda path: read_measurements(path, channels))


def measurements_of(text: str, robot: Robot) -> Measurements:
    """Read the text of a measurement file of a robot."""
    return _from_file(text, lambda path: updating.read(path, robot=robot))


def _from_file(text: str, reader: Callable[[Path], T]) -> T:
    with tempfile.TemporaryDirectory() as folder:
        path = Path(folder) / "modes.csv"
        path.write_text(text, encoding="utf-8")
        return reader(path)
