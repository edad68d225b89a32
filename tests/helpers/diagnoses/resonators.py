"""A frame on whose floors a mass may hang on a spring of its own, for terms that add a mode."""

from __future__ import annotations

from collections.abc import Sequence
from functools import cached_property

import numpy as np

from helpers.diagnoses.chains import Frame, at
from pkmodes.loop.diagnosis import MatrixStructure
from pkmodes.loop.diagnosis.problem import Batch, Candidate, Parameter, Prediction, predict_one_by_one

#: Pairs of mass and frequency from which a resonator is fitted.
STARTS = tuple((mass, f) for mass in (0.2, 1.0) for f in np.geomspace(5.0, 45.0, 12).tolist())


class Resonant:
    """The frame, with resonators as its terms; its own parameters come first."""

    def __init__(self, frame: Frame, setups: Sequence[int] | None = None, *, extended: bool = False) -> None:
        self.frame, self.extended = frame, extended
        whole = frame.structure()
        self.own = whole if setups is None else whole.subset(setups)
        self.labels, self.channels, self.channel_units = self.own.setups, whole.channels, whole.channel_units
        self.candidates: tuple[Candidate, ...] = ()
        self.parameters: tuple[Parameter, ...] = whole.parameters
        for floor in frame.names if extended else ():
            term = f"resonator:{floor}"
            names = (f"{term}.mass", f"{term}.frequency")
            self.parameters += (
                Parameter(names[0], 0.0, "kg", lower=0.0),
                Parameter(names[1], 20.0, "Hz", lower=2.0, upper=100.0),
            )
            sentence = f"a mass on a spring of its own at {floor}"
            self.candidates += (Candidate(term, names, sentence, True, form="resonator", starts=STARTS),)

    def with_terms(self) -> Resonant:
        setups = [self.frame.setups.index(label) for label in self.labels]
        return Resonant(self.frame, setups, extended=True)

    def subset(self, setups: Sequence[int]) -> Resonant:
        places = [self.frame.setups.index(self.labels[i]) for i in setups]
        return Resonant(self.frame, places, extended=self.extended)

    @cached_property
    def hung(self) -> list[MatrixStructure]:
        """The frame with a resonator of mass and frequency at each floor."""

        def at_floor(k: int) -> MatrixStructure:
            def matrices(values: dict[str, float], setup: str) -> tuple[np.ndarray, np.ndarray]:
                M, K = (np.pad(one, (0, 1)) for one in self.frame.matrices(values, setup))
                M[-1, -1] = values["m"]
                v = np.zeros(len(M))
                v[[k, -1]] = 1.0, -1.0
                return M, K + values["m"] * (2.0 * np.pi * values["f"]) ** 2 * np.outer(v, v)

            more = Parameter("m", 0.1, lower=1e-9), Parameter("f", 20.0, lower=1.0)
            return MatrixStructure(
                [*self.own.parameters, *more],
                [],
                matrices,
                channels=self.channels,
                coordinates=(*self.channels, "mass"),
                setups=self.labels,
            )

        return [at_floor(k) for k in range(self.frame.floors)]

    def predict(self, values: np.ndarray, by: Sequence[int], *, shape_rates: bool = False) -> Prediction:
        own = len(self.own.parameters)
        masses = values[own::2]
        some = np.flatnonzero(masses > 1e-9)
        if len(some):
            (k,) = some
            place = {**{i: i for i in range(own)}, own + 2 * k: own, own + 2 * k + 1: own + 1}
            there = np.append(values[:own], values[own + 2 * k : own + 2 * k + 2])
            found = self.hung[k].predict(there, [place[i] for i in by if i in place])
            rates = np.zeros((*found.eigenvalues.shape, len(by)))
            rates[..., [t for t, i in enumerate(by) if i in place]] = found.rates
            return Prediction(found.eigenvalues, rates, found.shapes)
        found = self.own.predict(values[:own], [i for i in by if i < own])
        rates = np.zeros((*found.eigenvalues.shape, len(by)))
        rates[..., [t for t, i in enumerate(by) if i < own]] = found.rates
        for t, i in enumerate(by):
            if i >= own and (i - own) % 2 == 0:  # a small mass acts as m w^2 / (w^2 - lambda)
                square = (2.0 * np.pi * values[i + 1]) ** 2
                size = found.shapes[..., (i - own) // 2] ** 2
                rates[..., t] = -found.eigenvalues * size * square / (square - found.eigenvalues)
        return Prediction(found.eigenvalues, rates, found.shapes)

    def predict_many(
        self, values: np.ndarray, by: Sequence[Sequence[int]], *, shape_rates: bool = False
    ) -> list[Batch]:
        return predict_one_by_one(self, values, by, shape_rates=shape_rates)

    def position_rates(self, values: np.ndarray, *, shape_rates: bool = False) -> None:
        return None

    def elsewhere(self, count: int) -> None:
        return None


def hanging(frame: Frame, floor: int, mass: float, frequency: float) -> tuple[np.ndarray, np.ndarray]:
    """Return what a resonator adds to M and K of a frame, with its own coordinate last."""
    n = frame.floors + 1
    v = np.zeros(n)
    v[[floor - 1, -1]] = 1.0, -1.0
    return mass * at(n, n), mass * (2.0 * np.pi * frequency) ** 2 * np.outer(v, v)
