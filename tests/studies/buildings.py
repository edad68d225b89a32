"""Storey frames as specimens: the declared model, the true modes, and the model that is diagnosed.

The model is a chain of masses and springs, as in `examples/lumped_structure.py`; MuJoCo gives the true modes.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field

import numpy as np

from pkmodes.loop.diagnosis import Candidate, MatrixStructure, Parameter
from pkmodes_rig import TrueModes, channels, storey_modes

#: Declared mass of a floor and stiffness of a storey, and relative uncertainty of the floors' common mass.
MASS, STIFFNESS, MASS_SIGMA = 20.0, 4.0e5, 0.005


@dataclass(frozen=True)
class Building:
    """A storey frame fixed to the ground.

    Attributes
    ----------
    storeys : int
    prior : float
        Relative standard deviation of the stiffness common to all storeys.
    taper : float
        Fraction by which each storey is declared softer than the one below.
    loads : tuple of float
        Mass on the roof in each setup [kg].
    values : mapping
        Deviations from the declaration, by candidate: the relative change of ``storey i``, or the mass in kg
        added to ``mass i``.
    outside : mapping
        Causes outside the candidates: stiffness [N/m] of a ``brace`` from the ground to the second floor, or
        mass [kg] of an ``absorber`` on the roof.
    """

    storeys: int
    prior: float = 0.05
    taper: float = 0.0
    loads: tuple[float, ...] = (0.0,)
    values: Mapping[str, float] = field(default_factory=dict)
    outside: Mapping[str, float] = field(default_factory=dict)

    @property
    def machine(self) -> str:
        """Name of the specimen in tables."""
        return f"frame of {self.storeys} storeys"

    @property
    def sizes(self) -> Mapping[str, float]:
        """True values of all that differs from the declaration and can be named."""
        return self.values

    @property
    def channels(self) -> tuple[str, ...]:
        """Channels at which its shape can be measured."""
        return channels(self.storeys)

    @property
    def setups(self) -> tuple[str, ...]:
        """Labels of the setups in files."""
        return tuple(f"P{i + 1}" for i in range(len(self.loads)))

    def modes(self, rng: np.random.Generator) -> list[TrueModes]:
        """Return the true modes in each setup, with mass and stiffness drawn from their priors."""
        mass = MASS * (1.0 + MASS_SIGMA * rng.standard_normal())
        stiffness = STIFFNESS * (1.0 + self.prior * np.clip(rng.standard_normal(), -2.5, 2.5))
        return [self._modes(mass, stiffness, self.values, self.outside, load) for load in self.loads]

    def declared(self) -> TrueModes:
        """Return the modes of the declared frame."""
        return self._modes(MASS, STIFFNESS, {}, {}, 0.0)

    def _modes(
        self,
        mass: float,
        stiffness: float,
        values: Mapping[str, float],
        outside: Mapping[str, float],
        load: float,
    ) -> TrueModes:
        floors = [mass + values.get(f"mass {i}", 0.0) for i in self._numbers]
        floors[-1] += load
        springs = [stiffness * self._part(i) * (1.0 + values.get(f"storey {i}", 0.0)) for i in self._numbers]
        braces = {(0, 2): outside["brace"]} if "brace" in outside else {}
        absorbers = {}
        if "absorber" in outside:  # tuned between the first two modes
            absorbers = {self.storeys: (outside["absorber"], outside["absorber"] * (2 * np.pi * 14.0) ** 2)}
        return storey_modes(floors, springs, braces=braces, absorbers=absorbers)

    def structure(self) -> MatrixStructure:
        """Return the declared model with its candidates."""
        storeys = [Parameter(f"storey {i}", 0.0, "1", lower=-0.9, upper=3.0) for i in self._numbers]
        masses = [Parameter(f"mass {i}", 0.0, "kg", lower=0.0) for i in self._numbers]
        return MatrixStructure(
            [
                Parameter("mass", MASS, "kg", sigma=MASS_SIGMA * MASS),
                Parameter("stiffness", STIFFNESS, "N/m", sigma=self.prior * STIFFNESS),
                *storeys,
                *masses,
            ],
            [Candidate(p.name, (p.name,), f"{p.name} is not as declared") for p in (*storeys, *masses)],
            self._matrices,
            channels=self.channels,
            setups=self.setups,
        )

    def _matrices(self, values: Mapping[str, float], setup: str) -> tuple[np.ndarray, np.ndarray]:
        M = np.diag([values["mass"] + values[f"mass {i}"] for i in self._numbers])
        M[-1, -1] += self.loads[self.setups.index(setup)]
        k = np.array([self._part(i) * (1.0 + values[f"storey {i}"]) for i in self._numbers])
        k = values["stiffness"] * k
        return M, np.diag(k + np.append(k[1:], 0.0)) - np.diag(k[1:], 1) - np.diag(k[1:], -1)

    @property
    def _numbers(self) -> range:
        return range(1, self.storeys + 1)

    def _part(self, storey: int) -> float:
        return (1.0 - self.taper) ** (storey - 1)
