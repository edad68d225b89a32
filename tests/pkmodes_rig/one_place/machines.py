"""Machines with faults at places, assembled from rows: springs, masses and resonators act on what the engine moves.

MuJoCo moves the bodies of machines with closed loops (`linkage`); printers consist of rows only.  A machine's own
parts follow docs/model.md and the pages of the mechanisms; nothing is shared with the derived model.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field
from functools import lru_cache
from typing import Any

import numpy as np
from scipy.spatial.transform import Rotation

from pkmodes_rig.engine import TrueModes
from pkmodes_rig.mujoco_rotary_delta import arm_angles
from pkmodes_rig.one_place.faults import Fault
from pkmodes_rig.one_place.linkage import AXES, FRAME, MOUNT, Linkage, Point, rail_positions
from pkmodes_rig.rows import Rows

#: Coordinates of resonators, one for each of two faults.
RESONATORS = ("resonator_1", "resonator_2")
#: A uniform rod as three points, exact for a velocity that is linear along it (Simpson's rule).
ROD = ((0.0, 1 / 6), (0.5, 2 / 3), (1.0, 1 / 6))
#: Bodies whose bearing is a rail or a base joint.
BEARINGS = ("carriage", "arm", "leg")
#: What is locked unless a fault releases it.
RELEASED = ("delta", "psi", "eps", "u_", MOUNT, "resonator")
#: Of the fields of a machine, those that only springs and masses need.
WITHOUT_MOTION = ("mass", "inertia", "stiffness", "width", "gravity", "limits", "products", "ratio", "travel")


@dataclass(frozen=True)
class Place:
    """A body on which a fault acts.

    Attributes
    ----------
    rows : dict of str to array, shape (n,)
        Its motion in each direction; of a body with one freedom one, without a name.
    point : Point or None
        How its centre moves in space; None for a body that rotates about its axis.
    axes : dict of str to array, shape (3,)
        The directions of `rows` in space.
    lumps : tuple of (float, Point)
        How a mass is spread over it, by shares.
    """

    rows: Mapping[str, np.ndarray]
    point: Point | None = None
    axes: Mapping[str, np.ndarray] = field(default_factory=dict)
    lumps: tuple[tuple[float, Point], ...] = ()


@dataclass
class Assembly:
    """A machine at one pose.

    Attributes
    ----------
    rows : Rows
        Inertia, springs and the stiffness of weight.
    gravity : array, shape (3,)
    places : dict of str to Place
    drives : list of (int, array, float)
        Springs of the drives: the axis, from 0, the row that is strained, the stiffness.
    travel : array
        Where each axis is on its travel, from 0 to 1.
    locked : set of str
        Coordinates that no fault has released.
    """

    rows: Rows
    gravity: np.ndarray
    places: dict[str, Place] = field(default_factory=dict)
    drives: list[tuple[int, np.ndarray, float]] = field(default_factory=list)
    travel: np.ndarray = field(default_factory=lambda: np.zeros(0))
    locked: set[str] = field(default_factory=set)

    # Parts ---------------------------------------------------------------------------------------------------

    def lump(self, mass: float, point: Point) -> None:
        """Add a mass, with its weight."""
        self.rows.inertia(point.motion, mass)
        self.rows.weights -= mass * np.einsum("i,ikl->kl", self.gravity, point.curvature)

    def spread(self, mass: float, lumps: Sequence[tuple[float, Point]]) -> None:
        """Add a mass that is spread over points."""
        for share, point in lumps:
            self.lump(share * mass, point)

    # Faults --------------------------------------------------------------------------------------------------

    def add(self, fault: Fault, number: int = 0) -> None:
        """Add a fault; a value of one axis is not one of the machine's parts."""
        getattr(self, f"_{fault.form}")(fault, number)

    def _mass(self, fault: Fault, number: int) -> None:
        place, amount = self.places[fault.places[0]], fault.amount
        if place.point is None:
            self.rows.inertia(place.rows[""], amount)
        else:
            self.spread(amount, place.lumps or ((1.0, place.point),))

    def _spring(self, fault: Fault, number: int) -> None:
        rows = self._moved(fault.places[0], fault.direction)
        if len(fault.places) == 2:
            rows = rows - self._moved(fault.places[1], fault.direction)
        self.rows.spring(rows, fault.values["stiffness"])

    def _moved(self, name: str, direction: str) -> np.ndarray:
        place = self.places[name]
        if direction in place.rows:
            return place.rows[direction]
        if direction:  # of a body that slides along another one
            assert place.point is not None
            return np.asarray(AXES[direction] @ place.point.motion)
        return np.array([place.rows[axis] for axis in AXES if axis in place.rows])

    def _compliance(self, fault: Fault, number: int) -> None:
        (coordinate,) = fault.places
        self._yield(coordinate, fault.values["compliance"])

    def _mount(self, fault: Fault, number: int) -> None:
        (place,) = fault.places
        stem, _, which = place.partition("_")
        own = f"{MOUNT}_{which}" if stem in ("pulley", "motor") else MOUNT
        self._yield(own, fault.values["compliance"])
        self.rows.inertia(self.rows.row(**{own: 1.0}), fault.values.get("mass", 0.0))

    def _yield(self, coordinate: str, compliance: float) -> None:
        self.locked.discard(coordinate)
        self.rows.spring(self.rows.row(**{coordinate: 1.0}), 1.0 / compliance)

    def _resonator(self, fault: Fault, number: int) -> None:
        place, mass = self.places[fault.places[0]], fault.amount
        own = self.rows.row(**{RESONATORS[number]: 1.0})
        if place.point is None:
            self.rows.inertia(place.rows[""] + own, mass)
        else:
            motion = place.point.motion + np.outer(place.axes[fault.direction], own)
            self.lump(mass, Point(motion, place.point.curvature))
        self.locked.discard(RESONATORS[number])
        self.rows.spring(own, mass * (2 * np.pi * fault.values["frequency"]) ** 2)

    # Modes ---------------------------------------------------------------------------------------------------

    def modes(self, factors: np.ndarray | float = 1.0) -> TrueModes:
        """Return the modes, with the stiffness of the drives of each axis multiplied by a factor."""
        springs = self.rows.springs.copy()
        factors = np.broadcast_to(factors, len(self.travel))
        for j, row, stiffness in self.drives:
            self.rows.spring(row, stiffness * float(factors[j]))
        modes = self.rows.modes(sorted(self.locked))
        self.rows.springs = springs
        return modes


