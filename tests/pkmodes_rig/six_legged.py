"""Hexapod and hexaglide on the virtual test rig: true modes with any effects of the catalogue and causes outside it.

MuJoCo supplies what turning bodies and closed loops give, the inertia, the weight and the motion of the platform
(`mujoco_six_legged`); springs, rotors and belts are rows, from the contract only.
"""

from __future__ import annotations

from collections.abc import Mapping
from functools import lru_cache
from typing import Any

import numpy as np

from pkmodes_rig.engine import TrueModes
from pkmodes_rig.mujoco_six_legged import LEGS, Engine
from pkmodes_rig.rows import Rows, completed, frame_compliance, without

#: The engine requires a frame with mass [kg]: it is taken off again.
GHOST = 1e-3
FRAME = ("u_x", "u_y", "u_z")
#: Frequency of the isolated absorber [Hz], below the lowest vibration mode.
TUNED = {"hexapod": 150.0, "hexaglide": 40.0}
#: Fields of a machine's shared tables, each a value for all legs or one for each leg in the parameters.
TABLES: dict[str, dict[str, tuple[str, ...]]] = {
    "hexapod": {
        "leg": (
            *("stiffness", "base_mass", "base_center", "base_inertia"),
            *("rod_mass", "rod_center", "rod_inertia"),
        ),
        "motor": ("inertia", "travel"),
    },
    "hexaglide": {
        "link": ("length", "mass"),
        "carriage": ("mass", "length"),
        "belt": ("specific_stiffness", "width"),
        "pulley": ("radius", "inertia"),
        "motor": ("inertia", "gear_ratio"),
    },
}
#: Fields whose name in the parameters is not ``<table>_<field>``.
RENAMED = {("motor", "gear_ratio"): "gear_ratio"}


def hexapod(
    q: Any,
    p: np.ndarray,
    effects: Mapping[str, float] = {},
    outside: Mapping[str, float] = {},
    *,
    held: bool = False,
) -> TrueModes:
    """Compute the modes of a hexapod at one pose, x y z [m] and rx ry rz [rad]; arguments are those of `corexy`."""
    rows = _assembled("hexapod", ("l", "s"), q, p, effects, outside)
    for j in LEGS:
        factor = 1.0 + effects.get(f"axis_leg_stiffness.factor_{j + 1}", 0.0)
        strain = rows.row(**{f"l_{j + 1}": 1.0, f"s_{j + 1}": -1.0})
        rows.spring(strain, q.leg_stiffness[j] * factor)
    rows.spring(rows.row(l_1=1.0), outside.get("leg_hose", 0.0))
    locked = [name for name in FRAME if not frame_compliance(name, effects)]
    completed(rows, "s", effects, outside, tuned=TUNED["hexapod"])
    return rows.modes([*locked, *without(outside)], rows.motors("s") if held else ())


def hexaglide(
    q: Any,
    p: np.ndarray,
    effects: Mapping[str, float] = {},
    outside: Mapping[str, float] = {},
    *,
    held: bool = False,
) -> TrueModes:
    """Compute the modes of a hexaglide at one pose; the arguments are those of `hexapod`."""
    rows = _assembled("hexaglide", ("x", "theta"), q, p, effects, outside)
    released = {
        "psi": ("gearbox_compliance", "one_gearbox"),
        "delta": ("link_compliance", "one_link"),
        "eps": ("clamp_compliance", ""),
    }
    locked = [name for name in FRAME if not frame_compliance(name, effects)]
    for j in LEGS:
        _belt(rows, q, float(_carriage(q, p, j)), j, effects)
        for stem, (effect, single) in released.items():
            compliance = effects.get(f"{effect}.compliance", 0.0)
            compliance += outside.get(single, 0.0) if j == 0 else 0.0
            name = f"{stem}_{j + 1}"
            if compliance:
                rows.spring(rows.row(**{name: 1.0}), 1.0 / compliance)
            else:
                locked.append(name)
        driven, inertia = _driven(q, j), q.gear_ratio[j] ** 2 * q.motor_inertia[j]
        # In the engine the motor turns with the pulley.
        rows.inertia(rows.row(**{driven: 1.0}), -inertia)
        rows.inertia(rows.row(**{driven: 1.0, f"psi_{j + 1}": 1.0}), inertia)
    rows.spring(rows.row(x_1=1.0), outside.get("leg_hose", 0.0))
    motors = [{_driven(q, j): 1.0, f"psi_{j + 1}": 1.0} for j in LEGS]
    completed(rows, "theta", effects, outside, motors=motors, tuned=TUNED["hexaglide"])
    return rows.modes([*locked, *without(outside)], motors if held else ())


def _driven(q: Any, j: int) -> str:
    return f"theta_{j + 1}_{1 if q.drive[j, 0] else 2}"


def _carriage(q: Any, p: np.ndarray, j: int) -> float:
    """Return the position of a carriage on its rail."""
    direction = q.direction[j] / np.linalg.norm(q.direction[j])
    reach = p[:3] + _rotation(p[3:]) @ q.joint[j] - q.origin[j]
    along = float(direction @ reach)
    across = reach - along * direction
    return along + float(q.branch[j]) * float(np.sqrt(q.link_length[j] ** 2 - across @ across))


