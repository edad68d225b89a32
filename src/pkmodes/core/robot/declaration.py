"""The declarations of a robot file, merged and in SI units."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field
from functools import cache
from typing import Any

import numpy as np

from pkmodes.core.base.drives import FREE, checked_drives
from pkmodes.core.mechanism import registry
from pkmodes.core.mechanism.described import DAMPING_RATIO, Mechanism
from pkmodes.core.robot.covariance import Covariance
from pkmodes.core.robot.layout import QUANTITY_KINDS, effect_parameters, items
from pkmodes.core.robot.units import Quantity
from pkmodes.core.robot.usable import Bound

#: The named tuple of the generated model; each mechanism has its own.
Parameters = Any


@dataclass(frozen=True, eq=False)
class Declaration:
    """The declarations of a robot file.

    Two declarations are equal if their content is equal; the location of their files is ignored.

    Attributes
    ----------
    name : str
        The robot's name.
    mechanism_name : str
        The mechanism's name.
    source : str
        The robot file, for messages.
    parameters : Parameters
        Parameter values in SI units, as passed to the generated model.
    quantities : mapping of str to Quantity
        Every declared value with its standard deviation, by dotted path (``platform.mass``,
        ``axis.1.belt.width`` for the override of one axis, ``axis.1.limits.min``, ``gravity.z``).
    effects : mapping of str to float
        Parameters of the declared effects in SI units, by ``<effect>.<parameter>``.  A diagnosis also tries
        compliances of single joints, by ``<effect>.<parameter>.<coordinate>``; a file cannot declare them.
    constants : mapping of str to float
        Effect parameters that come from other tables of the file and are never fitted (the frame mass), whether or
        not the effect is declared.
    usable : mapping of str to Limits, Radius or SingularAngle
        Where the machine is used: lower and upper limit of components of the pose, ``radius`` and
        ``singular_angle``, in SI units.
    report : mapping of str to str
        Fields for the header of reports, by key of the table ``[report]``.
    covariance : tuple of Covariance
        Tables of values with correlated errors; all other values are independent.
    drives : {"free", "held"}
        How the machine is used: its motors turn freely, or position loops far stiffer than the machine hold them.
    kept : dict
        Results kept for this robot, to be computed once.
    """

    name: str
    mechanism_name: str
    source: str
    parameters: Parameters
    quantities: Mapping[str, Quantity] = field(repr=False)
    effects: Mapping[str, float] = field(default_factory=dict)
    constants: Mapping[str, float] = field(default_factory=dict)
    usable: Mapping[str, Bound] = field(default_factory=dict)
    report: Mapping[str, str] = field(default_factory=dict)
    covariance: tuple[Covariance, ...] = ()
    drives: str = FREE
    kept: dict[str, Any] = field(default_factory=dict, init=False, repr=False)

    def __eq__(self, other: object) -> bool:
        return self._content == other._content if isinstance(other, Declaration) else NotImplemented

    def __getstate__(self) -> dict[str, Any]:
        # The mechanism comes first: unpickling it registers it, and the parameters need its generated module.
        return {"mechanism": self.mechanism, **vars(self), "kept": {}}

    def __setstate__(self, state: dict[str, Any]) -> None:
        # Pickling and copying lose the read-only flag.
        self.__dict__.update({name: value for name, value in state.items() if name != "mechanism"})
        for value in self.parameters:
            if isinstance(value, np.ndarray):
                value.flags.writeable = False

    def __hash__(self) -> int:
        return hash(self._content)

    @property
    def _content(self) -> tuple[object, ...]:
        """Everything except the source, in a form that can be compared and hashed."""
        arrays = (np.asarray(value) for value in self.parameters)
        mappings = (self.quantities, self.effects, self.constants, self.usable, self.report)
        return (
            self.name,
            self.mechanism_name,
            tuple((array.shape, *array.ravel().tolist()) for array in arrays),
            *(frozenset(mapping.items()) for mapping in mappings),
            self.covariance,
            self.drives,
        )

    @property
    def mechanism(self) -> Mechanism:
        """The mechanism: description and generated functions."""
        return registry.mechanism(self.mechanism_name)

    def resolve_drives(self, drives: str | None) -> str:
        """Return the state of the motors: as requested, or else as the machine is used.

        Parameters
        ----------
        drives : {None, "free", "held"}
            None takes that of the robot file.

        Returns
        -------
        str
            "free" or "held".

        Raises
        ------
        PkmodesError
            If it is neither.
        """
        return self.drives if drives is None else checked_drives(drives)

    @property
    def damping_ratio(self) -> float:
        """Damping ratio of every vibration mode, in addition to what effects dissipate."""
        ratio = self.quantities.get(DAMPING_RATIO)
        return 0.0 if ratio is None else ratio.value

    @property
    def effects_dissipate(self) -> bool:
        """Whether any effect dissipates."""
        catalogue = self.mechanism.effects
        return any(
            value and catalogue[path.partition(".")[0]].dissipates for path, value in self.effects.items()
        )

    @property
    def dissipates(self) -> bool:
        """Whether anything dissipates: an effect, or the damping ratio of every vibration mode."""
        return self.effects_dissipate or self.damping_ratio > 0.0

    @property
    def declared(self) -> dict[str, object]:
        """Every declared value by dotted path, in SI units: quantities, and choices such as a direction."""
        values: dict[str, object] = {path: quantity.value for path, quantity in self.quantities.items()}
        for item in items(self.mechanism):
            if item.key.kind in QUANTITY_KINDS:
                continue
            value = np.asarray(getattr(self.parameters, item.key.field))[item.index]
            if item.key.kind == "choice":
                values[item.path] = int(value)
            elif item.key.kind == "one_of":
                values[item.path] = item.key.choices[int(np.argmax(value))]
            elif item.key.kind == "direction":
                values[item.path] = value.tolist()
            else:
                values[item.path] = [int(sign) for sign in value]
        return values


def changeable_units(robot: Declaration) -> dict[str, str]:
    """Return the paths that can be changed or added, with their SI units."""
    declared = {path: quantity.unit for path, quantity in robot.quantities.items()}
    return {**declared, **_always_changeable(robot.mechanism)}


def unit_of(robot: Declaration, path: str) -> str | None:
    """Return the SI unit of a path that can be changed or added, None for any other."""
    quantity = robot.quantities.get(path)
    return _always_changeable(robot.mechanism).get(path) if quantity is None else quantity.unit


@cache
def _always_changeable(mechanism: Mechanism) -> dict[str, str]:
    """Return the paths that can be changed although the file need not declare them, with their SI units."""
    undeclared = {
        number.path: number.unit
        for item in items(mechanism)
        if item.shared or item.key.default is not None
        for number in item.numbers
    }
    groups = {group.path: group.unit for group in mechanism.parameter_groups}
    return {**undeclared, **effect_parameters(mechanism), **groups}
