"""What a picture shows: the tool, and each belt from its clamp to a pulley at -l_i that follows the tool sideways."""

from __future__ import annotations

import numpy as np

import planar_pair
from planar_pair import extended


def drawing_points(p, parameters):
    x, y = np.moveaxis(np.asarray(p), -1, 0)
    first, second = (np.broadcast_to(-length, x.shape) for length in parameters.length)
    zero = np.zeros_like(x)
    tool = np.stack([x, y, zero], axis=-1)
    pulleys = np.stack([first, y, zero], axis=-1), np.stack([x, second, zero], axis=-1)
    return np.stack([tool, pulleys[0], tool, pulleys[1], tool], axis=-2)


def drawing_motion(p, parameters):
    """x, y, theta_1, theta_2, eps_1, eps_2; tool, pulley 1, clamp 1, pulley 2, clamp 2."""
    J = np.zeros((5, 3, 6))
    J[:, [0, 1], [0, 1]] = 1.0
    J[1, 0, 0] = J[3, 1, 1] = 0.0
    J[2, 0, 4] = J[4, 1, 5] = 1.0
    return planar_pair.filled(np.shape(p)[:-1], J)


def springs(p, parameters, effects):
    k = planar_pair.belts(p, parameters)
    cable = np.broadcast_to(effects.cable_stiffness_stiffness, k.shape)
    g = np.vstack([extended.strain(parameters), np.eye(2, 6)])
    return np.concatenate([k, cable], axis=-1), planar_pair.filled(np.shape(p)[:-1], g)
