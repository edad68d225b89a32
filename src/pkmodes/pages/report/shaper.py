"""The report of ``pkmodes shaper``: what shapers leave of the vibration, where, and how certain that is."""

from __future__ import annotations

from collections.abc import Sequence
from typing import TYPE_CHECKING, Any

import numpy as np
from numpy.typing import NDArray

from pkmodes.core.base.numbers import plain
from pkmodes.core.mechanism.poses import format_pose
from pkmodes.core.robot.report_fields import head_of
from pkmodes.core.robot.units import DISPLAY_UNITS
from pkmodes.machine.shaping.residual_vibration import residual
from pkmodes.machine.shaping.settings import append_unit
from pkmodes.pages.plots import shapers
from pkmodes.pages.plots.labels import typeset
from pkmodes.pages.report.blocks import Cell, Column, Facts, Paragraph, Picture, Section, Summary, Table
from pkmodes.pages.report.firmware_lines import firmware_lines, schedule_lines
from pkmodes.pages.report.formatting import clean, minus, number, pointer, sentence, shortened, thousands
from pkmodes.pages.report.page import need_report, page
from pkmodes.pages.report.sections import origin
from pkmodes.pages.report.shaper_curves import CURVES, design_of, over_frequency_section, spectrum_facts
from pkmodes.pages.report.shaper_schedule import schedule_blocks
from pkmodes.pages.report.sources import Source, known_sources

if TYPE_CHECKING:
    from pkmodes.core.model import Model
    from pkmodes.machine.shaping.measured_spectrum import MeasuredSpectrum
    from pkmodes.machine.shaping.results import Candidate, Choice

#: Relative errors of the frequencies in the second figure.
ERRORS = np.linspace(-0.2, 0.2, 81)
#: Most poses at which shapers are evaluated over the frequency error.
POSES = 400
#: Poses whose components differ by less than this lie in one layer [SI].
SAME = 1e-9
#: Where less than this is left everywhere [%], a map would have a single colour.
FLAT = 0.05
#: Smallest number of poses in a layer, relative to that in a layer of a regular grid.
LAYER = 0.3


def shaper_report(
    model: Model,
    choice: Choice,
    content: dict[str, Any],
    sources: Sequence[Source] | None = None,
    spectrum: MeasuredSpectrum | None = None,
) -> str:
    """Return the report of a choice.

    - content: the JSON of the command
    - sources: the input files as they were read; by default the robot file as it is now
    - spectrum: over which shapers are drawn

    Returns HTML that needs no other file and no network.
    Raises MissingExtraError if the libraries of the extra ``report`` are not installed.
    """
    need_report()
    sources = known_sources([("robot file", model.robot.source)]) if sources is None else sources
    sections = [
        Section("shapers", "Shapers", [shapers_table(choice)]),
        *([Section("schedule", "Schedule", table)] if (table := schedule_blocks(choice)) else []),
        Section("machine", "The machine", [machine(model, choice, content)]),
        Section("workspace", "Over the workspace", [_over_workspace(model, choice)]),
        *([] if spectrum is None else [over_frequency_section(choice, spectrum)]),
        Section("errors", "Where frequencies differ from the model's", [_against_error(choice)]),
        Section("firmware", "Lines for firmware", [*firmware_lines(content), *schedule_lines(content)]),
        origin(sources, model.mechanism),
    ]
    return page(shaper_summary(model, choice, content), sections)


def shaper_summary(model: Model, choice: Choice, content: dict[str, Any]) -> Summary:
    """Return the recommended shaper, and what it leaves."""
    best, unshaped = choice.candidates[choice.recommended], choice.unshaped
    at = pointer("shapers", choice.recommended, "left", "worst")
    share = float(best.left_at.max())
    return Summary(
        subject=f"{shortened(content['robot'])}, {choice.ringing.motors}",
        kind="Shaper",
        headline=f"{best.kind} leaves {plain(100.0 * best.left.worst, 2)} % of the largest vibration",
        reason=(
            f"The recommended fixed shaper, for {design_of(best)}. Where it leaves most, the vibration "
            f"is {plain(100.0 * best.left.worst, 2)} % of the largest one without a shaper. {why_recommended(choice)}"
        ),
        notes=[as_sentence(clean(note)) for note in content["notes"]],
        facts=[
            ("lasts", Cell(f"{plain(1e3 * best.duration, 3)} ms", best.duration)),
            (
                "largest vibration left, of the largest without",
                Cell(_per_cent(best.left.worst), best.left.worst, at),
            ),
            (
                f"most left at one {choice.ringing.point_is}, of the vibration there",
                Cell(_per_cent(share), share),
            ),
            (
                "largest vibration without, for a step of 1 m/s\u00b2",
                Cell(
                    f"{plain(1e6 * unshaped.worst, 3)} \u00b5m", unshaped.worst, pointer("unshaped", "worst")
                ),
            ),
            *spectrum_facts(content),
        ],
        head=head_of(model.robot.report),
    )


