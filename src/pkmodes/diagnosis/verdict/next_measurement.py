"""The next measurement: the pose, motors and perhaps load, at which two remaining explanations differ most."""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass
from typing import cast

import numpy as np

from pkmodes.core.base.drives import DRIVES, Drives, motors, other_drives
from pkmodes.diagnosis.fit.fitter import Fitter
from pkmodes.diagnosis.fit.hypothesis import Fit
from pkmodes.diagnosis.problem import Array, Driven, Loadable, Prediction, Structure, Surrounded
from pkmodes.diagnosis.verdict.findings import NextMeasurement

#: Number of poses to choose from.
POSES = 80
UNKNOWN = "it is not known where else the structure could be measured"


@dataclass(frozen=True)
class _Way:
    """A way to measure: the structure at the poses to choose from, what its motors do, and what is set there.

    Attributes
    ----------
    unlike : bool
        Whether its motors do something else than in most of the measurements.
    """

    structure: Structure
    drives: Drives | None
    load: Mapping[str, float]
    unlike: bool = False

    @property
    def effort(self) -> int:
        """How much more work it is than to measure another pose."""
        return 2 if self.load else int(self.unlike)


def next_measurement(
    fitter: Fitter, contested: Sequence[tuple[str, Fit]]
) -> tuple[NextMeasurement | None, str]:
    """Propose a pose, with other motors or a load if that separates far better than any pose alone.

    Parameters
    ----------
    contested : sequence of (str, Fit)
        Names and fits of the explanations that the data cannot tell apart, best first.

    Returns
    -------
    NextMeasurement or None
        None if nothing separates any of them from the best.
    str
        Why not; empty if there is a proposal, or fewer than two are contested.
    """
    if len(contested) < 2:
        return None, ""
    others = fitter.structure.elsewhere(POSES)
    where = _surroundings(fitter.structure)
    if others is None:
        return None, UNKNOWN
    points, structure = others
    if not len(points):
        return None, f"there are no {where}"
    found = list(_proposals(fitter, contested, points, structure))
    least, best = fitter.criteria.claim.worth_measuring, None
    for way, proposed in found:
        gain = 1.0 if best is None or way.effort == best[0].effort else fitter.criteria.claim.worth_loading
        if proposed.sigmas >= least and (best is None or proposed.sigmas > gain * best[1].sigmas):
            best = way, proposed
    if best is not None:
        return best[1], ""
    return None, _nowhere(f"{len(points)} {where}", structure, [one for _, one in found], least)


def _ways(structure: Structure, points: Array) -> Iterator[_Way]:
    """Yield the ways to measure at these poses, the simplest first."""
    drives = cast("Drives", structure.drives) if isinstance(structure, Driven) else None
    yield _Way(structure, drives, {})
    if isinstance(structure, Driven):
        others = structure.with_other_drives(range(len(points)))
        yield _Way(others, cast("Drives", other_drives(structure.drives)), {}, unlike=True)
    for load, loaded in structure.loaded() if isinstance(structure, Loadable) else ():
        yield _Way(loaded, drives, load)


def _proposals(
    fitter: Fitter, contested: Sequence[tuple[str, Fit]], points: Array, structure: Structure
) -> Iterator[tuple[_Way, NextMeasurement]]:
    """Yield for each way to measure the pose at which two explanations differ most."""
    for way in _ways(structure, points):
        # A load cannot be a parameter of an explanation: setting it would not remove that cause.
        some = [(name, fit) for name, fit in contested if not way.load.keys() & _names(fit)]
        if some and some[0][1] is contested[0][1]:
            proposed = _best(fitter, some, points, way)
            if proposed is not None:
                yield way, proposed


