"""Inputs and outputs of a machine by name: torques, prescribed motor angles, forces, motions.

Another kind of port is an entry of `INPUTS` or `OUTPUTS` (docs/how-to/response.md).
"""

from __future__ import annotations

import re
from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass
from typing import Any

import numpy as np
from numpy.typing import NDArray

from pkmodes.core.base.drives import FREE, HELD
from pkmodes.core.base.errors import PkmodesError, nearest_name, shown
from pkmodes.core.mechanism.directions import unit_direction
from pkmodes.core.model import Model
from pkmodes.machine.response.linearised import LinearisedRobot
from pkmodes_description import Named

Array = NDArray[np.float64]
TORQUE, MOTOR, FORCE, MOMENT = "torque_", "motor_", "force_", "moment_"
#: An output as the caller gives it: a name, or directions of the platform, ``{"name": [dx, dy, dz]}``.
Output = str | Mapping[str, Sequence[float]]
#: Powers of i omega by which the displacement is multiplied.
QUANTITIES = {"displacement": 0, "velocity": 1, "acceleration": 2}


@dataclass(frozen=True)
class Port:
    """An input or an output.

    - kind: ``torque``, ``motor``, ``force``, ``platform`` or ``coordinate``.  A ``torque`` is the force of a drive
      that moves a length; a ``force`` on the platform is a moment for one of its rotations.
    - index: index of the drive, the component of the platform's motion or the coordinate
    - direction: unit vector, for an output of kind ``platform``, along the components of the platform's motion
    """

    name: str
    unit: str
    kind: str
    index: int = 0
    direction: tuple[float, ...] = ()


def inputs_of(model: Model, names: Sequence[str], drives: str) -> tuple[Port, ...]:
    """Return the inputs by name.

    Raises PkmodesError if a name is unknown or repeated, a torque is given to a held motor, or the angle of a free
    one is prescribed.
    """
    mechanism = model.robot.mechanism
    ports: dict[str, Port] = {}
    for j, drive in enumerate(mechanism.drives):
        ports[f"{TORQUE}{drive.name}"] = Port(f"{TORQUE}{drive.name}", drive.unit, "torque", j)
        ports[f"{MOTOR}{drive.name}"] = Port(f"{MOTOR}{drive.name}", _displacement_unit(drive), "motor", j)
    for k, axis in enumerate((*mechanism.directions, *mechanism.rotations)):
        is_rotation = k >= len(mechanism.directions)
        name = f"{MOMENT if is_rotation else FORCE}{axis}"
        ports[name] = Port(name, "N m" if is_rotation else "N", "force", k)
    selected_ports = _select_ports("inputs", names, ports)
    for port in selected_ports:
        if port.kind == "torque" and drives == HELD:
            problem = f"{port.name} is the torque of a motor, but the motors are held"
            raise PkmodesError(
                problem, "inputs", f'use motor_{port.name.removeprefix(TORQUE)}, or drives="free"'
            )
        if port.kind == "motor" and drives == FREE:
            problem = f"{port.name} is a prescribed angle, but the motors are free"
            raise PkmodesError(
                problem, "inputs", f'use torque_{port.name.removeprefix(MOTOR)}, or drives="held"'
            )
    return selected_ports


def outputs_of(model: Model, names: Sequence[str | Mapping[str, Any]]) -> tuple[Port, ...]:
    """Return the outputs: by name, or directions at the platform centre as ``{"name": [dx, dy, dz]}``.

    Raises PkmodesError if a name is unknown or repeated, or a direction is not one.
    """
    mechanism, system = model.robot.mechanism, model.system
    ports: dict[str, Port] = {}
    for component, axis in zip(mechanism.platform, np.eye(len(mechanism.platform)), strict=True):
        ports[component.name] = Port(
            component.name, component.unit, "platform", direction=tuple(axis.tolist())
        )
    for j, drive in enumerate(mechanism.drives):
        ports[f"{MOTOR}{drive.name}"] = Port(f"{MOTOR}{drive.name}", _displacement_unit(drive), "motor", j)
    extended = mechanism.extended
    units = dict(zip(extended.COORDINATES, extended.COORDINATE_UNITS, strict=True))
    for i, name in enumerate(system.coordinates):
        ports.setdefault(name, Port(name, units[name], "coordinate", i))
    selection: list[Any] = []
    for output in _as_list("outputs", names):
        if isinstance(output, Mapping):
            for name, direction in output.items():
                _check_name(name, ports)
                unit = unit_direction(direction, mechanism.directions, f"outputs: {name}")
                all_components = (*unit.tolist(), *(0.0,) * len(mechanism.rotations))
                ports[name] = Port(name, mechanism.platform[0].unit, "platform", direction=all_components)
                selection.append(name)
        else:
            selection.append(output)
    return _select_ports("outputs", selection, ports)


