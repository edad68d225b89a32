"""A roving hammer and fixed sensors: whether the files of all its points can be fitted together."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field, replace
from pathlib import Path

import numpy as np
from numpy.typing import NDArray

from pkmodes.modaltest.campaign.averaging import group_by_mode
from pkmodes.modaltest.campaign.campaign import Campaign
from pkmodes.modaltest.campaign.mode_estimates import FileModes, ModeEstimate
from pkmodes.modaltest.identification.modes import IdentifiedModes

Array = NDArray[np.float64]
Complex = NDArray[np.complex128]
#: Number of standard deviations above which a change is real.
CHANGE_SIGMAS = 3.0
#: Minimum relative standard deviation of a frequency (less is rounding), and sweeps of the median polish.
MIN_RELATIVE_SIGMA, MEDIAN_SWEEPS = 1e-7, 20
#: Largest difference of a mode's frequencies at two points for their functions to share a pole, in half-power
#: bandwidths.
MAX_SHIFT = 0.15


@dataclass(frozen=True, eq=False)
class RovingPoint:
    """A file of a point that was hit.

    - modes: modes of this file alone
    - factor: factor from its frequencies to those of the machine in the middle of its change
    """

    path: Path
    modes: tuple[ModeEstimate, ...]
    factor: float = 1.0

    def correction(
        self,
        frequencies: Array,
        points: Sequence[str],
        references: Sequence[str],
        window_time_constant: float | None = None,
        length: float | None = None,
    ) -> Complex:
        """Return the correction of the file's accelerances, (F, S, R), to those of the machine in mid-change.

        Accelerances scale with the ratio of frequencies at the same damping ratios: only the poles move, and the
        residues with them.  The file's modes give the poles; its noise is left unchanged.

        - frequencies: (F,) [Hz]
        - points, references: as in the shapes and participations of the modes
        - window_time_constant: time constant of a window that the responses have had [s]
        - length: length of the record of each impact, which cuts off the decays [s]; complete ones by default
        """
        if self.factor == 1.0 or not self.modes:
            return np.zeros((len(frequencies), len(points), len(references)), complex)
        shapes = np.array([[mode.shape.get(name, 0.0) for name in points] for mode in self.modes])
        participations = np.array(
            [[mode.participation.get(name, 0.0) for name in references] for mode in self.modes]
        )
        ratios = np.array([mode.damping for mode in self.modes])
        undamped = 2.0 * np.pi * np.array([mode.frequency for mode in self.modes])
        poles = undamped * (-ratios + 1j * np.sqrt(np.maximum(1.0 - ratios**2, 0.0)))

        def response(factor: float) -> Complex:
            shifted = factor * poles - (1.0 / window_time_constant if window_time_constant else 0.0)
            recorded = np.ones(len(shifted)) if length is None else 1.0 - np.exp(shifted * length)
            return IdentifiedModes(shifted, factor * recorded[:, None] * shapes, participations).response(
                frequencies
            )

        return response(self.factor) - response(1.0)


@dataclass(frozen=True)
class RovingChange:
    """The change of a machine from point to point, and the largest allowed, both relative to its frequencies.

    - factors: factors from the frequencies of each setup to those in mid-change; 1 where no change is certain
    """

    difference: float
    allowed: float
    factors: Mapping[str, float] = field(default_factory=dict)

    def add_to_sigma(self, mode: ModeEstimate) -> ModeEstimate:
        """Return a mode fitted to all points with half the change in its sigma: the machine had both frequencies."""
        sigma = float(np.hypot(mode.sigma_frequency, 0.5 * self.difference * mode.frequency))
        return replace(mode, sigma_frequency=sigma)


def match_repeats(files: Mapping[str, Mapping[Path, FileModes]], campaign: Campaign) -> list[dict[str, Path]]:
    """Return the files of each repeat by setup where setups are points of a roving hammer; none otherwise.

    - files: the modes of each file of each setup.  If a setup has more files than another one, its last ones are in
      no repeat.
    """
    sensors = [campaign.sensors_in(setup) for setup in files]
    forces_hit: list[frozenset[str]] = []  # keys of the forces that act in all files of a setup
    for setup, by_path in files.items():
        forces = campaign.forces_in(setup)
        file_forces = [{forces[name].key for name in file.forces} for file in by_path.values()]
        forces_hit.append(frozenset(set.intersection(*file_forces)))
    if (
        len(set(forces_hit)) < 2
        or not all(forces_hit)
        or any(setup_sensors != sensors[0] for setup_sensors in sensors)
    ):
        return []
    return [dict(zip(files, paths, strict=True)) for paths in zip(*files.values(), strict=False)]


def estimate_change(points: Mapping[str, Sequence[ModeEstimate]]) -> RovingChange:
    """Return by how much the machine changed from point to point, given the modes of each.

    Warming and settling shift all modes; differences in single modes come from fits of modes that a point hardly
    excites.  So the logarithm of each frequency is modelled as that of the mode plus a shift of the point, by a
    weighted median polish (Tukey, Exploratory Data Analysis, 1977, chapter 11).
    """
    groups = [
        {i: mode for i, mode in group.items() if mode.sigma_frequency < _allowed_difference(mode)}
        for group in group_by_mode(list(points.values()))
    ]
    groups = [group for group in groups if len(group) > 1]
    if not groups:
        return RovingChange(0.0, np.inf, dict.fromkeys(points, 1.0))
    widths = [min(_allowed_difference(mode) / mode.frequency for mode in group.values()) for group in groups]
    logs, sigma = (np.full((len(groups), len(points)), np.nan) for _ in range(2))
    for k, group in enumerate(groups):
        for i, mode in group.items():
            logs[k, i] = np.log(mode.frequency)
            sigma[k, i] = max(mode.sigma_frequency / mode.frequency, MIN_RELATIVE_SIGMA)
    shifts = np.zeros(len(points))
    for _ in range(MEDIAN_SWEEPS):
        mode_logs = np.array([_weighted_median(*row) for row in zip(logs - shifts, sigma, strict=True)])
        residuals = logs - mode_logs[:, None]
        shifts = np.array([_weighted_median(*column) for column in zip(residuals.T, sigma.T, strict=True)])
    errors = [_median_sigma(*column) for column in zip((residuals - shifts).T, sigma.T, strict=True)]
    shifts -= np.median(shifts)
    significant = np.where(np.abs(shifts) > CHANGE_SIGMAS * np.array(errors), shifts, 0.0)
    low, high = min(significant), max(significant)
    factors = {
        setup: float(np.exp(0.5 * (low + high) - shift))
        for setup, shift in zip(points, significant, strict=True)
    }
    return RovingChange(float(-np.expm1(low - high)), float(np.median(widths)), factors)


def _weighted_median(values: Array, sigma: Array) -> float:
    """Return the median of values, weighted by their standard deviations; 0 where none is known."""
    order = np.argsort(values)[: int(np.isfinite(values).sum())]
    weights = np.cumsum(1.0 / sigma[order])
    return float(values[order[np.searchsorted(weights, 0.5 * weights[-1])]]) if len(order) else 0.0


def _median_sigma(residuals: Array, sigma: Array) -> float:
    """Return the standard deviation of a weighted median: as stated, or scaled up if the residuals are larger."""
    finite = np.isfinite(residuals)
    if not finite.any():
        return np.inf
    scale = max(1.0, 1.4826 * float(np.median(np.abs(residuals[finite]) / sigma[finite])))
    return float(scale * np.sqrt(0.5 * np.pi / (sigma[finite] ** -2.0).sum()))


def _allowed_difference(mode: ModeEstimate) -> float:
    """Return the allowed difference of a mode's frequencies [Hz]."""
    return MAX_SHIFT * 2.0 * mode.damping * mode.frequency
