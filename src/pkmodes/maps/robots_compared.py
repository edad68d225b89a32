"""By how much the frequencies of two robots differ, pose by pose, their modes paired by shape."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from typing import Any

import numpy as np
from numpy.typing import NDArray
from scipy.optimize import linear_sum_assignment

from pkmodes.core.base.drives import FREE
from pkmodes.core.base.errors import PoseError
from pkmodes.core.model import Model
from pkmodes.robot_files.differences import check_one_mechanism
from pkmodes.support.mac import mass_weighted_mac
from pkmodes.support.progress import say

Array = NDArray[np.float64]
#: Poses evaluated together.
CHUNK = 4096
#: Shares of the poses below the ends of the range that is given for each mode.
ENDS = (0.02, 0.98)
#: A mode can be compared where its partner is another one at no more than this share of the poses, and the median MAC
#: of the pairs is at least this.
EXCHANGED, LIKE = 0.1, 0.8
#: Smaller relative differences of a frequency count as none.
NOTHING = 5e-5


@dataclass(frozen=True, eq=False)
class FrequencyChanges:
    """The frequencies of two robots at N poses; m vibration modes of the first, m' of the second.

    Attributes
    ----------
    poses : ndarray, shape (N, d)
    first, second : ndarray of bool, shape (N,)
        Where each can be evaluated.
    frequencies : ndarray, shape (N, m)
        Of the first robot [Hz]; NaN where it cannot be evaluated.
    relative : ndarray, shape (N, m)
        Frequency of the partner over that of the mode, minus 1; NaN where there is no partner.
    partner : ndarray of int, shape (N, m)
        Index among the vibration modes of the second robot, -1 for none.
    mac : ndarray, shape (N, m)
        Of the two shapes, by the mass matrix of the first robot at the coordinates that both have.
    second_modes : int
        The number m'.
    """

    poses: Array
    first: NDArray[np.bool_]
    second: NDArray[np.bool_]
    frequencies: Array
    relative: Array
    partner: NDArray[np.intp]
    mac: Array
    second_modes: int

    @property
    def modes(self) -> int:
        """The number m."""
        return int(self.frequencies.shape[1])

    @property
    def counts(self) -> dict[str, int]:
        """How many poses both robots reach, one of them only, or none."""
        return {
            "both": int((self.first & self.second).sum()),
            "first_only": int((self.first & ~self.second).sum()),
            "second_only": int((self.second & ~self.first).sum()),
            "none": int((~self.first & ~self.second).sum()),
        }


@dataclass(frozen=True)
class ModeChange:
    """By how much the frequency of one mode differs over the poses.

    Attributes
    ----------
    mode : int
        Number by frequency among the vibration modes of the first robot, from 1.
    poses : int
        Poses at which it has a partner.
    median, low, high : float or None
        Of the relative difference; 2 % of the poses lie below the low end and above the high one.
    partner : int or None
        Number of its partner among the vibration modes of the second robot, at most of the poses.
    exchanged : float or None
        Share of the poses at which its partner has another number, because frequencies cross or veer.
    mac : float or None
        Median MAC of the two shapes.
    """

    mode: int
    poses: int
    median: float | None
    low: float | None
    high: float | None
    partner: int | None
    exchanged: float | None
    mac: float | None

    @property
    def comparable(self) -> bool:
        """Whether it is one mode of the second robot, so that its difference is that of one motion."""
        return (
            self.exchanged is not None
            and self.mac is not None
            and self.exchanged <= EXCHANGED
            and self.mac >= LIKE
        )


def headline(modes: Sequence[ModeChange]) -> str:
    """Return the largest difference of a mode that can be compared, as a sentence without a stop."""
    known = [mode for mode in modes if mode.comparable]
    if not known:
        return "No mode of the first robot is one mode of the second throughout"
    of = "" if len(known) == len(modes) else " of the modes that can be compared"
    most = max(known, key=lambda mode: abs(mode.median or 0.0))
    if abs(most.median or 0.0) < NOTHING:
        return f"No frequency{of} changes"
    first = f"Mode {most.mode} changes most{',' if of else ''}{of}"
    return f"{first}: {100.0 * (most.median or 0.0):+.2f} % in the median"


def exchanging(modes: Sequence[ModeChange]) -> str:
    """Return which modes have partners but cannot be compared, as a sentence without a stop; empty if none."""
    names = [str(mode.mode) for mode in modes if mode.poses and not mode.comparable]
    if not names:
        return ""
    several = len(names) > 1
    which = f"modes {', '.join(names[:-1])} and {names[-1]}" if several else f"mode {names[0]}"
    return (
        f"{which} cannot be compared: the partner is another one at more than {100.0 * EXCHANGED:g} % of the poses, "
        f"or the median MAC is below {LIKE:g}, so that {'their' if several else 'its'} quantiles mix motions"
    )


def compare_frequencies(first: Model, second: Model, poses: Array, drives: str = FREE) -> FrequencyChanges:
    """Evaluate two robots at the same poses and pair their modes at each of them.

    The pairs are those with the largest sum of MAC, so a mode keeps its partner where frequencies cross or veer.

    Parameters
    ----------
    poses : ndarray, shape (N, d)
        Where a robot cannot be evaluated, it is left out.
    drives : {"free", "held"}
        As for `pkmodes.Model.modes`.

    Raises
    ------
    PoseError
        If there is no pose that both can reach.
    PkmodesError
        If their mechanisms differ.
    """
    check_one_mechanism(first.robot, second.robot)
    parts = []
    for start in range(0, len(poses), CHUNK):
        say(f"{start:,} of {len(poses):,} poses of the two robots")
        parts.append(_at(first, second, poses[start : start + CHUNK], drives))
    modes = second.modes(poses[:1], "nan", fields=("frequencies",), drives=drives)
    count = modes.frequencies.shape[-1] - modes.rigid_modes
    reached, also, *rest = (np.concatenate(each) for each in zip(*parts, strict=True))
    frequencies, relative, partner, mac = rest
    changes = FrequencyChanges(poses, reached, also, frequencies, relative, partner, mac, second_modes=count)
    if not changes.counts["both"]:
        what = f"expected poses that both robots can reach, found none among {len(poses):,}"
        raise PoseError(what, "poses", "give poses in the workspaces of both")
    return changes


def mode_changes(changes: FrequencyChanges) -> tuple[ModeChange, ...]:
    """Return the distribution of each mode's difference over the poses."""
    return tuple(_mode_change(changes, mode) for mode in range(changes.modes))


