"""A robot at valid poses, with the quantities that fields are functions of."""

from __future__ import annotations

from collections.abc import Mapping
from functools import cached_property
from typing import Any

import numpy as np
from numpy.typing import NDArray

from pkmodes.core.mechanism.generated import Generated
from pkmodes.core.mechanism.length import lengths_of
from pkmodes.core.solve.fields import FIELDS
from pkmodes.core.system.evaluation import Evaluation
from pkmodes.core.system.stiffness_parts import StiffnessParts, stiffness_parts

Array = NDArray[np.float64]


class RobotAtPoses:
    """The quantities of a robot at N poses; each is evaluated once, when it is needed.

    - points: (N, d)
    - source: the robot, for messages
    - quantities: quantities that need not be evaluated, such as ``eigenvalues`` and ``shapes`` from a solver
    """

    def __init__(self, system: Evaluation, points: Array, source: str, quantities: Mapping[str, Any]) -> None:
        self.system, self.points, self.source = system, points, source
        self.quantities = dict(quantities)

    def __getitem__(self, name: str) -> Any:
        """Return a field, or a quantity by the name of an attribute."""
        if name not in self.quantities:
            field = FIELDS.get(name)
            if field is None or field.needs == (name,):
                return getattr(self, name)
            self.quantities[name] = field.function(*(self[needed] for needed in field.needs))
        return self.quantities[name]

    def evaluated(self, name: str) -> Any:
        """Return a quantity that was given or has been evaluated; else None."""
        return self.quantities.get(name, vars(self).get(name))

    @cached_property
    def all_coordinates(self) -> tuple[Array, Array]:
        """M and K including the coordinates of locked joints, each (N, e, e)."""
        return self.system.all_coordinates(self.points)

    @cached_property
    def mass_matrix(self) -> Array:
        """M, (N, n, n)."""
        return self.system.free_part(self["all_coordinates"][0])

    @cached_property
    def stiffness_matrix(self) -> Array:
        """K, (N, n, n)."""
        return self.system.free_part(self["all_coordinates"][1])

    @cached_property
    def stiffness_parts(self) -> StiffnessParts:
        """K in parts, of an extended system."""
        return stiffness_parts(self.system, self.points)

    @cached_property
    def platform_motion(self) -> Array:
        """Absolute motion of the platform per unit of each coordinate, (N, components, n)."""
        return self.system.platform_motion(self.points)

    @cached_property
    def elastic_stiffness(self) -> Array:
        """K without effects and gravity, in base coordinates, (N, b, b)."""
        return np.asarray(self._base.elastic_hessian(self.points))

    @cached_property
    def static_torque(self) -> Array:
        """Torques or forces of the drives that hold the poses, (N, drives)."""
        return self._statics[0]

    @cached_property
    def static_rotation(self) -> Array:
        """Static values of the dependent coordinates, (N, dependent)."""
        return self._statics[1]

    @cached_property
    def _statics(self) -> tuple[Array, Array]:
        return self.system.statics(self.points)

    @cached_property
    def joint_positions(self) -> Array:
        """The independent coordinates, (N, k)."""
        return np.asarray(self._base.inverse_kinematics(self.points))

    @cached_property
    def platform_jacobian(self) -> Array:
        """D_p, (N, d, k)."""
        return np.asarray(self._base.platform_jacobian(self.points))

    @property
    def directions(self) -> tuple[str, ...]:
        """Names of the directions of the platform's motion, which come first among its components."""
        return tuple(self.system.mechanism.directions)

    @cached_property
    def lengths(self) -> Array:
        """Factors that make lengths of the components of the platform's motion, (components,)."""
        return lengths_of(self.system.mechanism, self.system.parameters)

    @property
    def _base(self) -> Generated:
        return Generated(self.system.mechanism.model, self.system.parameters)
