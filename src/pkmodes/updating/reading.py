"""Read the modes measured on a robot: the columns of its mechanism, or of any mechanism."""

from __future__ import annotations

from dataclasses import replace
from functools import partial
from os import PathLike
from pathlib import Path

from pkmodes.core.base.drives import checked_drives
from pkmodes.core.base.errors import MeasurementError, PkmodesError, shown
from pkmodes.core.mechanism.registry import Mechanism, mechanism, names
from pkmodes.core.model import Model
from pkmodes.core.robot.robot import Robot
from pkmodes.measured.measurements import Measurements
from pkmodes.measured.reading import read_measurements
from pkmodes.updating.channels import channels
from pkmodes.updating.load_cases import settable
from pkmodes.updating.measured_robot import columns_of_others, robot_of


def read(
    path: str | Path,
    band: tuple[float, float] | None = None,
    robot: Robot | Model | None = None,
    *,
    drives: str | None = None,
) -> Measurements:
    """Read the modes measured on a robot.

    Parameters
    ----------
    path : path-like
        A CSV file with one row for each identified mode (docs/diagnosis.md, "What goes in").
    band : tuple of two floats, optional
        Lowest and highest frequency of the test [Hz], if the file does not state it.
    robot : Robot or Model, optional
        Robot whose mechanism defines the allowed columns; by default those of any mechanism.
    drives : {"free", "held"}, optional
        What the motors did in the test, if the file does not state it: they turned freely, which is the default, or
        position loops held them.

    Returns
    -------
    Measurements
        In SI units and Hz.

    Raises
    ------
    MeasurementError
        If anything in the file is wrong, it states another band or other drives, or a row lies outside the band.
    """
    if not isinstance(path, str | PathLike):
        raise PkmodesError(f"expected a path, found {shown(path)}", "read", "give the name of a CSV file")
    of = None if robot is None else robot_of(robot)
    mechanisms = [mechanism(name) for name in names()] if of is None else [of.mechanism]
    data = read_measurements(
        path,
        {name: unit for one in mechanisms for name, unit in channels(one).items()},
        components=[_components(one) for one in mechanisms],
        settings={name: unit for one in mechanisms for name, unit in settable(one, of).items()},
        drives=None if drives is None else checked_drives(drives),
        others=dict if of is None else partial(columns_of_others, of.mechanism),
    )
    if band is None:
        return data
    if data.band not in (None, band):
        stated = f"{data.band[0]:g} Hz to {data.band[1]:g} Hz"
        what = f"the file states the band {stated}, not {band[0]:g} Hz to {band[1]:g} Hz"
        raise MeasurementError(what, data.source, "leave the band out, or correct the file")
    return replace(data, band=band)


def _components(mechanism: Mechanism) -> dict[str, str]:
    """Return the components of a pose and their units: columns of a measurement file."""
    return {component.name: component.unit for component in mechanism.pose}
