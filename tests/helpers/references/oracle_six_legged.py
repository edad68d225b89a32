"""Hexapod and hexaglide in 60 digits, from their contract (mechanisms.md, effects.md).

Positions are functions of the platform's position and rotation, of the elongations of the rods and of the frame:
inverse kinematics, which is explicit.  The lengths of the legs, or the positions of the carriages, follow, and every
derivative by these is one by the platform through the inverse of their Jacobian:

    K = J^-T (V_yy - sum_k V_k q_k,yy) J^-1,     V_k = (J^-T V_y)_k,     J = q_y,

for any potential V of coordinates q(y).  All derivatives by y are central differences, to some 24 digits, as in
`high_precision_mechanisms`.  Rotations have three charts around the pose; no result depends on which is used.

A machine is what its robot file contains, in SI units (`helpers.robots.six_legged`).
"""

from __future__ import annotations

from collections.abc import Callable, Iterable, Mapping, Sequence
from functools import cached_property
from typing import Any, NamedTuple

import numpy as np
import scipy.linalg

from helpers.references.high_precision_mechanisms import (
    GAUSS,
    STEP,
    Number,
    Vector,
    combine,
    dot,
    exact,
    minus,
    mp,
    plus,
)

LEGS = range(6)
CHARTS = ("exponential", "cayley", "euler")

Row = Mapping[str, Number]


class Result(NamedTuple):
    """A machine at a pose, in doubles."""

    coordinates: tuple[str, ...]
    M: np.ndarray
    K: np.ndarray
    #: Of the springs of transmissions, cable and servo; of gravity; K has those of released joints, too.
    K_el: np.ndarray
    K_g: np.ndarray
    #: Six forces [N] or torques [N m], on the drives.
    statics: np.ndarray
    #: Absolute motion of the platform by the coordinates: p_x p_y p_z r_x r_y r_z.
    platform: np.ndarray
    #: Lengths of the legs, or positions of the carriages.
    independent: np.ndarray
    #: Motors by the coordinates.
    motors: np.ndarray


class Modes(NamedTuple):
    """Eigenvalues ascending [1/s^2], frequencies with their signs [Hz], shapes as rows in all coordinates."""

    eigenvalues: np.ndarray
    frequencies: np.ndarray
    shapes: np.ndarray


# Rotations


def skew(v: Vector) -> Any:
    return mp.matrix([[0, -v[2], v[1]], [v[2], 0, -v[0]], [-v[1], v[0], 0]])


def turned(vector: Vector, chart: str) -> list[Vector]:
    """Rotation matrix of three coordinates, zero for no rotation."""
    return [list(row) for row in _turned(vector, chart).tolist()]


def _turned(vector: Vector, chart: str) -> Any:
    if chart == "exponential":
        angle = mp.sqrt(dot(vector, vector))
        if angle == 0:
            return mp.eye(3)
        axis = skew([component / angle for component in vector])
        return mp.eye(3) + mp.sin(angle) * axis + (1 - mp.cos(angle)) * axis * axis
    if chart == "cayley":
        half = skew([component / 2 for component in vector])
        return (mp.eye(3) - half) ** -1 * (mp.eye(3) + half)
    R = mp.eye(3)
    for k, angle in enumerate(vector):  # about the fixed axes x, y, z, one after the other
        c, s, (i, j) = mp.cos(angle), mp.sin(angle), ((1, 2), (2, 0), (0, 1))[k]
        one = mp.eye(3)
        one[i, i] = one[j, j] = c
        one[i, j], one[j, i] = -s, s
        R = one * R
    return R


def times(R: Sequence[Vector], vector: Vector) -> Vector:
    return [dot(row, vector) for row in R]


def product(R: Sequence[Vector], S: Sequence[Vector]) -> list[Vector]:
    columns = list(zip(*S, strict=True))
    return [[dot(row, column) for column in columns] for row in R]


def unit(vector: Vector) -> Vector:
    length = mp.sqrt(dot(vector, vector))
    return [component / length for component in vector]


def all_exact(value: Any) -> Any:
    """A robot file's contents with all numbers as mpf."""
    if isinstance(value, Mapping):
        return {key: all_exact(entry) for key, entry in value.items()}
    if isinstance(value, list | tuple):
        return [all_exact(entry) for entry in value]
    return value if isinstance(value, str) else exact(value)


