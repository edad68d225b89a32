"""``--vary``: parameters and effects with ranges, such as ``platform.mass=0.5:3,effects.payload.mass=0:2 kg:9``."""

from __future__ import annotations

from typing import TYPE_CHECKING

import click
import numpy as np
from numpy.typing import NDArray

from pkmodes.core.base.errors import PkmodesError, nearest, shown

if TYPE_CHECKING:
    from pkmodes.core.robot.robot import Robot

OPTION = "--vary"
EXAMPLE = f"for example: {OPTION} platform.mass=0.5:3,effects.payload.mass=0:2"

vary_option = click.option(
    OPTION,
    "vary",
    metavar="PATH=START:STOP,...",
    default=None,
    help="Sliders for up to three parameters or effects instead of the pose, which is then that of --pose: "
    "start:stop, or start:stop:count, in SI units or with units.",
)


def parse_vary(text: str, robot: Robot) -> dict[str, NDArray[np.float64]]:
    """Read the ranges of the option.

    Parameters
    ----------
    robot : Robot
        It says which paths there are, and their units.

    Returns
    -------
    dict of str to ndarray
        Values in SI units by path, in the order given.

    Raises
    ------
    PkmodesError
        If a path is unknown or repeated, a range is invalid, or there are too many.
    """
    from pkmodes.core.robot.declaration import changeable
    from pkmodes.maps.ranges import parse_range
    from pkmodes.view.varying import COUNTS, PARAMETERS

    parts = [part.strip() for part in text.split(",")]
    if len(parts) > PARAMETERS:
        what = f"expected at most {PARAMETERS} parameters, found {len(parts)}"
        raise PkmodesError(what, OPTION, "vary the others on another page")
    units, found = changeable(robot), dict[str, NDArray[np.float64]]()
    for part in parts:
        path, equals, span = (piece.strip() for piece in part.partition("="))
        if not equals or not path or not span:
            raise PkmodesError(f"expected PATH=START:STOP, found {shown(part)}", OPTION, EXAMPLE)
        if path not in units:
            remedy = nearest(path, units, "see docs/sensitivities.md for the paths")
            raise PkmodesError(f"unknown parameter path {shown(path)}", OPTION, remedy)
        if path in found:
            raise PkmodesError(f"{path} is given twice", OPTION, "give its range once")
        if span.count(":") not in (1, 2):
            what = f"expected start:stop or start:stop:count, found {shown(span)}"
            raise PkmodesError(what, f"{OPTION} {path}", EXAMPLE)
        start, stop, *count = (piece.strip() for piece in span.split(":"))
        if start == stop or count == ["1"]:
            what = f"a slider needs several values, found {shown(span)}"
            raise PkmodesError(
                what, f"{OPTION} {path}", "give two different ends and a count of at least 2, or none"
            )
        whole = span if span.count(":") == 2 else f"{span}:{COUNTS[len(parts)]}"
        found[path] = parse_range(whole, units[path], f"{OPTION} {path}")
    return found
