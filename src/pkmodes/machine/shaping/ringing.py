"""How a machine in use rings: the lowest modes, and how much each moves the platform.

Its motors are held, or give way on the springs that the robot file has for them.  It is evaluated at operating
points: at poses or, if parameters such as a payload take several values in use, at the poses of each setting of them.
"""

from __future__ import annotations

from collections.abc import Collection, Mapping, Sequence
from dataclasses import dataclass, replace
from functools import cached_property
from typing import Any

import numpy as np
from numpy.typing import ArrayLike, NDArray

from pkmodes.core.base.arguments import POSITIVE_INTEGER, check_argument
from pkmodes.core.base.drives import HELD, motors_text
from pkmodes.core.base.errors import PkmodesError, PoseError
from pkmodes.core.model import Model
from pkmodes.core.solve.backends import AUTO
from pkmodes.core.support.motors import drives_in_use, motors_give_way, motors_in_words
from pkmodes.core.support.progress import report_progress
from pkmodes.core.system.evaluation import number_of_modes
from pkmodes.loop.sensitivity.spread import spread_of
from pkmodes.machine.shaping.settings import Setting, setting_combinations

Array = NDArray[np.float64]
#: Default number of modes considered, the lowest ones.
DEFAULT_MODES = 3
#: Ratio of the largest to the median amplitude above which a few poses decide everything.
MAX_WORST_TO_MEDIAN = 20.0
#: A mode that a step along another axis excites less than this, relative to its own axis, belongs to its own.
MAX_CROSS_AXIS_RATIO = 1e-6
#: Relative difference below which frequencies count as equal.
FREQUENCY_TOLERANCE = 1e-9
#: Points and weights of the average over a normal distribution (Gauss-Hermite quadrature): exact for polynomials up
#: to degree 17, and accurate to 1e-3 for the vibration that shapers leave.
QUADRATURE_POINTS, QUADRATURE_WEIGHTS = (np.array(column) for column in np.polynomial.hermite_e.hermegauss(9))


