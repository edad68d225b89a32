"""Wirings: what each shape column of a file really measures, with which sign, and how well each fits.

A sensor with three axes has 48 signed orders, 24 of them turned mountings (rotations) and 24 of the other hand, which
only exchanged or reversed cables give; in a plane there are 8.  If some of its axes are not in the file, a column may
also measure one of those.  Shapes have any sign, so wirings that differ by the sign of all columns are the same.

A wrong wiring changes the shapes, and with them the pairing: modes of nearly equal frequency are told apart by their
shapes alone.  So every wiring has its own pairing, and frequencies count as well as shapes.
"""

from __future__ import annotations

import itertools
from collections.abc import Iterator, Sequence
from dataclasses import dataclass, replace

import numpy as np

from pkmodes.diagnosis.fit.fitter import Fitter
from pkmodes.diagnosis.fit.hypothesis import Fit, Hypothesis
from pkmodes.diagnosis.problem import Array, Index, Prediction, Sensor
from pkmodes.measured.measurements import Measurements
from pkmodes.support.mac import channel_motion

#: Numbers in the largest array that is evaluated at once.
AT_ONCE = 2_000_000
#: Number of setups, those with the worst shapes, that show whether another wiring may fit.
WORST = 3


@dataclass(frozen=True)
class Wiring:
    """What the C shape columns of a file measure.

    Attributes
    ----------
    channels : tuple of str
        For each column, the channel of the model that it measures.
    signs : tuple of int
        For each column, 1, or -1 if it measures the opposite direction.
    """

    channels: tuple[str, ...]
    signs: tuple[int, ...]

    def of(self, data: Measurements) -> Measurements:
        """Return the measurements with columns that say what they measure."""
        return replace(data, channels=self.channels, shapes=data.shapes * self.signs)

    @property
    def up_to_sign(self) -> Wiring:
        """The same wiring with the first column of positive sign: shapes do not tell the two apart."""
        return Wiring(self.channels, tuple(sign * self.signs[0] for sign in self.signs))


def as_in_file(columns: Sequence[str]) -> Wiring:
    """Return the wiring in which each column measures what its header says."""
    return Wiring(tuple(columns), (1,) * len(columns))


def wirings(columns: Sequence[str], sensors: Sequence[Sensor]) -> dict[Wiring, list[Wiring]]:
    """Return all wirings that a single mistake gives, except that of the file.

    Parameters
    ----------
    columns : sequence of str
        Channels of the shape columns.
    sensors : sequence of Sensor
        Sensors with several axes.

    Returns
    -------
    dict of Wiring to list of Wiring
        For each wiring, up to the sign of all columns, the mistakes that give it, the simplest first.
    """
    right = as_in_file(columns)
    found: dict[Wiring, list[Wiring]] = {}
    for wiring in (*_reversed(right), *_exchanged(right), *_turned(right, sensors)):
        same = found.setdefault(wiring.up_to_sign, [])
        if wiring not in same:
            same.append(wiring)
    found.pop(right.up_to_sign, None)
    return found


def _reversed(right: Wiring) -> Iterator[Wiring]:
    for i in range(len(right.channels)):
        yield Wiring(right.channels, tuple(-1 if k == i else 1 for k in range(len(right.channels))))


def _exchanged(right: Wiring) -> Iterator[Wiring]:
    for i, k in itertools.combinations(range(len(right.channels)), 2):
        channels = list(right.channels)
        channels[i], channels[k] = channels[k], channels[i]
        yield Wiring(tuple(channels), right.signs)


def _turned(right: Wiring, sensors: Sequence[Sensor]) -> Iterator[Wiring]:
    for sensor in sensors:
        place = [i for i, name in enumerate(right.channels) if name in sensor.channels]
        for order in itertools.permutations(sensor.channels, len(place)):
            for signs in itertools.product((1, -1), repeat=len(place)):
                channels, each = list(right.channels), list(right.signs)
                for i, name, sign in zip(place, order, signs, strict=True):
                    channels[i], each[i] = name, sign
                yield Wiring(tuple(channels), tuple(each))


