"""Mistakes of an experimenter that measurements show: another unit, exchanged sensors, shapes that are all alike."""

from __future__ import annotations

import itertools
from collections.abc import Iterator
from dataclasses import replace

import numpy as np

from pkmodes.diagnosis.fit.fitter import Fitter
from pkmodes.diagnosis.fit.hypothesis import Fit
from pkmodes.diagnosis.match.pairing import Pairer, Pairing
from pkmodes.diagnosis.problem import Array, Prediction
from pkmodes.measured.measurements import Measurements

#: How many times too large frequencies are if they are in another unit than Hz.
UNITS = {"rad/s": 2.0 * np.pi, "1/min": 60.0, "mHz": 1e3, "kHz": 1e-3, "degrees/s": 360.0}
UNITS |= {f"{name}, converted the wrong way": 1.0 / UNITS[name] for name in ("rad/s", "1/min")}


def other_unit(fitter: Fitter) -> str:
    """A sentence where all frequencies seem to be in another unit; empty where they are not."""
    declared = fitter.structure.predict(fitter.declared, ())
    if not np.isfinite(declared.eigenvalues).all():
        return ""
    c, here = fitter.criteria, _usual(fitter, declared, 1.0)
    found = {name: _usual(fitter, declared, factor) for name, factor in UNITS.items()}
    name = min(found, key=found.__getitem__)
    if found[name] > c.unit_difference or found[name] * c.unit_gain > here:
        return ""
    return (
        f"the frequencies look like {name}: divided by {UNITS[name]:.4g} they agree with the declared model to "
        f"{100 * found[name]:.2g} %; write the unit into the header, such as frequency [rad/s]"
    )


def _usual(fitter: Fitter, prediction: Prediction, factor: float) -> float:
    """Median difference of the frequencies, divided by a factor, and the model's, which may lack some modes."""
    data = fitter.data
    scaled = _changed(data, frequency=data.frequency / factor, sigma=data.sigma / factor, band=None)
    pairer = Pairer(scaled, fitter.structure.channels, prediction, fitter.criteria)
    pairing = pairer.pair(prediction, np.ones(len(data.frequency), dtype=bool), compare=False)
    return float(np.median(np.abs(pairer.differences(prediction, pairing))))


def other_wiring(fitter: Fitter, fit: Fit) -> str:
    """A sentence where shapes fit far better with two channels exchanged or one turned; empty where they do not."""
    if not fitter.shapes.known.any():
        return ""
    here = _squares(fitter, fit, fitter.data)
    degrees = max(float(fitter.shapes.degrees(fitter.used(fit.hypothesis))), 1.0)
    if here / degrees <= 1.5 * (1.0 if fitter.shapes.stated.any() else 0.5):
        return ""
    # The pairs stay as they are at first: that takes little time, and most measurements are wired well.
    found = {text: _squares(fitter, fit, data, fit.pairing) for text, data in _rewired(fitter.data)}
    text = min(found, key=found.__getitem__, default="")
    if not text or found[text] * fitter.criteria.rewired_perhaps > here:
        return ""
    found = {text: _squares(fitter, fit, data) for text, data in _rewired(fitter.data)}
    text = min(found, key=found.__getitem__)
    return f"the shapes fit far better with {text}" if found[text] * fitter.criteria.rewired < here else ""


def _rewired(data: Measurements) -> Iterator[tuple[str, Measurements]]:
    for i, k in itertools.combinations(range(len(data.channels)), 2):
        order = np.arange(len(data.channels))
        order[[i, k]] = k, i
        text = f"the channels {data.channels[i]} and {data.channels[k]} exchanged"
        yield text, _changed(data, shapes=data.shapes[:, order])
    for i, name in enumerate(data.channels):
        sign = np.ones(len(data.channels))
        sign[i] = -1.0
        yield f"the sign of {name} turned", _changed(data, shapes=data.shapes * sign)


def _squares(fitter: Fitter, fit: Fit, data: Measurements, pairing: Pairing | None = None) -> float:
    """Sum of squares of shapes, by default paired anew with the modes of a fit, in units of their errors."""
    used = fitter.used(fit.hypothesis)
    if pairing is None:
        pairer = Pairer(data, fitter.structure.channels, None, fitter.criteria)
        pairer.moves = fitter.pairer.moves
        pairing = pairer.pair(fit.prediction, used, compare=False)
    rows = fitter.shape_rows_of(data)
    return float(((rows.residual(fit.prediction, pairing, used) / rows.sigma) ** 2).sum())


def all_alike(data: Measurements, same: float) -> tuple[str, ...]:
    """Labels of setups whose shapes, three or more, are all the same: their MAC with each other is above a limit."""
    found = []
    for setup, label in enumerate(data.labels):
        shapes = data.shapes[data.pose == setup]
        common = np.isfinite(shapes).all(axis=0)
        some: Array = shapes[:, common]
        if len(some) < 3 or common.sum() < 2:
            continue
        size = np.linalg.norm(some, axis=1)
        if (size > 0.0).all() and (np.abs(some @ some.T) / np.outer(size, size)).min() ** 2 > same:
            found.append(label)
    return tuple(found)


def _changed(data: Measurements, **changes: object) -> Measurements:
    """Measurements with other columns, checked as ever."""
    return replace(data, **changes)  # type: ignore[arg-type]
