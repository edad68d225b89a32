"""A robot: what its file declares, which may be changed by value."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any

from pkmodes.robot.declaration import Declaration
from pkmodes.robot.variants import with_values


class Robot(Declaration):
    """A robot as declared.

    Robots are equal when they declare the same: where their files are does not count.  Their attributes are those
    of `Declaration`: ``name``, ``mechanism``, ``source``, ``parameters``, ``quantities``, ``effects``, ``constants``,
    and ``kind`` and ``declared``, which follow from them.
    """

    def with_values(self, values: Mapping[str, Any]) -> Robot:
        """Return the robot that a file with these values would declare.

        Parameters
        ----------
        values : mapping of str to value
            By dotted path: every quantity of the robot file (``platform.mass``, ``axis.1.origin.x``, or all of
            ``axis.1.origin``), a value of one axis in place of the shared one (``axis.1.belt.width``), a parameter
            of an effect, declared or not (``effects.payload.mass``), ``frame.mass``, and wholes such as
            ``axis.span`` and ``axis.joint_radius``.  A value is written as in the file: text with a unit, a number
            in SI units, or a table ``{"value": ..., "sigma": ...}``; a `Quantity` will do as well.

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
        return Robot.of(with_values(self, values))

    @classmethod
    def of(cls, declaration: Declaration) -> Robot:
        """The robot of a declaration."""
        return cls(**vars(declaration))