def _best(
    fitter: Fitter, contested: Sequence[tuple[str, Fit]], points: Array, way: _Way
) -> NextMeasurement | None:
    """Return the pose that separates an explanation most from the first one; None if none can be evaluated."""
    modes = int(np.median(np.bincount(fitter.data.pose)))
    noise = float(np.median(fitter.observations.sigma))
    first, *others = (_lowest(way, way.structure.predict(fit.values, ()), fit, modes) for _, fit in contested)
    best: NextMeasurement | None = None
    for (name, _), prediction in zip(contested[1:], others, strict=True):
        both = min(first.shape[1], prediction.shape[1])
        apart = (prediction[:, :both] - first[:, :both]) / noise
        away = np.sqrt(np.sum(apart**2, axis=1))
        if not both or not np.isfinite(away).any():
            continue
        k = int(np.nanargmax(away))
        if best is None or away[k] > best.sigmas:
            hidden = _hiding(fitter, contested[0][1], way, k, apart[k]) if way.unlike else ""
            names, pose = (contested[0][0], name), tuple(points[k].tolist())
            best = NextMeasurement(pose, names, float(away[k]), way.drives, hidden, dict(way.load))
    return best


def _hiding(fitter: Fitter, fit: Fit, way: _Way, pose: int, apart: Array) -> str:
    """Return the uncertain value that could make up most of a difference at a pose within its standard deviation.

    What the motors did in the measurements may have left values undetermined that matter now, such as the inertia of
    motors that were held.

    Parameters
    ----------
    apart : ndarray, shape (m,)
        Differences of the lowest modes in standard deviations of a measured frequency.

    Returns
    -------
    str
        Its name; empty if the difference is worth measuring beside all that is uncertain.
    """
    prediction = way.structure.predict(fit.values, fit.free)
    rates = _lowest_of(prediction.log_rates, way, prediction, fit, len(apart))[pose]
    rates = rates / float(np.median(fitter.observations.sigma))

    def left(covariance: Array) -> float:
        V = np.eye(len(apart)) + rates @ covariance @ rates.T
        return float(np.sqrt(apart @ np.linalg.solve(V, apart)))

    C = fit.covariance
    if left(C) >= fitter.criteria.claim.worth_measuring:
        return ""
    known = {
        fitter.parameters[i].name: left(C - np.outer(C[k], C[k]) / C[k, k])
        for k, i in enumerate(fit.free)
        if i in fitter.nuisances and C[k, k] > 0.0
    }
    return max(known, key=lambda name: known[name], default="")


def _nowhere(where: str, structure: Structure, found: Sequence[NextMeasurement], least: float) -> str:
    """Return why nothing is proposed although explanations are contested."""
    if not found:
        return f"at none of {where} can the remaining explanations be compared"
    ways = f", with {motors(DRIVES)}" if isinstance(structure, Driven) else ""
    ways += ", or with a load" if isinstance(structure, Loadable) and structure.loaded() else ""
    best = max(found, key=lambda one: one.sigmas)
    return (
        f"none of {where} separates the remaining explanations by {least:g} standard deviations or more{ways}: "
        f"{' and '.join(best.separates)} differ by {best.sigmas:.2g} at most"
    )


def _surroundings(structure: Structure) -> str:
    """Return what the poses to choose from are."""
    return structure.surroundings if isinstance(structure, Surrounded) else "other setups"


def _names(fit: Fit) -> set[str]:
    """Return the names of the parameters of a fit's causes."""
    return {name for cause in fit.causes for name in cause.parameters}


def _lowest(way: _Way, prediction: Prediction, fit: Fit, modes: int) -> Array:
    """Return the log frequencies of the lowest measurable modes; a formerly rigid mode counts if it is paired."""
    return _lowest_of(prediction.log_frequencies, way, prediction, fit, modes)


def _lowest_of(values: Array, way: _Way, prediction: Prediction, fit: Fit, modes: int) -> Array:
    """Return values, (S, m, ...), at the lowest measurable modes; a formerly rigid mode counts if it is paired.

    With other motors, modes that were not measured say nothing about which are measurable.
    """
    paired = fit.pairing.partner[fit.pairing.partner >= 0]
    above = int(paired.min()) - fit.prediction.rigid if len(paired) else 0
    first = max(prediction.rigid + (min(above, 0) if way.unlike else above), 0)
    return values[:, first : first + modes]
