"""The tables of ``pkmodes sensitivities``: relative derivatives, standard deviations, derivatives per unit."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from typing import TYPE_CHECKING

import numpy as np
from numpy.typing import NDArray

from pkmodes.cli.terminal import Terminal
from pkmodes.core.mechanism.poses import placed
from pkmodes.sensitivity.changes import CORRELATED, SIGMA, changes_at, coinciding
from pkmodes.sensitivity.relative import alike_around, scalable
from pkmodes.sensitivity.spread import stated_sigmas
from pkmodes.support.motors import motors_in_words

if TYPE_CHECKING:
    from pkmodes.core.model import Model
    from pkmodes.core.solve.results import Modes
    from pkmodes.sensitivity.sensitivities import Sensitivities

Array = NDArray[np.float64]
#: Derivatives below these bounds are rounding and shown as 0: relative change of the frequency per relative change of
#: the value, or per SI unit if the value is 0.
NOTHING, NOTHING_BY_UNIT = 1e-9, 1e-15
Rows = Sequence[Sequence[str]]


@dataclass(frozen=True)
class _Line:
    """A quantity in the tables, with its derivatives for the vibration modes; or several that act as one."""

    path: str
    unit: str
    value: float
    rates: Array
    relative: Array

    @property
    def weight(self) -> float:
        """Sort key of the line, to six digits; 0 for a quantity that is 0, of which a percent is 0."""
        return float(f"{np.nanmax(np.abs(self.relative), initial=0.0):.6g}") if self.value else 0.0


def print_tables(
    model: Model, modes: Modes, derivatives: Sensitivities, relative: Array, *, most: int | None, asked: bool
) -> None:
    """Print derivatives at a pose.

    Parameters
    ----------
    relative : ndarray, shape (T, m)
        d ln f / d ln p; NaN where the value or the frequency is 0.
    most : int or None
        The most quantities in the first table, of those of which a per cent means something, and no table per unit;
        None for everything.
    asked : bool
        Whether the quantities were chosen: then nothing is said of others.
    """
    terminal = Terminal()
    rigid = modes.rigid_modes
    every = _lines(modes, derivatives, relative)
    acting = [line for line in every if line.rates.any()]
    at, doing = placed(model.mechanism, modes.poses, "g"), motors_in_words(model.robot, modes.drives)
    terminal.heading(f"{model.robot.name} at {at}, {doing}")
    numbers = [str(number) for number in range(1, len(modes.frequencies) - rigid + 1)]
    head = ["f [Hz]", *(f"{f:.3f}" for f in modes.frequencies[rigid:])]
    kept = set(scalable(model.robot)) if most is not None else {line.path for line in acting}
    present = _joined(model, modes, [line for line in acting if line.value != 0.0 and line.path in kept])
    if present:
        shown = present[:most]
        terminal.line()
        terminal.line(f"percent of the frequency per percent of the value{_how_many(shown, present, most)}:")
        rows = [head, *(row for line in shown for row in _named(line.path, map(_share, line.relative)))]
        _table(terminal, ["mode", *numbers], rows, 1)
    if not asked:
        _sigmas(terminal, model, modes, numbers)
    if most is not None:
        terminal.line()
        terminal.line(
            "--all prints everything: also coordinates, of which a percent depends on where the origin lies, effects "
            "that the file does not have, and Hz per unit of the value"
        )
    elif acting:
        terminal.line()
        terminal.line("Hz per unit of the value:")
        ordered = sorted(acting, key=lambda line: -line.weight)
        rows = [
            [line.path, f"{line.value:.6g}", "" if line.unit == "1" else line.unit, *map(_rate, line.rates)]
            for line in ordered
        ]
        _table(terminal, ["mode", "value", "unit", *numbers], rows, 3)
    still = [line.path for line in every if not line.rates.any()]
    if still and most is None:
        terminal.line()
        terminal.line(f"no frequency depends on: {', '.join(still)}")
    for sentence in coinciding(derivatives.groups.tolist(), rigid, "derivatives"):
        terminal.line()
        terminal.line(sentence)


def _how_many(shown: Sequence[_Line], present: Sequence[_Line], most: int | None) -> str:
    if most is None or len(shown) == len(present):
        return ""
    return f", the {len(shown)} largest of {len(present)} by their largest in any mode"


def _lines(modes: Modes, derivatives: Sensitivities, relative: Array) -> list[_Line]:
    """Return all quantities; what is rounding is zero."""
    values, rigid = derivatives.values.tolist(), modes.rigid_modes
    floor = np.array([NOTHING / abs(value) if value else NOTHING_BY_UNIT for value in values])
    small = np.abs(derivatives.frequencies) <= floor[:, None] * np.abs(modes.frequencies)
    rates = np.where(small, 0.0, derivatives.frequencies)[:, rigid:]
    return list(map(_Line, derivatives.parameters, derivatives.units, values, rates, relative[:, rigid:]))


def _joined(model: Model, modes: Modes, lines: Sequence[_Line]) -> list[_Line]:
    """Return the lines with those that act as one in one, the largest first."""
    if not lines:
        return []
    paths = [line.path for line in lines]
    joined = []
    for one in alike_around(model, modes.poses, paths, modes.drives):
        first = lines[one.members[0]]
        joined.append(_Line(one.name(paths), "1", first.value, first.rates, first.relative))
    return sorted(joined, key=lambda line: -line.weight)


def _sigmas(terminal: Terminal, model: Model, modes: Modes, numbers: Sequence[str]) -> None:
    """Print what one standard deviation of each value does, where the robot file states any."""
    sigmas = stated_sigmas(model.robot)
    if not sigmas:
        return
    found = changes_at(model, modes.poses, modes.drives, SIGMA)
    terminal.line()
    terminal.line("Hz for one standard deviation of the value:")
    rows = []
    for i in found.largest_of_all():
        (path,) = found.names[i]
        unit = model.robot.quantities[path].unit
        rows.append(
            [path, f"{sigmas[path]:.3g}", "" if unit == "1" else unit, *map(_hertz, found.changes[i])]
        )
    if found.together is not None:
        rows.append(["all together", "", "", *map(_hertz, found.together)])
    _table(terminal, ["mode", "sigma", "unit", *numbers], rows, 3)
    if model.robot.covariance:
        terminal.line(f"all together: {CORRELATED}")


def _table(terminal: Terminal, titles: Sequence[str], rows: Rows, fixed: int) -> None:
    """Print a table, as several below each other where it is wider than the terminal."""
    terminal.table(titles, rows, left=("mode", "unit"), repeated=1, described_by=fixed, even=True)


def _named(name: str, cells: Sequence[str] | map[str]) -> list[list[str]]:
    """Return the rows of a quantity: further names of it are below the first one."""
    first, *others = name.split(", ")
    numbers = list(cells)
    if not others:
        return [[first, *numbers]]
    names = [f"{one}," for one in (first, *others[:-1])] + [others[-1]]
    return [[names[0], *numbers], *([one, *[""] * len(numbers)] for one in names[1:])]


def _share(value: float) -> str:
    return "" if np.isnan(value) else "0" if abs(value) < 5e-5 else f"{value:.4f}"


def _rate(value: float) -> str:
    return "" if np.isnan(value) else f"{value:.4g}"


def _hertz(value: float) -> str:
    return "" if np.isnan(value) else "0" if abs(value) < 5e-4 else f"{value:.3f}"
