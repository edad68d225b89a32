"""The report of a map: where the machine rings, and what it depends on."""

from __future__ import annotations

import math
from collections.abc import Iterator, Sequence
from typing import TYPE_CHECKING, Any

from pkmodes.core.robot.declaration import changeable
from pkmodes.core.robot.report_fields import head_of
from pkmodes.core.robot.units import SHOWN
from pkmodes.core.solve.fields import FIELDS
from pkmodes.figures.pictures import pictures
from pkmodes.maps.left_out import sentences, shown
from pkmodes.maps.spread import spread_along
from pkmodes.maps.summary import FEW, SHARES, quantiles_in_words, summary_of
from pkmodes.plots import sweeps
from pkmodes.plots.labels import MINUS, typeset
from pkmodes.report.blocks import (
    Block,
    Cell,
    Column,
    Listing,
    Paragraph,
    Picture,
    Section,
    Summary,
    Table,
)
from pkmodes.report.explorer import explorer_of
from pkmodes.report.formatting import clean, hertz, number, plural, pointer, thousands, unit
from pkmodes.report.map_planes import declared_values, plane_of, swept_paths, swept_pictures
from pkmodes.report.page import need_report, page
from pkmodes.report.sections import origin, view_section
from pkmodes.report.sources import Source, known_sources
from pkmodes.support import numbers
from pkmodes.support.motors import motors_in_words

if TYPE_CHECKING:
    import xarray

    from pkmodes.core.model import Model

NO_BREAK_PER_CENT = "\N{NO-BREAK SPACE}%"
#: What the bands are where the robot file states standard deviations.
BAND = (
    "the band is one standard deviation on either side, to first order from those that the robot file states"
)


def map_report(
    model: Model,
    dataset: xarray.Dataset,
    content: dict[str, Any] | None = None,
    sources: Sequence[Source] | None = None,
    view: str | None = None,
) -> str:
    """Return the report of a map.

    Parameters
    ----------
    model : Model
        The robot as declared.
    dataset : xarray.Dataset
        From `pkmodes.Model.map` of this model.
    content : dict, optional
        The summary of the map as JSON has it, from ``pkmodes.maps.summary.summary_of``.
    sources : sequence of Source, optional
        The input files as they were read; by default the robot file as it is now.
    view : str, optional
        HTML of a view in three dimensions, from `view_of`; by default there is none.

    Returns
    -------
    str
        HTML that needs no other file and no network.

    Raises
    ------
    MissingExtraError
        If the libraries of the extra ``report`` are not installed.
    """
    need_report()
    content = summary_of(dataset, None).as_json() if content is None else content
    sources = known_sources([("robot file", model.robot.source)]) if sources is None else sources
    sections = [
        Section("modes", "Range of each frequency", _ranges(model, content)),
        *_explored(model, dataset, view),
        *view_section(view),
        *_changes(model, dataset, shown(dataset)),
        *_figures(model, dataset),
        origin(sources, model.mechanism, _about(content), str(dataset.attrs["version"])),
    ]
    return page(_summary(model, content), sections)


