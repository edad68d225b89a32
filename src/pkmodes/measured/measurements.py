"""Modal measurements as arrays, one row for each identified mode.

The same rules (`rules`) apply to numbers from a file and from a script, so no other module has to check again whether
a frequency is positive or a label has a single position.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, replace
from typing import Never

import numpy as np
from numpy.typing import ArrayLike

from pkmodes.base.errors import MeasurementError, listed, nearest, shown
from pkmodes.measured.columns import POSITION, Array, Columns
from pkmodes.measured.header import frequency_factor
from pkmodes.measured.rules import (
    SET,
    SHAPE,
    BrokenRuleError,
    checked_band,
    position_problems,
    refuse,
    repetitions,
    setting_problems,
    text_problems,
    value_problems,
)
from pkmodes.robot.units import QuantityError

#: Default standard deviation of a damping ratio, relative to it.
DAMPING_SIGMA = 0.2
#: Arguments of `Measurements.from_rows` by column name, where the two names differ.
KEYWORDS = {"sigma_shape": "shape_sigma", "sigma_damping": "damping_sigma", "x": "points", "shape": "shapes"}
ARGUMENTS = (
    "points",
    "point_sigma",
    "damping",
    "mode",
    "shapes",
    "shape_sigma",
    "damping_sigma",
    "band",
    "components",
    "settings",
)


@dataclass(frozen=True, eq=False)
class Measurements(Columns):
    """Identified modes of a machine at P poses: R rows in the order of their file, C shape channels.

    `from_rows` builds them from plain columns.  Arrays are copied and read-only.

    The attributes are those of `pkmodes.measured.columns.Columns`.

    Raises
    ------
    MeasurementError
        If the arrays do not match or a number breaks a rule; the place gives line and column.
    """

    def __post_init__(self) -> None:
        poses, rows, channels = len(self.labels), np.size(self.pose), len(self.channels)
        size = len(self.components)
        if not self.settings:
            object.__setattr__(self, "set_values", np.empty((poses, 0)))
        if len(self.mode) != rows:
            raise MeasurementError(
                f"expected {rows} mode numbers, found {len(self.mode)}",
                f"{self.source}: mode",
                "give one number for each row",
            )
        for name, shape in {
            "points": (poses, size),
            "point_sigma": (poses, size),
            "pose": (rows,),
            "frequency": (rows,),
            "sigma": (rows,),
            "damping": (rows,),
            "lines": (rows,),
            "shapes": (rows, channels),
            "shape_sigma": (rows,),
            "damping_sigma": (rows,),
            "set_values": (poses, len(self.settings)),
        }.items():
            whole = name in ("pose", "lines")
            array = _array(getattr(self, name), name, shape, self.source, whole)
            array.flags.writeable = False
            object.__setattr__(self, name, array)
        if self.band is not None:
            object.__setattr__(self, "band", checked_band(self.band, f"{self.source}: band"))
        used, first = np.unique(self.pose, return_index=True)
        if not np.array_equal(used, np.arange(poses)) or (np.diff(first) < 0).any():
            raise MeasurementError(
                f"expected pose indices that number the {poses} labels in the order of their first rows",
                f"{self.source}: pose",
                "build measurements with Measurements.from_rows",
            )
        refuse([*value_problems(self, first), *text_problems(self, first)], self.source, self.lines)

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
        settings: Mapping[str, ArrayLike] | None = None,
        **unknown: Never,
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
            Standard deviations of the damping ratios, by default and where NaN a fifth of the ratio.
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
        settings : mapping of str to array_like of shape (R,), optional
            Known values of parameters by path, in SI units, NaN where the declared value applies.  Rows with the
            same label must agree.
        **unknown
            Refused; the error suggests the nearest argument.

        Returns
        -------
        Measurements
            With the labels in the order of their first rows.

        Raises
        ------
        MeasurementError
            If the columns do not match, a number breaks a rule, a label has two positions or two values of a
            setting, or a row is repeated.
        """
        for name in unknown:
            what = f"unknown argument {shown(name)}"
            raise MeasurementError(what, "from_rows", nearest(KEYWORDS.get(name, name), ARGUMENTS))
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
        labels = listed(pose, "labels", f"{source}: pose", '"P1"', error=MeasurementError)
        names = [str(label) for label in labels]
        rows, shapes = len(names), _by_name(shapes, "shapes", "x_1", source)
        shape = rows, len(components)
        places = np.zeros(shape) if points is None else _array(points, "points", shape, source)
        spreads = (
            np.zeros(shape) if point_sigma is None else _array(point_sigma, "point_sigma", shape, source)
        )
        columns = [_array(column, f"{SHAPE}{name}", (rows,), source) for name, column in shapes.items()]
        known = _by_name(settings, "settings", "effects.payload.mass", source)
        loads = np.empty((rows, len(known)))
        for k, (name, given) in enumerate(known.items()):
            loads[:, k] = _array(given, f"{SET}{name}", (rows,), source)
        first: dict[str, int] = {}  # first row of each label, in the order of the rows
        for i, label in enumerate(names):
            first.setdefault(label, i)
        index = {label: i for i, label in enumerate(first)}
        introduced = list(first.values())
        ratios = np.full(rows, np.nan) if damping is None else _array(damping, "damping", (rows,), source)
        unsure = (
            np.full(rows, np.nan)
            if damping_sigma is None
            else _array(_for_all(damping_sigma, rows), "damping_sigma", (rows,), source)
        )
        columns_of_rows = Columns(
            source=source,
            labels=tuple(first),
            points=places[introduced],
            point_sigma=spreads[introduced],
            pose=np.array([index[label] for label in names], dtype=int),
            frequency=_array(frequency, "frequency", (rows,), source),
            sigma=_array(sigma, "sigma", (rows,), source),
            damping=ratios,
            mode=("",) * rows if mode is None else tuple(map(str, _numbers(mode, source))),
            lines=np.arange(1, rows + 1)
            if lines is None
            else _array(lines, "lines", (rows,), source, whole=True).astype(int),
            channels=tuple(shapes),
            shapes=np.stack(columns, axis=-1) if columns else np.empty((rows, 0)),
            shape_sigma=np.full(rows, np.nan)
            if shape_sigma is None
            else _array(_for_all(shape_sigma, rows), "shape_sigma", (rows,), source),
            damping_sigma=np.where(np.isnan(unsure), DAMPING_SIGMA * ratios, unsure),
            band=band,
            unit=unit,
            components=tuple(components),
            component_units=tuple(components.values()),
            settings=tuple(known),
            set_values=loads[introduced],
        )
        try:
            found = cls(**vars(columns_of_rows))
        except BrokenRuleError as error:
            name = error.problem.column
            if lines is not None or not name.startswith("sigma_") or name not in KEYWORDS:
                raise
            where = error.where.replace(f"column {name}", f"argument {KEYWORDS[name]}")
            raise MeasurementError(error.what, where, error.remedy) from None
        problems = [
            *position_problems(found, places, spreads),
            *setting_problems(found, loads),
            *repetitions(found),
        ]
        refuse(problems, source, found.lines)
        return found

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
        indices = listed(
            poses, "pose indices", f"{self.source}: at", "0", (int, np.integer), MeasurementError
        )
        chosen = np.asarray(indices) if indices else np.empty(0, dtype=int)
        if chosen.ndim != 1 or chosen.dtype.kind not in "iu" or len(set(chosen.tolist())) < len(chosen):
            raise MeasurementError(
                "expected different pose indices", f"{self.source}: at", "give each index once"
            )
        if chosen.size and not (chosen.min() >= 0 and chosen.max() < len(self.labels)):
            raise MeasurementError(
                f"expected pose indices from 0 to {len(self.labels) - 1}, found {chosen.tolist()}",
                f"{self.source}: at",
                "give indices into labels",
            )
        kept = np.sort(chosen)  # labels are in the order of their first rows, and so is every subset of them
        rows = np.flatnonzero(np.isin(self.pose, kept))
        return replace(
            self,
            labels=tuple(self.labels[i] for i in kept),
            points=self.points[kept],
            point_sigma=self.point_sigma[kept],
            pose=np.searchsorted(kept, self.pose[rows]),
            frequency=self.frequency[rows],
            sigma=self.sigma[rows],
            damping=self.damping[rows],
            mode=tuple(self.mode[i] for i in rows),
            lines=self.lines[rows],
            shapes=self.shapes[rows],
            shape_sigma=self.shape_sigma[rows],
            damping_sigma=self.damping_sigma[rows],
            set_values=self.set_values[kept],
        )