# Machines


class Place(NamedTuple):
    """Where platform and frame are: origin and rotation relative to the frame, elongations, the frame."""

    origin: Vector
    R: Sequence[Vector]
    longer: Vector
    frame: Vector


class SixLegged:
    """A machine at a pose; its subclasses say what connects the platform to the base."""

    #: Names of the coordinates that the platform determines, of the drives', of the released ones.
    independent: tuple[str, ...]
    transmissions: tuple[str, ...]
    released: tuple[str, ...]
    #: Released coordinates on which the positions of bodies depend, besides the frame's.
    elongations: tuple[str, ...] = ()

    def __init__(self, machine: Mapping[str, Any], pose: Any, chart: str = "exponential") -> None:
        self.machine, self.chart = all_exact(machine), chart
        self.effects: Mapping[str, Any] = self.machine.get("effects", {})
        self.position = list(exact(pose))[:3]
        self.R = turned(list(exact(pose))[3:], "exponential")
        self.axes = self.machine["axis"]

    # The robot file

    def of(self, j: int, table: str, key: str) -> Number:
        """A value of an axis, its own or the shared one."""
        own = self.axes[j].get(table, {})
        return own[key] if key in own else self.machine[table][key]

    def effect(self, name: str, key: str, default: Any = 0) -> Any:
        return self.effects.get(name, {}).get(key, default)

    @property
    def coordinates(self) -> tuple[str, ...]:
        return (*self.independent, *self.transmissions, *self.released)

    def motor(self, j: int) -> Row:
        """A motor's coordinate, as the released ones have it."""
        raise NotImplementedError

    # Positions: y is position and rotation of the platform, elongations, frame

    @property
    def size(self) -> int:
        return 9 + len(self.elongations)

    def place(self, y: Vector) -> Place:
        n = len(self.elongations)
        return Place(
            plus(self.position, y[:3]),
            product(turned(y[3:6], self.chart), self.R),
            y[6 : 6 + n],
            y[6 + n :],
        )

    def drives(self, at: Place) -> list[Number]:
        """Lengths of the legs, or positions of the carriages: inverse kinematics."""
        raise NotImplementedError

    def legs(self, at: Place, drives: list[Number]) -> list[tuple[Number, Vector]]:
        """Masses of legs, rods and carriages at points, such that their kinetic energy is that of the contract."""
        raise NotImplementedError

    def leg_weights(self, at: Place, drives: list[Number]) -> list[tuple[Number, Vector]]:
        """Masses of legs, rods and carriages at their centres."""
        raise NotImplementedError

    def joint(self, j: int, at: Place) -> Vector:
        """Joint of the platform, relative to the frame."""
        return plus(at.origin, times(at.R, self.axes[j]["joint"]))

    def bodies(self, at: Place) -> list[tuple[Number, Vector]]:
        """Platform and payload."""
        table = self.machine["platform"]
        return [
            (table["mass"], plus(at.origin, times(at.R, table["center"]))),
            (
                self.effect("payload", "mass"),
                plus(at.origin, times(at.R, self.effect("payload", "offset", [mp.mpf(0)] * 3))),
            ),
        ]

    def spread(self, at: Place) -> list[tuple[Number, Vector]]:
        """Three masses of 1 kg that move as the tensor of inertia says, if the body turns about its centre.

        T = tr(R' S R'^T) / 2 with the second moments S = tr(I) / 2 - I = L L^T: the columns of R L are points.
        """
        xx, yy, zz = self.machine["platform"]["inertia"]
        xy, xz, yz = self.machine["platform"].get("products", [mp.mpf(0)] * 3)
        inertia = mp.matrix([[xx, xy, xz], [xy, yy, yz], [xz, yz, zz]])
        L = mp.cholesky((xx + yy + zz) / 2 * mp.eye(3) - inertia)
        return [(mp.mpf(1), times(at.R, [L[i, k] for i in range(3)])) for k in range(3)]

    def weight(self, at: Place, drives: list[Number]) -> Number:
        parts = [*self.bodies(at), *self.leg_weights(at, drives)]
        g = self.machine["gravity"]
        return -sum((mass * dot(g, plus(where, at.frame)) for mass, where in parts), mp.mpf(0))

    @property
    def frame_mass(self) -> Number:
        return self.machine.get("frame", {}).get("mass", mp.mpf(50))

    # Linear parts: inertias and springs on combinations of the coordinates

    def inertias(self) -> list[tuple[Number, Row]]:
        raise NotImplementedError

    def springs(self) -> list[tuple[Number, Row]]:
        raise NotImplementedError

    def form(self, parts: Iterable[tuple[Number, Row]]) -> np.ndarray:
        """Matrix of a sum of c (row . q)^2 / 2."""
        found = np.full((len(self.coordinates),) * 2, mp.mpf(0), dtype=object)
        index = {name: i for i, name in enumerate(self.coordinates)}
        for factor, row in parts:
            for a, one in row.items():
                for b, other in row.items():
                    found[index[a], index[b]] += factor * one * other
        return found

    # Derivatives by y

    def at(self, *steps: tuple[int, Number]) -> Vector:
        y = [mp.mpf(0)] * self.size
        for k, step in steps:
            y[k] += step
        return y

    def slopes(self, values: Callable[[Vector], Vector]) -> Any:
        """Derivatives, (values, y)."""
        columns = []
        for k in range(self.size):
            ahead, behind = values(self.at((k, STEP))), values(self.at((k, -STEP)))
            columns.append([value / (2 * STEP) for value in minus(ahead, behind)])
        return mp.matrix(columns).T

    def curvatures(self, values: Callable[[Vector], Vector]) -> np.ndarray:
        """Second derivatives, (y, y, values): differences along each, and along each pair for the mixed ones."""
        n, here = self.size, np.array(values(self.at()), dtype=object)

        def along(*which: int) -> np.ndarray:
            ahead, behind = (values(self.at(*((k, step) for k in which))) for step in (STEP, -STEP))
            bent = np.array(ahead, dtype=object) + np.array(behind, dtype=object) - 2 * here
            return np.asarray(bent / STEP**2)

        single = [along(k) for k in range(n)]
        found = np.empty((n, n, len(here)), dtype=object)
        for i in range(n):
            found[i, i] = single[i]
            for j in range(i):
                found[i, j] = found[j, i] = (along(i, j) - single[i] - single[j]) / 2
        return found

    @cached_property
    def moving(self) -> list[int]:
        """Where the coordinates that y determines are."""
        names = (*self.independent, *self.elongations, "u_x", "u_y", "u_z")
        return [self.coordinates.index(name) for name in names]

    @cached_property
    def by_coordinates(self) -> Any:
        """Derivatives of y by the coordinates that it determines."""
        J = mp.eye(self.size)
        J[:6, :] = self.slopes(lambda y: self.drives(self.place(y)))
        return J**-1

    # What is compared

    def mass_matrix(self) -> np.ndarray:
        masses: list[Number] = []

        def positions(y: Vector) -> Vector:
            at = self.place(y)
            parts = [*self.bodies(at), *self.legs(at, self.drives(at))]
            absolute = [(mass, plus(where, at.frame)) for mass, where in parts]
            absolute += [*self.spread(at), (self.frame_mass, at.frame)]
            masses[:] = [mass for mass, _ in absolute for _ in range(3)]
            return [component for _, where in absolute for component in where]

        J = self.slopes(positions) * self.by_coordinates
        found = self.form(self.inertias())
        found[np.ix_(self.moving, self.moving)] += np.array(
            (J.T * mp.diag(masses) * J).tolist(), dtype=object
        )
        return found

    def weights_and_drives(self, y: Vector) -> Vector:
        at = self.place(y)
        drives = self.drives(at)
        return [self.weight(at, drives), *drives]

    def gravity_gradient(self) -> Vector:
        """By the coordinates that y determines."""
        return list(self.slopes(self.weights_and_drives)[0, :] * self.by_coordinates)

    def gravity_hessian(self) -> np.ndarray:
        curved = self.curvatures(self.weights_and_drives)
        loads = self.gravity_gradient()[:6]
        inner = mp.matrix((curved[:, :, 0] - curved[:, :, 1:] @ np.array(loads, dtype=object)).tolist())
        found = np.full((len(self.coordinates),) * 2, mp.mpf(0), dtype=object)
        found[np.ix_(self.moving, self.moving)] = np.array(
            (self.by_coordinates.T * inner * self.by_coordinates).tolist(), dtype=object
        )
        return found

    def platform_motion(self) -> np.ndarray:
        """Absolute motion of the origin, and rotation about base axes, by the coordinates.

        Near zero all charts are the rotation vector, to first order.
        """
        found = np.full((6, len(self.coordinates)), mp.mpf(0), dtype=object)
        motion = self.by_coordinates[:6, :].copy()
        for i in range(3):
            motion[i, self.size - 3 + i] += 1
        found[:, self.moving] = np.array(motion.tolist(), dtype=object)
        return found

    def elastic_hessian(self) -> np.ndarray:
        """Transmissions, and the springs to ground: of the motors, and of the platform's origin."""
        found = self.form(self.springs())
        motion = self.platform_motion()[:3]
        return np.asarray(found + self.effect("cable_stiffness", "stiffness") * motion.T @ motion)

    def released_stiffness(self) -> dict[str, Number]:
        """Stiffness of the joints that effects release, by coordinate."""
        frame = self.effects.get("frame_compliance", {})
        compliance = {f"u_{axis}": frame.get(f"compliance_{axis}", frame.get("compliance")) for axis in "xyz"}
        effects = {"psi": "gearbox_compliance", "delta": "link_compliance", "eps": "clamp_compliance"}
        for name in self.released:
            stem = name.partition("_")[0]
            if stem in effects:
                compliance[name] = self.effects.get(effects[stem], {}).get("compliance")
        return {name: 1 / value for name, value in compliance.items() if value}

    def statics(self) -> Vector:
        """Forces or torques of the drives that hold the pose."""
        raise NotImplementedError

    def result(self) -> Result:
        """Everything in the coordinates of the base model and of the active effects."""
        stiffness = self.released_stiffness()
        base = (*self.independent, *self.transmissions)
        names = (*base, *(name for name in self.released if name in stiffness))
        kept = [self.coordinates.index(name) for name in names]
        M, K_el, K_g = (
            matrix[np.ix_(kept, kept)].astype(float)
            for matrix in (self.mass_matrix(), self.elastic_hessian(), self.gravity_hessian())
        )
        joints = np.diag([float(stiffness.get(name, 0)) for name in names])
        motors = np.array([[float(self.motor(j).get(name, 0)) for name in names] for j in LEGS])
        return Result(
            coordinates=names,
            M=M,
            K=K_el + K_g + joints,
            K_el=K_el,
            K_g=K_g,
            statics=np.array([float(value) for value in self.statics()]),
            platform=self.platform_motion()[:, kept].astype(float),
            independent=np.array([float(value) for value in self.drives(self.place(self.at()))]),
            motors=motors,
        )


