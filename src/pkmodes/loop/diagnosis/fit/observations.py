"""Measurements and the predictions of a structure: the data of a fit, their errors, and which rows count.

A row is a measured mode.  Its data are the components of each measured *quantity*: one of its frequency, one of its
shape for each channel.  All data are in one vector, quantity by quantity: with R rows of n components each, those of
a quantity are R n numbers, row by row.  Fits, scores, limits and verdicts use only this vector, so adding a quantity
takes a class with the members of `ComparedQuantity` and an entry in `QUANTITIES`.
"""

from __future__ import annotations

import copy
from collections.abc import Callable, Iterator, Mapping, Sequence
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from pkmodes.loop.diagnosis.criteria import Criteria
from pkmodes.loop.diagnosis.fit.frequencies import FrequencyRows
from pkmodes.loop.diagnosis.fit.noise import Noise
from pkmodes.loop.diagnosis.fit.quantity import ComparedQuantity, Mask
from pkmodes.loop.diagnosis.fit.shapes import ShapeRows
from pkmodes.loop.diagnosis.match.pairing import Pairer, Pairing
from pkmodes.loop.diagnosis.problem import Array, Prediction, Structure
from pkmodes.loop.measured.measurements import Measurements
from pkmodes.loop.measured.quantities import FREQUENCY


class ObservationInput(NamedTuple):
    """Arguments from which the data of a quantity are made.

    - shape_scatter: standard deviation of shape components for which none is stated, relative to the largest
      component of the row
    """

    data: Measurements
    structure: Structure
    pairer: Pairer
    shape_scatter: float
    criteria: Criteria


def shape_rows(measured: ObservationInput) -> ShapeRows:
    """Return the shapes of measured modes."""
    data, structure, pairer, shape_scatter, criteria = measured
    units = [structure.channel_units[i] for i in pairer.columns]
    return ShapeRows(data, pairer.columns, units, pairer.motion, shape_scatter, criteria)


SHAPE = "shape"
#: Quantities of a measured mode in addition to its frequency.
QUANTITIES: dict[str, Callable[[ObservationInput], ComparedQuantity]] = {SHAPE: shape_rows}


class EvaluatedSet(NamedTuple):
    """Residuals and derivatives for one of several sets of parameter values, and the prediction.

    - set_index: index of the set of values that was evaluated
    - residual, rates: (D,) and (D, T)
    """

    set_index: int
    residual: Array
    rates: Array
    prediction: Prediction


