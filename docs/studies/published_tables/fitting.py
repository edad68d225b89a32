"""Least-squares fit to all printed numbers: frequencies and shapes, each in units of its last digit."""

from __future__ import annotations

from collections.abc import Collection, Mapping, Sequence
from dataclasses import dataclass

import numpy as np
from scipy.optimize import least_squares

import pkmodes
from geometry import Geometry
from printed import HALF_HERTZ, Array, Row


@dataclass(frozen=True)
class Found:
    """A fit: the geometry, standard errors of the fitted values, and the rms residual in half digits."""

    geometry: Geometry
    sigma: Mapping[str, float]
    rms: float


class Tables:
    """Printed rows at points of the grid, for comparison with the model.

    Parameters
    ----------
    declared : Robot
    rows : sequence of Row
    readings : mapping of str to str
        How the x column of each row is read.
    index : mapping of str to int
        Point of the grid of each row.
    shapeless : collection of str
        Rows whose shapes are not compared.
    cut : bool
        Whether the digits of the shapes were truncated (or rounded).
    """

    def __init__(
        self,
        declared: pkmodes.Robot,
        rows: Sequence[Row],
        readings: Mapping[str, str],
        index: Mapping[str, int],
        shapeless: Collection[str] = (),
        cut: bool = True,
    ) -> None:
        self.declared, self.rows, self.readings = declared, tuple(rows), readings
        self.index = np.array([index[row.name] for row in rows])
        self.mode = np.array([row.mode - 1 for row in rows])
        self.frequency = np.array([row.frequency for row in rows])
        self.printed = np.array([row.middle(cut) for row in rows])
        self.half = np.array([0.5 * row.unit for row in rows])
        #: Which components have digits and are compared, (rows, 9).
        self.used = (self.half > 0.0) & np.array([row.name not in shapeless for row in rows])[:, None]

    def predict(self, geometry: Geometry) -> tuple[Array, Array]:
        """Predict frequencies (rows,) and shapes (rows, 9) as printed: with the scale and x unit of each row."""
        frequencies, shapes = geometry.modes(self.declared, self.index)
        pick = np.arange(len(self.rows)), self.mode
        radius = geometry.value("pulley_radius", self.declared)
        pairs = zip(shapes[pick], self.rows, strict=True)
        printed = [as_printed(shape, row, self.readings[row.name], radius) for shape, row in pairs]
        return frequencies[pick], np.array(printed)

    def misses(self, geometry: Geometry) -> tuple[Array, Array]:
        """Return the differences from the printed numbers in half digits: frequencies (rows,), shapes (rows, 9)."""
        frequency, shape = self.predict(geometry)
        components = (shape - self.printed) / np.where(self.used, self.half, np.inf)
        return (frequency - self.frequency) / HALF_HERTZ, components

    def residual(self, geometry: Geometry) -> Array:
        """Return all differences in half digits."""
        frequencies, components = self.misses(geometry)
        return np.nan_to_num(np.concatenate([frequencies, components[self.used]]), nan=1e6)  # out of reach

    def rms(self, geometry: Geometry) -> float:
        """Return the root mean square difference in half digits; exact numbers with digits left off give 0.58."""
        return float(np.sqrt(np.mean(self.residual(geometry) ** 2)))

    def largest_error(self, geometry: Geometry) -> float:
        """Return the largest relative error of the frequencies."""
        return float(np.abs(self.predict(geometry)[0] / self.frequency - 1.0).max())

    def fit(self, start: Geometry, free: Sequence[str]) -> Found:
        """Fit unknowns or declared values.

        Standard errors assume that the digits beyond the last one are uniformly distributed: the standard deviation
        is 1/sqrt(3) half digits.
        """
        first = np.array([start.value(name, self.declared) for name in free])
        # Steps of central differences, and unit of the unknowns: a millionth, or 10 nm for values that start at 0.
        unit = 1e-6 * np.where(first == 0.0, 0.01, np.abs(first))

        def at(x: Array) -> Geometry:
            return start.moved(**dict(zip(free, (first + x * unit).tolist(), strict=True)))

        def jacobian(x: Array) -> Array:
            steps = np.eye(len(free))
            return np.column_stack(
                [(self.residual(at(x + step)) - self.residual(at(x - step))) / 2.0 for step in steps]
            )

        found = least_squares(
            lambda x: self.residual(at(x)), np.zeros(len(free)), jacobian, x_scale="jac", method="lm"
        )
        size = np.linalg.norm(found.jac, axis=0)
        inverse = np.linalg.inv((found.jac / size).T @ (found.jac / size))
        sigma = np.sqrt(np.diagonal(inverse) / 3.0) / size * unit
        geometry = at(found.x)
        return Found(geometry, dict(zip(free, sigma.tolist(), strict=True)), self.rms(geometry))


def as_printed(shape: Array, row: Row, reading: str, radius: float) -> Array:
    """Return a computed shape as a row would print it: the component used for normalisation is +-1."""
    scaled = shape.copy()
    if reading == "x/R_p":
        scaled[:3] /= radius
    largest = int(np.argmax(np.abs(row.shape)))
    return np.asarray(scaled * (row.shape[largest] / scaled[largest]))
