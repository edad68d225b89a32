"""Motions of a robot that move its platform and strain nothing."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from pkmodes.core.mechanism.generated import Generated
from pkmodes.core.system.evaluation import Evaluation

Array = NDArray[np.float64]


def strain_free_motions(system: Evaluation, points: Array) -> Array:
    """Return the motions of `StrainFreeMotions` at N poses, (N, n, components).

    - system: with free motors
    - points: (N, d)
    """
    model = Generated(system.mechanism.model, system.parameters)
    return StrainFreeMotions(system)(model.elastic_hessian(points), model.platform_jacobian(points))


class StrainFreeMotions:
    """The motions that move the platform by 1 along each direction, or turn it by 1, and strain nothing.

    They are those of rigid links, belts, reducers and joints: released joints do not move, and springs to ground
    count as no strain.  The other components of the platform's motion are 0.

    - system: with free motors
    """

    def __init__(self, system: Evaluation) -> None:
        mechanism = system.mechanism
        names = [q.name for q in mechanism.coordinates]
        self._independent = np.array([names.index(name) for name in mechanism.independent])
        self._dependent = np.setdiff1d(np.arange(len(names)), self._independent)
        self._coordinates = len(system.coordinates)

    def __call__(self, elastic: Array, jacobian: Array) -> Array:
        """Return the motions at N poses.

        - elastic: K without effects and gravity, in base coordinates, (N, b, b)
        - jacobian: of the platform, whose components are those of the pose, (N, k, k)

        Returns (N, n, components), in all n coordinates, motors included.
        """
        rates = np.linalg.inv(jacobian)
        motions = np.zeros((len(jacobian), self._coordinates, rates.shape[-1]))
        motions[:, self._independent] = rates
        # The other coordinates follow without force: so the motion is the one that strains nothing.
        rows = elastic[:, self._dependent]
        forces = rows[..., self._independent] @ rates
        motions[:, self._dependent] = -np.linalg.solve(rows[..., self._dependent], forces)
        return motions
