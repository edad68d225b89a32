"""What a call for modes does, worked out once for a model, and the fields that are evaluated when they are read."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from typing import Any

from numpy.typing import NDArray

from pkmodes.core.mechanism.poses import CheckedPoses
from pkmodes.core.robot.robot import Robot
from pkmodes.core.solve.mode_fields import ModeFields

Array = NDArray[Any]


@dataclass(frozen=True, eq=False)
class Plan:
    """What a call for some fields does, for given drives and one back end.

    Attributes
    ----------
    fields : ModeFields
        Those that are computed at once.
    shared : mapping of str to str
        Those that share the array of another one, by name.
    later : mapping of str to ModeFields
        Those that are evaluated when they are read, each alone.
    rigid_modes : int
    backend : str
        Of the result.
    """

    fields: ModeFields
    shared: Mapping[str, str]
    later: Mapping[str, ModeFields]
    rigid_modes: int
    backend: str


class Later:
    """The fields of a result that are evaluated when they are read; each is what it would have been at once.

    Parameters
    ----------
    fields : mapping of str to ModeFields
        For each of them.
    robot : Robot
    max_condition : float
        As for the result.
    checked : CheckedPoses
        The poses of the result.  They are copied: the caller may change what the result shows.
    threads : int
        As for the result.
    """

    __slots__ = ("_checked", "_fields", "_max_condition", "_robot", "_threads")

    def __init__(
        self,
        fields: Mapping[str, ModeFields],
        robot: Robot,
        max_condition: float,
        checked: CheckedPoses,
        threads: int,
    ) -> None:
        self._fields, self._robot, self._max_condition, self._threads = fields, robot, max_condition, threads
        self._checked = CheckedPoses(
            checked.points.copy(), checked.codes.copy(), checked.batch, checked.known, checked.left
        )

    def __contains__(self, name: object) -> bool:
        return name in self._fields

    def shape(self, name: str) -> tuple[int, ...]:
        """Return the shape of a field."""
        return self._checked.batch + self._fields[name].tail(name)

    def __call__(self, name: str) -> Array:
        """Evaluate a field."""
        rows = self._fields[name].again(self._robot, self._max_condition, self._checked, self._threads)
        return rows[name].reshape(self.shape(name))
