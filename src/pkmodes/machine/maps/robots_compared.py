"""By how much the frequencies of two robots differ, pose by pose, their modes paired by shape."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from typing import Annotated, Any, cast

import numpy as np
from msgspec import Meta
from numpy.typing import NDArray
from scipy.optimize import linear_sum_assignment

from pkmodes.core.base.drives import FREE, Drives
from pkmodes.core.base.errors import PoseError
from pkmodes.core.base.numbers import range_text
from pkmodes.core.model import Model
from pkmodes.core.robot.robot import Robot
from pkmodes.core.support.documents import Count, Document, Number, Probability
from pkmodes.core.support.mac import MIN_MAC_OF_PAIR, mass_weighted_mac
from pkmodes.core.support.ordering import joined
from pkmodes.core.support.progress import report_progress
from pkmodes.loop.robot_files.differences import (
    ChoiceDifference,
    ValueDifference,
    check_one_mechanism,
    differences,
)

Array = NDArray[np.float64]
#: Poses evaluated at once.
CHUNK_POSES = 4096
#: Quantiles over the poses: the ends of the range that is reported for each mode.
RANGE_QUANTILES = (0.02, 0.98)
#: A mode is comparable if its partner differs at no more than this share of the poses, and the median MAC of the
#: pairs is at least this.
MAX_EXCHANGED, MIN_MAC = 0.1, 0.8
#: Smaller relative changes of a frequency are reported as none.
NEGLIGIBLE_CHANGE = 5e-5


@dataclass(frozen=True, eq=False)
class FrequencyChanges:
    """The frequencies of two robots at N poses; m vibration modes of the first, m' of the second.

    - poses: (N, d)
    - first_valid, second_valid: whether each robot can be evaluated, (N,)
    - frequencies: frequencies of the first robot, (N, m) [Hz]; NaN where it cannot be evaluated
    - relative: frequency of the partner over that of the mode, minus 1, (N, m); NaN where there is no partner
    - partner: index among the vibration modes of the second robot, -1 for none, (N, m)
    - mac: MAC of the two shapes, by the mass matrix of the first robot at the coordinates that both have, (N, m); NaN
      without a partner
    - second_modes: the number m'
    """

    poses: Array
    first_valid: NDArray[np.bool_]
    second_valid: NDArray[np.bool_]
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
    def counts(self) -> PoseCounts:
        """Numbers of poses that both robots reach, that one of them reaches, and that neither does."""
        return PoseCounts(
            both=int((self.first_valid & self.second_valid).sum()),
            first_only=int((self.first_valid & ~self.second_valid).sum()),
            second_only=int((self.second_valid & ~self.first_valid).sum()),
            none=int((~self.first_valid & ~self.second_valid).sum()),
        )


class ModeChange(Document, frozen=True):
    """The relative difference of a frequency over the poses that both robots reach."""

    mode: Annotated[
        Number, Meta(description="Number by frequency in the first robot: 1 is its first vibration mode.")
    ]
    poses: Annotated[
        Count, Meta(description="Poses at which it has this partner: those of median, low, high and mac.")
    ]
    median: Annotated[
        float | None,
        Meta(description="Median of second / first - 1; null, like the next five, without a partner."),
    ]
    low: Annotated[float | None, Meta(description="2 % of the poses lie below it.")]
    high: Annotated[float | None, Meta(description="2 % of the poses lie above it.")]
    partner: Annotated[
        Number | None,
        Meta(
            description="Number of its partner among the vibration modes of the second robot, at most of the poses."
        ),
    ]
    exchanged: Annotated[
        Probability | None,
        Meta(description="Share of the poses that both reach at which it has another partner, or none."),
    ]
    mac: Annotated[float | None, Meta(description="Median modal assurance criterion of the pairs.")]

    @property
    def comparable(self) -> bool:
        """Whether it is one mode of the second robot, so that its difference is that of one motion."""
        return (
            self.exchanged is not None
            and self.mac is not None
            and self.exchanged <= MAX_EXCHANGED
            and self.mac >= MIN_MAC
        )


class PoseCounts(Document, frozen=True):
    """How many of the poses each robot can reach."""

    both: Annotated[Count, Meta(description="Both robots.")]
    first_only: Annotated[Count, Meta(description="The first robot only.")]
    second_only: Annotated[Count, Meta(description="The second robot only.")]
    none: Annotated[Count, Meta(description="None of them, such as corners of a grid.")]


class RobotsCompared(Document, frozen=True):
    """The differences of two robots: the second against the first."""

    first: Annotated[str, Meta(description="Name of the first robot.")]
    second: Annotated[str, Meta(description="Name of the second robot.")]
    drives: Drives
    compared: Annotated[Count, Meta(description="Number of declared values compared.")]
    values: Annotated[
        tuple[ValueDifference, ...],
        Meta(description="Those that differ, also by their standard deviations."),
    ]
    choices: Annotated[tuple[ChoiceDifference, ...], Meta(description="Choices that differ.")]
    effects_added: Annotated[tuple[str, ...], Meta(description="Effects of the second robot only.")]
    effects_removed: Annotated[tuple[str, ...], Meta(description="Effects of the first robot only.")]
    poses: Annotated[PoseCounts, Meta(description="Poses considered.")]
    modes: Annotated[tuple[ModeChange, ...], Meta(description="The vibration modes of the first robot.")]
    second_modes: Annotated[Count, Meta(description="Number of vibration modes of the second robot.")]
    notes: Annotated[tuple[str, ...], Meta(description="What the reader should know.")]


def compare_robots(first: Model, second: Model, poses: Array, drives: str | None = None) -> RobotsCompared:
    """Compare two robots by what their files declare, and by their frequencies over poses.

    Parameters, and errors raised, are those of `compare_frequencies`.
    """
    used_alike = drives is not None or first.robot.drives == second.robot.drives
    drives = _drives_of_both(first.robot, second.robot, drives)
    declared = differences(first.robot, second.robot)
    changes = compare_frequencies(first, second, poses, drives)
    modes = mode_changes(changes)
    notes = [sentence] if (sentence := incomparable_modes_sentence(modes)) else []
    if not used_alike:
        notes.append(
            f"the motors are {first.robot.drives} in the first robot file and {second.robot.drives} in the second: "
            "both are compared with free ones; --drives held compares both held"
        )
    surplus = changes.second_modes - changes.modes
    if surplus:
        richer = "second" if surplus > 0 else "first"
        noun = "mode" if abs(surplus) == 1 else "modes"
        notes.append(
            f"the {richer} robot has {abs(surplus)} {noun} of vibration more, without partners at each pose"
        )
    if not (declared.values or declared.choices or declared.added or declared.removed):
        notes.append("the two files declare the same robot")
    return RobotsCompared(
        first=first.robot.name,
        second=second.robot.name,
        drives=cast("Drives", drives),
        compared=declared.compared,
        values=declared.values,
        choices=declared.choices,
        effects_added=declared.added,
        effects_removed=declared.removed,
        poses=changes.counts,
        modes=modes,
        second_modes=changes.second_modes,
        notes=tuple(notes),
    )


def largest_difference_sentence(modes: Sequence[ModeChange]) -> str:
    """Return a sentence, without a stop, on the largest difference of a mode that can be followed."""
    comparable = [mode for mode in modes if mode.comparable]
    if not comparable:
        return "No mode can be followed from the first robot to the second"
    scope = "" if len(comparable) == len(modes) else " of the modes that can be followed"
    largest = max(comparable, key=lambda mode: abs(mode.median or 0.0))
    if abs(largest.median or 0.0) < NEGLIGIBLE_CHANGE:
        return f"No frequency{scope} changes"
    subject = f"Mode {largest.mode} changes most{',' if scope else ''}{scope}"
    return f"{subject}: {100.0 * (largest.median or 0.0):+.2f} % in the median"


def incomparable_modes_sentence(modes: Sequence[ModeChange]) -> str:
    """Return a sentence, without a stop, on the modes that have partners but cannot be followed; empty if none."""
    lost = [mode for mode in modes if mode.poses and not mode.comparable]
    if not lost:
        return ""
    exchanging = [mode for mode in lost if (mode.exchanged or 0.0) > MAX_EXCHANGED]
    unlike = [mode for mode in lost if mode not in exchanging]
    reasons = []
    if exchanging:
        shares = range_text([100.0 * (mode.exchanged or 0.0) for mode in exchanging], ".0f")
        subject = _subject(exchanging, lost)
        reasons.append(
            f"at {shares} % of the poses {subject} {'has' if len(exchanging) == 1 else 'have'} another partner, or "
            f"none (at most {100.0 * MAX_EXCHANGED:g} % is allowed)"
        )
    if unlike:
        mac = range_text([mode.mac or 0.0 for mode in unlike], ".2f")
        reasons.append(
            f"{_subject(unlike, lost)} {'differs' if len(unlike) == 1 else 'differ'} in shape: the median MAC is "
            f"{mac} (at least {MIN_MAC:g} is needed)"
        )
    return f"{_modes_in_words(lost)} cannot be followed: {'; '.join(reasons)}"


def _subject(some: Sequence[ModeChange], lost: Sequence[ModeChange]) -> str:
    """Return those modes for which a reason holds: a pronoun if it holds for all."""
    if len(some) < len(lost):
        return _modes_in_words(some)
    return "it" if len(lost) == 1 else "they"


def _modes_in_words(modes: Sequence[ModeChange]) -> str:
    """Return some modes by their numbers."""
    return f"{'mode' if len(modes) == 1 else 'modes'} {joined([str(mode.mode) for mode in modes])}"


def compare_frequencies(
    first: Model, second: Model, poses: Array, drives: str | None = None
) -> FrequencyChanges:
    """Evaluate two robots at the same poses and pair their modes at each of them.

    The pairs are those with the largest sum of MAC, so a mode keeps its partner where frequencies cross or veer; but
    modes with a MAC below `MIN_MAC_OF_PAIR` are none.

    - poses: where a robot cannot be evaluated, it is left out, (N, d)
    - drives: as for `pkmodes.Model.modes`; by default as both robot files say, free where these differ

    Raises PoseError if there is no pose that both can reach.
    Raises PkmodesError if their mechanisms differ.
    """
    check_one_mechanism(first.robot, second.robot)
    drives = _drives_of_both(first.robot, second.robot, drives)
    parts = []
    for start in range(0, len(poses), CHUNK_POSES):
        report_progress(f"{start:,} of {len(poses):,} poses of the two robots")
        parts.append(_compare_at(first, second, poses[start : start + CHUNK_POSES], drives))
    modes = second.modes(poses[:1], "nan", fields=("frequencies",), drives=drives)
    count = modes.frequencies.shape[-1] - modes.rigid_modes
    first_valid, second_valid, *mode_arrays = (
        np.concatenate(columns) for columns in zip(*parts, strict=True)
    )
    frequencies, relative, partner, mac = mode_arrays
    changes = FrequencyChanges(
        poses, first_valid, second_valid, frequencies, relative, partner, mac, second_modes=count
    )
    if not changes.counts.both:
        problem = f"expected poses that both robots can reach, found none among {len(poses):,}"
        raise PoseError(problem, "poses", "give poses in the workspaces of both")
    return changes


def _drives_of_both(first: Robot, second: Robot, drives: str | None) -> str:
    """Return what the motors of both do: as requested, else as both robot files say; free where these differ."""
    if drives is None and first.drives != second.drives:
        return FREE
    return first.resolve_drives(drives)


def mode_changes(changes: FrequencyChanges) -> tuple[ModeChange, ...]:
    """Return the distribution of each mode's difference over the poses at which it has its most frequent partner."""
    modes, shared_pose_count = [], changes.counts.both
    for mode in range(changes.modes):
        partners = changes.partner[changes.partner[:, mode] >= 0, mode]
        if not len(partners):
            modes.append(ModeChange(mode + 1, 0, None, None, None, None, None, None))
            continue
        most_frequent = int(np.bincount(partners).argmax())
        paired = changes.partner[:, mode] == most_frequent
        relative = changes.relative[paired, mode]
        low, high = np.quantile(relative, RANGE_QUANTILES)
        modes.append(
            ModeChange(
                mode + 1,
                int(paired.sum()),
                float(np.median(relative)),
                float(low),
                float(high),
                most_frequent + 1,
                float(1.0 - paired.sum() / shared_pose_count),
                float(np.median(changes.mac[paired, mode])),
            )
        )
    return tuple(modes)


