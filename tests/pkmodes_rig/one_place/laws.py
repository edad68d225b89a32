"""Twelve laws that no term has: what a stiffness depends on, geometry, damping, gyroscopic forces, two faults."""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass, replace
from typing import Any

import numpy as np
from scipy.spatial.transform import Rotation

from pkmodes_rig.engine import TrueModes
from pkmodes_rig.one_place.linkage import AXES
from pkmodes_rig.one_place.machines import Assembly, assembled

#: The laws, each with the meaning of its size; "drives" are the springs of belts, reducers or legs.
LAWS = {
    "travel": "the stiffness of all drives depends on where they are on their travel: by [a part] to either side",
    "worn patch": "the drive of one axis is softer near one place of its travel [by a part]",
    "dispersive": "the stiffness of all drives grows with the logarithm of the frequency [by a part for a factor e]",
    "drift": "all drives become softer in the order of the poses [by a part in all]",
    "warm-up": "all drives become softer in the order of the poses, the first ones most [by a part in all]",
    "temperature steps": "three levels of temperature change the stiffness of all drives [by parts of a part]",
    "amplitude": "the drives are softer the larger the vibration, which differs from row to row [by a part, median]",
    "turned rail": "the rail, arm axis or base of one leg is turned [rad], in a direction that no value has",
    "displaced joint": "one joint of the platform is displaced obliquely [m]",
    "gyroscopic": "a spinning body couples the velocities of the platform in x and y [N s/m]",
    "dashpot": "viscous friction at one place, so strong that it changes the frequencies [N s/m, N m s/rad]",
    "two faults": "two faults of different forms at different places [each as large as one alone]",
}
#: Laws of printers: these have no legs; the tool head and the bed of a bed slinger share no direction.
WITHOUT_LEGS = tuple(law for law in LAWS if law not in ("turned rail", "displaced joint"))
#: Width of a worn patch and time of a warm-up, as parts of the travel and of the number of poses.
PATCH, WARM = 0.15, 0.25
#: Standard deviation of the logarithm of amplitudes.
SPREAD = 0.7
#: Oblique directions of a displaced joint and for a turned rail.
OBLIQUE = np.array([2.0, -6.0, 3.0]) / 7
#: Iterations of a frequency that depends on itself.
ITERATIONS = 6


@dataclass(frozen=True)
class Setting:
    """A machine whose modes are measured: `poses` in the order of measurement, with `seed` for what is drawn."""

    mechanism: str
    q: Any
    points: np.ndarray
    frame: float
    seed: int

    def machines(self, q: Any = None) -> list[Assembly]:
        """Return the machine at all poses, with other parameters if these are given."""
        parameters = self.q if q is None else q
        return [assembled(self.mechanism, parameters, p, frame=self.frame) for p in self.points]

    @property
    def rng(self) -> np.random.Generator:
        """The same draws every time."""
        return np.random.default_rng(self.seed)


def laws_of(mechanism: str) -> tuple[str, ...]:
    """Return the laws that a mechanism can follow."""
    if mechanism in ("corexy", "cartesian"):
        return WITHOUT_LEGS
    if mechanism == "bed_slinger":
        return tuple(law for law in WITHOUT_LEGS if law != "gyroscopic")
    return tuple(LAWS)


def modes_by_law(law: str, setting: Setting, size: float) -> list[TrueModes]:
    """Return the modes at all poses of a machine that follows a law; two faults are no law of this function."""
    return _LAWS[law](size, setting)


# What the stiffness of the drives depends on -------------------------------------------------------------------


def _travel(size: float, setting: Setting) -> list[TrueModes]:
    return [machine.modes(1.0 + size * (2 * machine.travel - 1)) for machine in setting.machines()]


def _worn_patch(size: float, setting: Setting) -> list[TrueModes]:
    machines, rng = setting.machines(), setting.rng
    axis, pose = int(rng.integers(len(machines[0].travel))), int(rng.integers(len(machines)))
    centre, found = machines[pose].travel[axis], []
    for machine in machines:
        factors = np.ones(len(machine.travel))
        factors[axis] = 1.0 / (1.0 + size * np.exp(-(((machine.travel[axis] - centre) / PATCH) ** 2)))
        found.append(machine.modes(factors))
    return found


def _in_order(size: float, setting: Setting, progress: np.ndarray) -> list[TrueModes]:
    softer = 1.0 / (1.0 + size * progress)
    return [machine.modes(float(s)) for machine, s in zip(setting.machines(), softer, strict=True)]


def _drift(size: float, setting: Setting) -> list[TrueModes]:
    return _in_order(size, setting, np.linspace(0.0, 1.0, len(setting.points)))


def _warm_up(size: float, setting: Setting) -> list[TrueModes]:
    time = np.arange(len(setting.points)) / (WARM * len(setting.points))
    return _in_order(size, setting, 1.0 - np.exp(-time))


def _temperature_steps(size: float, setting: Setting) -> list[TrueModes]:
    blocks = np.array_split(np.arange(len(setting.points)), 3)
    levels = setting.rng.permutation([0.0, 0.5, 1.0])
    progress = np.concatenate(
        [np.full(len(block), level) for block, level in zip(blocks, levels, strict=True)]
    )
    return _in_order(size, setting, progress)


