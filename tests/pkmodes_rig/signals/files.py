"""Writes signals and functions to the files of a laboratory: universal files, MATLAB and tables."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass
from pathlib import Path

import numpy as np
from scipy.io import savemat

from pkmodes_rig.signals import universal
from pkmodes_rig.signals.analyser import Functions

#: Node of the first force in universal files; those of sensors are 1, 2, ...
FIRST_FORCE = 101
#: Sensors of angles are beside others: the campaign says the unit of each.
UNSTATED = "NONE"


@dataclass(frozen=True)
class Format:
    """A file format.

    Attributes
    ----------
    suffix : str
    sensor, force : callable
        Name of sensor or force number i (from 0) in the file.
    write_times : callable
        Writes (path, step, force or None, motion (N, S)).
    write_functions : callable or None
        Writes (path, functions).
    """

    suffix: str
    sensor: Callable[[int], str]
    force: Callable[[int], str]
    write_times: Callable[[Path, float, np.ndarray | None, np.ndarray], None]
    write_functions: Callable[[Path, Functions], None]


def _universal_times(path: Path, step: float, force: np.ndarray | None, motion: np.ndarray) -> None:
    parts = [
        universal.dataset(universal.TIME, (i + 1, 1), (0, 0), 0.0, step, column, unit=UNSTATED)
        for i, column in enumerate(motion.T)
    ]
    if force is not None:
        place = (FIRST_FORCE, 1)
        parts.append(universal.dataset(universal.TIME, place, place, 0.0, step, force, universal.FORCE, "N"))
    path.write_bytes(b"".join(parts))


def _universal_functions(path: Path, functions: Functions) -> None:
    f, parts = functions.frequencies, list[bytes]()
    for i in range(functions.values.shape[1]):
        for k in range(functions.values.shape[2]):
            places = (i + 1, 1), (FIRST_FORCE + k, 1)
            at = (float(f[0]), float(f[1] - f[0]))
            values, coherence = functions.values[:, i, k], functions.coherence[:, i, k]
            parts.append(universal.dataset(universal.FRF, *places, *at, values, unit=UNSTATED))
            parts.append(
                universal.dataset(universal.COHERENCE, *places, *at, coherence, universal.NOTHING, "NONE")
            )
    path.write_bytes(b"".join(parts))


def _table_times(path: Path, step: float, force: np.ndarray | None, motion: np.ndarray) -> None:
    t = step * np.arange(len(motion))
    names = ["time", *(() if force is None else ("force",)), *map(_acc, range(motion.shape[1]))]
    _table(path, names, np.column_stack([t, *(() if force is None else (force,)), motion]))


def _table_functions(path: Path, functions: Functions) -> None:
    names, columns = ["frequency"], [functions.frequencies]
    sensors, forces = functions.values.shape[1:]
    for i in range(sensors):
        for k in range(forces):
            name = _acc(i) if forces == 1 else f"{_acc(i)}/{_table_force(k)}"
            H = functions.values[:, i, k]
            names += [f"re:{name}", f"im:{name}", f"coh:{name}"]
            columns += [H.real, H.imag, functions.coherence[:, i, k]]
    _table(path, names, np.column_stack(columns))


def _table(path: Path, names: Sequence[str], numbers: np.ndarray) -> None:
    np.savetxt(path, numbers, delimiter=",", header=",".join(names), comments="", fmt="%.7g")


def _matlab_times(path: Path, step: float, force: np.ndarray | None, motion: np.ndarray) -> None:
    variables = {"time": step * np.arange(len(motion))}
    variables |= {} if force is None else {"force": force}
    variables |= {_acc(i): column for i, column in enumerate(motion.T)}
    savemat(path, variables)


def _matlab_functions(path: Path, functions: Functions) -> None:
    variables: dict[str, np.ndarray] = {"frequency": functions.frequencies}
    sensors, forces = functions.values.shape[1:]
    for i in range(sensors):
        for k in range(forces):
            name = _acc(i) if forces == 1 else f"{_acc(i)}__{_table_force(k)}"
            variables[name] = functions.values[:, i, k]
    savemat(path, variables)


def _acc(i: int) -> str:
    return f"acc_{i + 1}"


def _table_force(k: int) -> str:
    return f"f_{k + 1}"


#: Formats by name.
FORMATS = {
    "universal": Format(
        ".uff",
        lambda i: f"{i + 1}:+X",
        lambda k: f"{FIRST_FORCE + k}:+X",
        _universal_times,
        _universal_functions,
    ),
    "table": Format(".csv", _acc, _table_force, _table_times, _table_functions),
    "matlab": Format(".mat", _acc, _table_force, _matlab_times, _matlab_functions),
}
