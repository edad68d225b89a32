"""The report of a map: where the machine rings, and what it depends on."""

from __future__ import annotations

import math
from collections.abc import Iterator, Sequence
from dataclasses import replace
from typing import TYPE_CHECKING, Any

import numpy as np

from pkmodes.core.robot.declaration import changeable_units
from pkmodes.core.support.motors import motors_in_words
from pkmodes.machine.maps.left_out import without_unrepresentative
from pkmodes.machine.maps.spread import spread_along, typical_spread
from pkmodes.machine.maps.summary import summary_of
from pkmodes.pages.figures.pictures import pictures
from pkmodes.pages.plots import sweeps
from pkmodes.pages.plots.volume import volume
from pkmodes.pages.report.blocks import Block, Cell, Listing, Paragraph, Picture, Section
from pkmodes.pages.report.explorer import interactive_map
from pkmodes.pages.report.formatting import clean, file_name, plural, shorten, to_sentence
from pkmodes.pages.report.map_planes import (
    MapSection,
    declared_values_in_words,
    section_of,
    swept_paths,
    swept_pictures,
)
from pkmodes.pages.report.map_summary import axis_units, range_table, summary_of_map
from pkmodes.pages.report.page import need_report, page
from pkmodes.pages.report.sections import origin_section, view_section
from pkmodes.pages.report.sources import Source, known_sources

if TYPE_CHECKING:
    import xarray

    from pkmodes.core.model import Model
    from pkmodes.machine.maps.pose_path import PosePath
    from pkmodes.machine.maps.poses import PoseGrid

#: Sections that are folded until a reader unfolds them.
FOLDED_SECTIONS = ("volume", "figures", "origin")
#: Explanation of the bands where the robot file states standard deviations.
BAND_MEANING = (
    "the band is one standard deviation on either side, to first order from those that the robot file states"
)


