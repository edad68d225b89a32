"""A hammer that roves in front of sensors that stay: whether the files of all its points can be fitted together."""

from __future__ import annotations

from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass, replace
from pathlib import Path

import numpy as np

from pkmodes.campaign.averaging import Mean, grouped_means
from pkmodes.campaign.campaign import Campaign
from pkmodes.campaign.found import FileModes, Found
from pkmodes.campaign.sensors import unsigned

#: Difference of the frequencies of a mode at two points at most, in half-power bandwidths, for functions to have one
#: pole.
SHIFT = 0.15


@dataclass(frozen=True)
class Change:
    """By how much a machine changed from point to point, and by how much it may, both relative to its frequencies."""

    apart: float
    allowed: float

    def on(self, mode: Found) -> Found:
        """Return a mode of the functions of all points: the machine had both ends of the change."""
        sigma = float(np.hypot(mode.sigma_frequency, 0.5 * self.apart * mode.frequency))
        return replace(mode, sigma_frequency=sigma)


def points_of(files: Mapping[str, Mapping[Path, FileModes]], campaign: Campaign) -> list[dict[str, Path]]:
    """Return the files of each repeat by setup where setups are points of a roving hammer; none otherwise.

    Parameters
    ----------
    files : mapping of str to mapping of Path to FileModes
        What each file of each setup gives.  If a setup has more files than another one, its last ones are in no
        repeat.
    """
    sensors = [campaign.sensors_in(setup) for setup in files]
    forces = [_hit(setup, each.values(), campaign) for setup, each in files.items()]
    if len(set(forces)) < 2 or not all(forces) or any(each != sensors[0] for each in sensors):
        return []
    return [dict(zip(files, paths, strict=True)) for paths in zip(*files.values(), strict=False)]


def _hit(setup: str, files: Iterable[FileModes], campaign: Campaign) -> frozenset[str]:
    """Return the keys of the forces that act in all files of a setup."""
    forces = campaign.forces_in(setup)
    in_each = [
        {place.key for name, place in forces.items() if unsigned(name) in (file.seen or ())} for file in files
    ]
    return frozenset(set.intersection(*in_each)) if in_each else frozenset()


def change_of(points: Sequence[Sequence[Mean]]) -> Change:
    """Return by how much the machine changed from point to point.

    Warmth and settling change all modes; what differs in single ones are fits of modes that a point hardly shows.
    """
    shifts: list[list[float]] = [[] for _ in points]
    widths = []
    for group in grouped_means(points):
        known = {i: one.mode for i, one in group.items() if one.mode.sigma_frequency < _allowed(one.mode)}
        if len(known) < 2:
            continue
        middle = float(np.median([mode.frequency for mode in known.values()]))
        widths.append(min(_allowed(mode) / mode.frequency for mode in known.values()))
        for i, mode in known.items():
            shifts[i].append(mode.frequency / middle - 1.0)
    each = [float(np.median(one)) for one in shifts if one]
    return Change(max(each) - min(each) if each else 0.0, float(np.median(widths)) if widths else np.inf)


def _allowed(mode: Found) -> float:
    """Return the difference of the frequencies of a mode that is allowed [Hz]."""
    return SHIFT * 2.0 * mode.damping * mode.frequency