def _compare_at(first: Model, second: Model, poses: Array, drives: str) -> tuple[NDArray[Any], ...]:
    """Return the arrays of `FrequencyChanges` at some poses, except the poses themselves."""
    fields = ("frequencies", "shapes")
    first_modes, second_modes = (
        model.modes(poses, "nan", fields=fields, drives=drives) for model in (first, second)
    )
    valid = tuple(np.asarray(modes.valid, dtype=bool) for modes in (first_modes, second_modes))
    f, g = (modes.frequencies[:, modes.rigid_modes :] for modes in (first_modes, second_modes))
    relative, mac = np.full(f.shape, np.nan), np.full(f.shape, np.nan)
    partner = np.full(f.shape, -1, dtype=np.intp)
    shared_indices = np.flatnonzero(valid[0] & valid[1])
    if len(shared_indices):
        common = [name for name in first_modes.coordinates if name in second_modes.coordinates]
        phi, psi = (
            modes.shapes[shared_indices][:, modes.rigid_modes :][
                ..., [modes.coordinates.index(name) for name in common]
            ]
            for modes in (first_modes, second_modes)
        )
        common_indices = [first.coordinates.index(name) for name in common]
        mass = first.matrices(poses[shared_indices], "nan")[0][:, common_indices][:, :, common_indices]
        norm = np.sqrt(((phi @ mass) * phi).sum(axis=-1, keepdims=True))
        phi = phi / np.where(norm > 0.0, norm, 1.0)  # a part of a shape is not mass-normalised
        mac_tables = mass_weighted_mac(phi @ mass @ np.swapaxes(psi, 1, 2), psi, mass)
        for row, mac_table in zip(shared_indices, mac_tables, strict=True):
            # One to one, with the largest sum of MAC.
            modes, partners = np.arange(len(mac_table)), mac_table.argmax(axis=1)
            if len(np.unique(partners)) < len(partners):
                modes, partners = linear_sum_assignment(mac_table, maximize=True)
            is_pair = mac_table[modes, partners] >= MIN_MAC_OF_PAIR
            modes, partners = modes[is_pair], partners[is_pair]
            partner[row, modes] = partners
            relative[row, modes] = g[row, partners] / f[row, modes] - 1.0
            mac[row, modes] = mac_table[modes, partners]
    return *valid, f, relative, partner, mac