class Hexapod(SixLegged):
    independent = tuple(f"l_{j + 1}" for j in LEGS)
    transmissions = tuple(f"s_{j + 1}" for j in LEGS)
    released = ("u_x", "u_y", "u_z")

    def motor(self, j: int) -> Row:
        return {f"s_{j + 1}": mp.mpf(1)}

    def along(self, j: int, at: Place) -> Vector:
        return minus(self.joint(j, at), self.axes[j]["base"])

    def drives(self, at: Place) -> list[Number]:
        vectors = [self.along(j, at) for j in LEGS]
        return [mp.sqrt(dot(vector, vector)) for vector in vectors]

    def centres(self, j: int, at: Place, length: Number) -> tuple[Vector, Vector, Vector]:
        """Centres of mass of the base part and of the rod, and the direction of the leg."""
        direction = [component / length for component in self.along(j, at)]
        base = combine(self.axes[j]["base"], self.of(j, "leg", "base_center"), direction)
        rod = combine(self.joint(j, at), -self.of(j, "leg", "rod_center"), direction)
        return base, rod, direction

    def leg_weights(self, at: Place, drives: list[Number]) -> list[tuple[Number, Vector]]:
        found = []
        for j in LEGS:
            base, rod, _ = self.centres(j, at, drives[j])
            found += [(self.of(j, "leg", "base_mass"), base), (self.of(j, "leg", "rod_mass"), rod)]
        return found

    def legs(self, at: Place, drives: list[Number]) -> list[tuple[Number, Vector]]:
        """Each part is two equal masses on the leg, a radius of gyration before and behind its centre."""
        found = []
        for j in LEGS:
            *centres, direction = self.centres(j, at, drives[j])
            for part, centre in zip(("base", "rod"), centres, strict=True):
                mass = self.of(j, "leg", f"{part}_mass")
                gyration = mp.sqrt(self.of(j, "leg", f"{part}_inertia") / mass)
                found += [(mass / 2, combine(centre, side * gyration, direction)) for side in (1, -1)]
        return found

    def inertias(self) -> list[tuple[Number, Row]]:
        more = self.effect("gearbox_inertia", "inertia")
        return [
            (self.of(j, "motor", "inertia") / self.of(j, "motor", "travel") ** 2 + more, self.motor(j))
            for j in LEGS
        ]

    def springs(self) -> list[tuple[Number, Row]]:
        servo = self.effect("servo_stiffness", "stiffness")
        found = []
        for j in LEGS:
            factor = 1 + self.effect("axis_leg_stiffness", f"factor_{j + 1}")
            strain = {f"l_{j + 1}": mp.mpf(1), f"s_{j + 1}": mp.mpf(-1)}
            found += [(self.of(j, "leg", "stiffness") * factor, strain), (servo, self.motor(j))]
        return found

    def statics(self) -> Vector:
        """The springs carry the load of their legs to the motors."""
        return self.gravity_gradient()[:6]


