"""The robot file of the linear delta, its poses and what limits them."""

from __future__ import annotations

from pkmodes_derive.description import Description, Key, Margin, Named, Requirement, Scale, Table, Whole

XYZ = ("x", "y", "z")
THREE = ("1", "2", "3")


def _axis() -> Table:
    return Table(
        "axis",
        "a rail with its belt and pulleys",
        (
            Key(
                "origin",
                "vector",
                "origin",
                "length",
                "the point of the rail where x_j = 0",
                elements=XYZ,
                signed=True,
            ),
            Key("direction", "direction", "direction", "number", "unit vector along the rail"),
            Key(
                "joint",
                "vector",
                "joint",
                "length",
                "c_j - p, platform joint seen from the platform centre",
                elements=XYZ,
                signed=True,
            ),
            Key(
                "limits",
                "pair",
                "limits",
                "length",
                "min(x_j) and max(x_j): pulley 2 sits at min, pulley 1 at max",
                elements=("min", "max"),
                signed=True,
            ),
            Key(
                "driven_pulley",
                "one_of",
                "drive",
                "number",
                "the pulley that the motor drives",
                choices=(1, 2),
            ),
            Key(
                "branch",
                "choice",
                "branch",
                "number",
                "1: the carriage is ahead of the platform joint along the rail; -1: behind",
                choices=(1, -1),
            ),
        ),
        count=3,
    )


def tables() -> tuple[Table, ...]:
    """Every table of the robot file, in its order."""
    return (
        Table(
            "platform",
            "the moving platform",
            (Key("mass", "quantity", "platform_mass", "mass", "mass", above=0.0),),
        ),
        Table(
            "link",
            "one distal linkage: both rods of the parallelogram together",
            (
                Key("length", "quantity", "link_length", "length", "length l_d", above=0.0),
                Key("mass", "quantity", "link_mass", "mass", "mass m_d", at_least=0.0),
            ),
            shared_by="axis",
        ),
        Table(
            "carriage",
            "one carriage",
            (
                Key("mass", "quantity", "carriage_mass", "mass", "mass m_t", at_least=0.0),
                Key(
                    "length",
                    "quantity",
                    "carriage_length",
                    "length",
                    "length l_t along the rail: each half shortens one belt span",
                    at_least=0.0,
                ),
            ),
            shared_by="axis",
        ),
        Table(
            "belt",
            "one timing belt",
            (
                Key(
                    "specific_stiffness",
                    "quantity",
                    "belt_specific_stiffness",
                    "specific stiffness",
                    "k_sp: the stiffness of a span is width * k_sp / free length",
                    above=0.0,
                ),
                Key("width", "quantity", "belt_width", "length", "width w_b", above=0.0),
            ),
            shared_by="axis",
        ),
        Table(
            "pulley",
            "each of the two pulleys of an axis",
            (
                Key("radius", "quantity", "pulley_radius", "length", "radius R_p", above=0.0),
                Key(
                    "inertia",
                    "quantity",
                    "pulley_inertia",
                    "moment of inertia",
                    "moment of inertia I_p",
                    above=0.0,
                ),
            ),
            shared_by="axis",
        ),
        Table(
            "motor",
            "motor and gearbox of an axis",
            (
                Key(
                    "inertia",
                    "quantity",
                    "motor_inertia",
                    "moment of inertia",
                    "moment of inertia at the motor shaft",
                    at_least=0.0,
                ),
                Key("gear_ratio", "quantity", "gear_ratio", "number", "motor over driven pulley", above=0.0),
            ),
            shared_by="axis",
        ),
        Table(
            "frame",
            "the frame; used by the effect frame_compliance only",
            (
                Key(
                    "mass",
                    "quantity",
                    "",
                    "mass",
                    "mass",
                    above=0.0,
                    default=50.0,
                    effect="frame_compliance.mass",
                    suspected=False,
                ),
            ),
        ),
        _axis(),
    )


