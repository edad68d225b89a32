"""Read the modes measured on a robot: the columns of its mechanism, of any mechanism, or of another structure."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import replace
from functools import partial
from os import PathLike
from pathlib import Path
from types import MappingProxyType
from typing import Any

from pkmodes.core.base.drives import FREE, checked_drives
from pkmodes.core.base.errors import MeasurementError, PkmodesError, shown
from pkmodes.core.mechanism.registry import Mechanism, mechanism, names
from pkmodes.core.model import Model
from pkmodes.core.robot.columns import split_heading
from pkmodes.core.robot.robot import Robot
from pkmodes.loop.measured.columns import merge_stated
from pkmodes.loop.measured.csv_format import read_text, states_in
from pkmodes.loop.measured.csv_rows import read_lines
from pkmodes.loop.measured.measurements import Measurements
from pkmodes.loop.measured.reading import read_measurements
from pkmodes.loop.measured.rules import SHAPE
from pkmodes.loop.updating.channels import channels
from pkmodes.loop.updating.load_cases import settable_paths
from pkmodes.loop.updating.measured_robot import columns_of_others, robot_of


def read(
    path: str | Path,
    band: tuple[float, float] | None = None,
    robot: Robot | Model | None = None,
    *,
    drives: str | None = None,
    priors: Mapping[str, float | str] = MappingProxyType({}),
    usable: Mapping[str, Any] = MappingProxyType({}),
    state: str | None = None,
) -> Measurements:
    """Read the modes measured on a robot.

    Parameters
    ----------
    path : path-like
        A CSV file with one row for each identified mode (docs/reference/measurement-file.md).
    band : tuple of two floats, optional
        Lowest and highest frequency of the test [Hz], if the file does not state it.
    robot : Robot or Model, optional
        Robot whose mechanism defines the allowed columns; by default those of any mechanism.
    drives : {"free", "held"}, optional
        What the motors did in the test, if the file does not state it: they turned freely, or position loops held
        them; by default as the robot file says, else "free".
    priors : mapping of str to float or str, optional
        Standard deviations of candidates of a diagnosis by name, numbers in SI units or text with a unit, beside
        those that the file states.
    usable : mapping of str to value, optional
        Where the next measurement may be, as in ``[usable]`` of a robot file, ``{"z": ["0 mm", "200 mm"]}``, whose
        limits of the same name it replaces; beside what the file states.
    state : str, optional
        The state of the machine whose rows are read, of a file with rows of several.

    Returns
    -------
    Measurements
        In SI units and Hz.

    Raises
    ------
    MeasurementError
        If anything in the file is wrong, it states something else than an argument, or a row lies outside the band.
    """
    if not isinstance(path, str | PathLike):
        raise PkmodesError(f"expected a path, found {shown(path)}", "read", "give the name of a CSV file")
    checked_robot = None if robot is None else robot_of(robot)
    mechanisms = [mechanism(name) for name in names()] if checked_robot is None else [checked_robot.mechanism]
    data = read_measurements(
        path,
        {name: unit for machine in mechanisms for name, unit in channels(machine).items()},
        components=[_components(machine) for machine in mechanisms],
        settings={
            name: unit
            for machine in mechanisms
            for name, unit in settable_paths(machine, checked_robot).items()
        },
        drives=None if drives is None else checked_drives(drives),
        usual_drives=FREE if checked_robot is None else checked_robot.drives,
        state=state,
        others=dict if checked_robot is None else partial(columns_of_others, checked_robot.mechanism),
    )
    return replace(
        _with_band(band, data),
        priors=merge_stated(data.priors, priors, "priors"),
        usable=merge_stated(data.usable, usable, "usable"),
    )


def read_states(
    path: str | Path,
    band: tuple[float, float] | None = None,
    robot: Robot | Model | None = None,
    **stated: Any,
) -> dict[str, Measurements]:
    """Read the modes measured on a robot in one or several states, by their names in the order of the file.

    - path, band, robot, **stated: as for `read`

    A file that names no state has one with an empty name.
    Raises MeasurementError as `read` does, or if some rows name no state.
    """
    states = states_in(path)
    if len(states) < 2:
        return dict.fromkeys(states, read(path, band, robot, **stated))
    return {state: read(path, band, robot, state=state, **stated) for state in states}


def read_any(
    path: str | Path, band: tuple[float, float] | None = None, *, drives: str | None = None
) -> Measurements:
    """Read the modes measured on a robot, or on another structure: without positions, or with channels of its own.

    - path, band, drives: as for `read`

    Returns them in SI units and Hz.
    Raises MeasurementError if anything in the file is wrong, it states another band, or a row lies outside the band.
    """
    source = str(path)
    text = read_text(Path(path), source, "the measurements", "give a CSV file with one row for each mode")
    _, cells = read_lines(text, source).header(source, "start with the names of the columns")
    machines = [mechanism(name) for name in names()]
    shape_columns = {f"{SHAPE}{name}" for machine in machines for name in channels(machine)}
    poses = {name for machine in machines for name in _components(machine)}
    columns = [split_heading(cell, [*shape_columns, *poses])[0] for cell in cells]
    file_shapes = [name for name in columns if name.lower().startswith(SHAPE)]
    if set(file_shapes) <= shape_columns and poses.intersection(columns):
        return read(path, band, drives=drives)
    data = read_measurements(
        path, [name[len(SHAPE) :] for name in file_shapes], positions=False, drives=drives
    )
    return _with_band(band, data)


def _with_band(band: tuple[float, float] | None, data: Measurements) -> Measurements:
    """Return measurements with the band of an argument, which may not contradict theirs."""
    if band is None:
        return data
    if data.band not in (None, band):
        stated = f"{data.band[0]:g} Hz to {data.band[1]:g} Hz"
        problem = f"the file states the band {stated}, not {band[0]:g} Hz to {band[1]:g} Hz"
        raise MeasurementError(problem, data.source, "leave the band out, or correct the file")
    return replace(data, band=band)


def _components(mechanism: Mechanism) -> dict[str, str]:
    """Return the components of a pose and their units: columns of a measurement file."""
    return {component.name: component.unit for component in mechanism.pose}
