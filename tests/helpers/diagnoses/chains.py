"""Chains of masses and springs, assembled here by hand: the truth of tests of any structure."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import dataclass

import numpy as np
from scipy.linalg import eigh

from pkmodes.loop.diagnosis import MatrixStructure, Measurements, Parameter


def chain(masses: np.ndarray, springs: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
    """Return M and K of masses in a row, each on a spring to the one before it, the first one to the ground."""
    K = np.diag(springs + np.append(springs[1:], 0.0))
    K -= np.diag(springs[1:], 1) + np.diag(springs[1:], -1)
    return np.diag(masses), K


def joined(n: int, *floors: int) -> np.ndarray:
    """Return the stiffness of a unit spring between two floors, numbered from 1, or of one to the ground."""
    v = np.zeros(n)
    v[[i - 1 for i in floors]] = (1.0, -1.0)[: len(floors)]
    return np.outer(v, v)


def at(n: int, floor: int) -> np.ndarray:
    """Return a unit mass at a floor, numbered from 1."""
    return joined(n, floor)


@dataclass(frozen=True)
class Frame:
    """A shear frame on the ground: floors of 20 kg on storeys of 400 kN/m, measured under loads on some floor.

    Attributes
    ----------
    loads : tuple of (int, float)
        Of each setup: a floor, numbered from 1, and the mass on it [kg].
    """

    floors: int = 6
    loads: tuple[tuple[int, float], ...] = (
        (1, 0.0),
        (2, 4.0),
        (3, 8.0),
        (4, 12.0),
        (5, 4.0),
        (6, 8.0),
        (1, 12.0),
    )

    @property
    def names(self) -> tuple[str, ...]:
        return tuple(f"floor {i}" for i in range(1, self.floors + 1))

    @property
    def setups(self) -> tuple[str, ...]:
        return tuple(f"S{k}" for k in range(1, len(self.loads) + 1))

    def matrices(self, values: Mapping[str, float], setup: str) -> tuple[np.ndarray, np.ndarray]:
        n = self.floors
        M, K = chain(np.full(n, 20.0 * values["mass"]), np.full(n, 4e5 * values["storey"]))
        floor, load = self.loads[int(setup[1:]) - 1]
        return M + load * at(n, floor), K

    def structure(self, kind: type[MatrixStructure] = MatrixStructure) -> MatrixStructure:
        """Return the model: the masses are known to half a per cent, the storeys to three."""
        parameters = [Parameter("mass", 1.0, sigma=0.005), Parameter("storey", 1.0, sigma=0.03)]
        return kind(parameters, [], self.matrices, channels=self.names, setups=self.setups)

    def measured(
        self, change: Callable[[int], tuple[np.ndarray, np.ndarray]], seed: int = 1, sigma: float = 0.0015
    ) -> Measurements:
        """Return frequencies with errors of a frame whose M and K differ, in each setup, by what `change` returns."""
        rng, pose, frequency = np.random.default_rng(seed), list[str](), list[float]()
        for k, setup in enumerate(self.setups):
            M, K = self.matrices({"mass": 1.002, "storey": 1.02}, setup)
            dM, dK = change(k)
            if len(dM) > len(M):  # a mass of its own
                M, K = (np.pad(one, (0, len(dM) - len(M))) for one in (M, K))
            found = np.sqrt(eigh(K + dK, M + dM, eigvals_only=True)) / (2.0 * np.pi)
            pose += [setup] * len(found)
            frequency += (found * (1.0 + sigma * rng.standard_normal(len(found)))).tolist()
        return Measurements.from_rows(pose, frequency, sigma * np.array(frequency))
