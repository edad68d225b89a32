"""Print a comparison with measurements: by mode, the rows that differ most, and if asked all of them."""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from typing import TYPE_CHECKING

import numpy as np

from pkmodes.cli.diagnosis_tables import setting
from pkmodes.cli.printing import signed
from pkmodes.cli.terminal import Terminal
from pkmodes.support.motors import motors_in_words
from pkmodes.support.numbers import hertz, p_in_words
from pkmodes.support.ordering import listed, sorted_labels

if TYPE_CHECKING:
    from pathlib import Path

    from pkmodes.core.robot.robot import Robot
    from pkmodes.diagnosis import Comparison
    from pkmodes.diagnosis.compare import ComparedRow

#: Rows that are shown without ``--all``, and unmatched ones and settings named there at most.
WORST, MOST_NAMED = 5, 8
#: Headings of the table of rows, which are text.
TEXT = ("pose", "motors", "own")


def show(robot: Robot, modes: Path, result: Comparison, everything: bool) -> None:
    """Print a comparison of a robot with the measurements of a file.

    Parameters
    ----------
    everything : bool
        Whether all rows are printed, in the order of the poses, instead of those that differ most.
    """
    terminal, rows = Terminal(), result.rows
    terminal.heading(f"{robot.name} compared with {modes}")
    terminal.line(_counted(robot, result))
    rms, chi2, p = result.rms_relative, result.chi2_per_dof, result.p_value
    if rms is not None and chi2 is not None and p is not None:
        terminal.line(
            f"rms of the differences {100 * rms:.3g} %, chi2 per degree of freedom {chi2:.3g} ({p_in_words(p)})"
        )
    for note in result.notes:
        terminal.line(note)
    if any(row.partner is not None for row in rows):
        terminal.line()
        _by_mode(terminal, result)
    if result.unpaired:
        terminal.line()
        unmatched = [f"{row.measured:g} Hz (line {row.line})" for row in result.unpaired]
        terminal.line(_named(unmatched, "unmatched:"))
    table, few = _Rows(terminal, result), len(rows) <= WORST
    worst = sorted((row for row in rows if row.sigmas is not None), key=lambda row: -abs(row.sigmas or 0.0))
    if worst and not few:
        terminal.line()
        terminal.line(f"the {min(WORST, len(worst))} that differ most, in standard deviations:")
        table.show(worst[:WORST], sorted_by_pose=False)
    if everything or few:
        terminal.line()
        terminal.line("all measured modes:")
        poses = {pose: i for i, pose in enumerate(sorted_labels(dict.fromkeys(row.pose for row in rows)))}
        ordered = sorted(rows, key=lambda row: (poses[row.pose], row.measured))
        table.show(ordered, sorted_by_pose=True)
        _damping(terminal, ordered, result.rigid)
    _settings(terminal, robot, rows, len(rows) if everything else MOST_NAMED)
    terminal.line()
    own = "own: mode number in the file; " if any(row.mode for row in rows) else ""
    terminal.line(
        f"line: in the file; {own}mode: number of the model's mode as in pkmodes modes; diff: prediction minus "
        "measurement; sigmas: diff in standard deviations"
    )
    if not (everything or few):
        terminal.line("every row: --all, --json or --report")


def _counted(robot: Robot, result: Comparison) -> str:
    count, poses = len(result.rows), len({row.pose for row in result.rows})
    unmatched = f", {len(result.unpaired)} of them unmatched" if result.unpaired else ""
    return (
        f"{count} measured mode{'' if count == 1 else 's'} at {poses} pose{'' if poses == 1 else 's'}{unmatched}, "
        f"{motors_in_words(robot, [row.drives for row in result.rows])}, frequencies in Hz"
    )


def _by_mode(terminal: Terminal, result: Comparison) -> None:
    """Print how far each mode of the model is from what was measured of it."""
    damped = any(row.damping is not None for row in result.rows)
    titles = ["mode", "number", "median [%]", "rms [%]", "largest [%]", "sigmas", "line"]
    titles += ["damping [%]", "model"] if damped else []
    cells = []
    for partner in sorted({row.partner for row in result.rows if row.partner is not None}):
        mine = [row for row in result.rows if row.partner == partner]
        differences = 100.0 * np.array([row.residual for row in mine], dtype=float)
        largest = mine[int(np.argmax(np.abs(differences)))]
        cells.append(
            [
                str(partner - result.rigid),
                str(len(mine)),
                signed(float(np.median(differences))),
                f"{np.sqrt(np.mean(differences**2)):.2f}",
                signed(100.0 * (largest.residual or 0.0)),
                signed(largest.sigmas or 0.0, 1),
                str(largest.line),
                *(
                    [_median(row.damping for row in mine), _median(row.predicted_damping for row in mine)]
                    if damped
                    else []
                ),
            ]
        )
    terminal.table(titles, cells)
    if damped:
        terminal.line("damping: medians, measured and of the model")