def _dispersive(size: float, setting: Setting) -> list[TrueModes]:
    """Return modes each of which has the stiffness of its own frequency."""
    found = []
    for machine in setting.machines():
        plain = machine.modes()
        middle = float(np.exp(np.mean(np.log(plain.frequencies[plain.rigid :]))))
        columns = []
        for i in range(len(plain.frequencies)):
            modes = plain
            for _ in range(ITERATIONS if i >= plain.rigid else 0):
                frequency = modes.frequencies[i]
                modes = machine.modes(float(np.exp(size * np.log(frequency / middle))))
            columns.append((modes, i))
        found.append(_columns(plain, columns))
    return found


def _amplitude(size: float, setting: Setting) -> list[TrueModes]:
    """Return modes each of which has been excited as strongly as it happened."""
    rng, found = setting.rng, []
    for machine in setting.machines():
        plain = machine.modes()
        amplitudes = np.exp(SPREAD * rng.standard_normal(len(plain.frequencies)))
        softer = [machine.modes(float(1.0 / (1.0 + size * a))) for a in amplitudes]
        found.append(_columns(plain, [(modes, i) for i, modes in enumerate(softer)]))
    return found


def _columns(plain: TrueModes, columns: Sequence[tuple[TrueModes, int]]) -> TrueModes:
    """Return modes that are each from other modes, by their places."""
    shapes = {name: np.array([modes.shapes[name][i] for modes, i in columns]) for name in plain.shapes}
    return replace(plain, frequencies=np.array([modes.frequencies[i] for modes, i in columns]), shapes=shapes)


# Geometry ------------------------------------------------------------------------------------------------------


def _turned_rail(size: float, setting: Setting) -> list[TrueModes]:
    q, rng = setting.q, setting.rng
    field, others = {"rotary_delta": ("axis", ("zero",)), "hexapod": ("base", ())}.get(
        setting.mechanism, ("direction", ())
    )
    leg = int(rng.integers(len(q.joint)))
    across = np.array([0.0, 0.0, 1.0])
    if field != "base":
        across = np.cross(getattr(q, field)[leg], OBLIQUE)
    turn = Rotation.from_rotvec(size * across / np.linalg.norm(across)).as_matrix()
    changed = {}
    for name in (field, *others):
        changed[name] = np.array(getattr(q, name), dtype=float)
        changed[name][leg] = turn @ changed[name][leg]
    return [machine.modes() for machine in setting.machines(q._replace(**changed))]


def _displaced_joint(size: float, setting: Setting) -> list[TrueModes]:
    joint = np.array(setting.q.joint, dtype=float)
    joint[int(setting.rng.integers(len(joint)))] += size * OBLIQUE
    return [machine.modes() for machine in setting.machines(setting.q._replace(joint=joint))]


# Velocities ----------------------------------------------------------------------------------------------------


def _gyroscopic(size: float, setting: Setting) -> list[TrueModes]:
    found = []
    for machine in setting.machines():
        modes = machine.modes()
        x, y = modes.shapes["p_x"], modes.shapes["p_y"]
        found.append(_with_velocities(modes, size * (np.outer(x, y) - np.outer(y, x))))
    return found


def _dashpot(size: float, setting: Setting) -> list[TrueModes]:
    machines, found = setting.machines(), []
    every = [(name, d) for name, place in machines[0].places.items() for d in place.rows if d in ("", *AXES)]
    name, direction = every[int(setting.rng.integers(len(every)))]
    for machine in machines:
        modes = machine.modes()
        shapes = np.array([modes.shapes[coordinate] for coordinate in machine.rows.names])
        moved = machine.places[name].rows[direction] @ shapes
        found.append(_with_velocities(modes, size * np.outer(moved, moved)))
    return found


def _with_velocities(modes: TrueModes, coupling: np.ndarray) -> TrueModes:
    """Return the modes with forces that are a matrix, in modal coordinates, times the velocities.

    Frequencies are the absolute values of the eigenvalues; a shape is the real part at the phase at which it is the
    largest.  What does not vibrate any more, or nearly so, is no mode.
    """
    n = len(modes.frequencies)
    omega = 2 * np.pi * modes.frequencies
    stiffness = np.diag(omega * np.abs(omega))
    stiffness[: modes.rigid, : modes.rigid] = 0.0
    system = np.block([[np.zeros((n, n)), np.eye(n)], [-stiffness, -coupling]])
    values, vectors = np.linalg.eig(system)
    least = np.abs(omega[modes.rigid]) * 0.3
    kept = [i for i in np.argsort(np.abs(values)) if values[i].imag > least]
    columns = []
    for i in kept:
        vector = vectors[:n, i]
        vector = vector * np.exp(-0.5j * np.angle(np.sum(vector**2)))
        columns.append(vector.real / np.linalg.norm(vector.real))
    own = np.column_stack([np.eye(n)[:, : modes.rigid], *columns])
    frequencies = np.concatenate([modes.frequencies[: modes.rigid], np.abs(values[kept]) / (2 * np.pi)])
    return replace(
        modes, frequencies=frequencies, shapes={name: row @ own for name, row in modes.shapes.items()}
    )


_LAWS: Mapping[str, Callable[[float, Setting], list[TrueModes]]] = {
    "travel": _travel,
    "worn patch": _worn_patch,
    "dispersive": _dispersive,
    "drift": _drift,
    "warm-up": _warm_up,
    "temperature steps": _temperature_steps,
    "amplitude": _amplitude,
    "turned rail": _turned_rail,
    "displaced joint": _displaced_joint,
    "gyroscopic": _gyroscopic,
    "dashpot": _dashpot,
}
