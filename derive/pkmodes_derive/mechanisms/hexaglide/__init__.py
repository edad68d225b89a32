r"""The hexaglide: six carriages on rails, six single rods, a platform that moves and turns.

It is made of the axes of the linear delta, with one rod each: the platform joints :math:`c_j = p + R b_j` turn with
the platform.
"""

from __future__ import annotations

from pkmodes_derive.conditions import LegDifferences, require_a_plane, require_different_legs, rotation_margin
from pkmodes_derive.machine import Machine
from pkmodes_derive.mechanisms.hexaglide.sample import SAMPLE
from pkmodes_derive.platform_table import platform_that_turns
from pkmodes_derive.rails import axes as rails
from pkmodes_derive.rails.picture import draw
from pkmodes_derive.vectors import cross
from pkmodes_derive.vocabulary import AXES

__all__ = ["DIRECTIONS", "ROTATIONS", "TITLE", "declare"]

TITLE = "six carriages on rails, six single rods, a platform with six degrees of freedom"
DIRECTIONS = ROTATIONS = AXES
WORDS = rails.Words(
    link="one rod, uniform and slender",
    length="length of rod {j}",
    mass="mass of rod {j}",
    joint="platform joint {j} from the platform's origin in platform axes",
)


def declare(m: Machine) -> None:
    """Declare the hexaglide."""
    platform = platform_that_turns(m)
    m.add_gravity()
    axes = rails.declare_axes(m, 6, WORDS)
    m.add_frame()

    p = m.platform_pose("p", "platform's origin in the base frame", "p")
    x, theta = rails.coordinates(m, 6)
    lever = m.vectors("B", "m", "platform joint {j} from the platform's origin, base frame", "B_{j}")
    for names, joint in zip(lever, axes.b, strict=True):
        m.fixed_in_platform(names, joint)
    distance2 = rails.close(m, axes, x, p, lever)

    m.platform = p
    m.body(platform.mass, platform.centre, platform.inertia, platform.products)
    rails.bodies(m, axes, x, p, lever)
    draw(m, rails.belts(m, axes, x, theta, lever), parallelograms=False)

    rotation_margin(m)
    require_a_plane(m, "joint", axes.b, "joints on the platform")

    def leg_differences(j: int, k: int) -> LegDifferences:
        offset = tuple(v - w for v, w in zip(axes.o[j], axes.o[k], strict=True))
        distance_of_rails = cross(offset, axes.n[j])  # of two rails in the same line it is zero
        joints = [v - w for v, w in zip(axes.b[j], axes.b[k], strict=True)]
        directions = [v - w for v, w in zip(axes.n[j], axes.n[k], strict=True)]
        lengths = [*joints, *distance_of_rails, axes.l_d[j] - axes.l_d[k]]
        return lengths, [*directions, axes.sigma[j] - axes.sigma[k]]

    remedy = "check joint, origin, direction, length of the rod and branch of both"
    require_different_legs(m, axes.b, "rods", leg_differences, remedy)
    rails.conditions(m, axes, distance2, "distance of the platform joints from the platform's origin")
    m.sample = SAMPLE
