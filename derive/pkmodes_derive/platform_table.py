"""The table of a platform that turns in space: its mass, and an inertia that a body can have."""

from __future__ import annotations

from dataclasses import dataclass

from sympy import Expr, Float, Matrix, Symbol

from pkmodes_derive.description import Requirement
from pkmodes_derive.functions import Output
from pkmodes_derive.machine import Extra, Machine
from pkmodes_derive.vocabulary import AXES

PRODUCTS = ("xy", "xz", "yz")
#: Tolerance for rounding, relative to the trace: a thin plate meets the triangle inequality with equality.
ROUNDING = Float("1e-9")


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
        "centre of mass of the platform from its origin in platform axes",
        "c_{{p,{i}}}",
    )
    inertia = table.vector_of(
        "inertia",
        "I_p",
        "moment of inertia",
        "moment of inertia of the platform about its centre of mass in platform axes",
        "I_{{p,{i}}}",
        above=0.0,
    )
    products = table.vector_of(
        "products",
        "I_p",
        "moment of inertia",
        "entry of the platform's inertia tensor about its centre of mass in platform axes",
        "I_{{p,{i}}}",
        PRODUCTS,
        default=0.0,
    )
    _require_positive_second_moments(m, inertia, products)
    return PlatformTable(mass, centre, inertia, products)


def _require_positive_second_moments(
    m: Machine, inertia: tuple[Symbol, ...], products: tuple[Symbol, ...]
) -> None:
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
        *(f"platform.products.{product_name}" for product_name in PRODUCTS),
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
