"""The correction of a robot as a difference of its file."""

from __future__ import annotations

import difflib
from pathlib import Path

from pkmodes.core.base.errors import PkmodesError
from pkmodes.core.robot.robot import Robot
from pkmodes.diagnosis.verdict.result import Diagnosis
from pkmodes.report.blocks import Block, Difference, Paragraph
from pkmodes.report.formatting import SENTENCE, clean
from pkmodes.updating.corrected_robot import corrected_robot

NO_END = "\\ No newline at end of file"


def correction(result: Diagnosis, robot: Robot | None) -> list[Block]:
    """Return the difference that ``--save-robot`` makes, or why there is none."""
    if robot is None:
        return [Paragraph("The model is not a robot file, so there is no file to correct.")]
    if not result.settled:
        return [Paragraph(f"No correction: the verdict is {result.verdict}.")]
    try:
        after = corrected_robot(robot, result)
    except PkmodesError as error:
        return [Paragraph(f"There is no corrected robot file: {clean(error.what, SENTENCE)}.")]
    source = Path(robot.source)
    lines = difference(source.read_bytes().decode("utf-8"), after, source.name)
    if not lines:
        return [Paragraph("The robot file needs no correction.")]
    losses = "the losses that the damping shows, " if result.damping.effects else ""
    several = [effect for effect in result.every_cause if len(effect.members) > 1]
    chosen = "".join(
        f" It has {clean(effect.name)}; the data cannot tell it from {' or '.join(map(clean, effect.members[1:]))}."
        for effect in several
    )
    return [
        Paragraph(
            "What the corrected robot file has instead of the given one, as written by --save-robot: the cause where "
            f"one was found, {losses}and the refitted values with their new standard deviations. "
            f"Comments and order are kept.{chosen}"
        ),
        Difference("Difference of the robot file", lines),
    ]


def difference(before: str, after: str, name: str) -> list[str]:
    """Return a unified difference, without line ends; `patch` applies it to the file.

    Parameters
    ----------
    before, after : str
        Two texts.
    name : str
        Name of the file.
    """
    lines = difflib.unified_diff(_lines(before), _lines(after), clean(name), clean(name), lineterm="")
    return [part for line in lines for part in line.split("\n")]


def _lines(text: str) -> list[str]:
    """Return the lines of a text without their ends; the last one says if it has none, as in `diff`."""
    *lines, rest = text.replace("\r\n", "\n").split("\n")
    visible = [
        "\t".join(clean(part, None) for part in line.split("\t"))
        for line in [*lines, *([rest] if rest else [])]
    ]
    return [*visible[:-1], f"{visible[-1]}\n{NO_END}"] if rest else visible
