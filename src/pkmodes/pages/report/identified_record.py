"""The section of a record in the report of an identification: its modes, and the fits that they come from."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from typing import Any

import numpy as np

from pkmodes.core.base.numbers import plain
from pkmodes.core.support.motors import motors_in_words
from pkmodes.core.support.ordering import listed
from pkmodes.modaltest.campaign.campaign import Campaign
from pkmodes.modaltest.campaign.inspection import Inspection
from pkmodes.modaltest.campaign.mode_estimates import mac
from pkmodes.modaltest.campaign.results import IdentifiedMode, RecordResult
from pkmodes.pages.plots import fits, identified_modes
from pkmodes.pages.report.blocks import (
    Block,
    Cell,
    Column,
    Facts,
    Listing,
    Paragraph,
    Picture,
    Section,
    Table,
)
from pkmodes.pages.report.formatting import (
    clean,
    file_name,
    frequency_cell,
    number_cell,
    plural,
    pointer,
    shorten,
    to_sentence,
    uncertain_cell,
)
from pkmodes.pages.report.tables import compact_table

#: Maximum number of complex shapes drawn for one record: the least collinear ones.
MAX_SHAPES = 18
#: Maximum number of modes of a record for a matrix with legible cells.
MAX_MAC_MODES = 60
#: Maximum number of messages listed for one record.
MAX_MESSAGES = 40
#: Kinds of record whose names are abbreviations.
KIND_TITLES = {"frf": "FRF"}
#: The functions measured in each kind of record.
FUNCTION_MEANINGS = {
    "frf": "frequency response function, as acceleration per force in SI units",
    "impact": "frequency response function from the blows, as acceleration per force in SI units",
    "ambient": "power spectral density of the responses, in SI units",
    "spectrum": "power spectrum, relative to its sum over the band",
}


def record_section(
    index: int, result: RecordResult, campaign: Campaign, content: Mapping[str, Any]
) -> Section:
    """Return the section of a record.

    - index: among the records of the JSON, from 0
    - content: the record in the JSON
    """
    record = result.record
    facts = list[tuple[str, Sequence[Cell]]]()
    if campaign.model is not None:
        motors = motors_in_words(campaign.model.robot, record.drives)
        facts.append(("motors", [Cell(motors.removeprefix("motors "))]))
    low, high = record.band
    facts.append(("band", [Cell(f"{low:g} Hz to {high:g} Hz")]))
    for name, paths in record.setups.items():
        files = listed([shorten(path.name) for path in paths], 12)
        facts.append((f"files of setup {shorten(name)}" if name else "files", [Cell(files)]))
    if result.struck:
        cells = [
            frequency_cell(f, pointer("records", index, "struck", k)) for k, f in enumerate(result.struck)
        ]
        facts.append(("struck out by the campaign [Hz]", cells))
    blocks: list[Block] = [Facts(facts)]
    empty_note = Paragraph("None of its files could be used." if result.is_left_out else "No mode was found.")
    blocks.append(modes_table(index, content["modes"]) if result.modes else empty_note)
    if result.messages:
        messages = [clean(message) for message in result.messages[:MAX_MESSAGES]]
        omitted = len(result.messages) - len(messages)
        blocks += [Paragraph("What was noticed:"), Listing(messages)]
        blocks += (
            [Paragraph(f"{plural(omitted, 'further message')} in the output of --json.")] if omitted else []
        )
    if result.left_out:
        faulty = [clean(f"{file_name(omission.file)}: {omission.reason}") for omission in result.left_out]
        blocks += [Paragraph("Files that were left out:"), Listing(faulty)]
    for inspection in result.inspections:
        blocks += _fit_pictures(inspection, result, campaign)
    blocks += _shape_pictures(result)
    blocks += _repeat_pictures(result)
    return Section(
        f"record-{index + 1}",
        shorten(f"{record.pose}: {KIND_TITLES.get(record.kind, record.kind)}", 60),
        blocks,
    )


def modes_table(index: int, modes: Sequence[Mapping[str, Any]]) -> Table:
    """Return the modes of a record with their standard deviations."""
    has_damping = any(mode["damping"] is not None for mode in modes)
    has_shapes = any(mode["complexity"] is not None for mode in modes)
    has_orders = any(mode["found_in"] is not None for mode in modes)
    has_edits = any(mode["edited"] for mode in modes)
    columns = [Column("mode"), Column("f [Hz]")]
    columns += [Column(title, page_only=True) for title in ("scatter", "fit", "repeatability")]
    groups = [("", 2), ("parts of \u03c3 [Hz]", 3)]
    if has_damping:
        columns.append(Column("damping ratio [%]"))
        groups.append(("", 1))
    further_columns = (
        [Column("MPC")] * has_shapes + [Column("orders", False)] * has_orders + [Column("files")]
    )
    further_columns += [Column("edited", False)] * has_edits
    columns, groups = [*columns, *further_columns], [*groups, ("", len(further_columns))]
    rows = []
    for k, mode in enumerate(modes):
        mode_keys = ("records", index, "modes", k)
        cells = [
            Cell(str(k + 1)),
            uncertain_cell(
                mode["frequency"],
                mode["sigma"],
                pointer(*mode_keys, "frequency"),
                pointer(*mode_keys, "sigma"),
            ),
        ]
        for key, sigma in mode["sigma_parts"].items():  # two significant digits, zeros among them
            form = "#.2g" if sigma is None or 0.0 < sigma < 9.95 else ".0f"
            known = None if key == "scatter" and mode["files"] == 1 else sigma  # one file has no scatter
            cells.append(number_cell(known, form, pointer(*mode_keys, "sigma_parts", key)))
        if has_damping:
            cells.append(_damping_cell(mode, mode_keys))
        cells += (
            [number_cell(mode["complexity"], ".3f", pointer(*mode_keys, "complexity"))] if has_shapes else []
        )
        if has_orders:
            orders = mode["found_in"]
            cells.append(number_cell(None) if orders is None else Cell(f"{orders[0]} of {orders[1]}"))
        cells.append(number_cell(mode["files"], ".0f", pointer(*mode_keys, "files")))
        cells += [Cell(mode["edited"] or "")] if has_edits else []
        rows.append(cells)
    sigma_meaning = "A standard deviation \u03c3 is the root of the sum of the squares of its parts"
    return compact_table(
        f"Modes. {'; '.join((sigma_meaning, *column_meanings(modes)))}.", columns, rows, groups
    )


def column_meanings(modes: Sequence[Mapping[str, Any]]) -> list[str]:
    """Return the meanings of those columns of the table that need one."""
    texts = {
        "complexity": "MPC is the modal phase collinearity, 1 for a real shape",
        "found_in": "orders: in how many model orders the pole was found",
    }
    return [text for key, text in texts.items() if any(mode[key] is not None for mode in modes)]


def _damping_cell(mode: Mapping[str, Any], mode_keys: Sequence[object]) -> Cell:
    """Return a damping ratio in per cent, with its standard deviation where that is known."""
    ratio, sigma, ratio_pointer = mode["damping"], mode["sigma_damping"], pointer(*mode_keys, "damping")
    if ratio is None or sigma is None:
        return number_cell(ratio, ".3g", ratio_pointer, scale=100.0)
    return uncertain_cell(ratio, sigma, ratio_pointer, pointer(*mode_keys, "sigma_damping"), scale=100.0)


def _fit_pictures(inspection: Inspection, result: RecordResult, campaign: Campaign) -> list[Block]:
    """Return the figures of the fit of a file."""
    file_text, measurement_text = f"file {shorten(inspection.file)}", "the record"
    if inspection.setup:
        file_text, measurement_text = f"setup {shorten(inspection.setup)}, {file_text}", "the setup"
    elif "" not in result.record.setups:  # of all setups together
        file_text, measurement_text = shorten(inspection.file), "each setup"
    low, high = result.record.band
    multiples = [
        tone * k for tone in campaign.tones for k in range(1, int(high / tone) + 1) if tone * k >= low
    ]
    marked_frequencies = fits.MarkedFrequencies(
        [(mode.frequency, k, bool(mode.edited)) for k, mode in enumerate(result.modes, start=1)],
        result.struck,
        sorted({*inspection.tones, *multiples}),
    )
    blocks: list[Block] = []
    if len(inspection.stabilisation.orders):
        blocks.append(
            _stabilisation_picture(inspection, result, marked_frequencies, file_text, measurement_text)
        )
    if inspection.curves:
        blocks.append(_function_picture(inspection, result, marked_frequencies, file_text))
    return blocks


def _stabilisation_picture(
    inspection: Inspection,
    result: RecordResult,
    marked_frequencies: fits.MarkedFrequencies,
    file_text: str,
    measurement_text: str,
) -> Picture:
    """Return the stabilisation diagram of a file.

    - file_text: the file in words
    - measurement_text: what other files of the same measurement belong to
    """
    undrawn_note = ""
    if inspection.others:
        other_files = "other file" if inspection.others == 1 else plural(inspection.others, "other file")
        undrawn_note = (
            f" The {other_files} of {measurement_text} {'is' if inspection.others == 1 else 'are'} not drawn."
        )
    line_meanings = ["lines with a number are the modes of the record, as in the table"]
    line_meanings += (
        ["dash-dotted lines are modes that were added"] if any(mode.edited for mode in result.modes) else []
    )
    line_meanings += ["dashed lines are modes that were struck out"] if result.struck else []
    line_meanings += ["dotted lines are tones"] if marked_frequencies.tones else []
    poles = plural(sum(map(len, inspection.stabilisation.poles)), "pole")
    orders = plural(len(inspection.stabilisation.orders), "model order")
    return Picture.from_drawing(
        fits.stabilisation_diagram(inspection, marked_frequencies, result.record.band),
        f"Stabilisation diagram of {file_text}",
        f"{poles} over {orders}, and {plural(len(result.modes), 'mode')}.",
        f"{file_text[:1].upper()}{file_text[1:]}: stabilisation diagram. Each short line is a pole at a model order; "
        "a stable one has nearly the same frequency and damping as a pole of the order before. Behind them is the "
        "sum of the magnitudes of all measured functions, each relative to its rms. "
        f"{to_sentence('; '.join(line_meanings))}{undrawn_note}",
    )


def _function_picture(
    inspection: Inspection, result: RecordResult, marked_frequencies: fits.MarkedFrequencies, file_text: str
) -> Picture:
    """Return the measured functions of a file over those synthesised from its modes."""
    kind, function_count, drawn_count = result.record.kind, inspection.functions, len(inspection.curves)
    has_phase = kind in ("frf", "impact")
    functions_text = (
        f"{drawn_count} of {function_count} functions, chosen so that each mode stands out in one of them"
    )
    if drawn_count == function_count:
        functions_text = f"its {plural(function_count, 'function')}" if function_count > 1 else "its function"
    panels = ["magnitude", *(["phase"] if has_phase else [])]
    panels += ["coherence"] if any(curve.coherence is not None for curve in inspection.curves) else []
    panels_clause = f": {', '.join(panels)}" if len(panels) > 1 else ""
    return Picture.from_drawing(
        fits.function_fits(inspection, marked_frequencies, result.record.band, has_phase),
        f"Measured and synthesised functions of {file_text}",
        f"{', '.join(shorten(curve.name, 40) for curve in inspection.curves)}: measured, and synthesised from "
        "the modes.",
        f"{file_text[:1].upper()}{file_text[1:]}: {functions_text}, measured and synthesised from the modes "
        f"of this file. Each is a {FUNCTION_MEANINGS[kind]}{panels_clause}. Faint lines are the modes of the "
        "record.",
    )


def _shape_pictures(result: RecordResult) -> list[Block]:
    """Return the figures of how similar and how complex the shapes are."""
    modes_with_shapes = [
        (k, mode) for k, mode in enumerate(result.modes, start=1) if len(mode.complex_shape) > 1
    ]
    if not modes_with_shapes:
        return []
    blocks: list[Block] = []
    if 1 < len(result.modes) <= MAX_MAC_MODES:
        macs = auto_macs(result.modes)
        similar_count = int(((macs > 0.5) & ~np.eye(len(macs), dtype=bool)).sum()) // 2
        blocks.append(
            Picture.from_drawing(
                identified_modes.auto_mac(macs),
                "autoMAC",
                f"Modal assurance criterion between {plural(len(macs), 'mode')}; "
                f"{plural(similar_count, 'pair')} above 0.5.",
                "autoMAC: how alike the shapes of the record's modes are, 1 for the same shape. A light cell "
                "beside the diagonal means that the sensors hardly tell two modes "
                f"apart.{lengths_note(result.modes)}",
            )
        )
    drawn_modes = sorted(
        sorted(modes_with_shapes, key=lambda entry: entry[1].complexity)[:MAX_SHAPES],
        key=lambda entry: entry[0],
    )
    titled_shapes = [(f"{k}: {mode.complexity:.2f}", mode.shape_in_metres) for k, mode in drawn_modes]
    selection_note = (
        ""
        if len(drawn_modes) == len(modes_with_shapes)
        else f" The {len(drawn_modes)} least collinear of {len(modes_with_shapes)} are drawn."
    )
    selection_note += lengths_note(result.modes)
    most_complex = min(modes_with_shapes, key=lambda entry: entry[1].complexity)
    blocks.append(
        Picture.from_drawing(
            identified_modes.complex_shapes(titled_shapes),
            "Shapes in the complex plane",
            f"{plural(len(drawn_modes), 'shape')}. The most complex one is that of mode {most_complex[0]}, "
            f"with a modal phase collinearity of {most_complex[1].complexity:.2f}.",
            "Shapes in the complex plane: a line for each component, relative to the largest, in a circle of "
            "radius 1; above it the number of the mode and its modal phase collinearity. A real shape is a "
            f"horizontal line; only the real part is used.{selection_note}",
        )
    )
    return blocks


def auto_macs(modes: Sequence[IdentifiedMode]) -> np.ndarray[Any, np.dtype[np.float64]]:
    """Return the MAC between all modes, (M, M), NaN where two have fewer than two components in common."""
    macs = np.full((len(modes), len(modes)), np.nan)
    for i, first in enumerate(modes):
        for k, second in enumerate(modes):
            if len(first.complex_shape.keys() & second.complex_shape.keys()) > 1:
                macs[i, k] = mac(first.complex_shape, second.complex_shape, first.lengths)
    return macs


def lengths_note(modes: Sequence[IdentifiedMode]) -> str:
    """Return a note on the length by which rotations in shapes are multiplied; empty where they have none."""
    lengths = [mode.lengths[name] for mode in modes for name in mode.complex_shape if name in mode.lengths]
    return (
        f" Rotations are times L = {lengths[0]:.4g} m, the characteristic length of the platform."
        if lengths
        else ""
    )


def _repeat_pictures(result: RecordResult) -> list[Block]:
    repeated = [repeat for repeat in result.repeats if len(repeat.files) > 1 and repeat.modes]
    if not repeated:
        return []
    file_count = sum(len(repeat.files) for repeat in repeated)
    largest_difference = max(
        abs(f / np.mean(list(mode.values())) - 1.0)
        for repeat in repeated
        for mode in repeat.modes
        for f in mode.values()
    )
    colours_note = " Each setup has a colour, and its own means." if len(repeated) > 1 else ""
    return [
        Picture.from_drawing(
            identified_modes.scatter_of_repeats(repeated),
            "Frequencies in each file",
            f"{plural(file_count, 'file')}; the largest difference from a mean is "
            f"{plain(100.0 * float(largest_difference), 2)} %.",
            "Frequencies in each file, relative to their mean over the repeats. A file that is off in all "
            f"modes was measured elsewhere, or at another temperature.{colours_note}",
        )
    ]
