"""Modal measurements as arrays, one row for each identified mode.

The same rules (`rules`) apply to numbers from a file and from a script, so no other module has to check again whether
a frequency is positive or a label has a single position.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, replace
from types import MappingProxyType
from typing import Any

import numpy as np
from numpy.typing import ArrayLike

from pkmodes.core.base.drives import FREE
from pkmodes.core.base.errors import MeasurementError, checked_list, shown
from pkmodes.core.robot.columns import frequency_factor
from pkmodes.core.robot.units import QuantityError
from pkmodes.loop.measured.arguments import (
    checked_array,
    checked_columns,
    checked_mode_numbers,
    drives_of_rows,
    make_read_only,
    quantity_columns,
    renamed_columns,
    repeat_for_rows,
    unknown_argument_remedy,
)
from pkmodes.loop.measured.columns import POSITION, Array, Columns, Numbers, merge_stated
from pkmodes.loop.measured.quantities import LEVEL, quantity_number_columns
from pkmodes.loop.measured.rules import (
    SET,
    SHAPE,
    BrokenRuleError,
    checked_band,
    checked_level_unit,
    drives_problems,
    level_problems,
    position_problems,
    refuse,
    repetitions,
    setting_problems,
    text_problems,
    value_problems,
)


@dataclass(frozen=True, eq=False, init=False)
class Measurements(Columns):
    """Identified modes of a machine at P poses: R rows in the order of their file, C shape channels.

    `from_rows` builds them from plain columns.  Arrays are copied and read-only.

    The attributes are those of `pkmodes.loop.measured.columns.Columns`.

    Raises
    ------
    MeasurementError
        If the arrays do not match or a number breaks a rule; the place gives line and column.
    """

    def __init__(self, *, numbers: Mapping[str, Array] = MappingProxyType({}), **columns: Any) -> None:
        # Measured quantities may also be given by name, alone or in place of those in `numbers`.
        names = [spec.argument for spec in quantity_number_columns()]
        merged = {**numbers, **{name: columns.pop(name) for name in names if name in columns}}
        if missing_names := [name for name in names if name not in merged]:
            raise TypeError(
                f"Measurements.__init__() missing measured quantities: {', '.join(missing_names)}"
            )
        super().__init__(
            numbers={name: merged[name] for name in (*names, *(n for n in merged if n not in names))},
            **columns,
        )
        self._check()

    def _check(self) -> None:
        """Convert the columns to read-only arrays of the right shape, and refuse what breaks a rule."""
        poses, rows, channels = len(self.labels), np.size(self.pose), len(self.channels)
        component_count = len(self.components)
        if not self.settings:
            object.__setattr__(self, "set_values", np.empty((poses, 0)))
        if not np.size(self.level):
            object.__setattr__(self, "level", np.full(poses, np.nan))
        if not self.drives:
            object.__setattr__(self, "drives", (FREE,) * poses)
        if len(self.drives) != poses:
            problem = f"expected what the motors did at {poses} poses, found {len(self.drives)}"
            raise MeasurementError(problem, f"{self.source}: drives", 'give "free" or "held" for each pose')
        if len(self.mode) != rows:
            raise MeasurementError(
                f"expected {rows} mode numbers, found {len(self.mode)}",
                f"{self.source}: mode",
                "give one number for each row",
            )
        for name, shape in {
            "points": (poses, component_count),
            "point_sigma": (poses, component_count),
            "pose": (rows,),
            "lines": (rows,),
            "shapes": (rows, channels),
            "shape_sigma": (rows,),
            "set_values": (poses, len(self.settings)),
            "level": (poses,),
        }.items():
            integers_only = name in ("pose", "lines")
            object.__setattr__(
                self,
                name,
                make_read_only(checked_array(getattr(self, name), name, shape, self.source, integers_only)),
            )
        numbers = {
            name: make_read_only(checked_array(column, name, (rows,), self.source))
            for name, column in self.numbers.items()
        }
        object.__setattr__(self, "numbers", Numbers(numbers))
        if self.band is not None:
            object.__setattr__(self, "band", checked_band(self.band, f"{self.source}: band"))
        pose_numbers, first_rows = np.unique(self.pose, return_index=True)
        if not np.array_equal(pose_numbers, np.arange(poses)) or (np.diff(first_rows) < 0).any():
            raise MeasurementError(
                f"expected pose indices that number the {poses} labels in the order of their first rows",
                f"{self.source}: pose",
                "build measurements with Measurements.from_rows",
            )
        refuse([*value_problems(self, first_rows), *text_problems(self, first_rows)], self.source, self.lines)

    @classmethod
    def from_rows(
        cls,
        pose: Sequence[object],
        frequency: ArrayLike,
        sigma: ArrayLike,
        *,
        points: ArrayLike | None = None,
        point_sigma: ArrayLike | None = None,
        damping: ArrayLike | None = None,
        mode: Sequence[object] | None = None,
        shapes: Mapping[str, ArrayLike] | None = None,
        shape_sigma: ArrayLike | None = None,
        damping_sigma: ArrayLike | None = None,
        band: tuple[float, float] | None = None,
        source: str = "measurements",
        lines: ArrayLike | None = None,
        unit: str = "",
        components: Mapping[str, str] = POSITION,
        drives: str | Sequence[str] = FREE,
        settings: Mapping[str, ArrayLike] | None = None,
        level: ArrayLike | None = None,
        level_unit: str = "",
        priors: Mapping[str, Any] = MappingProxyType({}),
        usable: Mapping[str, Any] = MappingProxyType({}),
        state: str = "",
        **further: ArrayLike,
    ) -> Measurements:
        """Build measurements from columns with one entry for each of R rows.

        Parameters
        ----------
        pose : sequence, length R
            Labels: rows with the same label belong to the same pose.
        frequency, sigma : array_like, shape (R,)
            Natural frequencies and their standard deviations [Hz].
        points : array_like, shape (R, d), optional
            The pose of each row in SI units; default 0, for a structure without positions.
        point_sigma : array_like, shape (R, d), optional
            Standard deviations of the points, default 0.
        damping : array_like, shape (R,), optional
            Damping ratios, NaN where unknown.
        mode : sequence, length R, optional
            The experimenter's mode numbers.
        shapes : mapping of str to array_like of shape (R,), optional
            Shape components by coordinate, NaN where not measured.
        shape_sigma : float or array_like, shape (R,), optional
            Standard deviation of each row's shape components relative to the largest, above 0 and below 1; NaN
            where unknown.  A single number applies to all rows.
        damping_sigma : float or array_like, shape (R,), optional
            Standard deviations of the damping ratios, by default and where NaN 30 % of the ratio.
        band : tuple of float, optional
            Lowest and highest frequency of the band in which modes were identified [Hz].
        source : str
            Origin of the data, for messages.
        lines : array_like of int, shape (R,), optional
            Line of each row in the source, default 1 to R.
        unit : str, optional
            Unit of the frequencies in the source if it gives one, for messages; the arguments are in Hz.
        components : mapping of str to str, optional
            Names of the d components of a point and their SI units; by default a position in space.
        drives : str or sequence of str, length R
            What the motors did, in all rows or in each: "free" to turn, or "held" by position loops.  Rows with the
            same label must agree.
        settings : mapping of str to array_like of shape (R,), optional
            Known values of parameters by path, in SI units, NaN where the declared value applies.  Rows with the
            same label must agree.
        level : float or array_like, shape (R,), optional
            Level of excitation, such as the rms of the force, NaN where unknown.  Rows with the same label must
            agree: modes that were measured at two levels at one position are two poses.
        level_unit : str, optional
            Unit of the level, for messages: any one.
        priors : mapping of str to float or str, optional
            Standard deviations of candidates of a diagnosis by name, numbers in SI units or text with a unit.
        usable : mapping of str to value, optional
            Where the next measurement may be, as in ``[usable]`` of a robot file: ``{"z": ["0 mm", "200 mm"]}``.
        state : str, optional
            State of the machine, such as "before".
        **further : array_like, shape (R,), optional
            Other measured quantities and their standard deviations.  Unknown names are refused; the error suggests
            the nearest argument.

        Returns
        -------
        Measurements
            With the labels in the order of their first rows.

        Raises
        ------
        MeasurementError
            If the columns do not match, a number breaks a rule, a label has two positions, two values of a setting,
            two levels or both free and held motors, or a row is repeated.
        """
        quantities = {spec.argument for spec in quantity_number_columns()}
        for name in (name for name in further if name not in quantities):
            problem = f"unknown argument {shown(name)}"
            raise MeasurementError(problem, "from_rows", unknown_argument_remedy(name))
        try:
            if unit:
                frequency_factor(unit)
        except QuantityError as error:
            raise MeasurementError(str(error), f"{source}: unit", "use a unit such as Hz or rad/s") from None
        if isinstance(pose, str):
            raise MeasurementError(
                f"expected one label for each row, found {shown(pose)}",
                f"{source}: pose",
                "give a list of labels",
            )
        labels = checked_list(pose, "labels", f"{source}: pose", '"P1"', error=MeasurementError)
        names = [str(label) for label in labels]
        rows, shapes = len(names), checked_columns(shapes, "shapes", "x_1", source)
        shape = rows, len(components)
        row_points = np.zeros(shape) if points is None else checked_array(points, "points", shape, source)
        row_point_sigmas = (
            np.zeros(shape)
            if point_sigma is None
            else checked_array(point_sigma, "point_sigma", shape, source)
        )
        components_of_shapes = [
            checked_array(column, f"{SHAPE}{name}", (rows,), source) for name, column in shapes.items()
        ]
        row_drives = drives_of_rows(drives, rows, source)
        setting_columns = checked_columns(settings, "settings", "effects.payload.mass", source)
        row_settings = np.empty((rows, len(setting_columns)))
        for k, (name, values) in enumerate(setting_columns.items()):
            row_settings[:, k] = checked_array(values, f"{SET}{name}", (rows,), source)
        row_levels = np.full(rows, np.nan)
        if level is not None:
            row_levels = checked_array(repeat_for_rows(level, rows), LEVEL.argument, (rows,), source)
        first_rows: dict[str, int] = {}  # first row of each label, in the order of the rows
        for i, label in enumerate(names):
            first_rows.setdefault(label, i)
        pose_index = {label: i for i, label in enumerate(first_rows)}
        pose_rows = list(first_rows.values())
        main_columns: dict[str, ArrayLike | None] = {
            "frequency": frequency,
            "sigma": sigma,
            "damping": damping,
            "damping_sigma": damping_sigma,
        }
        try:
            measurements = cls(
                source=source,
                labels=tuple(first_rows),
                points=row_points[pose_rows],
                point_sigma=row_point_sigmas[pose_rows],
                pose=np.array([pose_index[label] for label in names], dtype=int),
                numbers=quantity_columns({**main_columns, **further}, rows, source),
                mode=("",) * rows if mode is None else tuple(map(str, checked_mode_numbers(mode, source))),
                lines=np.arange(1, rows + 1)
                if lines is None
                else checked_array(lines, "lines", (rows,), source, integers_only=True),
                channels=tuple(shapes),
                shapes=np.stack(components_of_shapes, axis=-1)
                if components_of_shapes
                else np.empty((rows, 0)),
                shape_sigma=np.full(rows, np.nan)
                if shape_sigma is None
                else checked_array(repeat_for_rows(shape_sigma, rows), "shape_sigma", (rows,), source),
                band=band,
                unit=unit,
                components=tuple(components),
                component_units=tuple(components.values()),
                drives=tuple(row_drives[i] for i in pose_rows),
                settings=tuple(setting_columns),
                set_values=row_settings[pose_rows],
                level=row_levels[pose_rows],
                level_unit=checked_level_unit(level_unit, f"{source}: level_unit"),
                priors=merge_stated({}, priors, "priors"),
                usable=merge_stated({}, usable, "usable"),
                state=str(state),
            )
        except BrokenRuleError as error:
            name, renamed = error.problem.column, renamed_columns()
            if lines is not None or name not in renamed:
                raise
            where = error.where.replace(f"column {name}", f"argument {renamed[name]}")
            raise MeasurementError(error.what, where, error.remedy) from None
        problems = [
            *position_problems(measurements, row_points, row_point_sigmas),
            *setting_problems(measurements, row_settings),
            *level_problems(measurements, row_levels),
            *drives_problems(measurements, row_drives),
            *repetitions(measurements),
        ]
        refuse(problems, source, measurements.lines)
        return measurements

    def load(self, pose: int) -> dict[str, float]:
        """Return the values set at a pose by path, in SI units, without those that are as declared.

        Parameters
        ----------
        pose : int
            Index into `labels`.

        Returns
        -------
        dict of str to float
            Empty if nothing was set.
        """
        values = zip(self.settings, self.set_values[pose].tolist(), strict=True)
        return {name: value for name, value in values if not np.isnan(value)}

    def level_at(self, pose: int) -> float | None:
        """Return the level of excitation at a pose.

        Parameters
        ----------
        pose : int
            Index into `labels`.

        Returns
        -------
        float or None
            In the unit of the source; None where it is not known.
        """
        level = float(self.level[pose])
        return None if np.isnan(level) else level

    def at(self, poses: Sequence[int]) -> Measurements:
        """Return the measurements at some of the poses.

        Parameters
        ----------
        poses : sequence of int
            Indices into `labels`, each at most once.  Their order does not matter: rows keep the order of the
            file, and the remaining poses are renumbered in the order of their first rows.

        Returns
        -------
        Measurements
            With the rows of these poses.

        Raises
        ------
        MeasurementError
            If an index is out of range or repeated.
        """
        indices = checked_list(
            poses, "pose indices", f"{self.source}: at", "0", (int, np.integer), MeasurementError
        )
        setups = np.asarray(indices) if indices else np.empty(0, dtype=int)
        if setups.ndim != 1 or setups.dtype.kind not in "iu" or len(set(setups.tolist())) < len(setups):
            raise MeasurementError(
                "expected different pose indices", f"{self.source}: at", "give each index once"
            )
        if setups.size and not (setups.min() >= 0 and setups.max() < len(self.labels)):
            raise MeasurementError(
                f"expected pose indices from 0 to {len(self.labels) - 1}, found {setups.tolist()}",
                f"{self.source}: at",
                "give indices into labels",
            )
        # Labels are in the order of their first rows, and so is every subset of them.
        sorted_poses = np.sort(setups)
        rows = np.flatnonzero(np.isin(self.pose, sorted_poses))
        return replace(
            self,
            labels=tuple(self.labels[i] for i in sorted_poses),
            points=self.points[sorted_poses],
            point_sigma=self.point_sigma[sorted_poses],
            pose=np.searchsorted(sorted_poses, self.pose[rows]),
            numbers={name: column[rows] for name, column in self.numbers.items()},
            mode=tuple(self.mode[i] for i in rows),
            lines=self.lines[rows],
            shapes=self.shapes[rows],
            shape_sigma=self.shape_sigma[rows],
            drives=tuple(self.drives[i] for i in sorted_poses),
            set_values=self.set_values[sorted_poses],
            level=self.level[sorted_poses],
        )
