"""The report of ``pkmodes shaper``: what shapers leave of the vibration, where, and how certain that is."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace
from typing import TYPE_CHECKING, Any

import numpy as np
from numpy.typing import NDArray

from pkmodes.core.base.numbers import plain
from pkmodes.core.robot.report_fields import head_of
from pkmodes.core.robot.units import DISPLAY_UNITS
from pkmodes.core.support.ordering import joined
from pkmodes.machine.shaping.firmware import version_name
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

#: Title of the largest acceleration that Klipper suggests.
MAX_ACCELERATION = "Klipper's max_accel, for corners smoothed by 0.12 mm"
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
    parts = choice.parts.items()
    *recommended, together = shapers_tables(
        choice
    )  # where axes are independent, that for all of them is folded
    sections = [
        Section("shapers", "Shapers", recommended or [together]),
        *([Section("schedule", "Schedule", table)] if (table := schedule_blocks(choice)) else []),
        *([Section("together", "One shaper for all axes", [together], folded=True)] if recommended else []),
        Section("machine", "The machine", [machine(model, choice, content)], folded=True),
        Section(
            "workspace", "Over the workspace", [_over_workspace(model, part, axis) for axis, part in parts]
        ),
        *([] if spectrum is None else [over_frequency_section(choice, spectrum)]),
        Section(
            "errors",
            "Where frequencies differ from the model's",
            [_against_error(part, axis) for axis, part in parts],
            folded=True,
        ),
        Section("firmware", "Lines for firmware", [*firmware_lines(content), *schedule_lines(content)]),
        replace(origin(sources, model.mechanism), folded=True),
    ]
    return page(shaper_summary(model, choice, content), sections)


def shaper_summary(model: Model, choice: Choice, content: dict[str, Any]) -> Summary:
    """Return the recommended shaper, or that of each axis, and what it leaves at the worst pose."""
    parts = choice.parts
    worst = max(part.best.left_at_pose.worst for part in parts.values())
    if choice.by_axis:
        shapers = [f"{part.best.kind} on {axis} ({design_of(part.best)})" for axis, part in parts.items()]
        headline = f"{joined(shapers)} leave up to {_share(worst)} at the worst {choice.ringing.point_is}"
        reason = "The recommended fixed shapers: the axes are independent, so each has its own. " + " ".join(
            f"On {axis}, {part.best.kind} {_reason(part)}" for axis, part in parts.items()
        )
    else:
        headline = f"{choice.best.kind} leaves up to {_share(worst)} at the worst {choice.ringing.point_is}"
        reason = f"The recommended fixed shaper, for {design_of(choice.best)}. It {_reason(choice)}"
    facts = []
    for i, (axis, part) in enumerate(parts.items()):
        best, of, at = part.best, f"{axis}: " if axis else "", ("axes", i) if axis else ()
        place = (*at, "shapers", part.recommended)
        largest, on_pose = (pointer(*place, key, "worst") for key in ("left", "left_at_pose"))
        facts += [
            (
                f"{of}lasts",
                Cell(f"{plain(1e3 * best.duration, 3)} ms", best.duration, pointer(*place, "duration_s")),
            ),
            (
                f"{of}left at the worst {part.ringing.point_is}, of the vibration there",
                Cell(_per_cent(best.left_at_pose.worst), best.left_at_pose.worst, on_pose),
            ),
            (
                f"{of}largest vibration left, of the largest without",
                Cell(_per_cent(best.left.worst), best.left.worst, largest),
            ),
            (f"{of}{MAX_ACCELERATION}", acceleration_cell(best, pointer(*place, "max_acceleration"))),
        ]
    if not choice.by_axis:
        facts.append(
            (
                "largest vibration without, for a step of 1 m/s\u00b2",
                Cell(
                    f"{plain(1e6 * choice.unshaped.worst, 3)} \u00b5m",
                    choice.unshaped.worst,
                    pointer("unshaped", "worst"),
                ),
            )
        )
    return Summary(
        subject=f"{shortened(content['robot'])}, {choice.ringing.motors}",
        kind="Shaper",
        headline=headline,
        reason=reason,
        notes=[as_sentence(clean(note)) for note in content["notes"]],
        facts=[*facts, *spectrum_facts(content)],
        head=head_of(model.robot.report),
    )


def acceleration_cell(candidate: Candidate, json_pointer: str = "", *, unit: bool = True) -> Cell:
    """Return the largest acceleration that Klipper would suggest in mm/s^2, rounded as Klipper does.

    Klipper gives 0 where its speed in corners alone smooths them by more than it allows: it suggests none.
    """
    value = candidate.max_acceleration
    if value is None:
        return number(None)
    if value == 0.0:
        return Cell("none" if not unit else "none: corners are smoothed by more at any", value, json_pointer)
    step = 100 if value >= 1.0 else 1
    text = thousands(step * round(1e3 * value / step))
    return Cell(f"{text} mm/s\u00b2" if unit else text, value, json_pointer)


def _reason(choice: Choice) -> str:
    """Return what the recommended shaper leaves of the largest vibration, and why it is recommended."""
    share = _per_cent(choice.best.left.worst)
    return f"leaves at most {share} of the largest vibration without a shaper. {why_recommended(choice)}"


def why_recommended(choice: Choice) -> str:
    """Return why it is recommended."""
    limit, length = choice.left, choice.length
    lasting = "" if length is None else f" that lasts at most {1e3 * length:.4g} ms"
    of = "" if choice.firmware is None else f" of {version_name(choice.firmware)}"
    share = f"{plain(100.0 * limit, 3)} % of it"
    if choice.best.left.worst <= limit:
        return f"It is the shortest fixed one{of}{lasting} that leaves at most {share}."
    return f"No fixed one{of}{lasting} leaves at most {share}; it leaves least."


def as_sentence(text: str) -> str:
    """Return a note as a sentence; a name at its beginning keeps its small letter."""
    whole = sentence(text)
    return whole if text.partition(" ")[0].isalpha() else text[:1] + whole[1:]


def _per_cent(share: float) -> str:
    return f"{plain(100.0 * share, 3)} %" if share >= 1e-6 else "nothing"


def _share(share: float) -> str:
    """Return a share of the vibration for a headline."""
    return f"{plain(100.0 * share, 2)} % of the vibration"


def machine(model: Model, choice: Choice, content: dict[str, Any]) -> Facts:
    """Return the poses and the modes that count."""
    at = choice.ringing
    entries = [("poses", [Cell(thousands(content["poses"]), content["poses"], pointer("poses"))])]
    rms = number(choice.unshaped.rms, ".3g", pointer("unshaped", "rms"), scale=1e6)
    entries.append(("rms vibration without a shaper, for a step of 1 m/s\u00b2 [\u00b5m]", [rms]))
    # In the units of the poses below it.
    components = zip(model.mechanism.pose, choice.unshaped.pose.tolist(), strict=True)
    parts = [
        f"{component.name} = {value * DISPLAY_UNITS[component.unit][1] + 0.0:.5g} {DISPLAY_UNITS[component.unit][0]}"
        for component, value in components
    ]
    where = [minus(", ".join(parts))]
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


def shapers_tables(choice: Choice) -> list[Table]:
    """Return all shapers with what each leaves: for each independent axis, and last for all axes together."""
    tables = [shapers_table(part, axis, i) for i, (axis, part) in enumerate(choice.by_axis.items())]
    return [*tables, shapers_table(choice, recommends=not tables)]


def shapers_table(choice: Choice, axis: str = "", index: int = 0, *, recommends: bool = True) -> Table:
    """Return shapers, and what each leaves.

    - axis, index: that for which they are, and its number; empty for all
    - recommends: whether one of them is recommended
    """
    keys = {"rms": "rms [%]", "worst": "worst [%]", "rms_uncertain": "rms, uncertain [%]"}
    uncertain = any(candidate.left.rms_uncertain is not None for candidate in choice.candidates)
    if not uncertain:
        del keys["rms_uncertain"]
    columns = [
        Column("shaper", numbers=False),
        Column("design [Hz]", numbers=False),
        Column("lasts [ms]"),
        *(Column(title) for title in keys.values()),
        Column("largest [%]"),
        Column("max_accel"),
    ]
    rows = []
    for i, candidate in enumerate(choice.candidates):
        strong = recommends and i == choice.recommended
        at = (*(("axes", index) if axis else ()), "shapers", i)
        cells = [
            Cell(clean(candidate.kind) + (" *" if strong else ""), strong=strong),
            Cell(
                f"of the {choice.ringing.point_is}"
                if candidate.follows_pose
                else ", ".join(f"{f:.2f}" for f in candidate.frequencies)
            ),
            number(candidate.duration, ".1f", pointer(*at, "duration_s"), scale=1e3),
        ]
        cells += [
            number(
                getattr(candidate.left_at_pose, key), ".2f", pointer(*at, "left_at_pose", key), scale=100.0
            )
            for key in keys
        ]
        cells.append(number(candidate.left.worst, ".2f", pointer(*at, "left", "worst"), scale=100.0))
        cells.append(acceleration_cell(candidate, pointer(*at, "max_acceleration"), unit=False))
        rows.append(cells)
    point_is, points_are = choice.ringing.point_is, choice.ringing.points_are
    which = f" along {axis}" if axis else "" if recommends else ", with one shaper for all axes"
    caption = (
        f"What shapers leave{which}, of the vibration without a shaper at the same {point_is}: the root mean "
        f"square over the {points_are}, and the largest value"
    )
    if uncertain:
        caption += (
            "; the root mean square with frequencies spread by the standard deviations of the robot file"
        )
    caption += (
        ". The last share is of the largest vibration anywhere, and decides. max_accel [mm/s\u00b2] is what "
        "Klipper suggests."
    )
    note = "* The recommended one." if recommends else ""
    if any(candidate.follows_pose for candidate in choice.candidates):
        note += (
            f" Those of the {point_is} are judged at rest and for the model as it is: a move, and frequencies "
            "that differ from the model's, add to what they leave."
        )
    return Table(caption, columns, rows, note=note.strip(), heads=2)


def _picked(choice: Choice) -> dict[str, Candidate]:
    """Return the recommended shaper, and the best one that follows the pose."""
    best = choice.best
    picked = {f"{best.kind}, fixed": best}
    following = [candidate for candidate in choice.candidates if candidate.follows_pose]
    if following:
        follower = min(following, key=lambda candidate: (round(candidate.left.worst, 6), candidate.duration))
        picked[f"{follower.kind}, of the {choice.ringing.point_is}"] = follower
    return picked


def _over_workspace(model: Model, choice: Choice, axis: str = "") -> Picture | Paragraph:
    at, components = choice.ringing, model.mechanism.pose
    worst = choice.best.left
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
        return Paragraph(f"There is only one pose. Left of the vibration there{_along(axis)}: {share}.")
    clear = [name for name, values in shares.items() if values.max() < FLAT]
    shares = {name: values for name, values in shares.items() if name not in clear} or shares
    named = [components[i].name for i in varying]
    units = [DISPLAY_UNITS[components[i].unit] for i in varying]
    caption = f"Vibration that is left{_along(axis)}, in per cent of the largest one without a shaper"
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
    return Picture.of(drawn, f"Left over the workspace{_along(axis)}", caption + judged, caption + judged)


def _along(axis: str) -> str:
    """Return the axis that something is for, in words; empty for all."""
    return f" along {axis}" if axis else ""


def _plane(
    poses: NDArray[np.float64], through: NDArray[np.float64], normals: Sequence[int]
) -> tuple[NDArray[np.bool_], dict[int, float]]:
    """Return the poses in the layer through one of them, and its place; all poses where they form no layers."""
    layer = np.asarray((np.abs(poses[:, normals] - through[normals]) < SAME).all(axis=1))
    if layer.sum() < LAYER * len(poses) ** (2.0 / (2 + len(normals))):
        return np.ones(len(poses), dtype=bool), {}
    return layer, {i: float(through[i]) for i in normals}


def _against_error(choice: Choice, axis: str = "") -> Picture:
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
        f"Root mean square over the {at.points_are} of the vibration{_along(axis)} that is left if all "
        "frequencies differ from those of the model by the same share. Belts that are 10 % stiffer raise them by "
        "5 %."
    )
    spread = None if at.spread is None else float(at.spread.mean())
    if spread is not None:
        caption += " The band is the mean standard deviation of the frequencies."
    title = f"Against frequency error{_along(axis)}"
    return Picture.of(shapers.against_error(ERRORS, remaining, spread), title, caption, caption)
