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
    hertz,
    number,
    plural,
    pointer,
    sentence,
    shortened,
    uncertain_cell,
)
from pkmodes.pages.report.tables import table

#: Most complex shapes drawn for one record: the least collinear ones.
MOST_SHAPES = 18
#: Most modes of a record for a matrix with legible cells.
MOST_MAC = 60
#: Most messages listed for one record.
MOST_MESSAGES = 40
#: Kinds of record whose names are abbreviations.
SHOWN = {"frf": "FRF"}
#: The functions measured in each kind of record.
FUNCTIONS = {
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
        doing = motors_in_words(campaign.model.robot, record.drives)
        facts.append(("motors", [Cell(doing.removeprefix("motors "))]))
    low, high = record.band
    facts.append(("band", [Cell(f"{low:g} Hz to {high:g} Hz")]))
    for name, paths in record.setups.items():
        files = listed([shortened(path.name) for path in paths], 12)
        facts.append((f"files of setup {shortened(name)}" if name else "files", [Cell(files)]))
    if result.struck:
        cells = [hertz(f, pointer("records", index, "struck", k)) for k, f in enumerate(result.struck)]
        facts.append(("struck out by the campaign [Hz]", cells))
    blocks: list[Block] = [Facts(facts)]
    nothing = Paragraph("None of its files could be used." if result.is_left_out else "No mode was found.")
    blocks.append(modes_table(index, content["modes"]) if result.modes else nothing)
    if result.messages:
        messages = [clean(message) for message in result.messages[:MOST_MESSAGES]]
        omitted = len(result.messages) - len(messages)
        blocks += [Paragraph("What was noticed:"), Listing(messages)]
        blocks += (
            [Paragraph(f"{plural(omitted, 'further message')} in the output of --json.")] if omitted else []
        )
    if result.left_out:
        faulty = [clean(f"{file_name(omission.file)}: {omission.reason}") for omission in result.left_out]
        blocks += [Paragraph("Files that were left out:"), Listing(faulty)]
    for inspection in result.inspections:
        blocks += _fit(inspection, result, campaign)
    blocks += _shapes(result)
    blocks += _repeats(result)
    return Section(
        f"record-{index + 1}", shortened(f"{record.pose}: {SHOWN.get(record.kind, record.kind)}", 60), blocks
    )


def modes_table(index: int, modes: Sequence[Mapping[str, Any]]) -> Table:
    """Return the modes of a record with their standard deviations."""
    damped = any(mode["damping"] is not None for mode in modes)
    shaped = any(mode["complexity"] is not None for mode in modes)
    ordered = any(mode["found_in"] is not None for mode in modes)
    edited = any(mode["edited"] for mode in modes)
    columns = [Column("mode"), Column("f [Hz]")]
    columns += [Column(title, page_only=True) for title in ("scatter", "fit", "repeatability")]
    groups = [("", 2), ("parts of \u03c3 [Hz]", 3)]
    if damped:
        columns.append(Column("damping ratio [%]"))
        groups.append(("", 1))
    rest = [Column("MPC")] * shaped + [Column("orders", False)] * ordered + [Column("files")]
    rest += [Column("edited", False)] * edited
    columns, groups = [*columns, *rest], [*groups, ("", len(rest))]
    rows = []
    for k, mode in enumerate(modes):
        at = ("records", index, "modes", k)
        cells = [
            Cell(str(k + 1)),
            uncertain_cell(
                mode["frequency"], mode["sigma"], pointer(*at, "frequency"), pointer(*at, "sigma")
            ),
        ]
        for key, sigma in mode["sigma_parts"].items():  # two significant digits, zeros among them
            form = "#.2g" if sigma is None or 0.0 < sigma < 9.95 else ".0f"
            cells.append(number(sigma, form, pointer(*at, "sigma_parts", key)))
        if damped:
            cells.append(_damping(mode, at))
        cells += [number(mode["complexity"], ".3f", pointer(*at, "complexity"))] if shaped else []
        if ordered:
            orders = mode["found_in"]
            cells.append(number(None) if orders is None else Cell(f"{orders[0]} of {orders[1]}"))
        cells.append(number(mode["files"], ".0f", pointer(*at, "files")))
        cells += [Cell(mode["edited"] or "")] if edited else []
        rows.append(cells)
    parts = "A standard deviation \u03c3 is the root of the sum of the squares of its parts"
    return table(f"Modes. {'; '.join((parts, *meanings(modes)))}.", columns, rows, groups)


def meanings(modes: Sequence[Mapping[str, Any]]) -> list[str]:
    """Return what columns of the table mean."""
    texts = {
        "complexity": "MPC is the modal phase collinearity, 1 for a real shape",
        "found_in": "orders: in how many model orders the pole was found",
    }
    return [text for key, text in texts.items() if any(mode[key] is not None for mode in modes)]


def _damping(mode: Mapping[str, Any], at: Sequence[object]) -> Cell:
    """Return a damping ratio in per cent, with its standard deviation where that is known."""
    ratio, sigma, place = mode["damping"], mode["sigma_damping"], pointer(*at, "damping")
    if ratio is None or sigma is None:
        return number(ratio, ".3g", place, scale=100.0)
    return uncertain_cell(ratio, sigma, place, pointer(*at, "sigma_damping"), scale=100.0)


def _fit(inspection: Inspection, result: RecordResult, campaign: Campaign) -> list[Block]:
    """Return the figures of the fit of a file."""
    which, whole = f"file {shortened(inspection.file)}", "the record"
    if inspection.setup:
        which, whole = f"setup {shortened(inspection.setup)}, {which}", "the setup"
    elif "" not in result.record.setups:  # of all setups together
        which, whole = shortened(inspection.file), "each setup"
    low, high = result.record.band
    multiples = [
        tone * k for tone in campaign.tones for k in range(1, int(high / tone) + 1) if tone * k >= low
    ]
    marked = fits.MarkedFrequencies(
        [(mode.frequency, k, bool(mode.edited)) for k, mode in enumerate(result.modes, start=1)],
        result.struck,
        sorted({*inspection.tones, *multiples}),
    )
    blocks: list[Block] = []
    if len(inspection.stabilisation.orders):
        blocks.append(_stabilisation(inspection, result, marked, which, whole))
    if inspection.curves:
        blocks.append(_functions(inspection, result, marked, which))
    return blocks


def _stabilisation(
    inspection: Inspection, result: RecordResult, marked: fits.MarkedFrequencies, which: str, whole: str
) -> Picture:
    """Return the stabilisation diagram of a file.

    - which: the file in words
    - whole: what other files of the same measurement belong to
    """
    rest = ""
    if inspection.others:
        others = "other file" if inspection.others == 1 else plural(inspection.others, "other file")
        rest = f" The {others} of {whole} {'is' if inspection.others == 1 else 'are'} not drawn."
    lines = ["lines with a number are the modes of the record, as in the table"]
    lines += (
        ["dash-dotted lines are modes that were added"] if any(mode.edited for mode in result.modes) else []
    )
    lines += ["dashed lines are modes that were struck out"] if result.struck else []
    lines += ["dotted lines are tones"] if marked.tones else []
    poles = plural(sum(map(len, inspection.stabilisation.poles)), "pole")
    orders = plural(len(inspection.stabilisation.orders), "model order")
    return Picture.of(
        fits.stabilisation_diagram(inspection, marked, result.record.band),
        f"Stabilisation diagram of {which}",
        f"{poles} over {orders}, and {plural(len(result.modes), 'mode')}.",
        f"{which[:1].upper()}{which[1:]}: stabilisation diagram. Each short line is a pole at a model order; a "
        "stable one has nearly the same frequency and damping as a pole of the order before. Behind them is the sum "
        "of the magnitudes of all measured functions, each relative to its rms. "
        f"{sentence('; '.join(lines))}{rest}",
    )


def _functions(
    inspection: Inspection, result: RecordResult, marked: fits.MarkedFrequencies, which: str
) -> Picture:
    """Return the measured functions of a file over those synthesised from its modes."""
    kind, count, drawn = result.record.kind, inspection.functions, len(inspection.curves)
    phase = kind in ("frf", "impact")
    chosen = f"{drawn} of {count} functions, chosen so that each mode stands out in one of them"
    if drawn == count:
        chosen = f"its {plural(count, 'function')}" if count > 1 else "its function"
    panels = ["magnitude", *(["phase"] if phase else [])]
    panels += ["coherence"] if any(curve.coherence is not None for curve in inspection.curves) else []
    in_panels = f": {', '.join(panels)}" if len(panels) > 1 else ""
    return Picture.of(
        fits.function_fits(inspection, marked, result.record.band, phase),
        f"Measured and synthesised functions of {which}",
        f"{', '.join(shortened(curve.name, 40) for curve in inspection.curves)}: measured, and synthesised from the "
        "modes.",
        f"{which[:1].upper()}{which[1:]}: {chosen}, measured and synthesised from the modes of this file. Each is a "
        f"{FUNCTIONS[kind]}{in_panels}. Faint lines are the modes of the record.",
    )


def _shapes(result: RecordResult) -> list[Block]:
    """Return the figures of how similar and how complex the shapes are."""
    shaped = [(k, mode) for k, mode in enumerate(result.modes, start=1) if len(mode.complex_shape) > 1]
    if not shaped:
        return []
    blocks: list[Block] = []
    if 1 < len(result.modes) <= MOST_MAC:
        macs = auto_macs(result.modes)
        alike = int(((macs > 0.5) & ~np.eye(len(macs), dtype=bool)).sum()) // 2
        blocks.append(
            Picture.of(
                identified_modes.auto_mac(macs),
                "autoMAC",
                f"Modal assurance criterion between {plural(len(macs), 'mode')}; {plural(alike, 'pair')} above 0.5.",
                "autoMAC: how alike the shapes of the record's modes are, 1 for the same shape. A light cell beside "
                "the diagonal means that the sensors hardly tell two modes apart."
                f"{lengths_note(result.modes)}",
            )
        )
    drawn = sorted(
        sorted(shaped, key=lambda entry: entry[1].complexity)[:MOST_SHAPES], key=lambda entry: entry[0]
    )
    titles = [(f"{k}: {mode.complexity:.2f}", mode.shape_in_metres) for k, mode in drawn]
    which = (
        "" if len(drawn) == len(shaped) else f" The {len(drawn)} least collinear of {len(shaped)} are drawn."
    )
    which += lengths_note(result.modes)
    lowest = min(shaped, key=lambda entry: entry[1].complexity)
    blocks.append(
        Picture.of(
            identified_modes.complex_shapes(titles),
            "Shapes in the complex plane",
            f"{plural(len(drawn), 'shape')}. The most complex one is that of mode {lowest[0]}, with a modal phase "
            f"collinearity of {lowest[1].complexity:.2f}.",
            "Shapes in the complex plane: a line for each component, relative to the largest, in a circle of radius "
            "1; above it the number of the mode and its modal phase collinearity. A real shape is a horizontal line; "
            f"only the real part is used.{which}",
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
    """Return what makes metres of the rotations in shapes; empty where they have none."""
    lengths = [mode.lengths[name] for mode in modes for name in mode.complex_shape if name in mode.lengths]
    return (
        f" Rotations are times L = {lengths[0]:.4g} m, the characteristic length of the platform."
        if lengths
        else ""
    )


def _repeats(result: RecordResult) -> list[Block]:
    several = [repeat for repeat in result.repeats if len(repeat.files) > 1 and repeat.modes]
    if not several:
        return []
    files = sum(len(repeat.files) for repeat in several)
    widest = max(
        abs(f / np.mean(list(mode.values())) - 1.0)
        for repeat in several
        for mode in repeat.modes
        for f in mode.values()
    )
    colours = " Each setup has a colour, and its own means." if len(several) > 1 else ""
    return [
        Picture.of(
            identified_modes.scatter_of_repeats(several),
            "Frequencies in each file",
            f"{plural(files, 'file')}; the largest difference from a mean is {plain(100.0 * float(widest), 2)} %.",
            "Frequencies in each file, relative to their mean over the repeats. A file that is off in all modes was "
            f"measured elsewhere, or at another temperature.{colours}",
        )
    ]
