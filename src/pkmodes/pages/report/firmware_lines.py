"""Lines for firmware in the report of ``pkmodes shaper``: for each version where lines or impulses differ."""

from __future__ import annotations

from typing import Any

from pkmodes.machine.shaping.firmware import HOW_TO_FIND_VERSION
from pkmodes.pages.report.blocks import Lines, Paragraph
from pkmodes.pages.report.formatting import clean, per_cent

#: Keys of the remaining vibration, in order of preference.
WORST_KEYS = ("worst_uncertain", "worst")


def firmware_lines(content: dict[str, Any]) -> list[Paragraph | Lines]:
    """Return the lines for each version of a firmware that has the recommended shaper.

    - content: the JSON of the command
    """
    remaining = content["shapers"][content["recommended"]]["left"]
    compared_share = next(remaining[key] for key in WORST_KEYS if key in remaining)
    intro = "For the recommended shaper. Check which axes your firmware shapes: usually x and y, not z."
    return _blocks(intro, content["firmware_versions"], compared_share, "", "{} has no such shaper.")


def schedule_lines(content: dict[str, Any]) -> list[Paragraph | Lines]:
    """Return the lines of the schedule in the same way; empty without a schedule.

    - content: the JSON of the command
    """
    schedule = content["schedule"]
    if schedule is None:
        return []
    by_layer = schedule["steps"][0]["heights_m"] is not None
    insert_at = (
        "before the first layer that begins at its height or above" if by_layer else "where its values begin"
    )
    intro = (
        f"For the schedule: G-code, each line to be inserted {insert_at}. Klipper takes it if printer.cfg has a "
        "section [input_shaper]."
    )
    compared_share, missing_sentence = schedule["left"]["worst"], "{} lacks a shaper of the schedule."
    return _blocks(intro, schedule["firmware_versions"], compared_share, ", schedule", missing_sentence)


def _blocks(
    intro: str, versions: list[dict[str, Any]], compared_share: float, suffix: str, missing_sentence: str
) -> list[Paragraph | Lines]:
    """Return the lines; a version whose remaining vibration differs from `compared_share` shows its own.

    - versions: those of the JSON of the command
    - suffix: follows the name of a version in the title of its lines
    - missing_sentence: for a version without lines, with a field for its name
    """
    remaining_by_version = {
        version["version"]: per_cent(version["worst"]) for version in versions if version["worst"] is not None
    }
    differing = {name for name, text in remaining_by_version.items() if text != per_cent(compared_share)}
    if differing:
        intro += (
            " Some versions turn these lines into other impulses than those compared above: what these leave at "
            f"most, instead of {per_cent(compared_share)}, is beside their names."
        )
    blocks: list[Paragraph | Lines] = [Paragraph(intro)]
    for i, version in enumerate(versions):
        name, firmware = version["version"], version["firmware"]
        if version["lines"]:
            remaining_text = f", leaves {remaining_by_version[name]}" if name in differing else ""
            blocks.append(
                Lines(
                    f"{name}{suffix}{remaining_text}", [clean(line) for line in version["lines"].splitlines()]
                )
            )
        else:
            blocks.append(Paragraph(missing_sentence.format(name)))
        so_far, later = (
            [entry["firmware"] for entry in part] for part in (versions[: i + 1], versions[i + 1 :])
        )
        if so_far.count(firmware) > 1 and firmware not in later:
            blocks.append(Paragraph(HOW_TO_FIND_VERSION[firmware]))
    return blocks
