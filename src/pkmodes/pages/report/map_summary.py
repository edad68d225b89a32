"""What a map found, in numbers: the range of each frequency, and where its extremes are."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

from pkmodes.core.base import numbers
from pkmodes.core.base.numbers import plain
from pkmodes.core.robot.declaration import changeable_units
from pkmodes.core.robot.report_fields import head_of
from pkmodes.core.robot.units import DISPLAY_UNITS
from pkmodes.core.solve.fields import FIELDS
from pkmodes.core.support.motors import motors_in_words
from pkmodes.machine.maps.left_out import exclusion_sentences
from pkmodes.machine.maps.summary import MIN_POSES_FOR_2_PERCENT, QUANTILES, quantiles_sentence
from pkmodes.pages.plots.labels import MINUS, typeset
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

NO_BREAK_PER_CENT = "\N{NO-BREAK SPACE}%"


def summary_of_map(model: Model, content: dict[str, Any]) -> Summary:
    """Return where the lowest frequency lies, and what was mapped."""
    units, mapped_axes = axis_units(model), []
    for dim, (low, high) in content["ranges"].items():
        count = content["dimensions"][dim]
        if isinstance(low, str) or dim in ("pose", "sample"):
            mapped_axes.append(plural(count, "pose" if dim == "pose" else "sampled robot"))
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
        ("poses", Cell(group_thousands(content["poses"]), content["poses"], pointer("poses"))),
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


def _headline(content: dict[str, Any]) -> str:
    """Return where the lowest frequency lies, ignoring a few poses at the edge of the workspace."""
    first_mode, count = content["modes"][0], content["counted"]
    if first_mode["minimum_hz"] is None:
        return "The machine is not stable at any pose" if content["valid"] else "No pose could be evaluated"
    lowest = "Mode 1" if content["tracked"] else "The lowest frequency of vibration"
    if count < MIN_POSES_FOR_2_PERCENT:
        low, high, poses_clause = first_mode["minimum_hz"], first_mode["maximum_hz"], ""
    else:
        low, high, poses_clause = (
            first_mode["quantile_2_hz"],
            first_mode["quantile_98_hz"],
            " at 96 % of the poses",
        )
    if count == 1:
        return f"{lowest} is {numbers.format_frequency(low)} Hz"
    return (
        f"{lowest} lies between {numbers.format_frequency(low)} and {numbers.format_frequency(high)} "
        f"Hz{poses_clause}"
    )


def axis_units(model: Model) -> dict[str, tuple[str, float]]:
    """Return the unit of each axis as shown, with the factor from SI."""
    units = {path: (unit_text(name), 1.0) for path, name in changeable_units(model.robot).items()}
    return units | {component.name: DISPLAY_UNITS[component.unit] for component in model.mechanism.pose}


def _value_text(value: float) -> str:
    return typeset(f"{value:.5g}")


def range_table(model: Model, content: dict[str, Any]) -> Table:
    """Return the quantiles of each frequency, and its extremes with their poses."""
    units = axis_units(model)
    dims = [dim for dim in content["ranges"] if content["dimensions"][dim] > 1]
    axis_titles = [f"{dim} [{units[dim][0]}]" if units.get(dim, ("",))[0] else dim for dim in dims]
    pose_columns = [Column(axis, numeric=dim != "pose") for dim, axis in zip(dims, axis_titles, strict=True)]
    rows = []
    for i, mode in enumerate(content["modes"]):
        cells = [Cell(str(mode["mode"])), *(_frequency_cell(mode, i, key) for key in QUANTILES)]
        for end in ("minimum", "maximum"):
            extreme_pose = mode[f"{end}_at"] or {}
            cells.append(_frequency_cell(mode, i, f"{end}_hz"))
            cells += [_pose_cell(extreme_pose.get(dim), units.get(dim, ("", 1.0))[1]) for dim in dims]
        rows.append(cells)
    frequency = Column(FIELDS["frequencies"].heading)
    quantile_columns = [Column(title) for title in ("2 %", "median", "98 %")]
    columns = [Column("mode"), *quantile_columns, frequency, *pose_columns, frequency, *pose_columns]
    ends = [("lowest", 1 + len(dims)), ("highest", 1 + len(dims))]
    groups = [("", 1), ("quantiles [Hz]", 3), *ends]
    if content["poses"] == 1:  # all of these are one value
        return Table("Frequencies at the pose.", [columns[0], columns[4]], [[row[0], row[4]] for row in rows])
    caption = (
        f"{quantiles_sentence(content).replace(' %', NO_BREAK_PER_CENT)}. Its lowest and its highest value stand "
        "beside them, with their places."
    )
    return Table(caption, columns, rows, groups)


def _frequency_cell(mode: dict[str, Any], index: int, key: str) -> Cell:
    value = mode[key]
    return frequency_cell(value, pointer("modes", index, key))


def _pose_cell(coordinate: Any, factor: float) -> Cell:
    if coordinate is None or isinstance(coordinate, str):
        return label_cell(coordinate) if coordinate else number_cell(None)
    return number_cell(float(coordinate), ".5g", scale=factor)