class Hexaglide(SixLegged):
    independent = tuple(f"x_{j + 1}" for j in LEGS)
    transmissions = tuple(f"theta_{j + 1}_{k}" for k in (1, 2) for j in LEGS)
    elongations = tuple(f"delta_{j + 1}" for j in LEGS)
    released = (
        *(f"psi_{j + 1}" for j in LEGS),
        *elongations,
        *(f"eps_{j + 1}" for j in LEGS),
        *("u_x", "u_y", "u_z"),
    )

    def __init__(self, machine: Mapping[str, Any], pose: Any, chart: str = "exponential") -> None:
        super().__init__(machine, pose, chart)
        self.directions = [unit(axis["direction"]) for axis in self.axes]

    def driven(self, j: int) -> str:
        return f"theta_{j + 1}_{int(self.axes[j]['driven_pulley'])}"

    def motor(self, j: int) -> Row:
        return {self.driven(j): mp.mpf(1), f"psi_{j + 1}": mp.mpf(1)}

    def drives(self, at: Place) -> list[Number]:
        found = []
        for j, n in enumerate(self.directions):
            axis = self.axes[j]
            r = minus(self.joint(j, at), axis["origin"])
            along = dot(n, r)
            across = combine(r, -along, n)
            square = (self.of(j, "link", "length") + at.longer[j]) ** 2 - dot(across, across)
            found.append(along + axis["branch"] * mp.sqrt(square))
        return found

    def carriage(self, j: int, x: Number) -> Vector:
        return combine(self.axes[j]["origin"], x, self.directions[j])

    def leg_weights(self, at: Place, drives: list[Number]) -> list[tuple[Number, Vector]]:
        found = []
        for j in LEGS:
            carriage = self.carriage(j, drives[j])
            middle = [component / 2 for component in plus(carriage, self.joint(j, at))]
            found += [(self.of(j, "carriage", "mass"), carriage), (self.of(j, "link", "mass"), middle)]
        return found

    def legs(self, at: Place, drives: list[Number]) -> list[tuple[Number, Vector]]:
        """Carriages, and three points on each rod that follow its two ends."""
        found = []
        for j in LEGS:
            carriage = self.carriage(j, drives[j])
            along = minus(self.joint(j, at), carriage)
            found.append((self.of(j, "carriage", "mass"), carriage))
            for fraction, share in GAUSS:
                found.append((share * self.of(j, "link", "mass"), combine(carriage, fraction, along)))
        return found

    def spans(self, j: int) -> list[tuple[Number, Row, Row]]:
        """Free length and displacements of the two ends: from pulley to pulley, and from the clamp to each."""
        x = self.drives(self.place(self.at()))[j]
        low, high = self.axes[j]["limits"]
        half, R = self.of(j, "carriage", "length") / 2, self.of(j, "pulley", "radius")
        clamp = {f"x_{j + 1}": mp.mpf(1), f"eps_{j + 1}": mp.mpf(1)}
        first, second = {f"theta_{j + 1}_1": R}, {f"theta_{j + 1}_2": R}
        return [
            (high - low, second, first),
            (x - low - half, second, clamp),
            (high - x - half, clamp, first),
        ]

    def inertias(self) -> list[tuple[Number, Row]]:
        found: list[tuple[Number, Row]] = []
        density = self.effect("belt_mass", "linear_density")
        for j in LEGS:
            for k in (1, 2):
                found.append((self.of(j, "pulley", "inertia"), {f"theta_{j + 1}_{k}": mp.mpf(1)}))
            found.append((self.effect("gearbox_inertia", "inertia"), {self.driven(j): mp.mpf(1)}))
            ratio = self.of(j, "motor", "gear_ratio")
            found.append((ratio**2 * self.of(j, "motor", "inertia"), self.motor(j)))
            for length, one, other in self.spans(j):
                for fraction, share in GAUSS:
                    row = {name: (1 - fraction) * value for name, value in one.items()}
                    row |= {name: fraction * value for name, value in other.items()}
                    found.append((share * density * length, row))
        return found

    def springs(self) -> list[tuple[Number, Row]]:
        servo = self.effect("servo_stiffness", "stiffness")
        return [*self.belts(), *((servo, self.motor(j)) for j in LEGS)]

    def belts(self) -> list[tuple[Number, Row]]:
        tension = self.effect("belt_tension_stiffness", "tension")
        preload = 1 + self.effect("belt_tension_stiffness", "coefficient") * tension
        series = self.effect("belt_end_compliance", "compliance")
        found: list[tuple[Number, Row]] = []
        for j in LEGS:
            factor = 1 + self.effect("axis_belt_stiffness", f"factor_{j + 1}")
            width = self.of(j, "belt", "width")
            unit_stiffness = width * self.of(j, "belt", "specific_stiffness") * factor * preload
            for length, one, other in self.spans(j):
                strain = {**other, **{name: -value for name, value in one.items()}}
                found.append((1 / (length / unit_stiffness + series), strain))
        return found

    def statics(self) -> Vector:
        """Balance of carriages and pulleys, in the torques of the driven ones and in all rotations."""
        names = (*self.independent, *self.transmissions)
        kept = [self.coordinates.index(name) for name in names]
        K = self.form(self.belts())[np.ix_(kept, kept)]
        system, right = mp.matrix(18, 18), mp.matrix(18, 1)
        for i in range(18):
            for k in range(12):
                system[i, k] = K[i, 6 + k]
        for j, load in enumerate(self.gravity_gradient()[:6]):
            system[names.index(self.driven(j)), 12 + j] = -1
            right[j] = -load
        return list(mp.lu_solve(system, right))[12:]


