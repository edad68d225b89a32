"""Print the evidence, step by step."""

from __future__ import annotations

from collections.abc import Iterator

import numpy as np

import pkmodes
from carriage_rows import NAMES
from diagnoses import assumed_poses, diagnose_published
from extremes import Extremes
from geometry import OPPOSITE
from grid import Interval
from identification import Identified
from pkmodes.loop.updating import diagnose
from pulley_rows import AXES, READINGS, pose_of_shape

MM = 1e3


def first_look(found: Identified) -> None:
    """Print the evidence from single rows."""
    look = found.look
    print("1. Pulley rows: the span max - min [m] that each row implies, by the reading of its x column")
    print(f"   {'':12} axis {'x/R_p, as headed':>24} {'x in metres':>24}   verdict")
    for row in found.rows:
        for axis in AXES:
            if row.moves(axis):
                cells = [_spans(found, row.name, axis, reading) for reading in READINGS]
                verdict = look.readings.get(row.name, "neither")
                print(f"   {row.name:12} {axis + 1:4d} {cells[0]:>24} {cells[1]:>24}   {verdict}")
    low, high = look.span.low, look.span.high
    print(f"   {len(look.readings)} of {len(found.rows)} rows agree on a span of {low:.5f} to {high:.5f} m,")
    print("   each in one reading of its x column only.  Spans beyond 2 m are not shown.")
    for name, reading, ahead in _nearly(found):
        print(
            f"   {name}: reading x as {reading} misses by less than 1 mm, but then x_1 - x_2 would be {ahead:.3f} m."
        )

    print(f"\n2. Poses, with that span.  x_1 - x_2 = {_interval(look.ahead, 5)} m in all rows;")
    print(f"   the x_2 differ by multiples of {_interval(look.step, 6)} m:")
    for row in found.rows:
        if row.name in look.x_2:
            print(
                f"   {row.name:12} x_2 = {_interval(look.x_2[row.name], 5)} m   point {look.index[row.name]}"
            )
    print("   The other two rows: position and frequency implied by their shapes alone.")
    for row in found.rows:
        for axis in AXES if row.name in look.strays else ():
            if row.moves(axis):
                poses = pose_of_shape(row, axis, "metres", look.belts[axis], look.span.middle)
                told = ", ".join(f"x_{axis + 1} = {x:.3f} m at {f:.1f} Hz" for x, f in poses)
                print(f"   {row.name:12} printed {row.frequency:.3f} Hz; shape, x in metres: {told}")

    print("\n3. Carriage rows: moving masses [kg], and the link directions that give them")
    print("   " + ", ".join(f"{name} {m:.3f}" for name, m in zip(NAMES, look.masses, strict=True)))
    for one in look.links:
        sides = "opposite sides" if one.sides == OPPOSITE else "all on one side"
        where = f"z {MM * one.z:8.1f} mm, across {MM * one.across:6.1f} mm"
        print(f"   {sides:16} {where}, masses off by {one.misfit:.1e}")


def fits(found: Identified) -> None:
    """Print the fits, the round numbers and the poses."""
    kept = len(found.rows) - len(found.look.strays)
    print(f"\n4. Fit of {len(found.twelve.sigma)} unknowns to the {kept} self-consistent rows:")
    for cut, fit in found.fits.items():
        how = "truncated" if cut else "rounded"
        print(f"   shapes {how} to three digits: rms {fit.rms:.2f} half digits (exact: 0.58)")
    for name, stray in found.strays.items():
        told = ", ".join(f"point {k}, {f:.4f} Hz" for k, f in stray.frequency.items())
        shape = ", ".join(f"point {k} (x in {reading})" for k, reading in stray.shape)
        row = next(row for row in found.rows if row.name == name)
        print(
            f"   {name}: {row.frequency:.3f} Hz is predicted at {told}; every digit of its shape at {shape}"
        )

    components = int(found.tables.used.sum())
    print(
        f"\n5. Fit to all frequencies and {components} components (rms {found.twelve.rms:.2f}), and round numbers:"
    )
    print("            fitted [mm]              round     multiple of     chance of match")
    values = {name: found.twelve.geometry.value(name, found.declared) for name in found.twelve.sigma}
    sigmas = {**found.twelve.sigma, "radius": found.radius[1]}
    for name, value in {**values, "radius": found.radius[0]}.items():
        r = found.rounded[name]
        print(
            f"   {name:7} {MM * value:12.5f} +- {MM * sigmas[name]:.5f} {r.value:10g} {r.grain:13g} {r.chance:17.1g}"
        )
    print("   radius: across = 200 mm - radius * sin 60 deg, with the joints at 0 and +-120 deg on a circle.")
    z = found.last
    alone = f"{MM * z.geometry.z:.5f} +- {MM * z.sigma['z']:.5f} mm"
    print(f"   All but z are round (across through the radius).  Only z free: {alone} (rms {z.rms:.2f});")
    print(
        f"   every digit of 12 frequencies and {int(found.shapes.used.sum())} components is reproduced for z from"
    )
    print(f"   {MM * found.z.low:.5f} to {MM * found.z.high:.5f} mm.")

    print(
        "\n6. Poses: x_p in the robot file; extreme of its mode over the points "
        f"{found.area[0]:g} to {found.area[-1]:g} of the grid?"
    )
    along = found.geometry.modes(found.declared, found.area)[0]
    miss = np.abs(found.shapes.misses(found.geometry)[1]).max(axis=1)
    first = found.in_robot_file[2]
    for row, k, of_shape, worst in zip(found.rows, found.tables.index, found.shapes.index, miss, strict=True):
        pick = np.argmin if row.point == "minimum" else np.argmax
        extreme = "yes" if found.area[pick(along[:, row.mode - 1])] == k else "NO"
        print(
            f"   {row.name:12} point {k:2d}  x_p = {first + k * found.geometry.step:.4f} m   {extreme}   "
            f"shape from point {of_shape:2d}, worst component {worst:.2f} half digits"
        )


def diagnoses(declared: pkmodes.Robot, identified: pkmodes.Robot, found: Extremes) -> None:
    """Print the diagnosis of both robots."""
    print("\npkmodes diagnose, identified robot, published-modes.csv:")
    result = diagnose_published(identified)
    print(f"  {result.verdict}: {result.reason}")
    print("pkmodes diagnose, declared robot, at its own minima and maxima:")
    result = diagnose(declared, assumed_poses(found))
    print(f"  {result.verdict}: {result.reason}")


def _spans(found: Identified, row: str, axis: int, reading: str) -> str:
    every = [one for one in found.look.lengths if (one.row, one.axis, one.reading) == (row, axis, reading)]
    shown = [f"{one.low[0]:.3f}..{one.high[0]:.3f}" for one in every if one.low[0] < 2.0]
    return " ".join(shown) or "none"


def _nearly(found: Identified) -> Iterator[tuple[str, str, float]]:
    """Yield the rows whose spans nearly agree in the other reading, and x_1 - x_2 in that reading."""
    for name, verdict in found.look.readings.items():
        other = [
            min(every, key=lambda one: abs(one.middle[0] - found.look.span.middle))
            for axis in AXES
            if (
                every := [
                    o for o in found.look.lengths if (o.row, o.axis) == (name, axis) and o.reading != verdict
                ]
            )
        ]
        if len(other) == len(AXES) and all(abs(o.middle[0] - found.look.span.middle) < 1e-3 for o in other):
            yield name, other[0].reading, float(other[0].middle[1] - other[1].middle[1])


def _interval(interval: Interval, digits: int) -> str:
    return f"{interval.low:.{digits}f} to {interval.high:.{digits}f}"
