"""What derivatives of modes should be, in two ways that share no formula with the code that they test.

`by_differences` goes the public way: fourth-order differences of ``Model(moved(robot, ...)).modes``.
`by_complex_steps` is sharp: the generated matrices at complex parameters, whose eigenpairs are found by inverse
iteration in complex arithmetic, so that nothing is lost to the step.

Repeated eigenvalues have no shapes of their own, so both ways differentiate what is smooth whichever basis the
solver picks: for each group of modes, the sum of phi phi^T, and a matrix that has the group's eigenvalues.
"""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any, NamedTuple

import numpy as np

import pkmodes
from pkmodes.core.mechanism.registry import mechanism
from pkmodes.core.robot.reading import robot_from_document
from pkmodes.core.robot.robot import Robot
from pkmodes.loop.sensitivity.paths import ParameterPath, change_quantities
from pkmodes_generated.linear_delta import Parameters, extended

CATALOGUE = mechanism("linear_delta").effects

Array = np.ndarray
#: Shared tables of the robot file, and their fields in the generated model.
TABLES = {
    "link.length": "link_length",
    "link.mass": "link_mass",
    "carriage.mass": "carriage_mass",
    "carriage.length": "carriage_length",
    "belt.specific_stiffness": "belt_specific_stiffness",
    "belt.width": "belt_width",
    "pulley.radius": "pulley_radius",
    "pulley.inertia": "pulley_inertia",
    "motor.inertia": "motor_inertia",
    "motor.gear_ratio": "gear_ratio",
}
#: Compliances of the released joints, and their coordinates; those of the frame by direction are in series.
JOINTS = {
    f"{effect.name}.{effect.parameters[0].name}": tuple(q.name for q in effect.coordinates)
    for effect in CATALOGUE.values()
    if effect.coordinates
} | {f"frame_compliance.compliance_{i}": (f"u_{i}",) for i in "xyz"}
#: Derivative at 0 from values at multiples of a step, of fourth order; ahead where a quantity begins at zero.
CENTRAL = {-2: 1 / 12, -1: -8 / 12, 1: 8 / 12, 2: -1 / 12}
AHEAD = {0: -25 / 12, 1: 4.0, 2: -3.0, 3: 4 / 3, 4: -1 / 4}
TINY = 1e-30


def robot_of(parameters: Parameters, effects: dict[str, float]) -> Robot:
    """A robot as from a file: values that the axes share in tables, others on the axes."""
    document: dict[str, Any] = {
        "format": 1,
        "name": "sample",
        "mechanism": "linear_delta",
        "gravity": parameters.gravity.tolist(),
        "platform": {"mass": float(parameters.platform_mass)},
        "effects": {},
        "axis": [
            {
                "origin": parameters.origin[j].tolist(),
                "direction": parameters.direction[j].tolist(),
                "joint": parameters.joint[j].tolist(),
                "limits": parameters.limits[j].tolist(),
                "driven_pulley": 1 if parameters.drive[j, 0] else 2,
                "branch": int(parameters.branch[j]),
            }
            for j in range(3)
        ],
    }
    for path, field in TABLES.items():
        table, key = path.split(".")
        values = getattr(parameters, field)
        if np.all(values == values[0]):
            document.setdefault(table, {})[key] = float(values[0])
        else:
            for axis, value in zip(document["axis"], values, strict=True):
                axis.setdefault(table, {})[key] = float(value)
    for path, value in effects.items():
        name, parameter = path.split(".")
        document["effects"].setdefault(name, {})[parameter] = value
    return robot_from_document(document, "sample.toml")


class Rates(NamedTuple):
    """Derivatives of what is determined, by T paths.

    Attributes
    ----------
    M, K : ndarray, shape (T, n, n)
        NaN for the compliance of a locked joint.
    eigenvalues : ndarray, shape (T, m)
        In a group those of its branches, ascending.
    shapes : ndarray, shape (T, m, n)
        In a group the part outside, and what keeps the norm.
    largest : ndarray, shape (T,)
        The largest eigenvalue of the systems that were solved: solvers leave rounding of that size.
    """

    M: Array
    K: Array
    eigenvalues: Array
    shapes: Array
    largest: Array


