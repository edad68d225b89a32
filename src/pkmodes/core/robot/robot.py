"""A robot: the declarations of its file, with changed values if required."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import fields
from typing import Any

from pkmodes.core.base.attached import Attached
from pkmodes.core.robot.declaration import Declaration
from pkmodes.core.robot.variants import with_values


class Robot(Declaration):
    """A robot as declared.

    Two robots are equal if their declarations are equal; the location of their files is ignored.  The attributes are
    those of `pkmodes.core.robot.declaration.Declaration`: ``name``, ``mechanism_name``, ``source``, ``parameters``,
    ``quantities``, ``effects``, ``constants``, ``usable``, ``report``, ``covariance``, ``drives``, and the
    derived ``mechanism`` and ``declared``.
    """

    _repr_html_ = Attached("pkmodes.pages.report.notebook:robot_html")

    def with_values(self, values: Mapping[str, Any]) -> Robot:
        """Return the robot that a file with these values would declare.

        Parameters
        ----------
        values : mapping of str to value
            By dotted path: every quantity of the robot file (``platform.mass``, ``axis.1.origin.x``, or the whole
            vector ``axis.1.origin``), the override of a shared value for one axis (``axis.1.belt.width``), an effect
            parameter, declared or not (``effects.payload.mass``), ``frame.mass``, and groups such as ``axis.span``
            and ``axis.joint_radius``.  A value is written as in the file: text with a unit, a number in SI units, or
            a table ``{"value": ..., "sigma": ...}``; a `Quantity` is also accepted.

        Returns
        -------
        Robot
            Validated like a file.  A changed value keeps its absolute standard deviation unless a table gives
            another; ``{"sigma": ...}`` changes only the standard deviation, and a sigma of None removes it.  It
            keeps its correlations with others as long as it has a standard deviation.

        Raises
        ------
        PkmodesError
            If there is no such path (the message suggests the nearest), or one number would be changed twice.
        RobotFileError
            If a file with these values would be rejected: one problem for each thing to fix.

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
        """Return the robot with a given declaration.

        Parameters
        ----------
        declaration : Declaration
            Read from a file, or changed.

        Returns
        -------
        Robot
            With the same content.
        """
        if isinstance(declaration, cls):
            return declaration
        robot = cls(
            **{
                attribute.name: getattr(declaration, attribute.name)
                for attribute in fields(declaration)
                if attribute.init
            }
        )
        robot.kept.update(declaration.kept)
        return robot
