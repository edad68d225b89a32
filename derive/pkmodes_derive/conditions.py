"""Conditions on poses and robots that several mechanisms have."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from itertools import combinations

from sympy import Add, Expr, Float, Matrix, Symbol, pi, sqrt

from pkmodes_derive.description import Margin, Requirement
from pkmodes_derive.functions import Output
from pkmodes_derive.machine import Extra, Machine
from pkmodes_derive.vectors import dot, mean_square

#: Differences of two legs: lengths [m], and plain numbers, such as those of directions.
LegDifferences = tuple[Sequence[Expr], Sequence[Expr]]
#: Points whose distances from a line are below this fraction of their spread along it are collinear.
LINE_TOLERANCE = Float("1e-3")
#: Legs that differ by less than this fraction of the platform's size coincide.
COINCIDENCE_TOLERANCE = Float("1e-5")
#: Legs cross if they come closer than about this fraction of the smaller distance between their joints.
CROSSING_TOLERANCE = Float("1e-3")
#: A pose at which the closures do not determine the platform.
SINGULAR = Margin(
    "singular",
    "jacobian_condition",
    1,
    "at_most_limit",
    "the pose is singular",
    "the pose is singular: the condition number of D_l is {value}",
    "choose a pose farther from the singularity",
    unit="1",
)


def require_a_plane(m: Machine, name: str, points: Sequence[Sequence[Symbol]], noun: str) -> None:
    """Require that points of the axes do not lie in a line.

    The second invariant of their second moments about their mean measures the area that they span, and the trace of
    these their spread.

    Parameters
    ----------
    name : str
        Their key in the table ``axis``.
    noun : str
        What they are, in the plural.
    """
    mean = [Add(*component) / len(points) for component in zip(*points, strict=True)]
    deviations = Matrix([[c - centre for c, centre in zip(point, mean, strict=True)] for point in points])
    moments = deviations.T * deviations
    squared_norm = Add(*(entry**2 for entry in moments))
    area = (moments.trace() ** 2 - squared_norm) / 2 - LINE_TOLERANCE**2 * moments.trace() ** 2
    function = f"{name}_line_margin"
    m.extras.append(
        Extra(
            function,
            f"Whether the {noun} do not lie in a line.",
            "second invariant of their second moments about their mean",
            (Output("margin", (), (area,), "m^4", "positive for points that span a plane"),),
            arguments=(),
            definitions={},
        )
    )
    m.requirements += (
        Requirement(
            function,
            "above_zero",
            (f"axis.{name}",),
            f"expected {noun} that do not lie in one line, found all of them in one",
            f"in a line they leave the platform free to turn about it: check {name} of every axis",
            "m^4",
        ),
    )


def require_different_legs(
    m: Machine,
    joints: Sequence[Sequence[Symbol]],
    noun: str,
    differences: Callable[[int, int], LegDifferences],
    remedy: str,
) -> None:
    """Require that no two legs coincide.

    Parameters
    ----------
    joints : sequence of sequence of sympy.Symbol
        Those on the platform, whose distance from its origin is the scale.
    noun : str
        What the legs are, in the plural.
    differences : callable
        ``apart(j, k)`` returns the differences of two legs, by their indices.
    remedy : str
        What to do about two that coincide.
    """
    scale = mean_square(joints)

    def margin(j: int, k: int) -> Expr:
        lengths, numbers = differences(j, k)
        return dot(lengths, lengths) + scale * dot(numbers, numbers) - scale * COINCIDENCE_TOLERANCE**2

    _require_of_pairs(
        m,
        len(joints),
        margin,
        name="leg_margin",
        summary="Whether no two legs coincide.",
        source="sums of squared differences; numbers count times the rms distance of the platform joints",
        meaning="positive for two legs that differ",
        expected=f"expected {noun} that differ, found two that coincide",
        remedy=remedy,
    )


def require_legs_that_do_not_cross(
    m: Machine, base: Sequence[Sequence[Symbol]], joints: Sequence[Sequence[Symbol]], remedy: str
) -> None:
    """Require that no two legs meet between their joints at any position of a platform that is not turned.

    The points of legs j and k at a fraction t of their lengths are apart by (1 - t) A + t B, A from base joint to
    base joint and B from platform joint to platform joint: this is zero for a t between 0 and 1 if A and B have
    opposite directions.  Legs may share a joint.

    Parameters
    ----------
    base, joints : sequence of sequence of sympy.Symbol
        In the base frame, and in platform axes.
    remedy : str
        What to do about two that cross.
    """
    scale = mean_square(joints)

    def margin(j: int, k: int) -> Expr:
        A, B = ([x - y for x, y in zip(points[j], points[k], strict=True)] for points in (base, joints))
        cosine = 1 - CROSSING_TOLERANCE**2 / 2
        return sqrt(dot(A, A) * dot(B, B)) * cosine + dot(A, B) + scale * COINCIDENCE_TOLERANCE**2

    _require_of_pairs(
        m,
        len(joints),
        margin,
        name="crossing_margin",
        summary="Whether no two legs cross while the platform is not turned.",
        source="the differences of their joints at base and platform, which have opposite directions if they do",
        meaning="positive for two legs that do not cross",
        expected="expected legs that do not cross, found two that meet whenever the platform is not turned",
        remedy=remedy,
    )


def _require_of_pairs(
    m: Machine,
    count: int,
    margin: Callable[[int, int], Expr],
    *,
    name: str,
    summary: str,
    source: str,
    meaning: str,
    expected: str,
    remedy: str,
) -> None:
    """Require that a margin [m^2] of every two legs, by their indices, is positive."""
    pairs = tuple(combinations(range(count), 2))
    output = Output("margin", (len(pairs),), tuple(margin(j, k) for j, k in pairs), "m^2", meaning)
    m.extras.append(Extra(name, summary, source, (output,), arguments=(), definitions={}))
    places = tuple(f"axis.{j + 1} and axis.{k + 1}" for j, k in pairs)
    m.requirements += (Requirement(name, "above_zero", places, expected, remedy, "m^2"),)


def rotation_margin(m: Machine) -> None:
    """Require a rotation of less than 90 degrees."""
    assert m.turning is not None
    angle = sqrt(dot(m.turning.vector, m.turning.vector))
    m.extras.append(
        Extra(
            "rotation_margin",
            "By how much the rotation of the platform is less than 90 degrees.",
            "the norm of the rotation vector",
            (Output("margin", (), (pi / 2 - angle,), "rad", "positive for a rotation below 90 degrees"),),
        )
    )
    m.margins += (
        Margin(
            "rotation",
            "rotation_margin",
            0,
            "above_zero",
            "the platform turns by 90 degrees or more",
            "the platform is turned by 90 degrees or more, {missing} too far",
            "choose a rotation vector shorter than 90 degrees",
            unit="rad",
        ),
    )