@dataclass(frozen=True, eq=False)
class Ringing:
    """The lowest m modes of a machine in use at N poses, or at N operating points: poses of settings.

    Attributes
    ----------
    poses : ndarray, shape (N, d)
        Poses that can be evaluated and at which all these modes oscillate.
    frequencies, damping_ratios : ndarray, shape (N, m)
        Frequencies [Hz] and damping ratios [-].
    weights : ndarray, shape (N, m)
        Amplitude of the platform in each mode after a step of its acceleration by 1 m/s^2: the root of the sum of
        squares over the directions of the step [s^2].
    steps : ndarray, shape (N, m, k), or None
        The same for a step along each axis [s^2]; None where the axes are unknown.
    axes : tuple of str
        Their names, k of them.
    modes_of_all : int
        For one of several axes, how many modes count for all of them together; else 0.
    spread : ndarray, shape (N, m), or None
        Relative standard deviations of the frequencies, from those in the robot file; None where it has none.
    left_out : int
        Poses that were given but cannot be evaluated, or at which a mode does not oscillate.
    settings : tuple of Setting
        Empty where the robot is as its file says.
    setting : ndarray of int, shape (N,), or None
        Index of the setting of each operating point; None without settings.
    drives : {"free", "held"}
        What the motors do: held, or free against springs.
    motors : str
        The same in words.
    """

    poses: Array
    frequencies: Array
    damping_ratios: Array
    weights: Array
    spread: Array | None
    left_out: int
    settings: tuple[Setting, ...] = ()
    setting: NDArray[np.intp] | None = None
    drives: str = HELD
    motors: str = motors_text([HELD])
    steps: Array | None = None
    axes: tuple[str, ...] = ()
    modes_of_all: int = 0

    @cached_property
    def unshaped(self) -> Array:
        """Amplitude of all modes together without a shaper [s^2], (N,)."""
        return np.asarray(np.linalg.norm(self.weights, axis=-1))

    def shaped(self, remaining: Array) -> Array:
        """Return the same with a shaper that leaves some of each mode, (N, m), as (N,) [s^2]."""
        return np.asarray(np.linalg.norm(self.weights * remaining, axis=-1))

    @property
    def modes(self) -> int:
        """How many modes a shaper may have factors for."""
        return int(self.frequencies.shape[1])

    @property
    def counted(self) -> int:
        """How many of the lowest modes of the machine count at each pose, for all axes together."""
        return self.modes_of_all or self.modes

    @property
    def known_between(self) -> bool:
        """Whether shapers can be designed for any pose, so that they may follow it."""
        return True

    @property
    def share_of(self) -> str:
        """What the largest remaining vibration is a share of, in words."""
        return "of the largest vibration"

    @property
    def point_is(self) -> str:
        """What distinguishes operating points: their pose, and their setting where there are several."""
        return "pose and setting" if len(self.settings) > 1 else "pose"

    @property
    def points_are(self) -> str:
        """The same in the plural."""
        return "poses and settings" if len(self.settings) > 1 else "poses"

    def setting_of(self, point: int) -> Setting | None:
        """Return the setting of an operating point; None without settings."""
        return None if self.setting is None else self.settings[self.setting[point]]

    def only(self, setting: int) -> Ringing:
        """Return the part at one of the settings."""
        mask = self.setting == setting
        return replace(
            self,
            poses=self.poses[mask],
            frequencies=self.frequencies[mask],
            damping_ratios=self.damping_ratios[mask],
            weights=self.weights[mask],
            spread=None if self.spread is None else self.spread[mask],
            left_out=0,
            settings=(self.settings[setting],),
            setting=np.zeros(int(np.count_nonzero(mask)), dtype=np.intp),
            steps=None if self.steps is None else self.steps[mask],
        )

    def by_axis(self) -> dict[str, Ringing]:
        """Return the modes that a step along each axis excites, by its name, where the axes are independent.

        They are if no mode answers to steps along two of them, as where each axis has its own belt: then a shaper for
        one axis does nothing to the modes of another one.  Where a pose has fewer modes of an axis than another pose,
        the missing ones have no weight.  Empty if the axes are not independent, or one of them has no mode.
        """
        if self.steps is None or len(self.axes) < 2 or not self.steps.any():
            return {}
        ascending = np.sort(self.steps, axis=-1)
        if (ascending[..., -2] > MAX_CROSS_AXIS_RATIO * ascending[..., -1]).any():
            return {}
        excited = ascending[..., -1] > MAX_CROSS_AXIS_RATIO * ascending[..., -1].max(axis=-1, keepdims=True)
        axis_of_mode = self.steps.argmax(axis=-1)
        parts = {name: self._of_axis(k, excited & (axis_of_mode == k)) for k, name in enumerate(self.axes)}
        return (
            {} if None in parts.values() else {name: part for name, part in parts.items() if part is not None}
        )

    def _of_axis(self, axis: int, mode_mask: NDArray[np.bool_]) -> Ringing | None:
        """Return the modes of an axis; None if a setting has no pose with any.

        - mode_mask: which modes these are, (N, m)
        """
        pose_mask = mode_mask.any(axis=1)
        if not pose_mask.any() or (
            self.setting is not None and len(set(self.setting[pose_mask])) < len(self.settings)
        ):
            return None
        mode_mask = mode_mask[pose_mask]
        order = np.argsort(~mode_mask, axis=1, kind="stable")[:, : int(mode_mask.sum(axis=1).max())]
        present = np.take_along_axis(mode_mask, order, 1)
        order = np.where(present, order, order[:, :1])

        def select_modes(values: Array) -> Array:
            return np.asarray(np.take_along_axis(values[pose_mask], order, 1))

        assert self.steps is not None
        return replace(
            self,
            poses=self.poses[pose_mask],
            frequencies=select_modes(self.frequencies),
            damping_ratios=select_modes(self.damping_ratios),
            weights=np.where(present, select_modes(self.steps[..., axis]), 0.0),
            spread=None if self.spread is None else select_modes(self.spread),
            setting=None if self.setting is None else self.setting[pose_mask],
            steps=None,
            axes=(self.axes[axis],),
            modes_of_all=self.modes,
        )

    @property
    def changes_with_settings(self) -> bool:
        """Whether a frequency differs between the settings."""
        parts = [self.only(i).frequencies for i in range(len(self.settings))]
        return len(parts) > 1 and not all(
            part.shape == parts[0].shape and np.allclose(part, parts[0], FREQUENCY_TOLERANCE, 0.0)
            for part in parts
        )

    def notes(self, designed_for: str = "none") -> list[str]:
        """Return notes on these modes for the reader.

        - designed_for: the damping ratio of the designs where the machine has none, in words
        """
        notes = []
        if self.left_out:
            are = "pose is" if self.left_out == 1 else "poses are"
            counting = ", counted at each setting" if len(self.settings) > 1 else ""
            notes.append(
                f"{self.left_out} {are} left out{counting}: not reachable, or a mode does not oscillate there"
            )
        if len(self.settings) > 1 and not self.changes_with_settings:
            notes.append(
                f"no frequency changes with the settings: {' and '.join(self.settings[0].values)} cannot be "
                "seen in the modes that count"
            )
        worst_to_median = float(self.unshaped.max() / np.median(self.unshaped))
        if worst_to_median > MAX_WORST_TO_MEDIAN:
            notes.append(
                f"the machine rings {worst_to_median:.0f} times as much at the worst {self.point_is} as at half of "
                "them: poses near singular ones decide; give the part of the workspace that is used, as a "
                "grid or as [usable] in the robot file"
            )
        if not self.damping_ratios.any():
            notes.append(
                f"the robot file has no damping: shapers are designed for {designed_for}; see [damping]"
            )
        return notes

    @property
    def mean_ratio(self) -> float:
        """Damping ratio of all modes and poses, weighted by their squared amplitudes."""
        return float(np.average(self.damping_ratios, weights=self.weights**2))

    def at_spread(self) -> list[tuple[float, Array]]:
        """Return frequencies offset from the declared ones according to their standard deviations, (N, m).

        Each comes with its share of the average over all of them; empty without standard deviations.
        """
        if self.spread is None:
            return []
        shares = QUADRATURE_WEIGHTS / QUADRATURE_WEIGHTS.sum()
        return [
            (float(w), self.frequencies * np.exp(x * self.spread))
            for x, w in zip(QUADRATURE_POINTS, shares, strict=True)
        ]