def _for_all(given: ArrayLike, rows: int) -> ArrayLike:
    """Repeat a single number for all rows; return anything else unchanged."""
    return np.full(rows, given) if isinstance(given, int | float | np.integer | np.floating) else given


def _by_name(
    given: Mapping[str, ArrayLike] | None, argument: str, example: str, source: str
) -> Mapping[str, ArrayLike]:
    if given is None:
        return {}
    if not isinstance(given, Mapping) or not all(isinstance(name, str) for name in given):
        what = "components by coordinate" if argument == "shapes" else "values by name"
        raise MeasurementError(
            f"expected {what}, found {shown(given)}",
            f"{source}: {argument}",
            f'for example: {{"{example}": [0.5, -0.2]}}',
        )
    return given


def _numbers(mode: Sequence[object], source: str) -> list[object]:
    """Check the experimenter's mode numbers, which may be text."""
    return listed(mode, "mode numbers", f"{source}: mode", "1", error=MeasurementError)


def _array(given: ArrayLike, name: str, shape: tuple[int, ...], source: str, whole: bool = False) -> Array:
    """Copy an array, checking its shape and that it holds integers or numbers."""
    try:
        array = np.array(given)
        if array.dtype.kind not in ("iu" if whole else "iuf") and array.size:
            raise TypeError(f"values of type {array.dtype}")
    except Exception as error:  # conversion of an arbitrary object may raise anything
        kind = "whole numbers" if whole else "numbers"
        raise MeasurementError(
            f"expected {kind}, found {error}", f"{source}: {name}", f"give an array of {kind}"
        ) from None
    if array.shape != shape:
        raise MeasurementError(
            f"expected an array of shape {shape}, found {array.shape}",
            f"{source}: {name}",
            "give one entry for each row, and one column for each component",
        )
    return array.astype(int if whole else float)
