"""A robot: what its file declares, merged and in SI units."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field

from pkmodes.robot.units import Quantity
from pkmodes_generated.linear_delta import Parameters


@dataclass(frozen=True)
class Robot:
    """A robot as declared.

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

    @property
    def declared(self) -> dict[str, object]:
        """Every declared value by dotted path, in SI units: quantities, and what is chosen for each axis."""
        values: dict[str, object] = {path: quantity.value for path, quantity in self.quantities.items()}
        for j in range(3):
            values[f"axis.{j + 1}.direction"] = self.parameters.direction[j].tolist()
            values[f"axis.{j + 1}.driven_pulley"] = 1 if self.parameters.drive[j, 0] else 2
            values[f"axis.{j + 1}.branch"] = int(self.parameters.branch[j])
        return values
