"""The plane in which a machine moves: its coordinates, which are the pose, its travel, and conditions on both."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

from sympy import Add, Expr, Rational, Symbol

from pkmodes_derive.functions import Output
from pkmodes_derive.gantry.belts import BELTS, Belts
from pkmodes_derive.machine import Extra, Machine
from pkmodes_derive.parts import Form
from pkmodes_description import Margin, Requirement, Scale

DIRECTIONS = ("x", "y")
HALF = Rational(1, 2)


@dataclass(frozen=True)
class Travel:
    """Lower and upper ends of the travel along x and y [m]."""

    low: tuple[Symbol, ...]
    high: tuple[Symbol, ...]


def travel(m: Machine, of: str) -> Travel:
    """Declare the table ``workspace``: the travel of something, a noun phrase."""
    table = m.tables.single("workspace", f"travel of {of}")
    return Travel(*table.ranges(DIRECTIONS, "travel", "the travel along {i}", "{i}"))


def coordinates(m: Machine, x_is: str, y_is: str, pose_is: str) -> tuple[Symbol, ...]:
    """Declare x and y, which are the pose, and the rotations of the motor pulleys; return all four coordinates."""
    m.generalised(
        [("x", "m", x_is, "{x}", {}), ("y", "m", y_is, "{y}", {})],
        [
            ("theta_{j}", "rad", "rotation of motor pulley {j}", r"{{\vartheta}}_{j}", {"j": i + 1})
            for i in BELTS
        ],
    )
    m.independent_pose(m.coordinates[:2], pose_is)
    m.moves_platform(m.coordinates[:2], "xy", "positions")
    return m.coordinates


def scales(m: Machine, pulleys: tuple[int, int]) -> tuple[Scale, ...]:
    """Divide x and y in printed shapes by the radius of one motor pulley each, by their places."""
    return tuple(Scale(q.name, "pulley_radius", (i,), "R_p") for q, i in zip(m.pose, pulleys, strict=True))


def condition_of_travel(
    m: Machine, travel: Travel, summary: str, meaning: str, sentence: str, names: tuple[str, str]
) -> None:
    """Require that a pose is within the travel.

    Parameters
    ----------
    summary : str
        What the margin is.
    meaning, sentence : str
        What is wrong with a pose outside; in the sentence ``{0}`` stands for one of `names`, ``{1}`` for the end, and
        ``{missing}`` for the distance from it.
    names : tuple of str
        For x and y.
    """
    ends = zip(m.pose, travel.low, travel.high, strict=True)
    margins = tuple(margin for q, low, high in ends for margin in (q - low, high - q))
    m.extras.append(
        Extra(
            "travel_margin",
            summary,
            "both ends of the workspace",
            (
                Output(
                    "margin", (2, 2), margins, "m", "for x and y: above the lower end and below the upper end"
                ),
            ),
        )
    )
    m.margins += (
        Margin(
            "limits",
            "travel_margin",
            0,
            "at_least_zero",
            meaning,
            sentence,
            "choose a pose within the workspace, or check its limits",
            (names, ("lower", "upper")),
        ),
    )


def condition_of_runs(m: Machine, travel: Travel, belts: Belts, pulls: Sequence[Form], given_by: str) -> None:
    """Require that the runs of all belts have a length in the whole workspace; `given_by` names the keys to check."""
    shortest = [
        belts.lengths[i][k] + _minimum(m, travel, pulls[i], sign)
        for i in BELTS
        for k, sign in enumerate((1, -1))
    ]
    m.extras.append(
        Extra(
            "run_margin",
            "Shortest free length of each run in the whole workspace.",
            "the lengths are linear in x and y, so the shortest is at a corner",
            (
                Output(
                    "margin", (2, 2), tuple(shortest), "m", "for runs 1 and 2 of each belt; must be positive"
                ),
            ),
            arguments=(),
            definitions={},
        )
    )
    m.requirements += (
        Requirement(
            "run_margin",
            "above_zero",
            tuple(f"{belts.table}.{i + 1}.lengths.{k}" for i in BELTS for k in (1, 2)),
            "expected a positive free length in the whole workspace, found a run that is {missing} too short",
            f"check {given_by}",
            "m",
        ),
    )


def _minimum(m: Machine, travel: Travel, pull: Form, sign: int) -> Expr:
    """Return the least value in the workspace of a pull whose factors are 1 or -1, or of its negative."""
    ends = [(pull[q], a, b) for q, a, b in zip(m.pose, travel.low, travel.high, strict=True) if q in pull]
    sum_of_ends = Add(*(factor * (a + b) for factor, a, b in ends))
    return HALF * (sign * sum_of_ends - Add(*(b - a for _, a, b in ends)))
