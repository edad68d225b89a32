"""The table of a platform that turns in space, with the conditions that its inertia and its rotation must meet."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass
from itertools import combinations

from sympy import Add, Expr, Float, Matrix, Symbol, pi, sqrt

from pkmodes_derive.description import Margin, Requirement
from pkmodes_derive.functions import Output
from pkmodes_derive.machine import Extra, Machine
from pkmodes_derive.vectors import dot
from pkmodes_derive.vocabulary import AXES

PRODUCTS = ("xy", "xz", "yz")
#: A thin plate meets the triangle inequality exactly: what rounding may take from it, relative to the trace.
ROUNDING = Float("1e-9")
#: Points whose distances from a line are below this part of their spread along it lie in the line.
IN_LINE = Float("1e-3")
#: Legs whose joints are nearer to each other than this [m] coincide.
SAME = Float("1e-6")


@dataclass(frozen=True)
class PlatformTable:
    """The quantities of a platform: mass, centre of mass, moments and products of inertia in platform axes."""

    mass: Symbol
    centre: tuple[Symbol, ...]
    inertia: tuple[Symbol, ...]
    products: tuple[Symbol, ...]


def platform_that_turns(m: Machine) -> PlatformTable:
    """Declare the table ``[platform]`` and its conditions."""
    table = m.tables.single("platform", "the moving platform")
    (mass,) = table.quantity("mass", "m_p", "mass", "platform mass", above=0.0)
    centre = table.vector_of(
        "center",
        "c_p",
        "length",
        "component {i} of the platform's centre of mass from its origin, platform axes",
        "c_{{p,{i}}}",
    )
    inertia = table.vector_of(
        "inertia",
        "I_p",
        "moment of inertia",
        "moment of inertia of the platform about its centre of mass, axis {i} of the platform",
        "I_{{p,{i}}}",
        above=0.0,
    )
    products = table.vector_of(
        "products",
        "I_p",
        "moment of inertia",
        "entry {i} of the platform's inertia tensor about its centre of mass, platform axes",
        "I_{{p,{i}}}",
        PRODUCTS,
        default=0.0,
    )
    _require_a_body(m, inertia, products)
    return PlatformTable(mass, centre, inertia, products)


def _require_a_body(m: Machine, inertia: tuple[Symbol, ...], products: tuple[Symbol, ...]) -> None:
    """Require the inertia of a body: its second moments of mass, tr(I)/2 - I, are not negative in any direction."""
    xy, xz, yz = products
    tensor = Matrix([[inertia[0], xy, xz], [xy, inertia[1], yz], [xz, yz, inertia[2]]])
    trace = tensor.trace()
    moments = Matrix(3, 3, lambda i, k: (trace / 2 if i == k else 0) - tensor[i, k])
    minors: list[Expr] = []
    for i, k in ((0, 1), (0, 2), (1, 2)):
        minors.append((moments[i, i] * moments[k, k] - moments[i, k] ** 2) / trace**2 + ROUNDING)
    margins = [moments[i, i] / trace + ROUNDING for i in range(3)]
    margins += [*minors, moments.det(method="berkowitz") / trace**3 + ROUNDING]
    m.extras.append(
        Extra(
            "inertia_margin",
            "Whether the platform's inertia is that of a body.",
            "principal minors of its second moments of mass, divided by powers of the trace",
            (Output("margin", (7,), tuple(margins), "1", "none is negative for a body"),),
            arguments=(),
            definitions={},
        )
    )
    along = (
        *(f"platform.inertia.{axis}" for axis in AXES),
        *(f"platform.products.{two}" for two in PRODUCTS),
    )
    m.requirements += (
        Requirement(
            "inertia_margin",
            "at_least_zero",
            (*along, "platform.products.yz"),
            "expected the inertia of a body, found one in which about some axes a moment exceeds the sum of "
            "the others",
            "check the inertia: it is about the centre of mass, and products are the tensor's entries",
            "1",
        ),
    )


def require_a_plane(m: Machine, name: str, points: Sequence[Sequence[Symbol]], what: str) -> None:
    """Require that points of the axes do not lie in a line.

    The second invariant of their second moments about their mean measures the area that they span, and the trace of
    these their spread.

    Parameters
    ----------
    name : str
        Their key in the table ``axis``.
    what : str
        What they are, in the plural.
    """
    mean = [Add(*component) / len(points) for component in zip(*points, strict=True)]
    apart = Matrix([[c - middle for c, middle in zip(point, mean, strict=True)] for point in points])
    moments = apart.T * apart
    square = Add(*(entry**2 for entry in moments))
    area = (moments.trace() ** 2 - square) / 2 - IN_LINE**2 * moments.trace() ** 2
    function = f"{name}_line_margin"
    m.extras.append(
        Extra(
            function,
            f"Whether the {what} do not lie in a line.",
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
            f"expected {what} that do not lie in one line, found all of them in one",
            f"in a line they leave the platform free to turn about it: check {name} of every axis",
            "m^4",
        ),
    )


def require_different_legs(
    m: Machine, count: int, what: str, squares: Callable[[int, int], Sequence[Expr]], remedy: str
) -> None:
    """Require that no two legs coincide; `squares` are those of the differences between two, by their indices."""
    pairs = tuple(combinations(range(count), 2))
    margins = tuple(Add(*squares(j, k), -(SAME**2)) for j, k in pairs)
    m.extras.append(
        Extra(
            "leg_margin",
            "Whether no two legs coincide.",
            "sums of squared differences",
            (Output("margin", (len(pairs),), margins, "m^2", "positive for two legs that differ"),),
            arguments=(),
            definitions={},
        )
    )
    m.requirements += (
        Requirement(
            "leg_margin",
            "above_zero",
            tuple(f"axis.{j + 1} and axis.{k + 1}" for j, k in pairs),
            f"expected {what} that differ, found two that coincide",
            remedy,
            "m^2",
        ),
    )


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
