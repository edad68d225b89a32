r"""Measured modes as those that shapers are chosen for: each alone, at each pose, anywhere within its errors.

A table of modes does not say how much each takes part in a movement.  So each counts in full: what a shaper leaves of
all of them together, whatever their shares, never exceeds what it leaves of the one of which it leaves most,
:math:`\sqrt{\sum w_i^2 v_i^2} \le \max v_i \sqrt{\sum w_i^2}`.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, field
from typing import Annotated

import numpy as np
from msgspec import Meta
from numpy.typing import NDArray

from pkmodes.core.base.arguments import POSITIVE_INTEGER, Constraint, check_argument, is_number
from pkmodes.core.base.drives import HELD, motors_text
from pkmodes.core.base.errors import MeasurementError
from pkmodes.core.base.numbers import plain
from pkmodes.core.support.documents import Document, Size
from pkmodes.loop.measured.measurements import Measurements
from pkmodes.machine.shaping.choice import TICK, choose, default_kinds
from pkmodes.machine.shaping.results import GOOD_ENOUGH_SHARE, Candidate, Choice
from pkmodes.machine.shaping.ringing import DEFAULT_MODES, Ringing

Array = NDArray[np.float64]
#: Standard deviations within which frequency and damping ratio are varied, and the points evaluated: frequencies with
#: the smallest and the largest ratio, and last the mode as measured.
SIGMA_RANGE = 2.0
FREQUENCY_OFFSETS = np.repeat(np.linspace(-SIGMA_RANGE, SIGMA_RANGE, 5), 2)
RATIO_OFFSETS = np.tile([-SIGMA_RANGE, SIGMA_RANGE], 5)
OFFSETS = np.array([[*FREQUENCY_OFFSETS, 0.0], [*RATIO_OFFSETS, 0.0]])
#: Smallest and largest damping ratio assumed for a mode without one, and the largest for any mode: above it, none
#: oscillates.
UNKNOWN_RATIO_RANGE, MAX_RATIO = (0.0, 0.1), 0.99
RATIO = Constraint("a damping ratio from 0 to below 1", lambda value: is_number(value) and 0.0 <= value < 1.0)


class LeftOfModes(Document, frozen=True):
    """What a shaper leaves of measured modes, each relative to no shaper."""

    rms: Annotated[Size, Meta(description="Root mean square over the modes as measured.")]
    worst: Annotated[Size, Meta(description="Largest value of a mode as measured.")]
    worst_uncertain: Annotated[
        Size,
        Meta(
            description="Largest value of a mode with its frequency and damping ratio anywhere within two standard "
            "deviations: the one that decides."
        ),
    ]


@dataclass(frozen=True, eq=False)
class MeasuredRinging(Ringing):
    """R measured modes, each at K points within its errors and treated by itself: N = R K poses of one mode.

    - data: the table
    - rows: rows that count, (R,)
    - assumed: damping ratio of the modes without one; None: anything within `UNKNOWN_RATIO_RANGE`
    """

    data: Measurements = field(kw_only=True)
    rows: NDArray[np.intp] = field(kw_only=True)
    assumed: float | None = field(kw_only=True)

    @property
    def modes(self) -> int:
        """The largest number of modes at a pose."""
        return int(np.bincount(self.data.pose[self.rows]).max())

    @property
    def known_between(self) -> bool:
        """No: a table only has its own poses."""
        return False

    @property
    def share_of(self) -> str:
        """What the largest remaining vibration is a share of, in words."""
        return f"of the worst measured mode within {SIGMA_RANGE:g} standard deviations"

    def left_of(self, candidate: Candidate) -> tuple[Array, Array]:
        """Return what a shaper leaves of each mode as measured, and the most within its errors, (R,) each."""
        by_mode = candidate.left_at.reshape(len(self.rows), -1)
        return by_mode[:, -1], by_mode.max(axis=1)

    def shares(self, candidate: Candidate) -> LeftOfModes:
        """Return what a shaper leaves of all modes."""
        nominal, largest = self.left_of(candidate)
        return LeftOfModes(
            rms=float(np.sqrt(np.mean(nominal**2))),
            worst=float(nominal.max()),
            worst_uncertain=float(largest.max()),
        )

    def notes(self, designed_for: str = "none") -> list[str]:
        """Return notes on these modes for the reader.

        - designed_for: the damping ratio of the designs where no mode has any, in words
        """
        notes, data = [], self.data
        if self.left_out:
            are = "pose is" if self.left_out == 1 else "poses are"
            notes.append(
                f"{self.left_out} {are} left out: motors turned freely there, and a machine stops with held ones"
            )
        if self.drives != HELD:
            notes.append(
                "the table does not say that motors were held: a machine whose motors turned freely in the test "
                "rings in other modes at work; a printer's steppers hold in both"
            )
        unknown = int(np.isnan(data.damping[self.rows]).sum())
        if unknown:
            subject = (
                "no mode has" if unknown == len(self.rows) else f"{unknown} of {len(self.rows)} modes lack"
            )
            low, high = (100.0 * ratio for ratio in UNKNOWN_RATIO_RANGE)
            substitute = f"{plain(100.0 * (self.assumed or 0.0), 3)} % is taken instead, by --damping"
            if self.assumed is None:
                substitute = (
                    f"whichever from {low:g} to {high:g} % leaves most counts instead (--damping gives one)"
                )
            notes.append(f"{subject} a damping ratio: {substitute}")
        if not self.damping_ratios.any():
            notes.append(
                f"no mode has damping: shapers are designed for {designed_for}; --damping gives a ratio"
            )
        return notes


def measured_ringing(
    data: Measurements, modes: int | None = None, damping: float | None = None
) -> MeasuredRinging:
    """Return the modes of a table as those that shapers are chosen for.

    Where motors were held at some poses and free at others, those of held motors count.

    - data: with a standard deviation of each frequency
    - modes: how many modes count at each pose, the lowest; by default all
    - damping: damping ratio of the modes without one; by default anything from 0 to 10 %

    Raises PkmodesError if an argument is invalid.
    Raises MeasurementError if the table has no modes.
    """
    if modes is not None:
        check_argument(modes, POSITIVE_INTEGER, "modes", "for example: 3")
    if damping is not None:
        check_argument(damping, RATIO, "damping", "for example: 0.05")
    if not len(data.pose):
        raise MeasurementError("expected measured modes, found none", data.source, "give a row for each mode")
    held_mask = np.array([drives == HELD for drives in data.drives])
    counted_mask = held_mask if held_mask.any() else np.ones(len(held_mask), bool)
    order = np.lexsort((data.frequency, data.pose))
    rank = np.concatenate([np.arange(n) for n in np.bincount(data.pose)])
    counts = counted_mask[data.pose[order]] & (rank < (len(rank) if modes is None else modes))
    rows = np.sort(order[counts])
    f, sigma, zeta = data.frequency[rows], data.sigma[rows], data.damping[rows]
    smallest, largest = UNKNOWN_RATIO_RANGE if damping is None else (damping, damping)
    middle, half_range = 0.5 * (smallest + largest), 0.5 * (largest - smallest) / SIGMA_RANGE
    has_ratio = np.isfinite(zeta)
    ratios = np.where(has_ratio, zeta, middle)
    spread = np.where(has_ratio, data.damping_sigma[rows], half_range)
    frequency_offsets, ratio_offsets = OFFSETS
    varied_frequencies = f[:, None] * np.exp(frequency_offsets * (sigma / f)[:, None])
    varied_ratios = np.clip(ratios[:, None] + ratio_offsets * spread[:, None], 0.0, MAX_RATIO)
    point_count = varied_frequencies.size
    return MeasuredRinging(
        np.repeat(data.points[data.pose[rows]], varied_frequencies.shape[1], axis=0),
        varied_frequencies.reshape(point_count, 1),
        varied_ratios.reshape(point_count, 1),
        np.ones((point_count, 1)),
        None,
        int(np.count_nonzero(~counted_mask)),
        drives=data.drives[data.pose[rows[0]]],
        motors=motors_text([data.drives[data.pose[rows[0]]]]),
        data=data,
        rows=rows,
        assumed=damping,
    )


def of_measured(choice: Choice) -> MeasuredRinging:
    """Return the modes of a choice that `measured_shapers` made.

    Raises TypeError if they are those of a robot.
    """
    if not isinstance(choice.ringing, MeasuredRinging):
        raise TypeError("expected a choice for measured modes")
    return choice.ringing


def measured_shapers(
    data: Measurements,
    kinds: Sequence[str] | None = None,
    *,
    modes: int | None = None,
    damping: float | None = None,
    left: float = GOOD_ENOUGH_SHARE,
    length: float | None = None,
    tick: float = TICK,
    firmware: str | None = None,
) -> Choice:
    """Compare fixed shapers for the modes in a table.

    - data: such as `pkmodes.updating.read` reads
    - kinds: by default all for one mode, and products of zv for up to three modes
    - modes: how many modes count at each pose, the lowest; by default all
    - damping: damping ratio of the modes without one; by default anything from 0 to 10 %
    - left: share that the recommended shaper may leave of each mode, within two standard deviations of its frequency
      and damping ratio
    - length, tick, firmware: as for `pkmodes.Model.shapers`

    ``ringing`` is a `MeasuredRinging`; ``left.worst`` of a candidate is what it leaves at most of any mode within two
    standard deviations.
    Raises PkmodesError if an argument is invalid, no shaper is long or short enough, or the firmware has none of
    them.
    Raises MeasurementError if the table has no modes.
    """
    ringing = measured_ringing(data, modes, damping)
    compared_kinds = default_kinds(min(ringing.modes, DEFAULT_MODES)) if kinds is None else kinds
    return choose(ringing, compared_kinds, left=left, length=length, tick=tick, firmware=firmware)
