"""What a map found, in numbers: the range of each frequency, and where its extremes are."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

from pkmodes.core.base import numbers
from pkmodes.core.base.numbers import plain, round_to_sigma
from pkmodes.core.robot.declaration import changeable_units
from pkmodes.core.robot.report_fields import head_of
from pkmodes.core.robot.units import DISPLAY_UNITS
from pkmodes.core.solve.fields import FIELDS
from pkmodes.core.support.motors import motors_in_words
from pkmodes.machine.maps.left_out import exclusion_sentences
from pkmodes.machine.maps.summary import MIN_POSES_FOR_2_PERCENT, QUANTILES, quantiles_sentence
from pkmodes.pages.plots.labels import MINUS, PLUS_MINUS, typeset
from pkmodes.pages.report.blocks import Cell, Column, Summary, Table
from pkmodes.pages.report.formatting import (
    frequency_cell,
    group_thousands,
    label_cell,
    number_cell,
    plural,
    pointer,
    shorten,
    unit_text,
)

if TYPE_CHECKING:
    from pkmodes.core.model import Model
    from pkmodes.machine.maps.pose_path import PosePath

NO_BREAK_PER_CENT = "\N{NO-BREAK SPACE}%"


def summary_of_map(model: Model, content: dict[str, Any], path: PosePath | None = None) -> Summary:
    """Return where the lowest frequency lies, and what was mapped.

    - path: whose poses the map has
    """
    units, mapped_axes = axis_units(model), []
    for dim, (low, high) in content["ranges"].items():
        count = content["dimensions"][dim]
        if isinstance(low, str) or dim in ("pose", "sample"):
            along = "" if path is None else f" along a path of {plain(path.distance[-1], 4)} {path.unit}"
            mapped_axes.append(
                plural(count, "pose") + along if dim == "pose" else plural(count, "sampled robot")
            )
            continue
        name, factor = units.get(dim, ("", 1.0))
        range_text = (
            _value_text(low * factor)
            if count == 1
            else f"{_value_text(low * factor)} to {_value_text(high * factor)}"
        )
        count_text = f" ({count} values)" if count > 1 else ""
        mapped_axes.append(f"{dim} {range_text} {name}".rstrip() + count_text)
    motors = motors_in_words(model.robot, content["drives"])
    reason = f"Mapped with {motors}: {', '.join(mapped_axes)}."
    share = content["valid"] / content["poses"]
    notes = [
        f"{plural(count, 'pose')} cannot be evaluated: {model.reasons[code]}."
        for code, count in content["reasons"].items()
    ]
    notes += [sentence.replace("= -", f"= {MINUS}") for sentence in exclusion_sentences(content, units)]
    facts = [
        (_poses_of(content), Cell(group_thousands(content["poses"]), content["poses"], pointer("poses"))),
        (
            "can be evaluated",
            Cell(
                f"{group_thousands(content['valid'])} ({plain(100 * share, 3)} %)",
                content["valid"],
                pointer("valid"),
            ),
        ),
        ("vibration modes", Cell(str(len(content["modes"])), len(content["modes"]))),
    ]
    return Summary(
        subject=f"{shorten(content['robot'])}, {motors}",
        kind="Map",
        headline=_headline(content),
        reason=reason,
        notes=notes,
        facts=facts,
        head=head_of(model.robot.report),
    )


def _poses_of(content: dict[str, Any]) -> str:
    """Return whose poses are counted: a map of several robots has each pose once for each of them."""
    has_robots = any(
        ("." in dim or dim == "sample") and content["dimensions"][dim] > 1 for dim in content["ranges"]
    )
    return "poses of all robots" if has_robots else "poses"


def _headline(content: dict[str, Any]) -> str:
    """Return where the lowest frequency lies, ignoring a few poses at the edge of the workspace."""
    first_mode, count = content["modes"][0], content["counted"]
    if first_mode["minimum_hz"] is None:
        return "The machine is not stable at any pose" if content["valid"] else "No pose could be evaluated"
    lowest = "Mode 1" if content["tracked"] else "The lowest frequency of vibration"
    keys, poses_clause = ("minimum_hz", "maximum_hz"), ""
    if count >= MIN_POSES_FOR_2_PERCENT:
        keys, poses_clause = ("quantile_2_hz", "quantile_98_hz"), f" at 96 % of the {_poses_of(content)}"
    low, high = (_headline_frequency(first_mode[key], first_mode.get("sigma_hz")) for key in keys)
    sigma_text, source = "", ""
    if sigma := first_mode.get("sigma_hz"):
        sigma_text = f" {PLUS_MINUS} {round_to_sigma(first_mode['median_hz'], sigma).sigma}"
        source = " (from the standard deviations in the robot file)"
    if count == 1:
        return f"{lowest} is {low}{sigma_text} Hz{source}"
    each = f", each{sigma_text} Hz{source}" if sigma_text else ""
    if "sample" in content["dimensions"]:
        each = ", sampled from the standard deviations in the robot file"
    return f"{lowest} lies between {low} and {high} Hz{poses_clause}{each}"


def _headline_frequency(frequency: float, sigma: float | None) -> str:
    return round_to_sigma(frequency, sigma).value if sigma else numbers.format_frequency(frequency)


def axis_units(model: Model) -> dict[str, tuple[str, float]]:
    """Return the unit of each axis as shown, with the factor from SI."""
    units = {path: (unit_text(name), 1.0) for path, name in changeable_units(model.robot).items()}
    return units | {component.name: DISPLAY_UNITS[component.unit] for component in model.mechanism.pose}


def _value_text(value: float) -> str:
    return typeset(f"{value:.5g}")


def range_table(model: Model, content: dict[str, Any]) -> Table:
    """Return the quantiles and the standard deviation of each frequency, and its extremes with their poses."""
    units = axis_units(model)
    dims = [dim for dim in content["ranges"] if content["dimensions"][dim] > 1]
    axis_titles = [f"{dim} [{units[dim][0]}]" if units.get(dim, ("",))[0] else dim for dim in dims]
    pose_columns = [Column(axis, numeric=dim != "pose") for dim, axis in zip(dims, axis_titles, strict=True)]
    rows, has_sigmas = [], any(mode.get("sigma_hz") for mode in content["modes"])
    for i, mode in enumerate(content["modes"]):
        cells = [Cell(str(mode["mode"])), *(_frequency_cell(mode, i, key) for key in QUANTILES)]
        if has_sigmas:
            cells.append(_sigma_cell(mode, i))
        for end in ("minimum", "maximum"):
            extreme_pose = mode[f"{end}_at"] or {}
            cells.append(_frequency_cell(mode, i, f"{end}_hz"))
            cells += [_pose_cell(extreme_pose.get(dim), units.get(dim, ("", 1.0))[1]) for dim in dims]
        rows.append(cells)
    frequency = Column(FIELDS["frequencies"].heading)
    quantile_columns = [Column(title) for title in ("2 %", "median", "98 %")]
    sigma_columns = [Column(f"{PLUS_MINUS} [Hz]")] if has_sigmas else []
    columns = [Column("mode"), *quantile_columns, *sigma_columns, *2 * [frequency, *pose_columns]]
    ends = [("lowest", 1 + len(dims)), ("highest", 1 + len(dims))]
    groups = [("", 1), ("quantiles [Hz]", 3), *([("", 1)] if has_sigmas else []), *ends]
    if content["poses"] == 1:  # all of these are one value
        shown = [0, 4 + has_sigmas, *([4] if has_sigmas else [])]
        return Table(
            "Frequencies at the pose.", [columns[k] for k in shown], [[row[k] for k in shown] for row in rows]
        )
    caption = (
        f"{quantiles_sentence(content).replace(' %', NO_BREAK_PER_CENT)}. Its lowest and its highest value stand "
        "beside them, with their places."
    )
    note = f"{PLUS_MINUS}: one standard deviation, from those in the robot file; the median over poses."
    return Table(caption, columns, rows, groups, note=note if has_sigmas else "")


def _frequency_cell(mode: dict[str, Any], index: int, key: str) -> Cell:
    value = mode[key]
    return frequency_cell(value, pointer("modes", index, key))


def _sigma_cell(mode: dict[str, Any], index: int) -> Cell:
    """Return the standard deviation of a frequency with two digits, as the headline has it."""
    sigma = mode["sigma_hz"]
    if not sigma:
        return number_cell(None)
    return Cell(round_to_sigma(mode["median_hz"], sigma).sigma, sigma, pointer("modes", index, "sigma_hz"))


def _pose_cell(coordinate: Any, factor: float) -> Cell:
    if coordinate is None or isinstance(coordinate, str):
        return label_cell(coordinate) if coordinate else number_cell(None)
    return number_cell(float(coordinate), ".5g", scale=factor)