def _check_name(name: Any, ports: Mapping[str, Port]) -> None:
    """Refuse a name of a direction that tables of responses could not have in the names of their columns."""
    if name in ports:
        problem = f"the direction {shown(name)} has the name of another output"
        raise PkmodesError(problem, "outputs", "choose another name")
    if not isinstance(name, str) or re.fullmatch(r"[\w. +-]*\w[\w. +-]*", name) is None:
        problem = f"expected the name of a direction, found {shown(name)}"
        raise PkmodesError(problem, "outputs", "use letters, digits, and any of _ . + -")


def _displacement_unit(drive: Named) -> str:
    """Return the unit of the displacement of a drive."""
    return "m" if drive.unit == "N" else "rad"


def _as_list(where: str, names: Any) -> list[Any]:
    """Return a list of one or several names."""
    if isinstance(names, str | Mapping):
        return [names]
    if not isinstance(names, Iterable):
        raise PkmodesError(f"expected names of {where}, found {shown(names)}", where, "give a list of names")
    return list(names)


def _select_ports(where: str, names: Any, ports: Mapping[str, Port]) -> tuple[Port, ...]:
    requested_names = _as_list(where, names)
    if not requested_names:
        raise PkmodesError(
            f"expected at least one of the {where}, found none", where, f"known: {', '.join(ports)}"
        )
    for i, name in enumerate(requested_names):
        if not isinstance(name, str) or name not in ports:
            raise PkmodesError(f"unknown name {shown(name)}", where, nearest_name(str(name), ports))
        if name in requested_names[:i]:
            raise PkmodesError(f"{shown(name)} is given twice", where, "give each name once")
    return tuple(ports[name] for name in requested_names)


def input_vectors(robot: LinearisedRobot, ports: Sequence[Port]) -> Array:
    """Return the generalised force of each input, (N, n, inputs); 0 for prescribed motor angles."""
    N, _, n = robot.platform.shape
    B = np.zeros((N, n, len(ports)))
    for i, port in enumerate(ports):
        if port.kind == "force":
            B[:, :, i] = robot.platform[:, port.index]
        elif port.kind == "torque":
            B[:, :, i] = robot.motors[port.index]
    return B


def output_vectors(robot: LinearisedRobot, ports: Sequence[Port]) -> Array:
    """Return what each output shows of the coordinates, (N, outputs, n)."""
    N, _, n = robot.platform.shape
    L = np.zeros((N, len(ports), n))
    for i, port in enumerate(ports):
        if port.kind == "platform":
            L[:, i] = np.array(port.direction) @ robot.platform
        elif port.kind == "motor":
            L[:, i] = robot.motors[port.index]
        else:
            L[:, i, port.index] = 1.0
    return L


def prescribed(ports: Sequence[Port], drives: int) -> Array:
    """Return the angle that each input prescribes of each motor, (drives, inputs)."""
    motors = np.zeros((drives, len(ports)))
    for i, port in enumerate(ports):
        if port.kind == "motor":
            motors[port.index, i] = 1.0
    return motors


def units_of(inputs: Sequence[Port], outputs: Sequence[Port], quantity: str) -> tuple[tuple[str, ...], ...]:
    """Return the unit of a quantity of each output (rows) per input (columns)."""
    rate = ("", "/s", "/s^2")[QUANTITIES[quantity]]
    return tuple(
        tuple(_ratio(output_port.unit + rate, input_port.unit) for input_port in inputs)
        for output_port in outputs
    )


def _ratio(output_unit: str, input_unit: str) -> str:
    if output_unit == input_unit:
        return "1"
    return f"{output_unit}/{input_unit}" if " " not in input_unit else f"{output_unit}/({input_unit})"