def _rotation(vector: np.ndarray) -> np.ndarray:
    angle = float(np.linalg.norm(vector))
    if angle == 0.0:
        return np.eye(3)
    x, y, z = vector / angle
    cross = np.array([[0, -z, y], [z, 0, -x], [-y, x, 0]])
    return np.asarray(np.eye(3) + np.sin(angle) * cross + (1 - np.cos(angle)) * cross @ cross)


def _belt(rows: Rows, q: Any, x: float, j: int, effects: Mapping[str, float]) -> None:
    """Add the three spans of a belt, with their mass."""
    (low, high), half, radius = q.limits[j], q.carriage_length[j] / 2, q.pulley_radius[j]
    clamp = rows.row(**{f"x_{j + 1}": 1.0, f"eps_{j + 1}": 1.0})
    first, second = (rows.row(**{f"theta_{j + 1}_{k}": radius}) for k in (1, 2))
    unit = q.belt_width[j] * q.belt_specific_stiffness[j]
    unit *= 1.0 + effects.get(f"axis_belt_stiffness.factor_{j + 1}", 0.0)
    soft = effects.get("belt_end_compliance.compliance", 0.0)
    spans = (high - low, second, first), (x - low - half, second, clamp), (high - x - half, clamp, first)
    for length, one, other in spans:
        rows.spring(other - one, 1.0 / (length / unit + soft))
        mass = effects.get("belt_mass.linear_density", 0.0) * length
        for end in (one, other, one + other):  # linear between the ends: [[2, 1], [1, 2]] / 6
            rows.inertia(end, mass / 6)


def _assembled(
    mechanism: str,
    stems: tuple[str, str],
    q: Any,
    p: np.ndarray,
    effects: Mapping[str, float],
    outside: Mapping[str, float],
) -> Rows:
    """Return inertia and gravity from the engine, with a payload, and without springs and the mass of the frame."""
    mass = effects.get("payload.mass", 0.0)
    bare, loaded = (_engine(mechanism, _key(mechanism, q), tuple(map(float, p)), load) for load in (0.0, 1.0))
    names, M, motion, weights = bare
    names = [*names, *(f"{stem}_{j + 1}" for stem in ("psi", "eps") for j in LEGS if stems[0] == "x")]
    rows = Rows([*names, "absorber"], np.zeros((3, len(names) + 1)), turning=np.zeros((3, len(names) + 1)))
    own = np.ix_(range(len(M)), range(len(M)))
    # Inertia and weight grow in proportion to a payload; of an absorber, only the weight counts here.
    rows.M[own] = M + mass * (loaded[1] - M)
    rows.weights[own] = weights + (mass + outside.get("tuned_absorber", 0.0)) * (loaded[3] - weights)
    rows.platform[:, : len(M)], rows.turning[:, : len(M)] = motion[:3], motion[3:]
    for name in FRAME:
        rows.inertia(rows.row(**{name: 1.0}), -GHOST)
    return rows


def _key(mechanism: str, q: Any) -> tuple[tuple[str, bytes, tuple[int, ...]], ...]:
    """Return the parameters as something that can be compared, without what the engine's inertia does not contain."""
    fields = {name: np.asarray(value, dtype=float) for name, value in q._asdict().items()}
    return tuple((name, value.tobytes(), value.shape) for name, value in fields.items())


@lru_cache(maxsize=2000)
def _engine(
    mechanism: str, key: tuple[tuple[str, bytes, tuple[int, ...]], ...], p: tuple[float, ...], payload: float
) -> tuple[list[str], np.ndarray, np.ndarray, np.ndarray]:
    """Return coordinates, mass matrix, motion of the platform (six rows), and the Hessian of gravity."""
    q = {name: np.frombuffer(data).reshape(shape) for name, data, shape in key}
    machine = {
        "mechanism": mechanism,
        "gravity": q["gravity"],
        "frame": {"mass": GHOST},
        "platform": {name: q[f"platform_{name}"] for name in ("mass", "center", "inertia", "products")},
        "axis": [_axis(mechanism, q, j) for j in LEGS],
        "effects": {"payload": {"mass": payload}} if payload else {},
    }
    engine = Engine(machine, p)
    hessian = engine.gravity_hessian()
    names = [_renamed(name) for name in engine.names]
    return names, engine.mass_matrix(), engine.platform_motion(), (hessian + hessian.T) / 2


def _axis(mechanism: str, q: Mapping[str, np.ndarray], j: int) -> dict[str, Any]:
    places = (
        ("base", "joint", "limits") if mechanism == "hexapod" else ("origin", "direction", "joint", "limits")
    )
    axis: dict[str, Any] = {name: q[name][j] for name in places}
    for table, names in TABLES[mechanism].items():
        axis[table] = {name: float(q[RENAMED.get((table, name), f"{table}_{name}")][j]) for name in names}
    if mechanism == "hexaglide":
        axis |= {"branch": float(q["branch"][j]), "driven_pulley": 1 if q["drive"][j, 0] else 2}
    return axis


def _renamed(name: str) -> str:
    """Return the coordinate of a joint of the engine: ``carriage_0`` is ``x_1``, ``pulley_0_2`` ``theta_1_2``."""
    stem, _, place = name.partition("_")
    if stem == "carriage":
        return f"x_{int(place) + 1}"
    if stem == "pulley":
        j, k = place.split("_")
        return f"theta_{int(j) + 1}_{k}"
    return name