class Pose(NamedTuple):
    """Modes at one pose of several that are evaluated together, and their groups."""

    robot: Robot
    poses: Array
    index: int
    coordinates: tuple[str, ...]
    eigenvalues: Array
    shapes: Array
    M: Array
    K: Array
    members: tuple[Array, ...]

    @property
    def scale(self) -> Array:
        """Sizes of the coordinates in which metres, radians and coordinates without inertia compare."""
        largest = np.abs(self.eigenvalues).max()
        return np.asarray(1 / np.sqrt(np.abs(np.diagonal(self.K)) + largest * np.diagonal(self.M)))

    @property
    def gaps(self) -> Array:
        """Distance of each eigenvalue from those outside its group."""
        found = np.empty(len(self.eigenvalues))
        for members in self.members:
            others = np.delete(self.eigenvalues, members)
            found[members] = np.abs(others - self.eigenvalues[members].mean()).min()
        return found


def at_poses(robot: Robot, poses: Array, groups: Array) -> list[Pose]:
    modes = pkmodes.Model(robot).modes(poses)
    return [
        Pose(
            robot,
            poses,
            i,
            modes.coordinates,
            eigenvalues(modes.frequencies[i]),
            modes.shapes[i],
            modes.mass_matrix[i],
            modes.stiffness_matrix[i],
            tuple(np.flatnonzero(groups[i] == g) for g in np.unique(groups[i])),
        )
        for i in range(len(poses))
    ]


def eigenvalues(frequencies: Array) -> Array:
    return np.asarray(np.sign(frequencies) * (2 * np.pi * frequencies) ** 2)


def is_locked(robot: Robot, path: ParameterPath) -> bool:
    """Whether a path is the compliance of a joint that the robot holds locked."""
    (field, _), *_ = path.weights
    soft = {q for name, joints in JOINTS.items() if robot.effects.get(name, 0.0) for q in joints}
    return field in JOINTS and not soft & set(JOINTS[field])


def size(robot: Robot, path: ParameterPath, effects: dict[str, float]) -> float:
    """A change of the quantity that matters: the size of the numbers that it moves, or of an effect."""
    (field, _), *_ = path.weights
    if field in effects:
        return abs(effects[field])
    value = np.abs(np.asarray(getattr(robot.parameters, field))).max()
    return 0.1 if field in ("joint", "origin", "carriage_length") else float(value)


def ahead(pose: Pose, path: ParameterPath) -> float:
    """A step from zero along a joint's compliance that is small beside the joint's dynamic compliance."""
    M, K, _ = _complex_matrices(pose, [path], np.zeros(1))
    (field, _), *_ = path.weights
    joint = [extended.COORDINATES.index(q) for q in JOINTS[field]]
    stiffness = np.abs(K) + np.abs(pose.eigenvalues).max() * np.abs(M)
    return float(3e-3 / np.diagonal(stiffness[0])[joint].max())


def by_differences(
    here: Sequence[Pose], path: ParameterPath, step: float, stencil: dict[int, float]
) -> list[Rates]:
    """Differences of what the public model gives along one path, at all poses."""
    totals: list[list[Array]] = [[] for _ in here]
    largest = 0.0
    for multiple, weight in stencil.items():
        robot = change_quantities(here[0].robot, [(path, multiple * step)])
        modes = pkmodes.Model(robot).modes(here[0].poses)
        largest = max(largest, float(np.abs(eigenvalues(modes.frequencies)).max()))
        for pose, total in zip(here, totals, strict=True):
            columns = [modes.coordinates.index(q) for q in pose.coordinates]
            m, rows = len(pose.eigenvalues), np.ix_(columns, columns)
            values = [modes.mass_matrix[pose.index][rows], modes.stiffness_matrix[pose.index][rows]]
            phi = modes.shapes[pose.index][:m, columns]
            values += _smooth(pose, eigenvalues(modes.frequencies[pose.index][:m]), phi)
            parts = [weight / step * value for value in values]
            total[:] = [a + b for a, b in zip(total, parts, strict=True)] if total else parts
    return [
        _rates(pose, [part[None] for part in total], largest)
        for pose, total in zip(here, totals, strict=True)
    ]