def modes_of(
    mechanism: str, q: Any, p: np.ndarray, faults: Sequence[Fault] = (), **frame: float
) -> TrueModes:
    """Return the modes of a machine with faults at one pose."""
    return assembled(mechanism, q, p, faults, **frame).modes()


def assembled(
    mechanism: str, q: Any, p: np.ndarray, faults: Sequence[Fault] = (), *, frame: float = 50.0
) -> Assembly:
    """Assemble a machine with faults at one pose.

    Parameters
    ----------
    mechanism : str
    q : Parameters
        One machine, without batch axes.
    p : array
        Pose.
    faults : sequence of Fault
        At most two of them resonators, and one a mount.
    frame : float
        Mass of the frame [kg].
    """
    q = q._replace(**{name: np.asarray(value, dtype=float) for name, value in q._asdict().items()})
    if mechanism in GANTRIES:
        machine = _gantry(mechanism, q, np.asarray(p, dtype=float), frame)
    else:
        machine = _with_loops(mechanism, q, np.asarray(p, dtype=float), faults, frame)
    for number, fault in enumerate(faults):
        if fault.form != "parameter":
            machine.add(fault, number)
    return machine


# Machines with closed loops ----------------------------------------------------------------------------------


def _with_loops(mechanism: str, q: Any, p: np.ndarray, faults: Sequence[Fault], frame: float) -> Assembly:
    mount = next((leg for fault in faults if (leg := _bearing(fault)) is not None), None)
    linkage = _linkage(mechanism, _Geometry.of(q), tuple(map(float, p)), mount)
    legs = range(len(q.joint))
    belts = [
        *(f"theta_{j + 1}_{k}" for k in (1, 2) for j in legs),
        *(f"{stem}_{j + 1}" for stem in ("psi", "eps") for j in legs),
        *(f"{MOUNT}_{j + 1}_{k}" for k in (1, 2) for j in legs),
    ]
    motors = {"rotary_delta": "phi", "hexapod": "s"}
    own = [f"{motors[mechanism]}_{j + 1}" for j in legs] if mechanism in motors else belts
    names = [*linkage.names, *own, *RESONATORS]
    points = {name: _wider(point, len(names)) for name, point in linkage.points.items()}
    turning = None
    if linkage.turns:
        turning = np.zeros((3, len(names)))
        turning[:, : len(linkage.names)] = linkage.turning()
    machine = Assembly(Rows(names, points["platform"].motion, turning), q.gravity)
    machine.locked = {name for name in names if name.startswith(RELEASED)}
    _frame(machine, frame, AXES)
    _platform(machine, q, p, points)
    {"rotary_delta": _arms, "hexapod": _legs}.get(mechanism, _rails)(machine, q, p, points)
    return machine


