"""Rows of an identification against the truth of their records: which modes count, which row is which, what is wrong.

A mode counts if it lies in the band; if its peak alone stands 10 dB above the noise of one file at the best
sensor; and if its neighbours cannot imitate it: what is left of it after the best fit by the modes beside it
(of any shape and participation, their poles free to first order) still stands 10 dB above that noise.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np
from scipy.optimize import linear_sum_assignment

from pkmodes.modaltest.campaign.results import IdentifiedMode, RecordResult
from pkmodes_rig.signals.campaigns import Made
from pkmodes_rig.signals.modal_tests import ModalTest, Recorded
from pkmodes_rig.signals.small_motion import SmallMotion, Truth

#: Ratio of powers of a peak and the noise [-]: 10 dB.
PEAK = 10.0
#: A row may be a mode this near, relative to the frequency; what is further away is another one.
NEAR = 0.01
#: Lines, and their range about a mode, relative, at which it is compared with its neighbours.
LINES, AROUND = 161, 0.12


@dataclass(frozen=True)
class Row:
    """A row of the result with the mode that it is.

    Attributes
    ----------
    record, mode : int
        Indices; the mode is that of the record's truth, or -1 if the row is none.
    frequency, sigma, of_fit, repeatability : float
        As identified [Hz]; `of_fit` is scatter and fit in quadrature.
    true, nominal : float
        Mean of the frequencies of the record's files; that of the machine at the stated pose [Hz].
    damping, sigma_damping, true_damping : float
    mac : float
        Against the motion of the machine; NaN with fewer than two components.
    shape_errors : tuple of float
        Errors of the components, relative to the largest, of the motion as the sensors show it.
    sigma_shape : float
        Of them.
    """

    record: int
    mode: int
    frequency: float
    sigma: float
    of_fit: float
    repeatability: float
    true: float
    nominal: float
    damping: float
    sigma_damping: float
    true_damping: float
    mac: float
    shape_errors: tuple[float, ...]
    sigma_shape: float


@dataclass(frozen=True)
class Judged:
    """What an identification found.

    Attributes
    ----------
    rows : tuple of Row
    counted : tuple of (int, int)
        Record and mode of all modes that count.
    missed : tuple of (int, float)
        Record and frequency [Hz] of those that were not found.
    """

    rows: tuple[Row, ...]
    counted: tuple[tuple[int, int], ...]
    missed: tuple[tuple[int, float], ...]


def judge(found: Sequence[RecordResult], made: Made, test: ModalTest, band: tuple[float, float]) -> Judged:
    """Compare the rows of all records with their truth."""
    rows, counted, missed = list[Row](), list[tuple[int, int]](), list[tuple[int, float]]()
    by_record = {one.record.number - 1: one.modes for one in found}
    for i, nominal in enumerate(made.nominal):
        places = [place for place in made.machines if place[0] == i]
        truths = [made.machines[place].truth for place in places]
        frequencies = np.mean([truth.frequencies for truth in truths], axis=0)
        matched = _matched(by_record.get(i, ()), frequencies, truths[0], test)
        count = [
            m
            for m in counting(made.machines[places[0]], made.files[places[0]], test)
            if band[0] <= frequencies[m] <= band[1]
        ]
        counted += [(i, m) for m in count]
        missed += [(i, float(frequencies[m])) for m in count if m not in matched]
        for mode, k in zip(by_record.get(i, ()), matched, strict=True):
            rows.append(_row(i, mode, k, truths, nominal.truth, test))
    return Judged(tuple(rows), tuple(counted), tuple(missed))


def _matched(
    modes: Sequence[IdentifiedMode], frequencies: np.ndarray, truth: Truth, test: ModalTest
) -> list[int]:
    """Return the mode that each row is, one to one, by frequency and shape; -1 for none."""
    if not modes:
        return []
    apart = np.abs(np.array([mode.frequency for mode in modes])[:, None] / frequencies - 1.0) / NEAR
    unlike = 1.0 - np.array(
        [[np.nan_to_num(_mac(mode, truth, k)) for k in range(len(frequencies))] for mode in modes]
    )
    # A row that is no mode may cost more than the worst match.
    costs = np.where(apart <= 1.0, apart + unlike - 10.0, 0.0)
    found = [-1] * len(modes)
    for i, k in zip(*linear_sum_assignment(costs), strict=True):
        if costs[i, k] < 0.0:
            found[int(i)] = int(k)
    return found


def _mac(mode: IdentifiedMode, truth: Truth, k: int) -> float:
    names = list(mode.shape)
    if len(names) < 2:
        return np.nan
    a, b = np.array([mode.shape[name] for name in names]), np.array([truth.shapes[name][k] for name in names])
    return float(abs(np.vdot(a, b)) ** 2 / (np.vdot(a, a).real * np.vdot(b, b).real))


def _row(
    record: int, mode: IdentifiedMode, k: int, truths: Sequence[Truth], nominal: Truth, test: ModalTest
) -> Row:
    no = k < 0
    return Row(
        record,
        k,
        mode.frequency,
        mode.sigma,
        float(np.hypot(mode.parts.scatter, mode.parts.fit)),
        mode.parts.repeatability,
        np.nan if no else float(np.mean([truth.frequencies[k] for truth in truths])),
        np.nan if no else float(nominal.frequencies[k]),
        mode.damping,
        mode.sigma_damping,
        np.nan if no else float(np.mean([truth.ratios[k] for truth in truths])),
        np.nan if no else _mac(mode, truths[0], k),
        () if no else _shape_errors(mode, truths[0], k, test),
        mode.sigma_shape,
    )


def _shape_errors(mode: IdentifiedMode, truth: Truth, k: int, test: ModalTest) -> tuple[float, ...]:
    """Return errors of the components, the truth at the scale that fits best.

    Sensitivity and mounting of a sensor are no errors of the identification, so the truth is what the sensors show.
    """
    if len(mode.shape) < 2 or not np.isfinite(mode.sigma_shape):
        return ()
    sensors = {sensor.channel: sensor for sensor in test.sensors}
    shape = np.array(list(mode.shape.values()))
    shown = np.array([sensors[name].row(truth.shapes)[k] for name in mode.shape])
    shown = shown * np.exp(-0.5j * np.angle(np.sum(shown**2)))  # as real as possible
    true = shown.real * (shown.real @ shape) / (shown.real @ shown.real)
    # One degree of freedom of the components went into the scale.
    share = np.sqrt(len(shape) / (len(shape) - 1.0))
    return tuple(share * (shape - true))


def counting(machine: SmallMotion, recorded: Recorded, test: ModalTest) -> list[int]:
    """Return the modes whose peaks stand out of noise and neighbours, whatever the band."""
    into = np.array(
        [sum(part * machine.shapes[name] for name, part in one.items()) for one in test.exciters]
    )[: recorded.power.shape[1]]
    rows = np.array([sensor.row(machine.shapes) for sensor in test.sensors])
    alive = [i for i in range(len(rows)) if i != test.flaws.dead]
    rows, truth, first = rows[alive][:, machine.rigid :], machine.truth, machine.rigid
    into = into[:, first:]
    omega, ratios = 2.0 * np.pi * truth.natural, truth.ratios
    found = []
    for i, natural in enumerate(truth.natural):
        f = natural * np.linspace(1.0 - AROUND, 1.0 + AROUND, LINES)
        power = np.array([np.interp(f, recorded.frequencies, column) for column in recorded.power.T])
        weight = np.sqrt(power / test.room.noise)  # (exciters, lines)
        s = 2.0 * np.pi * f
        lines = -(s**2) / (omega[:, None] ** 2 - s**2 + 2j * ratios[:, None] * omega[:, None] * s)
        lost = 1.0 - np.exp(
            -ratios[i] * omega[i] * test.seconds
        )  # of a peak cut off by the end of the record
        alone = lost * np.einsum("s,r,f,rf->fsr", rows[:, i], into[:, i], lines[i], weight)
        if _height(alone) < PEAK:
            continue
        columns = []
        for j in np.flatnonzero(np.abs(truth.natural / natural - 1.0) < 2.0 * AROUND):
            if j != i:
                columns += _tangents(rows[:, j], into[:, j], lines[j], weight)
        basis = np.array(columns).reshape(len(columns), alone.size).T
        # Columns of very different size would hide small ones in the rank of the fit.
        basis = basis / np.linalg.norm(basis, axis=0)
        left = alone.ravel() - basis @ np.linalg.lstsq(basis, alone.ravel(), rcond=1e-10)[0]
        if _height(left.reshape(alone.shape)) >= PEAK:
            found.append(i)
    return found


def _height(values: np.ndarray) -> float:
    """Return the largest power over all lines at the best sensor, all exciters together."""
    return float(np.max(np.sum(np.abs(values) ** 2, axis=2)))


def _tangents(row: np.ndarray, into: np.ndarray, line: np.ndarray, weight: np.ndarray) -> list[np.ndarray]:
    """Return what changes of a mode's shape, participation and pole do to the functions."""
    sensors, exciters = len(row), len(into)
    found = []
    for a in range(sensors):
        found.append(np.einsum("s,r,f,rf->fsr", np.eye(sensors)[a], into, line, weight).ravel())
    for b in range(exciters if exciters > 1 else 0):
        found.append(np.einsum("s,r,f,rf->fsr", row, np.eye(exciters)[b], line, weight).ravel())
    found.append(np.einsum("s,r,f,rf->fsr", row, into, line**2, weight).ravel())
    return [column for column in found if np.any(column)]
