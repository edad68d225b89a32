"""Tests of the result: values set free, alternatives, and the findings added one by one."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass

import numpy as np

import pkmodes
from extremes import centre_line, extremes, percent
from geometry import SAME, Geometry, joint_radius
from grid import Interval
from identification import Identified, every_digit

#: Declared values, and values that the paper does not give: each is freed together with z.
FREED = (
    "platform_mass",
    "link_mass",
    "carriage_mass",
    "link_length",
    "belt_specific_stiffness",
    "pulley_radius",
    "pulley_inertia",
    "motor_inertia",
    "gravity",
    "carriage_length",
    "span",
)
GEOMETRY = ("z", "across", "offset", "first")


@dataclass(frozen=True)
class Freed:
    """A value fitted together with z, in SI units."""

    name: str
    declared: float
    value: float
    sigma: float


@dataclass(frozen=True)
class Alternative:
    """Alternative robot: rms difference in half digits, and the largest relative error of the frequencies."""

    what: str
    rms: float
    largest_error: float


def freed(found: Identified) -> Iterator[Freed]:
    """Fit each declared or assumed value together with z, to see whether it is recovered."""
    for name in FREED:
        before = found.geometry.value(name, found.declared)
        fit = found.tables.fit(found.geometry, ("z", name))
        yield Freed(name, before, fit.geometry.value(name, found.declared), fit.sigma[name])


def alternatives(found: Identified) -> Iterator[Alternative]:
    """Yield alternative robots, with the geometry refitted where noted."""
    g, tables = found.geometry, found.tables
    others: list[tuple[str, Geometry]] = [
        ("as identified", g),
        ("no gravity, refitted", tables.fit(g.moved(gravity=0.0), GEOMETRY).geometry),
        ("gravity upwards, refitted", tables.fit(g.moved(gravity=9.81), GEOMETRY).geometry),
        ("z = -245 mm, as printed", g.moved(z=-0.245)),
        ("joints at the platform's centre: across = 200 mm", g.moved(across=0.2)),
        ("offset 490 mm", g.moved(offset=0.49)),
        ("carriage length 10 mm", g.moved(carriage_length=0.01)),
        ("span 1.01 m", g.moved(span=1.01)),
        (_mirrored(found), g.mirrored(found.declared)),
    ]
    for what, geometry in others:
        yield Alternative(what, tables.rms(geometry), tables.largest_error(geometry))


def radius_alone(found: Identified) -> tuple[float, float]:
    """Return the radius of the joints' circle and its standard error [m], with the other numbers round."""
    fit = found.tables.fit(found.geometry, ("z", "across"))
    rails = float(found.declared.parameters.origin[2, 1])
    return float(joint_radius(fit.geometry.across, rails)), float(fit.sigma["across"] / np.sin(np.pi / 3.0))


def digits_with_across(found: Identified, across: float) -> Interval | None:
    """Return the heights of the plane that reproduce every printed digit for this distance of rails 2 and 3."""
    fit = found.tables.fit(found.geometry.moved(across=across), ("z",))
    return every_digit(found.tables, found.shapes, fit.geometry)


def shortest_span(found: Identified) -> float:
    """Return the shortest free span of a belt at the identified poses [m]: where "boundary effects" begin."""
    model = pkmodes.Model(found.geometry.robot(found.declared))
    x = model.inverse_kinematics(found.geometry.poses(found.area))
    return float(min(x.min(), (found.geometry.span - x).min()))


def one_by_one(found: Identified) -> Iterator[tuple[str, float, float]]:
    """Yield the residual (rms and largest, in percent) as the findings are added one after the other."""
    g, declared = found.geometry, found.declared
    printed = {(row.point, row.mode): row.frequency for row in found.rows}
    shortest = shortest_span(found) - 1e-6
    limits = declared.parameters.limits[0]
    before = Geometry(
        span=float(limits[1] - limits[0]),
        across=float(declared.parameters.origin[2, 1]),
        offset=0.0,
        z=-0.245,
        first=g.first,
        step=g.step,
    )
    stages = (
        ("declared", before),
        ("span", before.moved(span=g.span)),
        ("and joints off the centre", before.moved(span=g.span, across=g.across)),
        ("and rail 1 starts ahead", before.moved(span=g.span, across=g.across, offset=g.offset)),
        ("and height of the plane", g),
    )
    for what, geometry in stages:
        robot = geometry.robot(declared)
        yield what, *percent(extremes(robot, centre_line(robot, geometry.z, shortest)).relative(printed))
    yield "and the grid", *percent(extremes(g.robot(declared), g.poses(found.area)).relative(printed))


def report(found: Identified) -> None:
    """Print all tests."""
    radius, sigma = radius_alone(found)
    print(f"\nRadius of the joints with the other numbers round: {1e3 * radius:.4f} +- {1e3 * sigma:.4f} mm.")
    across = 1e-3 * found.rounded["across"].value
    z = digits_with_across(found, across)
    print(
        f"With across = {1e3 * across:g} mm instead, {'a' if z else 'no'} height z gives every printed digit."
    )
    print("\nDeclared and assumed values, each fitted together with z:")
    for one in freed(found):
        print(f"  {one.name:24} {one.value:13.8g} +- {one.sigma:.1g}   (before {one.declared:g})")
    print("\nAlternatives:                                        rms [half digits]   frequencies, at most")
    for other in alternatives(found):
        print(f"  {other.what:55} {other.rms:9.2f} {100 * other.largest_error:18.4f} %")
    same = next(one for one in found.look.links if one.sides == SAME)
    print(
        f"  {'all carriages on one side':55} excluded by the moving masses: off by {100 * same.misfit:.0f} %"
    )
    print("\nThe findings added one by one (extremes of the line; residual of the twelve frequencies):")
    for what, rms, largest in one_by_one(found):
        print(f"  {what:26} rms {rms:8.4f} %, largest {largest:8.4f} %")


def _mirrored(found: Identified) -> str:
    other = found.geometry.mirrored(found.declared)
    return f"sides swapped, offset {1e3 * other.offset:.2f}, first {1e3 * other.first:.2f} mm"