def why_recommended(choice: Choice) -> str:
    """Return why it is recommended."""
    limit, length = choice.left, choice.length
    lasting = "" if length is None else f" that lasts at most {1e3 * length:.4g} ms"
    if choice.candidates[choice.recommended].left.worst <= limit:
        return f"It is the shortest fixed one{lasting} that leaves at most {plain(100.0 * limit, 3)} % there."
    return f"No fixed one{lasting} leaves at most {plain(100.0 * limit, 3)} % there; it leaves least."


def as_sentence(text: str) -> str:
    """Return a note as a sentence; a name at its beginning keeps its small letter."""
    whole = sentence(text)
    return whole if text.partition(" ")[0].isalpha() else text[:1] + whole[1:]


def _per_cent(share: float) -> str:
    return f"{plain(100.0 * share, 3)} %" if share >= 1e-6 else "nothing"


def machine(model: Model, choice: Choice, content: dict[str, Any]) -> Facts:
    """Return the poses and the modes that count."""
    at = choice.ringing
    entries = [("poses", [Cell(thousands(content["poses"]), content["poses"], pointer("poses"))])]
    rms = number(choice.unshaped.rms, ".3g", pointer("unshaped", "rms"), scale=1e6)
    entries.append(("rms vibration without a shaper, for a step of 1 m/s\u00b2 [\u00b5m]", [rms]))
    where = [minus(format_pose(model.mechanism, choice.unshaped.pose, ".4g"))]
    if choice.unshaped.setting is not None:
        where[0] = Cell(f"{where[0].text},", plain=f"{where[0].plain or where[0].text},")
        where.append(Cell(clean(choice.unshaped.setting)))
    entries.append(("largest without a shaper at", where))
    for path, symbol in at.settings[0].units.items() if at.settings else ():
        values = np.array([setting.values[path] for setting in at.settings])
        count = len(set(values.tolist()))
        extent = append_unit(_range(values, ".4g"), symbol) + (f" ({count} values)" if count > 1 else "")
        entries.append((clean(path), [minus(extent)]))
    for i, component in enumerate(model.mechanism.pose):
        unit, factor = DISPLAY_UNITS[component.unit]
        entries.append((component.name, [minus(f"{_range(at.poses[:, i] * factor, '.5g')} {unit}")]))
    for k in range(at.frequencies.shape[1]):
        text = f"{_range(at.frequencies[:, k], '.1f')} Hz"
        cells = [Cell(text)]
        if at.spread is not None:
            sigma = float(np.median(at.spread[:, k] * at.frequencies[:, k]))
            cells = [Cell(f"{text},"), Cell(f"standard deviation {plain(sigma, 2)} Hz (median)", sigma)]
        entries.append((f"mode {k + 1}", cells))
    return Facts(entries)


def _range(values: NDArray[np.float64], form: str) -> str:
    ends = dict.fromkeys(format(end, form) for end in (values.min() + 0.0, values.max() + 0.0))
    return " to ".join(ends)


def shapers_table(choice: Choice) -> Table:
    """Return all shapers, and what each leaves."""
    keys = {"rms": "left, rms [%]", "worst": "worst [%]", "rms_uncertain": "rms, uncertain [%]"}
    uncertain = any(candidate.left.rms_uncertain is not None for candidate in choice.candidates)
    if not uncertain:
        del keys["rms_uncertain"]
    columns = [
        Column("shaper", numbers=False),
        Column("design [Hz]", numbers=False),
        Column("lasts [ms]"),
        *(Column(title) for title in keys.values()),
    ]
    rows = []
    for i, candidate in enumerate(choice.candidates):
        strong = i == choice.recommended
        cells = [
            Cell(clean(candidate.kind) + (" *" if strong else ""), strong=strong),
            Cell(
                f"of the {choice.ringing.point_is}"
                if candidate.follows_pose
                else ", ".join(f"{f:.2f}" for f in candidate.frequencies)
            ),
            number(candidate.duration, ".1f", scale=1e3),
        ]
        cells += [number(getattr(candidate.left, key), ".2f", scale=100.0) for key in keys]
        rows.append(cells)
    caption = (
        f"What shapers leave of the vibration: the root mean square over the {choice.ringing.points_are}, of that "
        "without a shaper; the largest value, of the largest without a shaper"
    )
    if uncertain:
        caption += (
            "; the root mean square where frequencies are spread by the standard deviations of the robot file"
        )
    note = (
        f"* The recommended one. Those of the {choice.ringing.point_is} are judged at rest and for the model as it "
        "is: a move, and frequencies that differ from the model's, add to what they leave."
    )
    return Table(f"{caption}.", columns, rows, note=note, heads=2)