def _mode_change(changes: FrequencyChanges, mode: int) -> ModeChange:
    paired = np.isfinite(changes.relative[:, mode])
    if not paired.any():
        return ModeChange(mode + 1, 0, None, None, None, None, None, None)
    relative, partner = changes.relative[paired, mode], changes.partner[paired, mode]
    most = int(np.bincount(partner).argmax())
    low, high = np.quantile(relative, ENDS)
    return ModeChange(
        mode + 1,
        int(paired.sum()),
        float(np.median(relative)),
        float(low),
        float(high),
        most + 1,
        float((partner != most).mean()),
        float(np.median(changes.mac[paired, mode])),
    )


def _at(first: Model, second: Model, poses: Array, drives: str) -> tuple[NDArray[Any], ...]:
    """Return the arrays of `FrequencyChanges` at some poses, but for the last."""
    fields = ("frequencies", "shapes")
    ours, theirs = (one.modes(poses, "nan", fields=fields, drives=drives) for one in (first, second))
    reached = tuple(np.asarray(modes.valid, dtype=bool) for modes in (ours, theirs))
    f, g = (modes.frequencies[:, modes.rigid_modes :] for modes in (ours, theirs))
    relative, mac = np.full(f.shape, np.nan), np.full(f.shape, np.nan)
    partner = np.full(f.shape, -1, dtype=np.intp)
    both = np.flatnonzero(reached[0] & reached[1])
    if len(both):
        common = [name for name in ours.coordinates if name in theirs.coordinates]
        phi, psi = (
            modes.shapes[both][:, modes.rigid_modes :][
                ..., [modes.coordinates.index(name) for name in common]
            ]
            for modes in (ours, theirs)
        )
        at = [first.coordinates.index(name) for name in common]
        mass = first.matrices(poses[both], "nan")[0][:, at][:, :, at]
        likeness = _mac(phi, psi, mass)
        for row, table in zip(both, likeness, strict=True):
            mine, others = _pairs(table)
            partner[row, mine] = others
            relative[row, mine] = g[row, others] / f[row, mine] - 1.0
            mac[row, mine] = table[mine, others]
    return *reached, f, relative, partner, mac


def _mac(phi: Array, psi: Array, mass: Array) -> Array:
    """Return the MAC of the modes of two robots, (N, m, m'), at coordinates that both have."""
    size = np.sqrt(((phi @ mass) * phi).sum(axis=-1, keepdims=True))
    phi = phi / np.where(size > 0.0, size, 1.0)
    products = phi @ mass @ np.swapaxes(psi, 1, 2)
    return mass_weighted_mac(products, psi, mass)


def _pairs(mac: Array) -> tuple[NDArray[np.intp], NDArray[np.intp]]:
    """Return the one-to-one assignment with the largest sum of MAC."""
    order = mac.argmax(axis=1)
    if len(np.unique(order)) == len(order):
        return np.arange(len(order)), order
    mine, others = linear_sum_assignment(mac, maximize=True)
    return mine, others
