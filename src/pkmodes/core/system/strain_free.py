"""Motions of a robot that move its platform and strain nothing."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from pkmodes.core.mechanism.generated import Generated
from pkmodes.core.system.evaluation import Evaluation

Array = NDArray[np.float64]


def strain_free_motions(system: Evaluation, points: Array) -> Array:
    """Return the motions that move the platform by 1 along each direction, or turn it by 1, and strain nothing.

    They are those of rigid links, belts, reducers and joints: released joints do not move, and springs to ground
    count as no strain.  The other components of the platform's motion are 0.

    Parameters
    ----------
    system : Evaluation
        With free motors.
    points : ndarray, shape (N, d)

    Returns
    -------
    ndarray, shape (N, n, components)
        In all n coordinates, motors included.
    """
    mechanism, extended = system.mechanism, system.mechanism.extended
    names, pose = [q.name for q in mechanism.coordinates], [c.name for c in mechanism.pose]
    model = Generated(mechanism.model, system.parameters)
    if model.has("elastic_hessian"):  # the same, several times faster
        elastic = model.elastic_hessian(points)
    else:
        _, elastic, _ = Generated(extended, system.parameters, extended.Effects()).extended_matrices(points)
    jacobian = model.platform_jacobian(points)
    rates = np.linalg.pinv(jacobian)[..., [pose.index(name) for name in mechanism.components]]
    given = [names.index(name) for name in mechanism.independent]
    follows = np.setdiff1d(np.arange(len(names)), given)
    motions = np.zeros((len(points), len(system.coordinates), rates.shape[-1]))
    motions[:, given] = rates
    # The other coordinates follow without force: so the motion is the one that strains nothing.
    forces = elastic[:, follows[:, None], given] @ rates
    motions[:, follows] = -np.linalg.solve(elastic[:, follows[:, None], follows], forces)
    return motions