def _bearing(fault: Fault) -> tuple[int, str] | None:
    """Return leg and direction of a mount of a rail or a base joint."""
    stem, _, which = fault.places[0].partition("_")
    return (int(which) - 1, fault.direction) if fault.form == MOUNT and stem in BEARINGS else None


@dataclass(frozen=True)
class _Geometry:
    """Parameters that can be compared by what moves."""

    key: tuple[bytes, ...]
    q: Any = field(compare=False)

    @classmethod
    def of(cls, q: Any) -> _Geometry:
        moving = [value for name, value in q._asdict().items() if not name.endswith(WITHOUT_MOTION)]
        return cls(tuple(value.tobytes() for value in moving), q)


@lru_cache(maxsize=600)
def _linkage(
    mechanism: str, geometry: _Geometry, p: tuple[float, ...], mount: tuple[int, str] | None
) -> Linkage:
    return Linkage(mechanism, geometry.q, np.array(p), mount)


def _wider(point: Point, n: int) -> Point:
    """Return the motion of a point in the coordinates of the linkage and others, which do not move it."""
    known = point.motion.shape[1]
    motion, curvature = np.zeros((3, n)), np.zeros((3, n, n))
    motion[:, :known], curvature[:, :known, :known] = point.motion, point.curvature
    return Point(motion, curvature)


def _free(point: Point, lumps: tuple[tuple[float, Point], ...] = ()) -> Place:
    """Return the place of a body that moves in all directions."""
    return Place(dict(zip(AXES, point.motion, strict=True)), point, AXES, lumps)


def _guided(row: np.ndarray, point: Point, axis: np.ndarray) -> Place:
    """Return the place of a body that slides along an axis."""
    return Place({"": row}, point, {"": axis})


def _rod(begin: Point, end: Point) -> tuple[tuple[float, Point], ...]:
    return tuple((share, begin.combined(end, along)) for along, share in ROD)


def _frame(machine: Assembly, mass: float, directions: Sequence[str] | Mapping[str, Any]) -> None:
    for name in directions:
        machine.rows.inertia(machine.rows.row(**{f"u_{name}": 1.0}), mass)


def _platform(machine: Assembly, q: Any, p: np.ndarray, points: Mapping[str, Point]) -> None:
    rows, place = machine.rows, _free(points["platform"])
    if len(rows.turning):
        machine.lump(float(q.platform_mass), points["platform_mass"])
        xy, xz, yz = q.platform_products
        tensor = np.diag(q.platform_inertia) + np.array([[0, xy, xz], [xy, 0, yz], [xz, yz, 0]])
        turned = rotation(p[3:])
        rows.M += rows.turning.T @ turned @ tensor @ turned.T @ rows.turning
        by_rotation = {f"r{name}": row for name, row in zip(AXES, rows.turning, strict=True)}
        place = Place({**place.rows, **by_rotation}, place.point, AXES)
    else:
        machine.lump(float(q.platform_mass), points["platform"])
    machine.places["platform"] = place


def rotation(vector: np.ndarray) -> np.ndarray:
    """Return the matrix of a rotation vector."""
    return Rotation.from_rotvec(vector).as_matrix()