def evaluate_ringing(
    model: Model,
    poses: ArrayLike,
    modes: int | None = None,
    settings: Mapping[str, Any] | None = None,
    drives: str | None = None,
) -> Ringing:
    """Evaluate the modes of a machine in use.

    - poses: those that cannot be evaluated, or at which a mode does not oscillate, are left out, (..., d)
    - modes: how many modes count, the lowest; by default three, or all if there are fewer
    - settings: values of parameters in SI units, by path: the poses of every combination count
    - drives: as for `pkmodes.Model.shapers`

    Raises PkmodesError if the machine has fewer modes, or rigid ones although its motors are held; if motors that
    nothing holds are to be free, or some settings have springs on the motors and others none; or if settings are
    invalid.
    Raises RobotFileError if a robot file with a setting would be rejected.
    Raises PoseError if no pose is left.
    """
    report_progress("computing the modes of the machine in use")
    if settings is None or (isinstance(settings, Mapping) and not settings):
        drives_used = drives_in_use(model.robot, drives)
        return _at_poses(model, poses, _count(model, modes, drives_used), drives_used)
    return at_settings(model, poses, modes, setting_combinations(model, settings), drives)


def at_settings(
    model: Model, poses: ArrayLike, modes: int | None, settings: Sequence[Setting], drives: str | None
) -> Ringing:
    """Evaluate the modes at the poses of each setting: see `evaluate_ringing`."""
    models = [model.with_values(setting.values) for setting in settings]
    give_way = [motors_give_way(variant.robot) for variant in models]
    if drives != HELD and len(set(give_way)) > 1:
        sprung, unsprung = (settings[give_way.index(gives)] for gives in (True, False))
        problem = f"at {sprung} springs hold the motors, and at {unsprung} none do"
        raise PkmodesError(problem, "settings", 'give values above 0 only, or take drives="held"')
    drives_used = drives_in_use(models[0].robot, drives)
    count = min(_count(variant, modes, drives_used) for variant in models)
    parts = []
    for variant, setting in zip(models, settings, strict=True):
        try:
            parts.append(_at_poses(variant, poses, count, drives_used, fixed_paths=setting.values))
        except PoseError as error:
            raise PoseError(f"{error.what}, at {setting}", error.where, error.remedy, error.index) from None
    spread = [part.spread for part in parts if part.spread is not None]
    return Ringing(
        np.concatenate([part.poses for part in parts]),
        np.concatenate([part.frequencies for part in parts]),
        np.concatenate([part.damping_ratios for part in parts]),
        np.concatenate([part.weights for part in parts]),
        np.concatenate(spread) if len(spread) == len(parts) else None,
        sum(part.left_out for part in parts),
        tuple(settings),
        np.repeat(np.arange(len(parts)), [len(part.poses) for part in parts]),
        drives_used,
        parts[0].motors,
        np.concatenate([part.steps for part in parts if part.steps is not None]),
        parts[0].axes,
    )