def middle_of(model: Model, dataset: xarray.Dataset) -> list[float] | None:
    """Return the pose in the middle of a map; None for a list of poses, or if it cannot be evaluated."""
    names = [component.name for component in model.mechanism.pose]
    if not set(names) <= set(dataset.dims):
        return None
    pose = [float(dataset[name].values[dataset.sizes[name] // 2]) for name in names]
    return pose if model.check(pose).valid else None


def _summary(model: Model, content: dict[str, Any]) -> Summary:
    headline = _headline(content)
    share = content["valid"] / content["poses"]
    notes = [
        f"{plural(count, 'pose')} cannot be evaluated: {model.reasons[code]}."
        for code, count in content["reasons"].items()
    ]
    notes += [one.replace("= -", f"= {MINUS}") for one in sentences(content, _si_units(model))]
    facts = [
        ("poses", Cell(thousands(content["poses"]), content["poses"], pointer("poses"))),
        (
            "can be evaluated",
            Cell(f"{thousands(content['valid'])} ({100 * share:.3g} %)", content["valid"], pointer("valid")),
        ),
        ("vibration modes", Cell(str(len(content["modes"])), len(content["modes"]))),
    ]
    return Summary(
        subject=clean(content["robot"]),
        kind="Map",
        headline=headline,
        reason=_extent(model, content),
        notes=notes,
        facts=facts,
        head=head_of(model.robot.report),
    )


def _headline(content: dict[str, Any]) -> str:
    """Return where the lowest frequency lies, without what a few poses at the edge of the workspace add."""
    first, count = content["modes"][0], content["counted"]
    if first["minimum_hz"] is None:
        return "The machine is stable at no pose" if content["valid"] else "No pose could be evaluated"
    lowest = "Mode 1" if content["tracked"] else "The lowest frequency of vibration"
    if count < FEW:
        low, high, where = first["minimum_hz"], first["maximum_hz"], ""
    else:
        low, high, where = first["quantile_2_hz"], first["quantile_98_hz"], " at 96 % of the poses"
    if count == 1:
        return f"{lowest} is {numbers.hertz(low)} Hz"
    return f"{lowest} lies between {numbers.hertz(low)} and {numbers.hertz(high)} Hz{where}"


def _extent(model: Model, content: dict[str, Any]) -> str:
    """Return what was mapped, as a sentence."""
    units, parts = _units(model), []
    for dim, (low, high) in content["ranges"].items():
        count = content["dimensions"][dim]
        if isinstance(low, str) or dim in ("pose", "sample"):
            parts.append(plural(count, "pose" if dim == "pose" else "sampled robot"))
            continue
        name, factor = units.get(dim, ("", 1.0))
        ends = _value(low * factor) if count == 1 else f"{_value(low * factor)} to {_value(high * factor)}"
        parts.append(f"{dim} {ends} {name}".rstrip())
    return f"Mapped with {motors_in_words(model.robot, content['drives'])}: {', '.join(parts)}."


def _si_units(model: Model) -> dict[str, str]:
    return {component.name: component.unit for component in model.mechanism.pose}


def _units(model: Model) -> dict[str, tuple[str, float]]:
    """Return the unit of each axis as shown, with the factor from SI."""
    units = {path: (unit(name), 1.0) for path, name in changeable(model.robot).items()}
    return units | {component.name: SHOWN[component.unit] for component in model.mechanism.pose}


def _value(value: float) -> str:
    return typeset(f"{value:.5g}")


def _ranges(model: Model, content: dict[str, Any]) -> list[Block]:
    units = _units(model)
    dims = [dim for dim in content["ranges"] if content["dimensions"][dim] > 1]
    axes = [f"{dim} [{units[dim][0]}]" if units.get(dim, ("",))[0] else dim for dim in dims]
    places = [Column(axis, numbers=dim != "pose") for dim, axis in zip(dims, axes, strict=True)]
    rows = []
    for i, mode in enumerate(content["modes"]):
        cells = [Cell(str(mode["mode"])), *(_frequency(mode, i, key) for key in SHARES)]
        for end in ("minimum", "maximum"):
            at = mode[f"{end}_at"] or {}
            cells.append(_frequency(mode, i, f"{end}_hz"))
            cells += [_place(at.get(dim), units.get(dim, ("", 1.0))[1]) for dim in dims]
        rows.append(cells)
    frequency = Column(FIELDS["frequencies"].heading)
    shares = [Column(title) for title in ("2 %", "median", "98 %")]
    columns = [Column("mode"), *shares, frequency, *places, frequency, *places]
    ends = [("lowest", 1 + len(dims)), ("highest", 1 + len(dims))]
    groups = [("", 1), ("quantiles [Hz]", 3), *ends]
    caption = (
        f"{quantiles_in_words(content).replace(' %', NO_BREAK_PER_CENT)}. Its lowest and its highest value stand "
        "beside them, with their poses."
    )
    return [Table(caption, columns, rows, groups)]


def _frequency(mode: dict[str, Any], index: int, key: str) -> Cell:
    value = mode[key]
    return hertz(value, pointer("modes", index, key))


def _place(value: Any, factor: float) -> Cell:
    if value is None or isinstance(value, str):
        return Cell(clean(value or "\u2013"))
    return number(float(value), ".5g", scale=factor)


def _explored(model: Model, dataset: xarray.Dataset, view: str | None) -> list[Section]:
    """Return the section of the interactive map, where there are poses to choose from."""
    explorer = explorer_of(model, dataset, _units(model), machine=view is not None)
    return [] if explorer is None else [Section("explore", "Pose by pose", [explorer])]


def _changes(model: Model, dataset: xarray.Dataset, drawn_of: xarray.Dataset) -> Iterator[Section]:
    """Yield the sections of swept parameters, samples, and poses on a line or in a list.

    Parameters
    ----------
    drawn_of : Dataset
        The same without the poses that say nothing about the others.
    """
    components = [component.name for component in model.mechanism.pose]
    dims = [str(dim) for dim in dataset["frequency"].dims if dataset.sizes[dim] > 1]
    swept = [dim for dim in dims if "." in dim]
    if swept:
        blocks: list[Block] = []
        for path in swept:
            spread = spread_along(model.robot, dataset, path, model.max_condition)
            caption = f"Frequencies against {clean(path)}{_banded(dataset, path, spread)}."
            drawing = sweeps.against(drawn_of, path, spread)
            blocks.append(Picture.of(drawing, clean(path), caption, caption))
        yield Section("sweeps", "Swept parameters", blocks)
    if "sample" in dims:
        drawn = [
            str(name) for name, c in dataset.coords.items() if c.dims == ("sample",) and name != "sample"
        ]
        caption = (
            "Scatter of the frequencies over the sampled robots at each pose, relative to their median: half of the "
            "values are within the bar, 95 % within the line."
        )
        picture = Picture.of(sweeps.scatter(drawn_of), "Scatter over sampled robots", caption, caption)
        listing = Listing([clean(path) for path in drawn], names=True)
        yield Section(
            "samples",
            "Sampled robots",
            [picture, Paragraph("Drawn from their standard deviations:"), listing],
        )
    if "pose" in dims:
        spread = spread_along(model.robot, dataset, "pose", model.max_condition)
        caption = "Frequencies along the poses, medians over everything else."
        if spread is not None:
            caption = f"Frequencies along the poses: {BAND}."
        drawing = sweeps.along(drawn_of, spread)
        picture = Picture.of(drawing, "Frequencies along the poses", caption, caption)
        yield Section("poses", "Along the poses", [picture])
    line = [dim for dim in dims if dim in components]
    if len(line) == 1:
        spread = spread_along(model.robot, dataset, line[0], model.max_condition)
        caption = f"Frequencies along {line[0]}{_banded(dataset, line[0], spread)}."
        drawing = sweeps.against(drawn_of, line[0], spread)
        picture = Picture.of(drawing, f"Along {line[0]}", caption, caption)
        yield Section("line", f"Along {line[0]}", [picture])


def _banded(dataset: xarray.Dataset, dim: str, spread: Any) -> str:
    """Return what line and band of `pkmodes.plots.sweeps.against` are, to end a caption; nothing without a band."""
    if spread is not None:
        return f": {BAND}"
    others = [str(other) for other in dataset["frequency"].dims if other not in (dim, "mode")]
    count = math.prod(dataset.sizes[other] for other in others)
    if count == 1:
        return ""
    several = [other for other in others if dataset.sizes[other] > 1]
    robots = any("." in other or other == "sample" for other in several)
    over = "everything else" if robots else "all poses"
    if count < sweeps.FEW:
        return f": the line is the median, the band the range over {over}"
    left_out = "the lowest and the highest 2\N{NO-BREAK SPACE}%"
    return f": the line is the median over {over}, the band leaves out {left_out}"


def _figures(model: Model, dataset: xarray.Dataset) -> Iterator[Section]:
    """Yield the figures of the robot: in the plane of the map if it has one, otherwise in its working plane."""
    if len(model.mechanism.pose) < 2:
        return
    places, where, title = plane_of(model, dataset)
    if places is None:
        yield Section("figures", title, [Paragraph(where)])
        return
    units, swept, drives = changeable(model.robot), swept_paths(dataset), str(dataset.attrs["drives"])
    blocks: list[Block] = []
    if swept and set(places.axes) <= set(dataset.dims):
        blocks += swept_pictures(model, dataset, places, units)
    declared = declared_values(model, swept, units)
    declared = f" with {declared}" if declared else ""
    doing = motors_in_words(model.robot, drives)
    text = f"The robot as declared{declared}, its {doing}, in {where}; modes are numbered by frequency."
    blocks.append(Paragraph(text))
    for picture in pictures(model, places, drives=drives):
        text = f"{picture.title}. {picture.description}"
        if picture.drawing is None:
            blocks.append(Paragraph(f"{picture.title}: {picture.instead}"))
            continue
        blocks.append(Picture.of(picture.drawing, picture.title, picture.description, text, cropped=True))
    yield Section("figures", title, blocks)


def _about(content: dict[str, Any]) -> list[tuple[str, list[Cell]]]:
    facts = [("rigid-body modes", [Cell(str(content["rigid_modes"]))])]
    if content["file"]:
        facts.append(("map", [Cell(clean(content["file"].replace("\\", "/").rpartition("/")[2]))]))
    return facts
