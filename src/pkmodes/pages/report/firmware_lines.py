"""Lines for firmware in the report of ``pkmodes shaper``: for each version where lines or impulses differ."""

from __future__ import annotations

from typing import Any

from pkmodes.machine.shaping.firmware import HOW_TO_FIND_VERSION
from pkmodes.pages.report.blocks import Paragraph, VerbatimLines
from pkmodes.pages.report.formatting import clean, percent_text


def firmware_lines(content: dict[str, Any]) -> list[Paragraph | VerbatimLines]:
    """Return the lines for each version of a firmware: of the recommended shaper, or of the best that it has.

    - content: the JSON of the command
    """
    parts = content.get("axes") or [content]
    recommended = [part["shapers"][part["recommended"]] for part in parts]
    compared_share = max(
        shaper["left_at_pose"]["worst"] if "left_at_pose" in shaper else shaper["left"]["worst_uncertain"]
        for shaper in recommended
    )
    shapers_text = "shapers of each axis" if len(parts) > 1 else "shaper"
    intro = (
        f"For the recommended {shapers_text}. Check which axes your firmware shapes: usually x and y, not z."
    )
    return _line_blocks(
        intro, content["firmware_versions"], compared_share, "", "{} has none of the shapers compared."
    )


def schedule_lines(content: dict[str, Any]) -> list[Paragraph | VerbatimLines]:
    """Return the lines of the schedule in the same way; empty without a schedule.

    - content: the JSON of the command
    """
    if content["axes"]:
        scheduled = [(axis["axis"], axis["schedule"]) for axis in content["axes"] if axis["schedule"]]
        return [block for axis, schedule in scheduled for block in _schedule_lines(schedule, axis)]
    return _schedule_lines(content["schedule"], "") if content["schedule"] else []


def _schedule_lines(schedule: dict[str, Any], axis: str) -> list[Paragraph | VerbatimLines]:
    """Return the lines of a schedule.

    - schedule: its part of the JSON
    - axis: that for which it is; empty for all
    """
    by_layer = schedule["steps"][0]["heights_m"] is not None
    insert_at = (
        "before the first layer that begins at its height or above" if by_layer else "where its values begin"
    )
    intro = (
        f"For the schedule{' of ' + axis if axis else ''}: G-code, each line to be inserted {insert_at}. Klipper "
        "takes it if printer.cfg has a section [input_shaper]."
    )
    missing_sentence = "{} has none of the shapers compared."
    if axis:
        intro += f" No line changes another axis than {axis}."
        missing_sentence = f"{{}} has no shaper for {axis} by itself."
    suffix = f", schedule of {axis}" if axis else ", schedule"
    compared_share = schedule["left_at_pose"]["worst"]
    return _line_blocks(intro, schedule["firmware_versions"], compared_share, suffix, missing_sentence)


def _line_blocks(
    intro: str, versions: list[dict[str, Any]], compared_share: float, suffix: str, missing_sentence: str
) -> list[Paragraph | VerbatimLines]:
    """Return the lines; a version whose remaining vibration differs from `compared_share` shows its own.

    - versions: those of the JSON of the command
    - suffix: follows the name of a version in the title of its lines
    - missing_sentence: for a version without lines, with a field for its name
    """
    remaining_by_version = {
        version["version"]: percent_text(version["worst_at_pose"])
        for version in versions
        if version["worst_at_pose"] is not None
    }
    differing = {name for name, text in remaining_by_version.items() if text != percent_text(compared_share)}
    if differing:
        intro += (
            " Some versions lack a shaper, or turn these lines into other impulses than those compared above: what "
            f"theirs leave at most, instead of {percent_text(compared_share)}, is beside their names."
        )
    blocks: list[Paragraph | VerbatimLines] = [Paragraph(intro)]
    for i, version in enumerate(versions):
        name, firmware = version["version"], version["firmware"]
        if version["lines"]:
            remaining_text = f", leaves {remaining_by_version[name]}" if name in differing else ""
            replacement_note = f", {clean(version['shaper'])} instead" if version["instead"] else ""
            lines = [clean(line) for line in version["lines"].splitlines()]
            blocks.append(VerbatimLines(f"{name}{suffix}{replacement_note}{remaining_text}", lines))
        else:
            blocks.append(Paragraph(missing_sentence.format(name)))
        firmware_to_here, later_firmware = (
            [entry["firmware"] for entry in part] for part in (versions[: i + 1], versions[i + 1 :])
        )
        if firmware_to_here.count(firmware) > 1 and firmware not in later_firmware:
            blocks.append(Paragraph(HOW_TO_FIND_VERSION[firmware]))
    return blocks
