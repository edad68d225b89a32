"""Print the summary of a map on the terminal: what was mapped, and between which frequencies each mode lies."""

from __future__ import annotations

from collections.abc import Iterator
from typing import Any

from pkmodes.base.numbers import hertz
from pkmodes.cli.terminal import Terminal
from pkmodes.maps.left_out import sentences
from pkmodes.maps.summary import SHARES, quantiles_in_words
from pkmodes.model.model import Model
from pkmodes.robot.corrections import changeable
from pkmodes.robot.motors import motors_in_words


def show(model: Model, content: dict[str, Any]) -> None:
    """Print the summary of a map of a robot, from `pkmodes.maps.summary.summary_of`."""
    terminal = Terminal()
    units = {component.name: component.unit for component in model.mechanism.pose}
    units |= {path: unit for path, unit in changeable(model.robot).items() if unit != "1"}
    terminal.line(
        f"{content['robot']}, {motors_in_words(model.robot, content['drives'])}: {content['valid']:,} of "
        f"{content['poses']:,} poses can be evaluated"
    )
    several = [name for name in content["ranges"] if content["dimensions"][name] > 1]
    for dim, (first, last) in content["ranges"].items():
        unit = f" {units[dim]}" if dim in units else ""
        if dim in several and not isinstance(first, str):
            number = content["dimensions"][dim]
            terminal.line(f"{dim} from {_shown(first)} to {_shown(last)}{unit}, {number} values", "  ")
        elif dim not in several:
            terminal.line(f"{dim} = {_shown(first)}{unit}", "  ")
    for code, count in content["reasons"].items():
        terminal.line(f"{count:,} cannot: {model.reasons[code]}", "  ")
    terminal.line()
    terminal.line(f"{quantiles_in_words(content)}:")
    terminal.table(
        ("mode", "2 % [Hz]", "median [Hz]", "98 % [Hz]"),
        [[str(row["mode"]), *(_hertz(row[key]) for key in SHARES)] for row in content["modes"]],
    )
    terminal.line()
    terminal.line("The extremes, and where they are:")
    terminal.table(
        ("mode", "", "f [Hz]", *several),
        [cells for row in content["modes"] for cells in _ends(row, several)],
        left=[""],
        repeated=3,
    )
    for sentence in sentences(content, units):
        terminal.line()
        terminal.line(sentence)
    if content["file"]:
        terminal.line()
        terminal.heading(f"wrote {content['file']}")


def _ends(row: dict[str, Any], dims: list[str]) -> Iterator[list[str]]:
    """Yield the lines of the lowest and of the highest frequency of a mode, each with its place."""
    for number, word, end in ((str(row["mode"]), "lowest", "minimum"), ("", "highest", "maximum")):
        at = row[f"{end}_at"] or {}
        yield [number, word, _hertz(row[f"{end}_hz"]), *(_shown(at.get(name, "-")) for name in dims)]


def _shown(value: Any) -> str:
    return value if isinstance(value, str) else f"{value:.6g}"


def _hertz(value: float | None) -> str:
    return "-" if value is None else hertz(value)