def map_report(
    model: Model,
    dataset: xarray.Dataset,
    content: dict[str, Any] | None = None,
    sources: Sequence[Source] | None = None,
    view: str | None = None,
    section: MapSection | None = None,
    path: PosePath | None = None,
) -> str:
    """Return the report of a map.

    Parameters
    ----------
    model : Model
        The robot as declared.
    dataset : xarray.Dataset
        From `pkmodes.Model.map` of this model.
    content : dict, optional
        The summary of the map as JSON has it, from ``pkmodes.machine.maps.summary.summary_of``.
    sources : sequence of Source, optional
        The input files as they were read; by default the robot file as it is now.
    view : str, optional
        HTML of a view in three dimensions, from `view_of`; by default there is none.
    section : MapSection, optional
        From `section_of`, where it was needed before.
    path : PosePath, optional
        The path whose poses the map has.

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
    if content is None:
        sigmas = typical_spread(model.robot, dataset, model.max_condition)
        content = summary_of(dataset, None, sigmas).as_json()
    sources = known_sources([("robot file", model.robot.source)]) if sources is None else sources
    section = section_of(model, dataset) if section is None else section
    explorer = interactive_map(
        model, dataset, axis_units(model), has_machine_view=view is not None, plane=section.plane
    )
    origin_facts = [("rigid-body modes", [Cell(str(content["rigid_modes"]))])]
    if content["file"]:
        origin_facts.append(("map", [Cell(shorten(file_name(content["file"])))]))
    sections = [
        Section("modes", "Range of each frequency", [range_table(model, content)]),
        *([Section("explore", "Pose by pose", [explorer])] if explorer is not None else []),
        *view_section(view, _robot_of_view(model, dataset)),
        *_volume_sections(model, dataset),
        *_variation_sections(model, dataset, without_unrepresentative(dataset), path),
        *_figure_sections(model, dataset, section),
        origin_section(sources, model.mechanism, origin_facts, str(dataset.attrs["version"])),
    ]
    return page(
        summary_of_map(model, content, path),
        [replace(section, folded=section.html_id in FOLDED_SECTIONS) for section in sections],
    )


def cursor_pose(model: Model, dataset: xarray.Dataset, plane: PoseGrid | None = None) -> list[float] | None:
    """Return the pose at which the cursor of a map begins, as in map_explorer.js; None if it cannot be evaluated.

    It is the first pose of a list, and else the middle of each axis.

    - plane: the plane of the figures: the pose is in the section of the map that is nearest to it
    """
    names = [component.name for component in model.mechanism.pose]
    if "pose" in dataset["frequency"].dims:
        pose = [float(dataset[name].values.reshape(-1)[0]) for name in names]
        return pose if model.check(pose).valid else None
    fixed = {} if plane is None else {name: v[0] for name, v in plane.axes.items() if len(v) == 1}
    pose = []
    for name in names:
        values = dataset[name].values.reshape(-1)
        index = np.abs(values - fixed[name]).argmin() if name in fixed else len(values) // 2
        pose.append(float(values[index]))
    return pose if model.check(pose).valid else None


def _robot_of_view(model: Model, dataset: xarray.Dataset) -> str:
    """Return the robot that a view shows beside a map of several robots; empty if the map is of the declared one."""
    if swept := swept_paths(dataset):
        values = declared_values_in_words(model, swept, changeable_units(model.robot))
        return f"the robot as declared{', with ' * bool(values)}{values}"
    return "the robot as declared" if "sample" in dataset["frequency"].dims else ""


def _volume_sections(model: Model, dataset: xarray.Dataset) -> Iterator[Section]:
    """Yield the picture of a map over a volume, if it has no other axes."""
    components = list(model.mechanism.directions)
    dims = dataset["frequency"].dims[:-1]
    if len(components) != 3 or {dim for dim in dims if dataset.sizes[dim] > 1} != {*components}:
        return
    if not dataset["valid"].any():
        return
    title = "The reachable volume"
    text = "The poses that can be reached, coloured by the frequency of mode 1: from outside, and cut open."
    drawing = volume(dataset.squeeze([dim for dim in dims if dim not in components]), components)
    yield Section("volume", title, [Picture.from_drawing(drawing, title, text, text, cropped=True)])


def _variation_sections(
    model: Model, dataset: xarray.Dataset, drawn_dataset: xarray.Dataset, path: PosePath | None
) -> Iterator[Section]:
    """Yield the sections of swept parameters, samples, and poses on a line or in a list.

    - drawn_dataset: the same without the poses that are not representative
    """
    components = [component.name for component in model.mechanism.pose]
    dims = [str(dim) for dim in dataset["frequency"].dims if dataset.sizes[dim] > 1]
    swept = [dim for dim in dims if "." in dim]
    if swept:
        blocks: list[Block] = []
        for name in swept:
            spread = spread_along(model.robot, dataset, name, model.max_condition)
            caption = f"Frequencies against {clean(name)}{_band_in_words(dataset, name, spread)}."
            drawing = sweeps.against_axis(drawn_dataset, name, spread)
            blocks.append(Picture.from_drawing(drawing, clean(name), caption, caption))
        yield Section("sweeps", "Swept parameters", blocks)
    if "sample" in dims:
        sampled_names = [
            str(name)
            for name, coordinate in dataset.coords.items()
            if coordinate.dims == ("sample",) and name != "sample"
        ]
        caption = (
            "Scatter of the frequencies over the sampled robots at each pose, relative to their median: half of "
            "the values are within the bar, 95 % within the line."
        )
        picture = Picture.from_drawing(
            sweeps.sample_scatter(drawn_dataset), "Scatter over sampled robots", caption, caption
        )
        listing = Listing([clean(path) for path in sampled_names], in_columns=True)
        yield Section(
            "samples",
            "Sampled robots",
            [picture, Paragraph("Drawn from their standard deviations:"), listing],
        )
    if "pose" in dims and path is not None:
        spread = spread_along(model.robot, dataset, "pose", model.max_condition)
        caption = (
            f"Frequencies along the path, at {plural(len(path.distance), 'pose')}; dashed lines are its corners. "
            "A gap is a part that cannot be evaluated."
        )
        caption += "" if spread is None else f" {to_sentence(BAND_MEANING)}"
        picture = Picture.from_drawing(
            sweeps.along_path(drawn_dataset, path, spread), "Frequencies along the path", caption, caption
        )
        yield Section("poses", "Along the path", [picture])
    elif "pose" in dims:
        spread = spread_along(model.robot, dataset, "pose", model.max_condition)
        caption = "Frequencies along the poses, medians over everything else."
        if spread is not None:
            caption = f"Frequencies along the poses: {BAND_MEANING}."
        drawing = sweeps.along_poses(drawn_dataset, spread)
        picture = Picture.from_drawing(drawing, "Frequencies along the poses", caption, caption)
        yield Section("poses", "Along the poses", [picture])
    line_components = [dim for dim in dims if dim in components]
    if len(line_components) == 1:
        spread = spread_along(model.robot, dataset, line_components[0], model.max_condition)
        caption = (
            f"Frequencies along {line_components[0]}{_band_in_words(dataset, line_components[0], spread)}."
        )
        drawing = sweeps.against_axis(drawn_dataset, line_components[0], spread)
        picture = Picture.from_drawing(drawing, f"Along {line_components[0]}", caption, caption)
        yield Section("line", f"Along {line_components[0]}", [picture])


def _band_in_words(dataset: xarray.Dataset, dim: str, spread: Any) -> str:
    """Return the meaning of line and band of `plots.sweeps.against_axis`, to end a caption; empty without a band."""
    if spread is not None:
        return f": {BAND_MEANING}"
    pooled = [str(axis) for axis in dataset["frequency"].dims if axis not in (dim, "mode")]
    count = math.prod(dataset.sizes[axis] for axis in pooled)
    if count == 1:
        return ""
    varying = [axis for axis in pooled if dataset.sizes[axis] > 1]
    pools_robots = any("." in axis or axis == "sample" for axis in varying)
    pooled_text = "everything else" if pools_robots else "all poses"
    if count < sweeps.FEW_VALUES:
        return f": the line is the median, the band the range over {pooled_text}"
    left_out = "the lowest and the highest 2\N{NO-BREAK SPACE}%"
    return f": the line is the median over {pooled_text}, the band leaves out {left_out}"


def _figure_sections(model: Model, dataset: xarray.Dataset, section: MapSection) -> Iterator[Section]:
    """Yield the figures of the robot: in the plane of the map if it has one, otherwise in its working plane."""
    if len(model.mechanism.pose) < 2:
        return
    plane, plane_in_words, title = section.plane, section.description, section.title
    if plane is None:
        yield Section("figures", title, [Paragraph(plane_in_words)])
        return
    units, swept, drives = changeable_units(model.robot), swept_paths(dataset), str(dataset.attrs["drives"])
    blocks: list[Block] = []
    if swept and set(plane.axes) <= set(dataset.dims):
        blocks += swept_pictures(model, dataset, plane, units)
    declared_values = declared_values_in_words(model, swept, units)
    declared_values = f" with {declared_values}" if declared_values else ""
    motors = motors_in_words(model.robot, drives)
    text = (
        f"The robot as declared{declared_values}, its {motors}, in {plane_in_words}; modes are numbered by "
        "frequency."
    )
    blocks.append(Paragraph(text))
    for picture in pictures(model, plane, drives=drives):
        text = f"{picture.title}. {picture.description}"
        if picture.drawing is None:
            blocks.append(Paragraph(f"{picture.title}: {picture.instead}"))
            continue
        blocks.append(
            Picture.from_drawing(picture.drawing, picture.title, picture.description, text, cropped=True)
        )
    yield Section("figures", title, blocks)