@dataclass(frozen=True)
class Misfit:
    """Misfit of the measurements with one wiring.

    Attributes
    ----------
    squares : ndarray, shape (3,)
        Whitened sums of squares: of the frequencies, of shapes with stated errors, of the other shapes.
    count : ndarray, shape (3,)
        Numbers of these data.
    least : ndarray, shape (3,)
        Sums of squares of the smallest errors that measurements have; smaller ones count as these.
    difference : float
        Root mean square of the differences of the shapes, relative to the largest component of each.
    """

    squares: Array
    count: Array
    least: Array
    difference: float

    def evidence(self, frequencies: bool = True) -> float:
        """Return the deviance, with errors of the size that the misfit shows, whether they are stated or not.

        Parameters
        ----------
        frequencies : bool, optional
            Whether the frequencies count: not if something else is missing in the model, because modes paired
            wrongly may then seem to fit better.
        """
        some = self.count > 0
        some[0] &= frequencies
        squares = np.maximum(self.squares, self.least)[some]
        return float((self.count[some] * np.log(squares / self.least[some])).sum())

    @property
    def shapes(self) -> float:
        """Sum of squares of the shapes relative to the least one."""
        return float(np.maximum(self.squares, self.least)[1:].sum())

    @property
    def per_value(self) -> tuple[float, float]:
        """Sums of squares per value of the frequencies and of the shapes with stated errors; 0 if there are none."""
        frequency, stated = (self.squares / np.maximum(self.count, 1.0))[:2]
        return float(frequency), float(stated)


class Scale:
    """The data that misfits count, for one set of measurements and excluded rows."""

    def __init__(self, fitter: Fitter, hypothesis: Hypothesis) -> None:
        shapes = fitter.shapes
        self.fitter, self.used = fitter, fitter.used(hypothesis)
        known = self.used & shapes.known
        self.masks = known & shapes.stated, known & ~shapes.stated
        counts = [int(self.used.sum()), *(int(shapes.count[mask].sum()) for mask in self.masks)]
        self.count = np.array(counts, dtype=float)
        smallest = fitter.criteria.shapes.least_scatter / fitter.shape_scatter
        self.least = np.maximum(self.count * [1.0, 1.0, smallest**2], 1e-300)

    def misfit(self, residual: Array) -> Misfit:
        """Return the misfit of unwhitened residuals of all data, (R + R C,)."""
        fitter = self.fitter
        white = residual / fitter.noise.stated
        shape = fitter.shapes.sigma.shape
        each = (white[fitter.shape_rows].reshape(shape) ** 2).sum(axis=1)
        squares = [
            float((white[fitter.frequency_rows][self.used] ** 2).sum()),
            *(float(each[mask].sum()) for mask in self.masks),
        ]
        apart = float((residual[fitter.shape_rows] ** 2).sum())
        difference = float(np.sqrt(apart / max(self.count[1:].sum(), 1.0)))
        return Misfit(np.array(squares), self.count, self.least, difference)


