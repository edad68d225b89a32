"""A robot: what its file declares, merged and in SI units."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field
from typing import Any

import numpy as np

from pkmodes.robot.units import Quantity
from pkmodes_generated.linear_delta import Parameters


@dataclass(frozen=True, eq=False)
class Robot:
    """A robot as declared.

    Robots are equal when they declare the same: where their files are does not count.

    Attributes
    ----------
    name : str
        Its name.
    mechanism : str
        ``"linear_delta"``.
    source : str
        The robot file, for messages.
    parameters : Parameters
        Values of the parameters in SI units, as the generated model takes them.
    quantities : mapping of str to Quantity
        Every declared value with its standard deviation, by dotted path (``platform.mass``,
        ``axis.1.belt.width`` where an axis overrides, ``axis.1.limits.min``, ``gravity.z``).
    effects : mapping of str to float
        Parameters of the declared effects in SI units, by ``<effect>.<parameter>``; no file declares them, but a
        diagnosis tries compliances of single joints too, by ``<effect>.<parameter>.<coordinate>``.
    constants : mapping of str to float
        Parameters that effects take from elsewhere in the file and that are never fitted (the frame's mass),
        whether or not the effect is declared.
    """

    name: str
    mechanism: str
    source: str
    parameters: Parameters
    quantities: Mapping[str, Quantity] = field(repr=False)
    effects: Mapping[str, float] = field(default_factory=dict)
    constants: Mapping[str, float] = field(default_factory=dict)

    def __eq__(self, other: object) -> bool:
        return self._content == other._content if isinstance(other, Robot) else NotImplemented

    def __setstate__(self, state: dict[str, Any]) -> None:
        # What is pickled or copied comes back as it was: not to be written to.
        self.__dict__.update(state)
        for value in self.parameters:
            if isinstance(value, np.ndarray):
                value.flags.writeable = False

    def __hash__(self) -> int:
        return hash(self._content)

    @property
    def _content(self) -> tuple[object, ...]:
        """All but the source, in a form that compares and hashes."""
        arrays = (np.asarray(value) for value in self.parameters)
        mappings = (self.quantities, self.effects, self.constants)
        return (
            self.name,
            self.mechanism,
            tuple((array.shape, *array.ravel().tolist()) for array in arrays),
            *(frozenset(mapping.items()) for mapping in mappings),
        )

    def with_values(self, values: Mapping[str, Any]) -> Robot:
        """Return the robot that a file with these values would declare.

        Parameters
        ----------
        values : mapping of str to value
            By dotted path: every quantity of the robot file (``platform.mass``, ``axis.1.origin.x``, or all of
            ``axis.1.origin``), a value of one axis in place of the shared one (``axis.1.belt.width``), a parameter
            of an effect, declared or not (``effects.payload.mass``), ``frame.mass``, and the wholes ``axis.span``
            and ``axis.joint_radius``.  A value is written as in the file: text with a unit, a number in SI units,
            or a table ``{"value": ..., "sigma": ...}``; a `Quantity` will do as well.

        Returns
        -------
        Robot
            Validated as a file is.  What changes keeps its standard deviation, as an absolute one, unless a table
            gives another; ``{"sigma": ...}`` alone changes nothing else, and a sigma of None takes it away.

        Raises
        ------
        PkmodesError
            If there is no such path, with the nearest; if one number would be changed twice.
        RobotFileError
            If a file with these values would be refused: one problem for each thing to mend.

        Examples
        --------
        >>> import pkmodes
        >>> robot = pkmodes.read_robot("robots/linear-delta-2022.toml")
        >>> heavier = robot.with_values({"platform.mass": "1800 g", "effects.payload.mass": 0.35})
        >>> heavier.quantities["platform.mass"]
        Quantity(value=1.8, unit='kg', sigma=None)
        >>> pkmodes.Model(heavier).frequencies([0.6, 0.0, -0.245])[3:].round(2)
        array([ 54.15,  59.25,  60.1 , 130.71, 133.72, 134.15])
        """
        from pkmodes.robot.variants import with_values  # reading units and schemas takes long to import

        return with_values(self, values)

    @property
    def declared(self) -> dict[str, object]:
        """Every declared value by dotted path, in SI units: quantities, and what is chosen for each axis."""
        values: dict[str, object] = {path: quantity.value for path, quantity in self.quantities.items()}
        for j in range(3):
            values[f"axis.{j + 1}.direction"] = self.parameters.direction[j].tolist()
            values[f"axis.{j + 1}.driven_pulley"] = 1 if self.parameters.drive[j, 0] else 2
            values[f"axis.{j + 1}.branch"] = int(self.parameters.branch[j])
        return values
