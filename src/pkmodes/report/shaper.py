"""The report of ``pkmodes shaper``: what shapers leave of the vibration, where, and how surely."""

from __future__ import annotations

from collections.abc import Sequence
from typing import TYPE_CHECKING, Any

import numpy as np

from pkmodes.plots import shapers
from pkmodes.plots.style import styled
from pkmodes.report.blocks import Cell, Column, Facts, Listing, Paragraph, Picture, Section, Summary, Table
from pkmodes.report.formatting import clean, number, pointer
from pkmodes.report.origin import files_of
from pkmodes.report.page import need_report, page
from pkmodes.report.sources import Source, known_sources
from pkmodes.robot.units import SHOWN
from pkmodes.shaping.residual_vibration import residual

if TYPE_CHECKING:
    from pkmodes.model.model import Model
    from pkmodes.shaping.choice import Candidate, Choice

#: Relative errors of the frequencies in the second figure.
ERRORS = np.linspace(-0.2, 0.2, 81)
#: Shapers drawn over the frequency error at most, and poses at which they are evaluated.
CURVES, POSES = 5, 400


def shaper_report(
    model: Model, choice: Choice, content: dict[str, Any], sources: Sequence[Source] | None = None
) -> str:
    """Return the report of a choice.

    Parameters
    ----------
    content : dict
        The JSON of the command.
    sources : sequence of Source, optional
        The input files as they were read; by default the robot file as it is now.

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
    sources = known_sources([("robot file", model.robot.source)]) if sources is None else sources
    sections = [
        Section("shapers", "Shapers", [_table(content)]),
        Section("workspace", "Over the workspace", [_over_workspace(model, choice)]),
        Section("errors", "Where frequencies differ from the model's", [_against_error(choice)]),
        Section("firmware", "Lines for firmware", _firmware(content)),
        Section("origin", "Data and versions", [Facts(files_of(sources))]),
    ]
    return page(_summary(choice, content), sections)


def _summary(choice: Choice, content: dict[str, Any]) -> Summary:
    best = choice.candidates[choice.recommended]
    at = pointer("shapers", choice.recommended, "left", "worst")
    return Summary(
        subject=clean(content["robot"]),
        kind="Shaper",
        verdict="",
        headline=f"{best.kind} leaves at most {100.0 * best.left.worst:.2g} % of the vibration",
        reason=f"The recommended fixed shaper, for {_design(best)}; motors held, {content['poses']} poses.",
        tone="plain",
        notes=[clean(note) for note in content["notes"]],
        facts=[
            ("lasts", Cell(f"{1e3 * best.duration:.3g} ms", best.duration)),
            ("left at the worst pose", Cell(f"{100.0 * best.left.worst:.3g} %", best.left.worst, at)),
            ("modes that count", Cell(str(content["modes"]), content["modes"], pointer("modes"))),
        ],
    )


def _design(one: Candidate) -> str:
    return ", ".join(f"{f:.1f}" for f in one.frequencies) + " Hz"


def _table(content: dict[str, Any]) -> Table:
    columns = [
        Column("shaper", numbers=False),
        Column("design [Hz]", numbers=False),
        Column("lasts [ms]"),
        Column("left, rms [%]"),
        Column("worst [%]"),
        Column("rms, uncertain [%]"),
    ]
    rows = []
    for i, one in enumerate(content["shapers"]):
        design = one["frequencies_hz"]
        left, strong = one["left"], i == content["recommended"]
        cells = [
            Cell(clean(one["kind"]), strong=strong),
            Cell("of the pose" if design is None else ", ".join(f"{f:.2f}" for f in design)),
            number(one["duration_s"], ".1f", scale=1e3),
        ]
        for key in ("rms", "worst", "rms_uncertain"):
            value = left[key]
            cells.append(Cell("\u2013") if value is None else number(value, ".2f", scale=100.0))
        rows.append(cells)
    caption = (
        "What shapers leave of the vibration, relative to none: root mean square over the poses, largest value over "
        "the largest without a shaper, and the root mean square where frequencies are spread by the standard "
        "deviations of the robot file. The recommended one is bold."
    )
    return Table(caption, columns, rows)


def _picked(choice: Choice) -> dict[str, Candidate]:
    """Return the recommended shaper, and the best one that follows the pose."""
    best = choice.candidates[choice.recommended]
    picked = {f"{best.kind}, fixed": best}
    following = [one for one in choice.candidates if one.follows_pose]
    if following:
        one = min(following, key=lambda each: (round(each.left.worst, 6), each.duration))
        picked[f"{one.kind}, of the pose"] = one
    return picked


def _over_workspace(model: Model, choice: Choice) -> Picture:
    poses, components = choice.ringing.poses, model.mechanism.pose
    shown = [0, 1] if poses.shape[1] > 1 else [0, 0]
    worst = choice.candidates[choice.recommended].left.pose
    others = [i for i in range(poses.shape[1]) if i not in shown]
    plane = np.isclose(poses[:, others], worst[others], rtol=0.0, atol=1e-9).all(axis=1)
    layer = "".join(
        f", at {components[i].name} = {worst[i] * SHOWN[components[i].unit][1]:.4g} {SHOWN[components[i].unit][0]}"
        for i in others
    )
    caption = (
        f"Vibration that is left, relative to that without a shaper at the same pose{layer}, where the recommended "
        "shaper leaves most. A shaper that follows the pose is judged at rest; a move adds to it."
    )
    with styled():
        drawn = shapers.left_over(
            poses[plane][:, shown],
            [components[i].name for i in shown],
            [SHOWN[components[i].unit] for i in shown],
            {name: one.left_at[plane] for name, one in _picked(choice).items()},
        )
        return Picture.of(drawn, "Left over the workspace", caption, caption)


def _against_error(choice: Choice) -> Picture:
    at = choice.ringing
    some = np.unique(np.linspace(0, len(at.poses) - 1, POSES).astype(int))
    f, ratios, weights = at.frequencies[some], at.damping_ratios[some], at.weights[some]
    before = np.sqrt(np.mean(np.sum(weights**2, axis=1)))
    fixed = sorted((one for one in choice.candidates if not one.follows_pose), key=lambda one: one.left.worst)
    drawn = {**_picked(choice), **{f"{one.kind}, fixed": one for one in fixed[:CURVES]}}
    left = {}
    for name, one in list(drawn.items())[:CURVES]:
        impulses = one.shaper
        if one.follows_pose:
            impulses = type(impulses)(impulses.amplitudes[some], impulses.delays[some])
        all_left = np.array([residual(impulses, f * (1.0 + error), ratios) for error in ERRORS])
        left[name] = np.sqrt(np.mean(np.sum((weights * all_left) ** 2, axis=2), axis=1)) / before
    caption = (
        "Root mean square over the poses of the vibration that is left if all frequencies differ from those of the "
        "model by the same share, such as belts of another stiffness: 10 % in stiffness are 5 % in frequency."
    )
    spread = None if at.spread is None else float(at.spread.mean())
    if spread is not None:
        caption += " The band is the mean standard deviation of the frequencies."
    with styled():
        return Picture.of(
            shapers.against_error(ERRORS, left, spread), "Against frequency error", caption, caption
        )


def _firmware(content: dict[str, Any]) -> list[Paragraph | Listing]:
    blocks: list[Paragraph | Listing] = [
        Paragraph("For the recommended shaper. Check which axes your firmware shapes: many leave out z.")
    ]
    for name, lines in content["firmware"].items():
        blocks.append(Paragraph(clean(name) if lines else f"{clean(name)} has no such shaper."))
        if lines:
            blocks.append(Listing([clean(line) for line in lines.splitlines()], names=True))
    return blocks