def at_prediction(scale: Scale, prediction: Prediction, wirings: Sequence[Wiring]) -> list[Misfit]:
    """Return the misfit of each wiring with the modes of a model, all evaluated together."""
    fitter = scale.fitter
    motion = channel_motion(fitter.structure.predict(fitter.declared, ()).shapes)
    modes = prediction.shapes.shape[1]
    most = max(AT_ONCE // max(len(fitter.log) * modes * len(fitter.data.channels), 1), 1)
    misfits: list[Misfit] = []
    for some in _parts(wirings, most):
        rows = fitter.rows.tiled(len(some))
        order = np.array([[fitter.structure.channels.index(name) for name in w.channels] for w in some])
        signs = np.array([w.signs for w in some], dtype=float)
        rows.pairer.moves = np.concatenate([motion[:, columns] for columns in order])
        together = _tiled(prediction, fitter.pairer.columns, order, signs)
        used = np.tile(scale.used, len(some))
        pairing = rows.pairer.pair(together, used, compare=False)
        misfits += [scale.misfit(each) for each in rows.of_each(rows.residual(together, pairing, used))]
    return misfits


def promising(fitter: Fitter, fit: Fit, wirings: Sequence[Wiring], gain: float) -> bool:
    """Return whether some other wiring fits the shapes better where they fit worst.

    At these few setups a wrong wiring is plain, and no wiring helps if there is only noise: most files need no more.
    """
    shapes, setups = fitter.shapes, len(fitter.data.labels)
    if setups <= 2 * WORST:
        return True
    squares = (fit.white[fitter.shape_rows].reshape(shapes.sigma.shape) ** 2).sum(axis=1)
    sums = np.bincount(fitter.data.pose, squares, setups) / np.maximum(
        np.bincount(fitter.data.pose, shapes.count, setups), 1.0
    )
    some = np.sort(np.argsort(sums)[-WORST:])
    part = Fitter(
        fitter.structure.subset(some.tolist()),
        fitter.data.at(some.tolist()),
        fitter.criteria,
        fitter.shape_scatter,
        parameters=fitter.parameters,
    )
    scale, every = Scale(part, Hypothesis()), [as_in_file(fitter.data.channels), *wirings]
    predictions = [part.structure.predict(part.declared, ()), _at(fit.prediction, some)]
    found = [at_prediction(scale, p, every) for p in predictions if np.isfinite(p.eigenvalues).all()]
    least = [min(each[k].shapes for each in found) for k in range(len(every))] if found else [np.inf]
    return min(least[1:], default=np.inf) * gain < least[0]


def refitted(fitter: Fitter, wiring: Wiring, hypothesis: Hypothesis, start: Array | None) -> Fit | None:
    """Return the fit of a hypothesis to the measurements with another wiring."""
    data = wiring.of(fitter.data)
    again = Fitter(
        fitter.structure, data, fitter.criteria, fitter.shape_scatter, parameters=fitter.parameters
    )
    return again.fit(hypothesis, start)


def misfits(
    fitter: Fitter, fit: Fit, wirings: Sequence[Wiring], refit: int, near: float
) -> dict[Wiring, Misfit]:
    """Return the misfit of the file and of other wirings, each with the values that suit it best.

    These are the declared ones, those of the fit, and those refitted with the best few wirings.

    Parameters
    ----------
    wirings : sequence of Wiring
        Other wirings.
    refit : int
        Number of wirings, the best ones, with which parameters are refitted.
    near : float
        Only wirings whose evidence differs from the best one by less than this.
    """
    scale, own = Scale(fitter, fit.hypothesis), as_in_file(fitter.data.channels)
    every = [own, *wirings]
    found: dict[Wiring, Misfit] = {}

    def keep(some: Sequence[Wiring], misfits: Sequence[Misfit]) -> None:
        for wiring, misfit in zip(some, misfits, strict=True):
            if wiring not in found or misfit.evidence() < found[wiring].evidence():
                found[wiring] = misfit

    keep([own], [scale.misfit(fit.residual)])
    for prediction in (fitter.structure.predict(fitter.declared, ()), fit.prediction):
        if np.isfinite(prediction.eigenvalues).all():
            keep(every, at_prediction(scale, prediction, every))
    best = sorted((w for w in found if w != own), key=lambda wiring: found[wiring].evidence())
    least = found[best[0]].evidence()
    hypotheses = [Hypothesis(excluded=fit.hypothesis.excluded)]
    if fit.causes:
        hypotheses.append(fit.hypothesis)
    again: list[tuple[float, Fit]] = []
    for wiring in [w for w in best if found[w].evidence() < least + near][:refit]:
        for hypothesis in hypotheses:
            other = refitted(fitter, wiring, hypothesis, fit.values if hypothesis.causes else None)
            if other is not None:
                misfit = scale.misfit(other.residual)
                keep([wiring], [misfit])
                again.append((misfit.evidence(), other))
    if again:  # the parameters are the same with whatever wiring
        keep(every, at_prediction(scale, min(again, key=lambda one: one[0])[1].prediction, every))
    return found


def _tiled(prediction: Prediction, columns: Index, order: Index, signs: Array) -> Prediction:
    """Return the prediction once for each wiring, with what its columns measure in the place of the file's."""
    count = len(order)
    shapes = np.tile(prediction.shapes, (count, 1, 1))
    setups = len(prediction.shapes)
    for k in range(count):
        part = slice(k * setups, (k + 1) * setups)
        shapes[part][..., columns] = prediction.shapes[..., order[k]] * signs[k]
    eigenvalues = np.tile(prediction.eigenvalues, (count, 1))
    return Prediction(eigenvalues, np.zeros((*eigenvalues.shape, 0)), shapes, prediction.rigid)


def _at(prediction: Prediction, setups: Index) -> Prediction:
    """Return the prediction at some setups, without derivatives."""
    eigenvalues = prediction.eigenvalues[setups]
    return Prediction(
        eigenvalues, np.zeros((*eigenvalues.shape, 0)), prediction.shapes[setups], prediction.rigid
    )


def _parts(wirings: Sequence[Wiring], most: int) -> Iterator[Sequence[Wiring]]:
    for start in range(0, len(wirings), most):
        yield wirings[start : start + most]
