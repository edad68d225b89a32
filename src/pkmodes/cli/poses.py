"""Poses on the command line: the components of one pose, a grid, a path, or a table."""

from __future__ import annotations

import re
from pathlib import Path
from typing import TYPE_CHECKING

import click

from pkmodes.cli.options import PATH
from pkmodes.core.base.errors import PoseError

if TYPE_CHECKING:
    from pkmodes.core.mechanism.registry import Mechanism
    from pkmodes.core.model import Model
    from pkmodes.machine.maps.pose_path import PosePath
    from pkmodes.machine.maps.poses import MapPoses

pose_option = click.option(
    "--pose",
    metavar="X,Y,...",
    required=True,
    help="The components of the mechanism's pose, such as the platform centre X,Y,Z: numbers in SI units, or "
    "quantities with their units.",
)

grid_option = click.option(
    "--grid",
    metavar="X=START:STOP:COUNT,...",
    help="For each component of the pose, start:stop:count with both ends included, or one value, in SI units or "
    "with units.  Rotations that are not given are 0.  By default the reachable workspace, within the "
    "[usable] limits of the robot file.",
)

path_option = click.option(
    "--path",
    "path",
    metavar="X,Y,...;X,Y,...",
    help="Straight lines from pose to pose, written as in --pose and separated by semicolons: the frequencies "
    "along the path.",
)

poses_option = click.option(
    "--poses",
    metavar="FILE.csv",
    type=PATH,
    help="Table of poses instead of a grid: one row per pose, with a column for each component, such as x,y,z.",
)


def parse_pose(text: str, mechanism: Mechanism) -> list[float]:
    """Read the components of a pose: bare numbers in SI units, or quantities.

    Raises PoseError if the number of components is wrong, or one of them is not such a quantity.
    """
    from pkmodes.core.robot.units import QuantityError, parse_number_or_quantity

    parts, names = text.split(","), ",".join(component.name for component in mechanism.pose).upper()
    if len(parts) != len(mechanism.pose):
        problem = f"expected {len(mechanism.pose)} components {names}, found {len(parts)}"
        remedy = f"write --pose {names}, decimals with a point: {mechanism.pose_is}"
        raise PoseError(problem, "--pose", remedy)
    pose = []
    for part, component in zip(parts, mechanism.pose, strict=True):
        try:
            pose.append(parse_number_or_quantity(part, component.unit))
        except QuantityError as error:
            remedy = error.remedy or f"write a number in {component.unit}, or a number with its unit"
            raise PoseError(str(error), "--pose", remedy) from None
    return pose


def parse_pose_option(model: Model, text: str) -> list[float]:
    """Read the pose of ``--pose``.

    Raises PoseError as `parse_pose` does, and if the robot could reach it if its bare lengths, some of them large,
    were in millimetres, or its bare angles in degrees.  Other poses that cannot be reached are left to the model to
    reject.
    """
    from pkmodes.core.mechanism.poses import LIKELY_UNITS

    pose, units = parse_pose(text, model.mechanism), [component.unit for component in model.mechanism.pose]
    if any(c.isalpha() for c in re.sub(r"\d[eE]", "", text)) or model.check(pose).valid:
        return pose
    large_units = {
        unit
        for c, unit in zip(pose, units, strict=True)
        if unit in LIKELY_UNITS and abs(c) >= LIKELY_UNITS[unit].size
    }
    converted = [
        c * LIKELY_UNITS[unit].factor if unit in large_units else c
        for c, unit in zip(pose, units, strict=True)
    ]
    if large_units and model.check(converted).valid:
        parts = [part.strip() for part in text.split(",")]
        with_units = ",".join(
            f"{part} {LIKELY_UNITS[unit].unit}" if unit in large_units else part
            for part, unit in zip(parts, units, strict=True)
        )
        apparent_units = " and ".join(
            LIKELY_UNITS[unit].plural for unit in LIKELY_UNITS if unit in large_units
        )
        remedy = f'the numbers look like {apparent_units}: write --pose "{with_units}"'
        raise PoseError(str(model.check(pose).sentences).partition(";")[0], "--pose", remedy)
    return pose


def parse_path_option(mechanism: Mechanism, text: str) -> PosePath:
    """Read ``--path``: poses with straight lines between them.

    Raises PoseError if there are fewer than two, one of them is not a pose, or two that follow each other are equal.
    """
    from pkmodes.machine.maps.pose_path import PosePath

    parts = [part.strip() for part in text.split(";") if part.strip()]
    try:
        corners = [parse_pose(part, mechanism) for part in parts]
    except PoseError as error:
        raise PoseError(error.what, "--path", error.remedy.replace("--pose", "--path")) from None
    return PosePath.through(mechanism, corners)


def selected_poses(model: Model, grid: str | None, poses: Path | None) -> MapPoses | None:
    """Return the poses that --grid or --poses selects; None without either.

    Raises click.UsageError if both are given.
    """
    if grid is not None and poses is not None:
        raise click.UsageError("--grid and --poses exclude each other", click.get_current_context())
    if grid is not None:
        from pkmodes.machine.maps.poses import checked_poses
        from pkmodes.machine.maps.ranges import parse_grid

        return checked_poses(model.mechanism, parse_grid(grid, model.mechanism, "--grid"))
    if poses is not None:
        from pkmodes.machine.maps.pose_file import read_poses
        from pkmodes.machine.maps.poses import checked_poses

        return checked_poses(model.mechanism, read_poses(poses, model.mechanism))
    return None