def _rails(machine: Assembly, q: Any, p: np.ndarray, points: Mapping[str, Point]) -> None:
    """Add carriages on rails, their links, pulleys, motors and belts."""
    rows = machine.rows
    turned = rotation(p[3:]) if len(p) == 6 else np.eye(3)
    positions = rail_positions(q, p[:3] + q.joint @ turned.T)
    for j, x in enumerate(positions):
        begin, end = points[f"begin_{j}"], points[f"end_{j}"]
        link = _rod(begin, end)
        machine.lump(q.carriage_mass[j], begin)
        machine.spread(q.link_mass[j], link)
        machine.places[f"carriage_{j + 1}"] = _guided(q.direction[j] @ begin.motion, begin, q.direction[j])
        machine.places[f"link_{j + 1}"] = _free(begin.combined(end, 0.5), link)
        driven = int(np.argmax(q.drive[j])) + 1
        for k in (1, 2):
            theta = rows.row(**{f"theta_{j + 1}_{k}": 1.0})
            machine.places[f"pulley_{j + 1}_{k}"] = Place({"": theta})
            rows.inertia(theta, q.pulley_inertia[j])
            if k == driven:
                motor = theta + rows.row(**{f"psi_{j + 1}": 1.0})
                rows.inertia(motor, q.gear_ratio[j] ** 2 * q.motor_inertia[j])
        _belt(machine, q, float(x), j, _along(machine, q, begin, j))
    travels = np.diff(q.limits, axis=1)[:, 0]
    machine.travel = (positions - q.limits[:, 0]) / travels


def _along(machine: Assembly, q: Any, carriage: Point, j: int) -> np.ndarray:
    """Return the motion of a carriage along its rail relative to the frame, which carries the pulleys."""
    rows, frame = machine.rows, np.zeros((3, len(machine.rows.names)))
    for i, name in enumerate(FRAME):
        frame[i] = rows.row(**{name: 1.0})
    return np.asarray(q.direction[j] @ (carriage.motion - frame))


def _belt(machine: Assembly, q: Any, x: float, j: int, carriage: np.ndarray) -> None:
    """Add the spans of a belt: pulley 2 is at the lower end of the travel, pulley 1 at the upper end.

    A bearing that yields moves its pulley outwards, away from the other one.
    """
    rows, ((low, high), half) = machine.rows, (q.limits[j], q.carriage_length[j] / 2)
    unit, radius = q.belt_width[j] * q.belt_specific_stiffness[j], q.pulley_radius[j]
    clamp = carriage + rows.row(**{f"eps_{j + 1}": 1.0})
    first, second = (rows.row(**{f"theta_{j + 1}_{k}": radius}) for k in (1, 2))
    out = [rows.row(**{f"{MOUNT}_{j + 1}_{k}": 1.0}) for k in (1, 2)]
    spans = (
        (high - low, second - first + out[0] + out[1]),
        (x - low - half, clamp - second + out[1]),
        (high - x - half, first - clamp + out[0]),
    )
    for length, strain in spans:
        if length <= 0:
            raise ValueError(f"carriage {j + 1} is beyond its limits")
        machine.drives.append((j, strain, unit / length))


def _arms(machine: Assembly, q: Any, p: np.ndarray, points: Mapping[str, Point]) -> None:
    """Add arms, their links, motors and reducers."""
    rows = machine.rows
    for j, angle in enumerate(arm_angles(q, p)):
        begin, end = points[f"begin_{j}"], points[f"end_{j}"]
        theta, phi = (rows.row(**{f"{name}_{j + 1}": 1.0}) for name in ("theta", "phi"))
        link, centre = _rod(begin, end), points[f"arm_{j}"]
        machine.lump(q.arm_mass[j], centre)
        rows.inertia(theta, q.arm_inertia[j] - q.arm_mass[j] * q.arm_center[j] ** 2)
        rows.inertia(phi, q.gear_ratio[j] ** 2 * q.motor_inertia[j])
        machine.spread(q.link_mass[j], link)
        machine.places[f"arm_{j + 1}"], machine.places[f"motor_{j + 1}"] = (
            Place({"": theta}),
            Place({"": phi}),
        )
        machine.places[f"link_{j + 1}"] = _free(begin.combined(end, 0.5), link)
        machine.drives.append((j, theta - phi, q.reducer_stiffness[j]))
        low, high = q.limits[j]
        machine.travel = np.append(machine.travel, (angle - low) / (high - low))