ORACLES: dict[str, type[SixLegged]] = {"hexapod": Hexapod, "hexaglide": Hexaglide}


def oracle(machine: Mapping[str, Any], pose: Any, chart: str = "exponential") -> SixLegged:
    return ORACLES[machine["mechanism"]](machine, pose, chart)


def result(machine: Mapping[str, Any], pose: Any) -> Result:
    """What a robot file's contents say about the machine at a pose (three lengths, a rotation vector)."""
    return oracle(machine, pose).result()


def modes(M: np.ndarray, K: np.ndarray, motors: np.ndarray | None = None) -> Modes:
    """Modes of some matrices; with the rows of the motors, of those motions in which all of them are at rest.

    Coordinates without inertia follow the others without load.
    """
    every = np.eye(len(M))
    if motors is not None:
        # the driven coordinate of each motor follows the others
        driven = [int(np.flatnonzero(row)[0]) for row in motors]
        every[driven] -= motors
        every = np.delete(every, driven, axis=1)
    M, K = every.T @ M @ every, every.T @ K @ every
    heavy = np.diag(M) > 0
    follow = np.zeros((len(M), int(heavy.sum())))
    follow[heavy] = np.eye(int(heavy.sum()))
    if not heavy.all():
        follow[~heavy] = -np.linalg.solve(K[np.ix_(~heavy, ~heavy)], K[np.ix_(~heavy, heavy)])
    every = every @ follow
    M, K = follow.T @ M @ follow, follow.T @ K @ follow
    scale = 1 / np.sqrt(np.diag(M))
    values, vectors = scipy.linalg.eigh(K * np.outer(scale, scale), M * np.outer(scale, scale))
    frequencies = np.sign(values) * np.sqrt(np.abs(values)) / (2 * np.pi)
    return Modes(values, frequencies, (every @ (scale[:, None] * vectors)).T)