class _Rows:
    """The table of measured modes, which has the same columns wherever it is printed."""

    def __init__(self, terminal: Terminal, result: Comparison) -> None:
        self._terminal, self._rigid = terminal, result.rigid
        self._shapes = any(row.mac is not None for row in result.rows)
        self._numbered = any(row.mode for row in result.rows)
        self._mixed = len({row.drives for row in result.rows}) > 1

    def show(self, rows: Sequence[ComparedRow], *, sorted_by_pose: bool) -> None:
        """Print rows: the pose in a column, or where that is too wide on a line above them, perhaps without `own`."""
        again = [sorted_by_pose and i > 0 and rows[i - 1].pose == row.pose for i, row in enumerate(rows)]
        poses = [["" if same else row.pose] for row, same in zip(rows, again, strict=True)]
        did = [["" if same else row.drives or ""] for row, same in zip(rows, again, strict=True)]
        begin = ["pose", "motors"] if self._mixed else ["pose"]
        labels = [[*a, *b] if self._mixed else a for a, b in zip(poses, did, strict=True)]
        titles, cells = self._columns(rows, self._numbered)
        beside = [[*label, *row] for label, row in zip(labels, cells, strict=True)]
        if self._terminal.fits([*begin, *titles], beside):
            self._terminal.table([*begin, *titles], beside, TEXT)
            return
        if not self._terminal.fits(titles, cells):
            titles, cells = self._columns(rows, False)
        above = [", motors ".join(filter(None, label)) for label in labels]
        self._terminal.table(titles, cells, TEXT, above=above)

    def _columns(self, rows: Sequence[ComparedRow], numbered: bool) -> tuple[list[str], list[list[str]]]:
        """Return titles and cells of everything but the pose."""
        titles = ["line", *(["own"] if numbered else []), "mode", "measured", "sigma", "predicted"]
        titles += ["diff [%]", "sigmas", *(["MAC"] if self._shapes else [])]
        cells = [
            [
                str(row.line),
                *([row.mode] if numbered else []),
                *_numbers(row, self._rigid),
                *(["" if row.mac is None else f"{row.mac:.3f}"] if self._shapes else []),
            ]
            for row in rows
        ]
        return titles, cells


def _damping(terminal: Terminal, rows: Sequence[ComparedRow], rigid: int) -> None:
    """Print the damping ratios of rows that have any."""
    some = [row for row in rows if row.damping is not None]
    if not some:
        return
    remarked = any(row.no_evidence for row in some)
    cells = [
        [
            str(row.line),
            "none" if row.partner is None else str(row.partner - rigid),
            *(
                "" if ratio is None else f"{100.0 * ratio:.3g}"
                for ratio in (row.damping, row.sigma_damping, row.predicted_damping)
            ),
            *([f"another shape (MAC {row.mac:.2f})" if row.no_evidence else ""] if remarked else []),
        ]
        for row in some
    ]
    terminal.line()
    terminal.line("damping ratios:")
    titles = ["line", "mode", "measured [%]", "sigma", "model [%]", *(["remark"] if remarked else [])]
    terminal.table(titles, cells, left=("remark",) if remarked else ())


def _settings(terminal: Terminal, robot: Robot, rows: Sequence[ComparedRow], most: int) -> None:
    """Print what the measurements set, and at which poses."""
    loads: dict[str, dict[str, None]] = {}
    for row in rows:
        if row.load:
            loads.setdefault(setting(robot.mechanism, row.load), {})[row.pose] = None
    if not loads:
        return
    terminal.line()
    terminal.line("set by the measurements:")
    for load, poses in list(loads.items())[:most]:
        terminal.line(f"{load} ({_named(list(poses), 'pose' if len(poses) == 1 else 'poses')})", "  ")
    if len(loads) > most:
        terminal.line(f"and {len(loads) - most} more", "  ")


def _named(labels: Sequence[str], what: str) -> str:
    return f"{what} {listed(labels, MOST_NAMED)}"


def _numbers(row: ComparedRow, rigid: int) -> list[str]:
    return [
        "none" if row.partner is None else str(row.partner - rigid),
        hertz(row.measured),
        hertz(row.sigma),
        "" if row.predicted is None else hertz(row.predicted),
        "" if row.residual is None else signed(100.0 * row.residual),
        "" if row.sigmas is None else signed(row.sigmas, 1),
    ]


def _median(ratios: Iterable[float | None]) -> str:
    """Return the median of the damping ratios that are known, in per cent."""
    known = [ratio for ratio in ratios if ratio is not None]
    return f"{100.0 * float(np.median(known)):.3g}" if known else "-"