def _picked(choice: Choice) -> dict[str, Candidate]:
    """Return the recommended shaper, and the best one that follows the pose."""
    best = choice.candidates[choice.recommended]
    picked = {f"{best.kind}, fixed": best}
    following = [candidate for candidate in choice.candidates if candidate.follows_pose]
    if following:
        follower = min(following, key=lambda candidate: (round(candidate.left.worst, 6), candidate.duration))
        picked[f"{follower.kind}, of the {choice.ringing.point_is}"] = follower
    return picked


def _over_workspace(model: Model, choice: Choice) -> Picture | Paragraph:
    at, components = choice.ringing, model.mechanism.pose
    worst = choice.candidates[choice.recommended].left
    part = np.arange(len(at.poses))
    if worst.setting is not None:
        number = at.settings.index(worst.setting)
        part, at = np.flatnonzero(at.setting == number), at.only(number)
    varying = [i for i in range(len(components)) if np.ptp(at.poses[:, i]) > SAME]
    shares = {
        name: 100.0 * candidate.left_at[part] * at.unshaped / choice.unshaped.worst
        for name, candidate in _picked(choice).items()
    }
    if not varying:
        share = ", ".join(f"{name}: {_per_cent(values[0] / 100.0)}" for name, values in shares.items())
        return Paragraph(f"There is only one pose. Left of the vibration there: {share}.")
    clear = [name for name, values in shares.items() if values.max() < FLAT]
    shares = {name: values for name, values in shares.items() if name not in clear} or shares
    named = [components[i].name for i in varying]
    units = [DISPLAY_UNITS[components[i].unit] for i in varying]
    caption = "Vibration that is left, in per cent of the largest one without a shaper"
    if len(choice.ringing.settings) > 1:
        caption += f", at {clean(worst.setting)}, where the recommended shaper leaves most"
    judged = ". A shaper that follows the pose is judged at rest; a move adds to it."
    if clear and len(shares) < len(_picked(choice)):
        judged = (
            f". At rest, {' and '.join(clear).replace(',', '')} leaves nothing anywhere; a move adds to it."
        )
    if len(varying) == 1:
        drawn = shapers.along_line(at.poses[:, varying[0]], named[0], units[0], shares)
    else:
        plane, layer = _plane(at.poses, worst.pose, varying[2:])
        for i, value in layer.items():
            unit, factor = DISPLAY_UNITS[components[i].unit]
            caption += f", at {components[i].name} = {typeset(f'{value * factor:.4g}')} {unit}"
        caption += ", where the recommended shaper leaves most" if layer else ""
        drawn = shapers.over_plane(
            at.poses[plane][:, varying[:2]],
            named,
            units,
            {name: share[plane] for name, share in shares.items()},
        )
    return Picture.of(drawn, "Left over the workspace", caption + judged, caption + judged)


def _plane(
    poses: NDArray[np.float64], through: NDArray[np.float64], normals: Sequence[int]
) -> tuple[NDArray[np.bool_], dict[int, float]]:
    """Return the poses in the layer through one of them, and its place; all poses where they form no layers."""
    layer = np.asarray((np.abs(poses[:, normals] - through[normals]) < SAME).all(axis=1))
    if layer.sum() < LAYER * len(poses) ** (2.0 / (2 + len(normals))):
        return np.ones(len(poses), dtype=bool), {}
    return layer, {i: float(through[i]) for i in normals}


def _against_error(choice: Choice) -> Picture:
    at = choice.ringing
    sample = np.unique(np.linspace(0, len(at.poses) - 1, POSES).astype(int))
    f, ratios, weights = at.frequencies[sample], at.damping_ratios[sample], at.weights[sample]
    before = np.sqrt(np.mean(np.sum(weights**2, axis=1)))
    fixed = sorted(
        (candidate for candidate in choice.candidates if not candidate.follows_pose),
        key=lambda candidate: candidate.left.worst,
    )
    drawn = {**_picked(choice), **{f"{candidate.kind}, fixed": candidate for candidate in fixed[:CURVES]}}
    remaining = {}
    for name, candidate in list(drawn.items())[:CURVES]:
        impulses = candidate.shaper
        if candidate.follows_pose:
            impulses = type(impulses)(impulses.amplitudes[sample], impulses.delays[sample])
        all_left = np.array([residual(impulses, f * (1.0 + error), ratios) for error in ERRORS])
        remaining[name] = 100.0 * np.sqrt(np.mean(np.sum((weights * all_left) ** 2, axis=2), axis=1)) / before
    caption = (
        f"Root mean square over the {at.points_are} of the vibration that is left if all frequencies differ from "
        "those of the model by the same share. Belts that are 10 % stiffer raise them by 5 %."
    )
    spread = None if at.spread is None else float(at.spread.mean())
    if spread is not None:
        caption += " The band is the mean standard deviation of the frequencies."
    return Picture.of(
        shapers.against_error(ERRORS, remaining, spread), "Against frequency error", caption, caption
    )
