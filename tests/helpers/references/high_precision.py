"""Modes and their derivatives in 80 digits, for matrices whose entries differ by forty orders of magnitude."""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from typing import Any, NamedTuple

import mpmath
import numpy as np

from pkmodes.core.mechanism.registry import mechanism
from pkmodes.core.system.evaluation import ExtendedSystem
from pkmodes_generated.linear_delta import Parameters, extended

CATALOGUE = mechanism("linear_delta").effects

mp = mpmath.mp.clone()
mp.dps = 80
Number = Any  # mpmath publishes no types


class Exact(NamedTuple):
    """Matrices and modes; shapes are columns, mass-normalised, in the free coordinates."""

    M: Number
    K: Number
    eigenvalues: list[Number]
    shapes: Number

    def values(self) -> np.ndarray:
        return np.array([float(value) for value in self.eigenvalues])

    def rows(self) -> np.ndarray:
        """Shapes as `pkmodes` lists them, of any sign."""
        return np.array(self.shapes.T.tolist(), dtype=float)


def exact_modes(parameters: Parameters, effects: Mapping[str, float], p: np.ndarray) -> Exact:
    """Modes of a robot at a pose: the generated M and K, and the stiffness 1/c of every joint without rounding."""
    system = ExtendedSystem(mechanism("linear_delta"), parameters, effects)
    joints_free = extended.extended_matrices(p, parameters, system.effects)
    M, K_el, K_g = (a[np.ix_(system.free, system.free)] for a in joints_free)
    K = mp.matrix(K_el.tolist()) + mp.matrix(K_g.tolist())
    for i, coordinate in enumerate(extended.COORDINATES[k] for k in system.free):
        for effect in CATALOGUE.values():
            if coordinate in (q.name for q in effect.coordinates):
                compliance = mp.mpf(effects.get(f"{effect.name}.compliance", 0.0))
                K[i, i] += 1 / (
                    compliance + mp.mpf(effects.get(f"{effect.name}.compliance.{coordinate}", 0.0))
                )
    return solved(mp.matrix(M.tolist()), K)


def solved(M: Number, K: Number) -> Exact:
    """Solve K phi = lambda M phi; rows and columns of zeros in M are condensed."""
    with_mass = [i for i in range(M.rows) if M[i, i] != 0]
    without = [i for i in range(M.rows) if M[i, i] == 0]
    mass, stiffness = part(M, with_mass, with_mass), part(K, with_mass, with_mass)
    if without:
        follow = -(part(K, without, without) ** -1) * part(K, without, with_mass)
        stiffness += part(K, with_mass, without) * follow
    inverse = mp.cholesky(mass) ** -1
    standard = inverse * stiffness * inverse.T
    values, vectors = mp.eigsy((standard + standard.T) / 2)
    order = sorted(range(len(with_mass)), key=lambda k: values[k])
    kept = inverse.T * vectors
    shapes = mp.matrix(M.rows, len(with_mass))
    for column, k in enumerate(order):
        for row, i in enumerate(with_mass):
            shapes[i, column] = kept[row, k]
        if without:
            yielded = follow * kept[:, k]
            for row, i in enumerate(without):
                shapes[i, column] = yielded[row]
    return Exact(M, K, [values[k] for k in order], shapes)


def part(matrix: Number, rows: list[int], columns: list[int]) -> Number:
    return mp.matrix([[matrix[i, j] for j in columns] for i in rows])


def exact_derivatives(
    modes: Exact, k: int, by: Sequence[tuple[Number, Number]]
) -> Iterator[tuple[Number, Number]]:
    """Derivatives of a simple eigenvalue and of its shape, by the bordered system of Nelson in all digits.

    For each of some pairs dM and dK; the system is that of the mode, factorised once.
    """
    n, value, phi = modes.M.rows, modes.eigenvalues[k], modes.shapes[:, k]
    momentum = modes.M * phi
    system = mp.matrix(n + 1, n + 1)
    for i in range(n):
        for j in range(n):
            system[i, j] = modes.K[i, j] - value * modes.M[i, j]
        system[i, n] = system[n, i] = momentum[i]
    factors, order = mp.LU_decomp(system)
    for dM, dK in by:
        change = (dK - value * dM) * phi
        rate = (phi.T * change)[0]
        right = mp.matrix(n + 1, 1)
        for i in range(n):
            right[i] = rate * momentum[i] - change[i]
        right[n] = -(phi.T * dM * phi)[0] / 2
        yield rate, mp.U_solve(factors, mp.L_solve(factors, right, order))[:n]
