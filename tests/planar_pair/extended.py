"""The same with effects: a payload, a cable to ground, and clamps that yield by eps_i, massless."""

from __future__ import annotations

from typing import Any, NamedTuple

import numpy as np

import planar_pair

COORDINATES = (*planar_pair.COORDINATES, "eps_1", "eps_2")
COORDINATE_UNITS = (*planar_pair.COORDINATE_UNITS, "m", "m")
TOOL = ((0, 0), (1, 1))
BELTS = tuple(tuple((a, b) for a in (i, i + 2, i + 4) for b in (i, i + 2, i + 4) if a <= b) for i in (0, 1))
VALUE_SENSITIVITIES = (
    ("mass", (), TOOL, ()),
    ("stiffness", (0,), (), BELTS[0]),
    ("stiffness", (1,), (), BELTS[1]),
    ("payload_mass", (), TOOL, ()),
    ("cable_stiffness_stiffness", (), (), TOOL),
)
GEOMETRY_SENSITIVITIES = ()


class Effects(NamedTuple):
    """Parameters of the effects."""

    payload_mass: Any = 0.0
    cable_stiffness_stiffness: Any = 0.0
    clamp_compliance_compliance: Any = 0.0


def strain(parameters):
    return np.hstack([planar_pair.strain(parameters), np.eye(2)])


def extended_matrices(p, parameters, effects):
    batch = np.shape(p)[:-1]
    M = np.zeros((6, 6))
    M[:4, :4] = planar_pair.mass_matrix(np.zeros(2), parameters)
    M[[0, 1], [0, 1]] += effects.payload_mass
    B = strain(parameters)
    K = B.T @ (planar_pair.belts(p, parameters)[..., None] * B)
    K[..., [0, 1], [0, 1]] += effects.cable_stiffness_stiffness
    return planar_pair.filled(batch, M), K, np.zeros((*batch, 6, 6))


def extended_platform_motion(p, parameters):
    return planar_pair.filled(np.shape(p)[:-1], np.eye(2, 6))


def motor_motion():
    return np.eye(2, 6, 2)


def joint_stiffness(effects):
    c = np.full(2, effects.clamp_compliance_compliance, dtype=float)
    return 1.0 / c, -1.0 / c**2


def extended_static_equilibrium(p, parameters, effects):
    loaded = parameters._replace(mass=parameters.mass + effects.payload_mass)
    return planar_pair.static_equilibrium(p, loaded)


def value_sensitivities(p, parameters, effects):
    batch = np.shape(p)[:-1]
    B = strain(parameters)
    by_belt = [np.outer(B[i], B[i]) for i in (0, 1)]
    listed = [[by_belt[i][place] for place in BELTS[i]] for i in (0, 1)]
    rates = 1.0 / (parameters.length + np.asarray(p))
    K = [np.multiply.outer(rates[..., i], listed[i]) for i in (0, 1)]
    return np.ones((*batch, 4)), np.concatenate([*K, np.ones((*batch, 2))], axis=-1)


def geometry_sensitivities(p, parameters, effects):
    batch = np.shape(p)[:-1]
    return np.zeros((*batch, 0)), np.zeros((*batch, 0))