def by_complex_steps(pose: Pose, paths: Sequence[ParameterPath], sizes: Array) -> Rates:
    """Imaginary parts of the modes at complex parameters.

    Where a joint r may be locked its coordinates are replaced by the forces y that it carries, x_r = c y, which
    is regular at c = 0: [K_qq, c K_qr; K_rq, 1 + c K_rr] with the mass matrix alike.
    """
    steps = TINY * sizes
    M, K, c = _complex_matrices(pose, paths, 1j * steps)
    every = np.arange(M.shape[-1])
    released = [extended.COORDINATES.index(q) for coordinates in JOINTS.values() for q in coordinates]
    free = [extended.COORDINATES.index(q) for q in pose.coordinates]
    joint = np.isin(every, released)
    by_force = np.where(joint, c, 1.0)
    K_y, M_y = K * by_force[:, None, :], M * by_force[:, None, :]
    K_y[:, every, every] += joint
    found: list[Array] = []
    for members, gap in zip(pose.members, (pose.gaps[members[0]] for members in pose.members), strict=True):
        phi = pose.shapes[members]
        shift = pose.eigenvalues[members].mean() + 0.1 * gap
        iterate = np.linalg.inv(K_y - shift * M_y) @ M_y
        X = np.zeros((len(paths), len(every), len(members)), dtype=complex)
        X[:, free] = phi.T
        X /= np.where(np.abs(by_force) > TINY, by_force, 1.0)[..., None]
        for _ in range(16):  # each leaves a ninth of what is not of the group
            X = iterate @ X
            X /= np.abs(X).max(axis=(1, 2), keepdims=True)
        along = np.zeros((len(members), len(every)))
        along[:, free] = phi @ pose.M
        ratio = (along @ iterate @ X) @ np.linalg.inv(along @ X)  # 1 / (lambda - shift)
        found.append(shift * np.eye(len(members)) + np.linalg.inv(ratio))
        X *= by_force[..., None]
        outer = X @ np.linalg.inv(np.swapaxes(X, 1, 2) @ M @ X) @ np.swapaxes(X, 1, 2)
        found.append(outer[:, free][:, :, free])
    with np.errstate(divide="ignore", invalid="ignore"):  # of locked joints
        K[:, every, every] += np.where(joint, 1 / c, 0.0)
    matrices = [A[:, free][:, :, free] for A in (M, K)]
    largest = float(np.abs(pose.eigenvalues).max())
    return _rates(pose, [A.imag / steps[:, None, None] for A in (*matrices, *found)], largest)


def _smooth(pose: Pose, values: Array, shapes: Array) -> list[Array]:
    found = []
    for members in pose.members:
        phi = shapes[members]
        along = pose.shapes[members] @ pose.M @ phi.T
        found += [along @ np.diag(values[members]) @ np.linalg.inv(along), phi.T @ phi]
    return found


def _rates(pose: Pose, changes: Sequence[Array], largest: float) -> Rates:
    """Turn derivatives of the smooth quantities into those that are asked for."""
    M, K, *rest = changes
    values = np.empty((len(M), len(pose.eigenvalues)))
    shapes = np.empty((len(M), *pose.shapes.shape))
    for members, inner, outer in zip(pose.members, rest[::2], rest[1::2], strict=True):
        phi = pose.shapes[members]
        values[:, members] = np.sort(np.linalg.eigvals(inner).real, axis=-1)
        change = np.swapaxes(outer @ pose.M @ phi.T, 1, 2)  # dphi + Phi (dPhi^T M phi)
        inside = np.einsum("tgi,ij,gj->tg", change, pose.M, phi)  # 2 phi^T M dphi
        shapes[:, members] = change - change @ pose.M @ phi.T @ phi + 0.5 * inside[..., None] * phi
    return Rates(M, K, values, shapes, np.full(len(M), largest))


def _complex_matrices(pose: Pose, paths: Sequence[ParameterPath], steps: Array) -> tuple[Array, Array, Array]:
    """M and K without joints, and the compliances of the joints, one step along each path."""
    robot, T = pose.robot, len(paths)

    def tiled(value: object) -> Array:
        array = np.asarray(value, dtype=complex)
        return np.tile(array, (T, *(1,) * array.ndim))

    fields = {name: tiled(value) for name, value in robot.parameters._asdict().items()}
    effects = {name: robot.effects.get(name, robot.constants.get(name, 0.0)) for name in _effect_parameters()}
    fields |= {name: tiled(value) for name, value in effects.items()}
    for t, path in enumerate(paths):
        for (field, index), weight in path.weights.items():
            fields[field][(t, *index)] += weight * steps[t]
    parameters = Parameters(**{name: fields[name] for name in Parameters._fields})
    chosen = extended.Effects(**{name.replace(".", "_"): fields[name] for name in effects})
    M, K_el, K_g = extended.extended_matrices(pose.poses[pose.index], parameters, chosen)
    c = np.zeros((T, M.shape[-1]), dtype=complex)
    for name, coordinates in JOINTS.items():
        c[:, [extended.COORDINATES.index(q) for q in coordinates]] += fields[name][:, None]
    return M, K_el + K_g, c


def _effect_parameters() -> list[str]:
    return [f"{e.name}.{p.name}" for e in CATALOGUE.values() for p in e.parameters]