def _at_poses(
    model: Model, poses: ArrayLike, count: int, drives: str, fixed_paths: Collection[str] = ()
) -> Ringing:
    """Evaluate the lowest modes at poses; frequencies are not spread by values that are known."""
    fields = ("frequencies", "damping_ratios", "vibration_amplitudes")
    checked, values = model.fields_at(poses, "nan", fields, AUTO, drives=drives)
    f, zeta, w = (
        values[name].reshape(len(checked.points), *values[name].shape[len(checked.batch) :])[:, :count]
        for name in fields
    )
    rings = np.asarray((f > 0.0).all(axis=-1) & (zeta < 1.0).all(axis=-1) & np.isfinite(w).all(axis=(-2, -1)))
    if not rings.any():
        problem = f"expected poses at which the machine can ring, found none among {len(rings)}"
        raise PoseError(
            problem, "poses", "give poses in the workspace, at which the modes that count oscillate"
        )
    points = checked.points[rings]
    sigmas = spread_of(model, points, drives, exact=fixed_paths)
    return Ringing(
        points,
        f[rings],
        zeta[rings],
        np.linalg.norm(w[rings], axis=-1),
        None if sigmas is None else np.nan_to_num(sigmas[:, :count]) / f[rings],
        int(np.count_nonzero(~rings)),
        drives=drives,
        motors=motors_in_words(model.robot, drives),
        steps=w[rings],
        axes=tuple(component.name for component in model.mechanism.pose)[: w.shape[-1]],
    )


def _count(model: Model, modes: int | None, drives: str) -> int:
    if rigid_modes := model.solved(HELD).rigid_modes:
        problem = f"with motors held the machine still has {rigid_modes} rigid modes: no shaper cancels these"
        raise PkmodesError(problem, model.robot.source, "check the drives of the mechanism")
    available = number_of_modes(model.solved(drives))
    if modes is None:
        return min(DEFAULT_MODES, available)
    check_argument(modes, POSITIVE_INTEGER, "modes", "for example: 3")
    if modes > available:
        doing = motors_in_words(model.robot, drives)
        problem = f"expected at most the {available} modes that the machine has with {doing}, found {modes}"
        raise PkmodesError(problem, "modes", f"give 1 to {available}")
    return modes