class Observations:
    """Measured modes at the setups of a structure.

    - reference: prediction of the declared model; the motion of its channels weights the channels of the shapes
    - shape_scatter: see `ObservationInput`

    Its attributes:
    - log_frequencies, sigma: ln f and its stated standard deviation, (R,)
    - size: number D of data
    - frequency_slice: the data that are frequencies
    - other_quantities: those other than the frequencies, by name
    """

    def __init__(
        self,
        data: Measurements,
        structure: Structure,
        reference: Prediction,
        shape_scatter: float,
        criteria: Criteria,
    ) -> None:
        self.log_frequencies = FREQUENCY.transformed(data)
        pairer = Pairer(data, structure.channels, reference, criteria)
        self.sigma = FREQUENCY.transformed_sigma(data)
        self.frequencies = FrequencyRows(pairer, self.sigma[:, None])
        measured = ObservationInput(data, structure, pairer, shape_scatter, criteria)
        self.other_quantities: Mapping[str, ComparedQuantity] = {
            name: make(measured) for name, make in QUANTITIES.items()
        }
        self._quantities: tuple[ComparedQuantity, ...] = (self.frequencies, *self.other_quantities.values())
        sizes = [quantity.sigma.size for quantity in self._quantities]
        ends = np.cumsum(sizes).tolist()
        self.frequency_slice, *ranges = (
            slice(end - size, end) for size, end in zip(sizes, ends, strict=True)
        )
        self._slices = dict(zip(self.other_quantities, ranges, strict=True))
        self.size: int = ends[-1]
        self.shape_rates = any(quantity.shape_rates for quantity in self._quantities)
        self.noise = Noise(data, self._quantities, criteria.fits.most_shared)
        self._copies = 1

    @property
    def pairer(self) -> Pairer:
        """The pairer of these rows with modes of a model."""
        return self.frequencies.pairer

    @property
    def shapes(self) -> ShapeRows:
        """The measured shapes."""
        quantity = self.other_quantities[SHAPE]
        assert isinstance(quantity, ShapeRows)
        return quantity

    # Which rows count --------------------------------------------------------------------------------------

    @property
    def all_rows(self) -> Mask:
        """A mask of all rows, (R,)."""
        return np.ones(len(self.log_frequencies), dtype=bool)

    def degrees_of_freedom(self, used_row_mask: Mask) -> int:
        """Return the degrees of freedom of the data of some rows."""
        return sum(int(quantity.count[used_row_mask].sum()) for quantity in self._quantities)

    def mask_of_stated(self, used_row_mask: Mask) -> tuple[Mask, int]:
        """Return the data of some rows with a stated error, as a mask (D,), and their degrees of freedom."""
        rows = [used_row_mask & quantity.known & quantity.stated for quantity in self._quantities]
        masked = list(zip(self._quantities, rows, strict=True))
        mask = np.concatenate([np.repeat(row_mask, quantity.sigma.shape[1]) for quantity, row_mask in masked])
        return mask, sum(int(quantity.count[row_mask].sum()) for quantity, row_mask in masked)

    def data_mask(self, used_row_mask: Mask) -> Mask:
        """Return a mask of the data of some rows, (D,)."""
        return np.concatenate(
            [np.repeat(used_row_mask, quantity.sigma.shape[1]) for quantity in self._quantities]
        )

    def data_indices(self, rows: NDArray[np.intp]) -> NDArray[np.intp]:
        """Return the indices of the data of some rows."""
        indices = np.arange(self.size)
        parts = [self.frequency_slice, *self._slices.values()]
        return np.concatenate(
            [indices[part].reshape(len(self.log_frequencies), -1)[rows].ravel() for part in parts]
        )

    def data_indices_by_setup(self) -> list[NDArray[np.intp]]:
        """Return the indices of the data of each setup."""
        return [self.data_indices(rows) for rows in self.noise.rows]

    def data_slice(self, name: str) -> slice:
        """Return the slice of the data of a quantity other than the frequencies."""
        return self._slices[name]

    def by_row(self, name: str, data: Array) -> Array:
        """Return the part of a data vector that belongs to a quantity, as (R, n); the vector may end with priors."""
        return np.asarray(data[self._slices[name]].reshape(self.other_quantities[name].sigma.shape))

    # Comparison with predictions ---------------------------------------------------------------------------

    def residual(self, prediction: Prediction, pairing: Pairing, used_row_mask: Mask) -> Array:
        """Return measured minus model, (D,); 0 for rows that are not used."""
        return np.concatenate(
            [quantity.residual(prediction, pairing, used_row_mask).ravel() for quantity in self._quantities]
        )

    def rates(self, prediction: Prediction, pairing: Pairing, used_row_mask: Mask) -> Array:
        """Return the derivatives of the predictions with respect to the requested parameters, (D, T)."""
        by_quantity = [
            quantity.rates(prediction, pairing, used_row_mask)
            for quantity in self._quantities
            if quantity.sigma.size
        ]
        rates = np.vstack(
            [rate.reshape(rate.shape[0] * rate.shape[1], rate.shape[2]) for rate in by_quantity]
        )
        # A step may lead to a mode at 0 Hz, whose logarithm has no derivative.
        return np.asarray(np.where(np.isfinite(rates), rates, 0.0))

    def tiled(self, count: int) -> Observations:
        """Return `count` copies, for predictions of `count` times the setups, the first copy first.

        The copy is shallow: `noise`, `size` and the slices still describe one copy.
        """
        copies = copy.copy(self)
        copies.frequencies, copies._copies = self.frequencies.tiled(count), count
        copies.other_quantities = {
            name: quantity.tiled(count) for name, quantity in self.other_quantities.items()
        }
        copies._quantities = (copies.frequencies, *copies.other_quantities.values())
        return copies

    def split_copies(self, values: Array) -> Array:
        """Reshape the data of all copies, (B D, ...), to (B, D, ...)."""
        parts = np.split(values, np.cumsum([quantity.sigma.size for quantity in self._quantities])[:-1])
        reshaped = [part.reshape(self._copies, len(part) // self._copies, *part.shape[1:]) for part in parts]
        return np.concatenate(reshaped, axis=1)

    def evaluate_many(
        self,
        structure: Structure,
        values: Array,
        free_parameters: Sequence[tuple[int, ...]],
        used_row_masks: Sequence[Mask],
    ) -> Iterator[EvaluatedSet]:
        """Yield residuals and derivatives for several sets of parameter values, evaluated together.

        Sets at which the structure cannot be evaluated are left out.

        - values: (B, P)
        - free_parameters: indices of the parameters with respect to which each set is differentiated
        - used_row_masks: used rows of each set
        """
        if not len(values):
            return
        shape_rates = self.shape_rates and any(free_parameters)
        for batch in structure.predict_many(values, free_parameters, shape_rates=shape_rates):
            if not np.isfinite(batch.prediction.eigenvalues).all():
                continue
            copies, used_row_mask = (
                self.tiled(len(batch.sets)),
                np.concatenate([used_row_masks[k] for k in batch.sets]),
            )
            pairing = copies.pairer.pair(batch.prediction, used_row_mask, compare=False)
            residuals = copies.split_copies(copies.residual(batch.prediction, pairing, used_row_mask))
            rates = np.zeros((*residuals.shape, 0))
            if any(free_parameters):
                rates = copies.split_copies(copies.rates(batch.prediction, pairing, used_row_mask))
            prediction_of_all = batch.prediction
            setup_count = len(prediction_of_all.eigenvalues) // len(batch.sets)
            for k, set_index in enumerate(batch.sets.tolist()):
                setups_of_set = slice(k * setup_count, (k + 1) * setup_count)
                prediction = Prediction(
                    prediction_of_all.eigenvalues[setups_of_set],
                    prediction_of_all.rates[setups_of_set],
                    prediction_of_all.shapes[setups_of_set],
                    prediction_of_all.rigid,
                )
                yield EvaluatedSet(
                    set_index, residuals[k], rates[k, :, : len(free_parameters[set_index])], prediction
                )