def margins() -> tuple[Margin, ...]:
    """What a pose needs."""
    return (
        Margin(
            "reachable",
            "reach_margin",
            0,
            "at_least_zero",
            "the pose is out of reach: a link is too short",
            "the pose is out of reach: link {0} is {missing} too short",
            "choose a pose closer to the rails",
            (THREE,),
        ),
        Margin(
            "singular",
            "jacobian_condition",
            1,
            "at_most_limit",
            "the pose is singular",
            "the pose is singular: the condition number of D_l is {value}",
            "choose a pose farther from the singularity",
            unit="1",
        ),
        Margin(
            "limits",
            "belt_spans",
            0,
            "above_zero",
            "a carriage is beyond its limits: a belt span would not be positive",
            "carriage {0} is beyond its limits: the belt span {1} would be {short}",
            "choose a pose within the travel of the carriages, or check limits and carriage length",
            (
                THREE,
                (
                    "between its pulleys",
                    "between its carriage and pulley 2",
                    "between its carriage and pulley 1",
                ),
            ),
        ),
    )


def requirements() -> tuple[Requirement, ...]:
    """What a robot needs at any pose."""
    return (
        Requirement(
            "travel_margin",
            "above_zero",
            tuple(f"axis.{j}.limits" for j in THREE),
            "expected a carriage shorter than the travel, found a length of {carriage.length}",
            "check the limits and carriage.length",
            "m",
        ),
    )


def sample() -> dict[str, object]:
    """A robot without any symmetry: oblique rails, everything different on each axis, tilted gravity.

    Terms that vanish or cancel in a real robot do not do so in this one.
    """
    direction = [[0.9, 0.2, 0.3], [-0.1, 0.8, 0.5], [0.3, -0.4, 0.9]]
    return {
        "platform_mass": 1.3,
        "gravity": [1.1, -2.3, -9.2],
        "origin": [[-0.7, 0.1, 0.2], [0.1, -0.6, -0.1], [-0.2, 0.3, -0.8]],
        "direction": [[c / sum(x * x for x in row) ** 0.5 for c in row] for row in direction],
        "joint": [[0.03, -0.02, 0.01], [-0.04, 0.03, -0.02], [0.02, 0.01, 0.05]],
        "link_length": [0.45, 0.5, 0.55],
        "link_mass": [0.4, 0.5, 0.6],
        "carriage_mass": [0.9, 1.0, 1.2],
        "carriage_length": [0.05, 0.06, 0.07],
        "belt_specific_stiffness": [2.2e6, 2.4e6, 2.6e6],
        "belt_width": [0.015, 0.02, 0.025],
        "pulley_radius": [0.03, 0.035, 0.04],
        "pulley_inertia": [1.1e-4, 1.3e-4, 1.5e-4],
        "motor_inertia": [1.5e-5, 1.7e-5, 1.9e-5],
        "gear_ratio": [8.0, 10.0, 12.0],
        "drive": [[1.0, 0.0], [0.0, 1.0], [0.0, 1.0]],
        "limits": [[0.0, 1.4], [0.1, 1.5], [-0.1, 1.3]],
        "branch": [-1.0, -1.0, -1.0],
    }


def describe(coordinates: tuple[tuple[str, str, str], ...], rigid_modes: int) -> Description:
    """The linear delta, with its coordinates as (name, unit, description)."""
    return Description(
        mechanism="linear_delta",
        title="three carriages on rails, parallelogram linkages, timing belts",
        pose=tuple(Named(c, "m", f"{c} of the platform centre in the base frame") for c in XYZ),
        pose_is="platform centre in the base frame",
        coordinates=tuple(Named(*q) for q in coordinates),
        independent=("x_1", "x_2", "x_3"),
        independent_are="carriage positions",
        directions=XYZ,
        drives=tuple(Named(j, "N m", f"driven pulley of axis {j}") for j in THREE),
        rigid_modes=rigid_modes,
        tables=tables(),
        wholes=(
            Whole("axis.span", "span", "limits", "m", "max - min of every axis, both ends moved evenly"),
            Whole(
                "axis.joint_radius", "radius", "joint", "m", "distance of the platform joints from the centre"
            ),
        ),
        margins=margins(),
        requirements=requirements(),
        sample=sample(),
        scales=tuple(Scale(f"x_{j + 1}", "pulley_radius", (j,), "R_p") for j in range(3)),
        differences=(("origin", "joint"),),
    )
