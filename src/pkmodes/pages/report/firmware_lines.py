"""Lines for firmware in the report of ``pkmodes shaper``: for each version where lines or impulses differ."""

from __future__ import annotations

from typing import Any

from pkmodes.core.base.numbers import plain
from pkmodes.machine.shaping.firmware import ASK
from pkmodes.pages.report.blocks import Lines, Paragraph
from pkmodes.pages.report.formatting import clean

#: Keys of the remaining vibration, in order of preference.
WORST = ("worst_uncertain", "worst")


def firmware_lines(content: dict[str, Any]) -> list[Paragraph | Lines]:
    """Return the lines for each version of a firmware that has the recommended shaper.

    - content: the JSON of the command
    """
    remaining = content["shapers"][content["recommended"]]["left"]
    reported = next(remaining[key] for key in WORST if key in remaining)
    intro = "For the recommended shaper. Check which axes your firmware shapes: usually x and y, not z."
    return _blocks(intro, content["firmware_versions"], reported, "", "{} has no such shaper.")


def schedule_lines(content: dict[str, Any]) -> list[Paragraph | Lines]:
    """Return the lines of the schedule in the same way; empty without a schedule.

    - content: the JSON of the command
    """
    schedule = content["schedule"]
    if schedule is None:
        return []
    layers = schedule["steps"][0]["heights_m"] is not None
    where = (
        "before the first layer that begins at its height or above" if layers else "where its values begin"
    )
    intro = (
        f"For the schedule: G-code, each line to be inserted {where}. Klipper takes it if printer.cfg has a section "
        "[input_shaper]."
    )
    reported, lacks = schedule["left"]["worst"], "{} lacks a shaper of the schedule."
    return _blocks(intro, schedule["firmware_versions"], reported, ", schedule", lacks)


def _blocks(
    intro: str, versions: list[dict[str, Any]], reported: float, suffix: str, lacks: str
) -> list[Paragraph | Lines]:
    """Return the lines, with the vibration that a version leaves if it differs from what is reported elsewhere."""
    leaves = {
        version["version"]: _per_cent(version["worst"])
        for version in versions
        if version["worst"] is not None
    }
    differing = {name for name, share in leaves.items() if share != _per_cent(reported)}
    if differing:
        intro += (
            " Some versions turn these lines into other impulses than those compared above: what these leave at "
            f"most, instead of {_per_cent(reported)}, is beside their names."
        )
    blocks: list[Paragraph | Lines] = [Paragraph(intro)]
    for i, version in enumerate(versions):
        name, firmware = version["version"], version["firmware"]
        if version["lines"]:
            share = f", leaves {leaves[name]}" if name in differing else ""
            blocks.append(
                Lines(f"{name}{suffix}{share}", [clean(line) for line in version["lines"].splitlines()])
            )
        else:
            blocks.append(Paragraph(lacks.format(name)))
        so_far, later = (
            [entry["firmware"] for entry in part] for part in (versions[: i + 1], versions[i + 1 :])
        )
        if so_far.count(firmware) > 1 and firmware not in later:
            blocks.append(Paragraph(ASK[firmware]))
    return blocks


def _per_cent(share: float) -> str:
    """Return a share in per cent, as sentences give it."""
    return f"{plain(100.0 * share, 2)} %"
