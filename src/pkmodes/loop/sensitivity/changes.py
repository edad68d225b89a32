"""Changes of the frequencies at a pose for a small change of each quantity: by one per cent, or by one sigma.

The changes are derivatives times the step, exact to first order; a decrease changes the frequencies by as much as an
increase, in the other direction.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np
from numpy.typing import ArrayLike, NDArray

from pkmodes.core.base.errors import PkmodesError
from pkmodes.core.model import Model
from pkmodes.loop.sensitivity.alike import TIE_FRACTION
from pkmodes.loop.sensitivity.paths import resolve_all
from pkmodes.loop.sensitivity.relative import equivalent_around, rates_of, scalable_quantities
from pkmodes.loop.sensitivity.spread import frequency_sigmas, stated_sigmas

Array = NDArray[np.float64]
#: By how much each quantity changes: one per cent of its value, or the standard deviation that the robot file states.
PERCENT, SIGMA = "percent", "sigma"
#: Note on the standard deviation from all quantities where the robot file has tables of correlations.
CORRELATED = (
    "with the [[covariance]] of the robot file, so that it may be less than what one value does alone"
)
#: Changes below this fraction of a frequency are rounding.
ROUNDING = 1e-11


def coinciding(groups: Sequence[int], rigid: int, quantity: str) -> list[str]:
    """Return a sentence on each group of coinciding modes of vibration, and on the meaning of their numbers.

    - groups: a number for each mode, the same for the members of a group
    - rigid: number of rigid-body modes, which come first
    - quantity: what the numbers are: derivatives, or changes
    """
    by_group = dict[int, list[str]]()
    for number, group in enumerate(groups[rigid:], start=1):
        by_group.setdefault(group, []).append(str(number))
    return [
        f"modes {', '.join(members)} coincide: the {quantity} are those of the branches into which they split, in "
        "ascending order"
        for members in by_group.values()
        if len(members) > 1
    ]


@dataclass(frozen=True, eq=False)
class Changes:
    """Changes of m frequencies of vibration at a pose, for T quantities.

    - by: by how much each quantity changes, "percent" or "sigma"
    - paths: of each quantity, length T; several where they act as one
    - names: the same as they are shown, length T: ``1/...`` for one that acts like the reciprocal
    - frequencies: in Hz, (m,)
    - changes: for a rise of each quantity, (T, m) [Hz]
    - combined: by sigma, (m,): the standard deviation of each frequency, from all quantities [Hz]
    """

    by: str
    paths: tuple[tuple[str, ...], ...]
    names: tuple[tuple[str, ...], ...]
    frequencies: Array
    changes: Array
    combined: Array | None

    def largest(self, mode: int, limit: int | None = None) -> list[int]:
        """Return the quantities that change a mode (counted from 0), the largest change first."""
        size = np.abs(self.changes[:, mode])
        has_effect = size > ROUNDING * abs(self.frequencies[mode])
        # Equal to six digits counts as equal: rounding does not order them.
        rounded = [float(f"{value:.6g}") for value in size.tolist()]
        order = sorted(np.flatnonzero(has_effect).tolist(), key=lambda i: -rounded[i])
        return order[:limit]

    def largest_of_all(self, limit: int | None = None) -> list[int]:
        """Return the quantities by their largest relative change in any mode."""
        size = np.nanmax(np.abs(self.changes / self.frequencies), axis=1, initial=0.0)
        rounded = [float(f"{value:.6g}") for value in size.tolist()]
        order = sorted(np.flatnonzero(size > ROUNDING).tolist(), key=lambda i: -rounded[i])
        return order[:limit]

    def strongest(self) -> list[tuple[int, list[int]]]:
        """Return the quantities with the largest relative change of any frequency, and the modes with that change.

        Changes within `TIE_FRACTION` of the largest count as equal; modes are counted from 0.
        """
        relative = np.nan_to_num(np.abs(self.changes / self.frequencies))
        is_largest = relative >= max((1.0 - TIE_FRACTION) * relative.max(initial=0.0), ROUNDING)
        return [
            (i, np.flatnonzero(is_largest[i]).tolist()) for i in self.largest_of_all() if is_largest[i].any()
        ]


def changes_at(
    model: Model, pose: ArrayLike, drives: str, by: str = PERCENT, paths: Sequence[str] | None = None
) -> Changes:
    """Compute the changes of the frequencies of vibration for a step of each quantity.

    - pose: in SI units, (d,)
    - by: by sigma, only the quantities with a standard deviation count, "percent" or "sigma"
    - paths: quantities to change by one per cent, none of them 0; by default those of which a per cent means
      something

    Raises PkmodesError if `by` is neither word, or the robot file states no standard deviation.
    """
    rigid = model.solved(drives).rigid_modes
    if by == PERCENT:
        candidates, combined_sigmas = scalable_quantities(model.robot) if paths is None else list(paths), None
        alike_groups = equivalent_around(model, pose, candidates, drives)
        members = tuple(tuple(candidates[i] for i in group.members) for group in alike_groups)
        names = tuple(tuple(group.names(candidates)) for group in alike_groups)
        first_paths = resolve_all(model.robot, [group[0] for group in members])
        steps = [0.01 * path.value for path in first_paths]
    elif by == SIGMA:
        combined_sigmas = frequency_sigmas(model, pose, drives=drives)[rigid:]
        sigmas = stated_sigmas(model.robot)
        steps = list(sigmas.values())
        names = members = tuple((path,) for path in sigmas)
    else:
        raise PkmodesError(
            f'expected "{PERCENT}" or "{SIGMA}", found {by!r}', "by", f'for example: by="{SIGMA}"'
        )
    rates = rates_of(model, pose, [group[0] for group in members], drives, "raise")[:, rigid:]
    frequencies = model.frequencies(pose, drives=drives)[rigid:]
    return Changes(by, members, names, frequencies, rates * np.array(steps)[:, None], combined_sigmas)
