"""A damped machine in all its coordinates together, where `pkmodes` works in modal coordinates: modes and poles."""

from __future__ import annotations

import numpy as np
from scipy.linalg import eig, eigh

import pkmodes
from helpers.references.damping_by_hand import friction_by_hand, loss_by_hand
from helpers.references.motors_by_hand import followers


def whole_modes(
    M: np.ndarray, K: np.ndarray, T: np.ndarray, rigid: int
) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
    """Omega and shapes of the vibrations in all coordinates, and all coordinates per unit of those with inertia."""
    M, K = T.T @ M @ T, T.T @ K @ T
    heavy = np.diag(M) > 1e-12 * np.median(np.diag(M))
    follow = np.zeros((len(M), heavy.sum()))
    follow[heavy] = np.eye(heavy.sum())
    if not heavy.all():
        follow[~heavy] = -np.linalg.solve(K[np.ix_(~heavy, ~heavy)], K[np.ix_(~heavy, heavy)])
    values, vectors = eigh(follow.T @ K @ follow, follow.T @ M @ follow)
    T = T @ follow
    return np.sqrt(np.abs(values[rigid:])), T @ vectors[:, rigid:], T


def companion_poles(M: np.ndarray, C: np.ndarray, K: np.ndarray) -> np.ndarray:
    """Roots of det(K + s C + s^2 M) from a pencil of twice the size, scaled to even sizes."""
    n, d = len(M), 1 / np.sqrt(np.diag(M))
    M, C, K = (a * np.outer(d, d) for a in (M, C, K))
    scale = np.sqrt(np.abs(np.diag(K)).max())
    one, none = np.eye(n), np.zeros((n, n))
    A = np.block([[none, one], [-K / scale**2, -C / scale]])
    return eig(A, np.block([[one, none], [none, M]]), right=False) * scale


def full_damping(model: pkmodes.Model, p: np.ndarray, drives: str) -> tuple[np.ndarray, ...]:
    """M, C, K of those coordinates that have inertia, with C_m, and with K'' as the viscous ratio of its mode."""
    M, K = model.matrices(p)
    omega, phi, T = whole_modes(M, K, followers(model, drives)[0], model.modes(p, drives=drives).rigid_modes)
    of_loss = np.einsum("ai,ab,bi->i", phi, loss_by_hand(model, p), phi)
    rates = 2 * model.robot.damping_ratio * omega + of_loss / omega
    C = friction_by_hand(model) + M @ phi @ np.diag(rates) @ phi.T @ M
    return tuple(T.T @ a @ T for a in (M, C, K))
