"""Print the summary of a map on the terminal: what was mapped, and where each frequency is lowest and highest."""

from __future__ import annotations

from typing import Any

from pkmodes.cli.terminal import Terminal
from pkmodes.model.model import Model
from pkmodes.robot.corrections import changeable


def show(model: Model, content: dict[str, Any]) -> None:
    """Print the summary of a map of a robot, from `pkmodes.maps.summary.summary_of`."""
    terminal = Terminal()
    units = {component.name: component.unit for component in model.mechanism.pose}
    units |= {path: unit for path, unit in changeable(model.robot).items() if unit != "1"}
    terminal.heading(
        f"{content['robot']}, motors {content['drives']}: {content['valid']:,} of {content['poses']:,} poses can be "
        "evaluated"
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
    rows = [
        [str(row["mode"]), *_cells(row, "minimum", several), *_cells(row, "maximum", several)]
        for row in content["modes"]
    ]
    terminal.table(("mode", "lowest [Hz]", *several, "highest [Hz]", *several), rows)
    if content["file"]:
        terminal.line()
        terminal.heading(f"wrote {content['file']}")


def _cells(row: dict[str, Any], end: str, dims: list[str]) -> list[str]:
    """Return an extreme frequency and its place."""
    value, at = row[f"{end}_hz"], row[f"{end}_at"] or {}
    return ["-" if value is None else f"{value:.3f}", *(_shown(at.get(name, "-")) for name in dims)]


def _shown(value: Any) -> str:
    return value if isinstance(value, str) else f"{value:.6g}"