def _legs(machine: Assembly, q: Any, p: np.ndarray, points: Mapping[str, Point]) -> None:
    """Add legs that change length, and their motors."""
    rows = machine.rows
    lengths = np.linalg.norm(p[:3] + q.joint @ rotation(p[3:]).T - q.base, axis=1)
    for j, length in enumerate(lengths):
        foot, unit = points[f"begin_{j}"], points[f"unit_{j}"]
        base, rod = foot.combined(unit, q.leg_base_center[j]), points[f"rod_{j}"]
        along, motor = (rows.row(**{f"{name}_{j + 1}": 1.0}) for name in ("l", "s"))
        machine.lump(q.leg_base_mass[j], base)
        machine.lump(q.leg_rod_mass[j], rod)
        # The leg turns across its axis as fast as its direction, a point at unit distance, moves.
        rows.inertia(unit.motion - foot.motion, q.leg_base_inertia[j] + q.leg_rod_inertia[j])
        rows.inertia(motor, q.motor_inertia[j] / q.motor_travel[j] ** 2)
        machine.places[f"leg_{j + 1}"], machine.places[f"rod_{j + 1}"] = _free(base), _free(rod)
        machine.places[f"motor_{j + 1}"] = Place({"": motor})
        machine.drives.append((j, along - motor, q.leg_stiffness[j]))
        low, high = q.limits[j]
        machine.travel = np.append(machine.travel, (length - low) / (high - low))


# Printers ----------------------------------------------------------------------------------------------------

#: Bodies of each printer, with the directions in which they follow the coordinates x and y; all follow the frame.
GANTRIES = {
    "corexy": {"platform": "xy", "gantry": "y"},
    "cartesian": {"platform": "xy", "beam": "y"},
    "bed_slinger": {"toolhead": "x", "bed": "y"},
}
PLANE = {"x": AXES["x"][:2], "y": AXES["y"][:2]}


def _gantry(mechanism: str, q: Any, p: np.ndarray, frame: float) -> Assembly:
    released = [f"{stem}_{i}" for stem in ("psi", "eps", f"{MOUNT}") for i in (1, 2)]
    names = ["x", "y", "theta_1", "theta_2", "u_x", "u_y", *released, *RESONATORS]
    n = len(names)
    first = next(iter(GANTRIES[mechanism].values()))
    rows = Rows(names, np.zeros((2, n)))
    rows.platform = _following(rows, first)
    machine = Assembly(rows, np.zeros(2))
    machine.locked = {name for name in names if name.startswith(RELEASED)}
    _frame(machine, frame, PLANE)
    for name, freedom in GANTRIES[mechanism].items():
        point = Point(_following(rows, freedom), np.zeros((2, n, n)))
        mass = q.toolhead_mass if name == "platform" else getattr(q, f"{name}_mass")
        machine.lump(float(mass), point)
        motion = {axis: point.motion[i] for i, axis in enumerate(PLANE) if axis in freedom}
        if len(freedom) == 1:
            machine.places[name] = _guided(motion[freedom], point, PLANE[freedom])
        else:
            machine.places[name] = Place(motion, point, PLANE)
    directions = q.belt_path_direction if mechanism == "corexy" else np.eye(2)
    lengths = q.belt_path_lengths if mechanism == "corexy" else q.axis_lengths
    for i in (0, 1):
        theta = rows.row(**{f"theta_{i + 1}": 1.0})
        machine.places[f"pulley_{i + 1}"] = Place({"": theta})
        rows.inertia(theta, q.pulley_inertia[i])
        motor = theta + rows.row(**{f"psi_{i + 1}": 1.0})
        rows.inertia(motor, q.gear_ratio[i] ** 2 * q.motor_inertia[i])
        g, unit = directions[i], q.belt_width[i] * q.belt_specific_stiffness[i]
        pulled = rows.row(x=g[0], y=g[1]) + rows.row(**{f"eps_{i + 1}": 1.0}) + q.pulley_radius[i] * theta
        out = rows.row(**{f"{MOUNT}_{i + 1}": 1.0})  # away from the tool head: both runs become longer
        for sign, length in zip((1.0, -1.0), lengths[i], strict=True):
            machine.drives.append((i, out + sign * pulled, unit / (length + sign * (g @ p))))
    machine.travel = (p - q.workspace[:, 0]) / np.diff(q.workspace, axis=1)[:, 0]
    return machine


def _following(rows: Rows, freedom: str) -> np.ndarray:
    """Return the motion in the plane of a body that follows the frame and, in some directions, a coordinate."""
    return np.array([rows.row(**{f"u_{i}": 1.0, **({i: 1.0} if i in freedom else {})}) for i in PLANE])
