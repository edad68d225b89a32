"""Motions of a robot that move its platform and strain nothing."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from pkmodes.core.mechanism.generated import Generated
from pkmodes.core.system.evaluation import Evaluation

Array = NDArray[np.float64]


def strain_free_motions(system: Evaluation, points: Array) -> Array:
    """Return the motions of `StrainFreeMotions` at N poses, (N, n, components).

    Parameters
    ----------
    system : Evaluation
        With free motors.
    points : ndarray, shape (N, d)
    """
    jacobian = Generated(system.mechanism.model, system.parameters).platform_jacobian(points)
    return StrainFreeMotions(system)(elastic_stiffness(system, points), jacobian)


def elastic_stiffness(system: Evaluation, points: Array) -> Array:
    """Return the stiffness of the transmissions without effects and gravity, (N, b, b), of base coordinates."""
    mechanism = system.mechanism
    model = Generated(mechanism.model, system.parameters)
    if model.has("elastic_hessian"):  # the same, several times faster
        return np.asarray(model.elastic_hessian(points))
    extended, first = mechanism.extended, len(mechanism.coordinates)
    _, elastic, _ = Generated(extended, system.parameters, extended.Effects()).extended_matrices(points)
    return np.asarray(elastic[:, :first, :first])


class StrainFreeMotions:
    """The motions that move the platform by 1 along each direction, or turn it by 1, and strain nothing.

    They are those of rigid links, belts, reducers and joints: released joints do not move, and springs to ground
    count as no strain.  The other components of the platform's motion are 0.

    Parameters
    ----------
    system : Evaluation
        With free motors.
    """

    def __init__(self, system: Evaluation) -> None:
        mechanism = system.mechanism
        names, pose = [q.name for q in mechanism.coordinates], [c.name for c in mechanism.pose]
        self._given = np.array([names.index(name) for name in mechanism.independent])
        self._follows = np.setdiff1d(np.arange(len(names)), self._given)
        self._components = [pose.index(name) for name in mechanism.components]
        self._coordinates = len(system.coordinates)

    def __call__(self, elastic: Array, jacobian: Array) -> Array:
        """Return the motions at N poses.

        Parameters
        ----------
        elastic : ndarray, shape (N, b, b)
            From `elastic_stiffness`.
        jacobian : ndarray, shape (N, d, k)
            Of the platform.

        Returns
        -------
        ndarray, shape (N, n, components)
            In all n coordinates, motors included.
        """
        square = jacobian.shape[-2] == jacobian.shape[-1]
        inverse = np.linalg.inv(jacobian) if square else np.linalg.pinv(jacobian)
        rates = inverse[..., self._components]
        motions = np.zeros((len(jacobian), self._coordinates, rates.shape[-1]))
        motions[:, self._given] = rates
        # The other coordinates follow without force: so the motion is the one that strains nothing.
        followed = elastic[:, self._follows]
        forces = followed[..., self._given] @ rates
        motions[:, self._follows] = -np.linalg.solve(followed[..., self._follows], forces)
        return motions
