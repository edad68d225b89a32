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
from pkmodes.core.model import Model
from pkmodes.core.support.documents import Count, Document, Number, Probability
from pkmodes.core.support.mac import mass_weighted_mac
from pkmodes.core.support.progress import say
from pkmodes.loop.robot_files.differences import (
    ChoiceDifference,
    ValueDifference,
    check_one_mechanism,
    differences,
)

Array = NDArray[np.float64]
#: Poses evaluated at once.
CHUNK = 4096
#: Quantiles over the poses that end the range given for each mode.
ENDS = (0.02, 0.98)
#: A mode is comparable if its partner differs at no more than this share of the poses, and the median MAC of the
#: pairs is at least this.
EXCHANGED, LIKE = 0.1, 0.8
#: Smaller relative differences of a frequency count as none.
NOTHING = 5e-5


@dataclass(frozen=True, eq=False)
class FrequencyChanges:
    """The frequencies of two robots at N poses; m vibration modes of the first, m' of the second.

    - poses: (N, d)
    - first, second: where each can be evaluated, (N,)
    - frequencies: of the first robot, (N, m) [Hz]; NaN where it cannot be evaluated
    - relative: frequency of the partner over that of the mode, minus 1, (N, m); NaN where there is no partner
    - partner: index among the vibration modes of the second robot, -1 for none, (N, m)
    - mac: of the two shapes, by the mass matrix of the first robot at the coordinates that both have, (N, m)
    - second_modes: the number m'
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
    def counts(self) -> PoseCounts:
        """How many poses both robots reach, one of them only, or none."""
        return PoseCounts(
            both=int((self.first & self.second).sum()),
            first_only=int((self.first & ~self.second).sum()),
            second_only=int((self.second & ~self.first).sum()),
            none=int((~self.first & ~self.second).sum()),
        )


class ModeChange(Document, frozen=True):
    """The relative difference of a frequency over the poses that both robots reach."""

    mode: Annotated[
        Number, Meta(description="Number by frequency in the first robot: 1 is its first vibration mode.")
    ]
    poses: Annotated[Count, Meta(description="Poses at which it has a partner in the second robot.")]
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
        Probability | None, Meta(description="Share of the poses at which the partner has another number.")
    ]
    mac: Annotated[float | None, Meta(description="Median modal assurance criterion of the pairs.")]

    @property
    def comparable(self) -> bool:
        """Whether it is one mode of the second robot, so that its difference is that of one motion."""
        return (
            self.exchanged is not None
            and self.mac is not None
            and self.exchanged <= EXCHANGED
            and self.mac >= LIKE
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


def compare_robots(first: Model, second: Model, poses: Array, drives: str = FREE) -> RobotsCompared:
    """Compare two robots by what their files declare, and by their frequencies over poses.

    Parameters, and errors raised, are those of `compare_frequencies`.
    """
    declared = differences(first.robot, second.robot)
    changes = compare_frequencies(first, second, poses, drives)
    modes = mode_changes(changes)
    notes = [sentence] if (sentence := exchanging(modes)) else []
    surplus = changes.second_modes - changes.modes
    if surplus:
        has = "second" if surplus > 0 else "first"
        noun = "mode" if abs(surplus) == 1 else "modes"
        notes.append(
            f"the {has} robot has {abs(surplus)} {noun} of vibration more, without partners at each pose"
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


def largest_difference(modes: Sequence[ModeChange]) -> str:
    """Return the largest difference of a mode that can be compared, as a sentence without a stop."""
    comparable = [mode for mode in modes if mode.comparable]
    if not comparable:
        return "No mode of the first robot corresponds to the same mode of the second at all poses"
    of = "" if len(comparable) == len(modes) else " of the modes that can be compared"
    largest = max(comparable, key=lambda mode: abs(mode.median or 0.0))
    if abs(largest.median or 0.0) < NOTHING:
        return f"No frequency{of} changes"
    first = f"Mode {largest.mode} changes most{',' if of else ''}{of}"
    return f"{first}: {100.0 * (largest.median or 0.0):+.2f} % in the median"


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

    - poses: where a robot cannot be evaluated, it is left out, (N, d)
    - drives: as for `pkmodes.Model.modes`

    Raises PoseError if there is no pose that both can reach.
    Raises PkmodesError if their mechanisms differ.
    """
    check_one_mechanism(first.robot, second.robot)
    parts = []
    for start in range(0, len(poses), CHUNK):
        say(f"{start:,} of {len(poses):,} poses of the two robots")
        parts.append(_at(first, second, poses[start : start + CHUNK], drives))
    modes = second.modes(poses[:1], "nan", fields=("frequencies",), drives=drives)
    count = modes.frequencies.shape[-1] - modes.rigid_modes
    reached, also, *rest = (np.concatenate(columns) for columns in zip(*parts, strict=True))
    frequencies, relative, partner, mac = rest
    changes = FrequencyChanges(poses, reached, also, frequencies, relative, partner, mac, second_modes=count)
    if not changes.counts.both:
        problem = f"expected poses that both robots can reach, found none among {len(poses):,}"
        raise PoseError(problem, "poses", "give poses in the workspaces of both")
    return changes


def mode_changes(changes: FrequencyChanges) -> tuple[ModeChange, ...]:
    """Return the distribution of each mode's difference over the poses."""
    modes = []
    for mode in range(changes.modes):
        paired = np.isfinite(changes.relative[:, mode])
        if not paired.any():
            modes.append(ModeChange(mode + 1, 0, None, None, None, None, None, None))
            continue
        relative, partner = changes.relative[paired, mode], changes.partner[paired, mode]
        dominant = int(np.bincount(partner).argmax())
        low, high = np.quantile(relative, ENDS)
        modes.append(
            ModeChange(
                mode + 1,
                int(paired.sum()),
                float(np.median(relative)),
                float(low),
                float(high),
                dominant + 1,
                float((partner != dominant).mean()),
                float(np.median(changes.mac[paired, mode])),
            )
        )
    return tuple(modes)


def _at(first: Model, second: Model, poses: Array, drives: str) -> tuple[NDArray[Any], ...]:
    """Return the arrays of `FrequencyChanges` at some poses, but for the last."""
    fields = ("frequencies", "shapes")
    ours, theirs = (model.modes(poses, "nan", fields=fields, drives=drives) for model in (first, second))
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
        size = np.sqrt(((phi @ mass) * phi).sum(axis=-1, keepdims=True))
        phi = phi / np.where(size > 0.0, size, 1.0)  # a part of a shape is not mass-normalised
        likeness = mass_weighted_mac(phi @ mass @ np.swapaxes(psi, 1, 2), psi, mass)
        for row, table in zip(both, likeness, strict=True):
            # One to one, with the largest sum of MAC.
            mine, partners = np.arange(len(table)), table.argmax(axis=1)
            if len(np.unique(partners)) < len(partners):
                mine, partners = linear_sum_assignment(table, maximize=True)
            partner[row, mine] = partners
            relative[row, mine] = g[row, partners] / f[row, mine] - 1.0
            mac[row, mine] = table[mine, partners]
    return *reached, f, relative, partner, mac
