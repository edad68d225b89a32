"""Measurements as a file in CSV, which the reader reads back to the last digit."""

from __future__ import annotations

import csv
import io
import math
from collections.abc import Sequence

import numpy as np

from pkmodes.loop.measured.columns import Columns
from pkmodes.loop.measured.header import SPREAD_PREFIX
from pkmodes.loop.measured.quantities import LEVEL, QUANTITIES, SHAPE_SIGMA, number_columns
from pkmodes.loop.measured.rules import SET, SHAPE


def as_csv(data: Columns, comments: Sequence[str] = ()) -> str:
    """Return measurements as CSV, in SI units and Hz.

    The columns of quantities and standard deviations are always there, blank where a number is not known; others that
    hold nothing are left out.

    - comments: lines at the beginning
    """
    text = io.StringIO()
    for comment in comments:
        text.write(f"# {comment}\n")
    if data.band is not None:
        low, high = (repr(float(limit)) for limit in data.band)
        text.write(f"# band: {low} Hz, {high} Hz\n")
    motors = dict.fromkeys(data.drives)
    if len(motors) == 1:
        text.write(f"# drives: {next(iter(motors))}\n")
    if data.state:
        text.write(f"# state: {data.state}\n")
    for word, statements in (("prior", data.priors), ("usable", data.usable)):
        for name, statement in statements.items():
            text.write(f"# {word}: {name} = {statement.text}\n")
    columns: dict[str, list[str]] = {"pose": [data.labels[i] for i in data.pose]}
    for k, name in enumerate(data.components):
        columns[name] = _numbers(data.points[data.pose, k])
        if data.point_sigma[:, k].any():
            columns[f"{SPREAD_PREFIX}{name}"] = _numbers(data.point_sigma[data.pose, k])
    for quantity in QUANTITIES.values():
        values, sigmas = (data.numbers[number.argument] for number in (quantity.value, quantity.sigma))
        # A blank standard deviation means the usual one; that of a blank quantity is blank.
        if quantity.usual_sigma is not None:
            is_usual = np.isnan(values) | (sigmas == quantity.usual_sigma(values))
            sigmas = np.where(is_usual, np.nan, sigmas)
        columns |= {quantity.value.column: _numbers(values), quantity.sigma.column: _numbers(sigmas)}
    if len(motors) > 1:
        columns["drives"] = [data.drives[i] for i in data.pose]
    for k, name in enumerate(data.settings):
        columns[f"{SET}{name}"] = _numbers(data.set_values[data.pose, k])
    level_heading = f"{LEVEL.column} [{data.level_unit}]" if data.level_unit else LEVEL.column
    columns[level_heading] = _numbers(data.level[data.pose])
    columns["mode"] = [str(mode) for mode in data.mode]
    for k, name in enumerate(data.channels):
        columns[f"{SHAPE}{name}"] = _numbers(data.shapes[:, k])
    columns[SHAPE_SIGMA.column] = _numbers(data.shape_sigma)
    required_names = {spec.column for spec in number_columns()}
    columns = {name: cells for name, cells in columns.items() if any(cells) or name in required_names}
    writer = csv.writer(text, lineterminator="\n")
    writer.writerow(columns)
    writer.writerows(zip(*columns.values(), strict=True))
    return text.getvalue()


def _numbers(values: Sequence[float] | np.ndarray) -> list[str]:
    return ["" if math.isnan(value) else repr(float(value)) for value in values]
