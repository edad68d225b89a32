"""Two mechanisms that only exist as descriptions: a gantry with two crossed belts, and arms that turn.

Their tables are those of mechanisms.md's corexy and rotary_delta; of a generated model they have what reading a robot
file needs, which is the named tuple of the parameters and the functions of the requirements.
"""

from __future__ import annotations

import math
from pathlib import Path

from msgspec.structs import replace

from pkmodes_description import (
    Description,
    Drawing,
    Effect,
    EffectParameter,
    Key,
    Named,
    ParameterGroup,
    Requirement,
    Table,
    encode,
)

XY, XYZ, ENDS, RUNS = ("x", "y"), ("x", "y", "z"), ("min", "max"), ("1", "2")


def quantity(name: str, field: str, dimension: str, **bounds: object) -> Key:
    return Key(name, "quantity", field, dimension, name, **bounds)  # type: ignore[arg-type]


def effect(name: str, *parameters: tuple[str, str], coordinates: tuple[str, ...] = ()) -> Effect:
    return Effect(
        name,
        f"there is {name.replace('_', ' ')}",
        grounds=False,
        coordinates=tuple(Named(q, "m", q) for q in coordinates),
        parameters=tuple(
            EffectParameter(parameter, unit, parameter, 0.0, fitted=parameter not in ("mass", "tension"))
            for parameter, unit in parameters
        ),
        requirements=(),
    )


EFFECTS = (
    effect("belt_mass", ("linear_density", "kg/m")),
    effect("belt_tension_stiffness", ("tension", "N"), ("coefficient", "1/N")),
    effect("frame_compliance", ("compliance", "m/N"), ("mass", "kg"), coordinates=("u_x", "u_y")),
)
FRAME = Table(
    "frame",
    "the frame",
    (quantity("mass", "", "mass", above=0.0, default=50.0, effect="frame_compliance.mass", suspected=False),),
)
MOTOR = (
    quantity("inertia", "motor_inertia", "moment of inertia", at_least=0.0),
    quantity("gear_ratio", "gear_ratio", "number", above=0.0),
)
GANTRY = Description(
    name="made_up_gantry",
    title="a gantry with two crossed belts",
    pose=tuple(Named(c, "m", c) for c in XY),
    pose_is="tool head in the base frame",
    coordinates=tuple(Named(c, "m", c) for c in XY),
    independent=XY,
    independent_are="positions",
    directions=XY,
    drives=(Named("1", "N m", "motor"),),
    rigid_modes=2,
    tables=(
        Table("toolhead", "the tool head", (quantity("mass", "toolhead_mass", "mass", above=0.0),)),
        Table("gantry", "the beam", (quantity("mass", "gantry_mass", "mass", at_least=0.0),)),
        Table(
            "belt",
            "a belt",
            (
                quantity("specific_stiffness", "belt_specific_stiffness", "specific stiffness", above=0.0),
                quantity("width", "belt_width", "length", above=0.0),
            ),
            shared_by="belt_path",
        ),
        Table(
            "pulley",
            "a motor pulley",
            (
                quantity("radius", "pulley_radius", "length", above=0.0),
                quantity("inertia", "pulley_inertia", "moment of inertia", above=0.0),
            ),
            shared_by="belt_path",
        ),
        Table("motor", "a motor", MOTOR, shared_by="belt_path"),
        Table(
            "workspace",
            "travel of the tool head",
            tuple(
                Key(c, "pair", "workspace", "length", c, (i,), ENDS, signed=True, suspected=False)
                for i, c in enumerate(XY)
            ),
        ),
        FRAME,
        Table(
            "belt_path",
            "a belt with its two runs",
            (
                Key("direction", "signs", "signs", "number", "g", elements=XY, choices=(1, -1)),
                Key("lengths", "vector", "lengths", "length", "free lengths", elements=RUNS, above=0.0),
            ),
            count=2,
        ),
    ),
    parameter_groups=(),
    margins=(),
    requirements=(
        Requirement(
            "shortest_runs",
            "above_zero",
            tuple(f"belt_path.{i}.lengths" for i in RUNS),
            "expected runs positive in the whole workspace, found one of {value} ({lengths.1} at the origin)",
            "check lengths and workspace",
            "m",
        ),
    ),
    effects_in_order=EFFECTS,
    sample={},
    scales=(),
    difference_pairs=(),
    drawing=Drawing(motions=(0,), elements=(), springs=(), uprights=0),
)
GANTRY_CODE = """
from typing import Any, NamedTuple

import numpy as np


class Parameters(NamedTuple):
    gravity: Any
    toolhead_mass: Any
    gantry_mass: Any
    belt_specific_stiffness: Any
    belt_width: Any
    pulley_radius: Any
    pulley_inertia: Any
    motor_inertia: Any
    gear_ratio: Any
    workspace: Any
    signs: Any
    lengths: Any


def shortest_runs(p):
    corners = np.array(np.meshgrid(*p.workspace)).reshape(2, -1)
    along = p.signs @ corners
    return np.minimum(p.lengths[:, :1] + along, p.lengths[:, 1:] - along).min(axis=1)
"""
GANTRY_FILE = """\
format = 1
name = "desktop"
mechanism = "made_up_gantry"
gravity = ["0 m/s^2", "0 m/s^2", "-9.81 m/s^2"]

[toolhead]
mass = { value = "0.5 kg", sigma = "2 %" }
[gantry]
mass = "0.7 kg"
[belt]
specific_stiffness = "2.6e6 N/m"
width = "6 mm"  # of both
[pulley]
radius = "6.37 mm"
inertia = "2e-7 kg*m^2"
[motor]
inertia = "5.4e-6 kg*m^2"
gear_ratio = 1

[workspace]
x = ["0 mm", "300 mm"]
y = ["-10 mm", "250 mm"]

[[belt_path]]
direction = [1, -1]
lengths = ["450 mm", "750 mm"]
[[belt_path]]
direction = [-1, -1]
lengths = ["750 mm", "760 mm"]
[belt_path.belt]
width = "9 mm"
"""

ARMS = replace(
    GANTRY,
    name="made_up_arms",
    title="arms that turn",
    tables=(
        Table(
            "arm",
            "an arm",
            (quantity("length", "arm_length", "length", above=0.0),),
            shared_by="axis",
        ),
        Table(
            "reducer",
            "between motor and arm",
            (quantity("stiffness", "reducer_stiffness", "torsional stiffness", above=0.0),),
            shared_by="axis",
        ),
        FRAME,
        Table(
            "axis",
            "an arm with its motor",
            (
                Key("axis", "direction", "axis", "number", "unit vector of rotation"),
                Key("joint", "vector", "joint", "length", "platform joint", elements=XYZ, signed=True),
                Key(
                    "limits",
                    "pair",
                    "limits",
                    "angle",
                    "of the arm",
                    elements=ENDS,
                    at_least=-math.pi,
                    at_most=math.pi,
                    signed=True,
                ),
                Key("branch", "choice", "branch", "number", "which way", choices=(1, -1)),
            ),
            count=3,
        ),
    ),
    parameter_groups=(
        ParameterGroup("axis.joint_radius", "radius", "joint", "m", "distance of the joints from the centre"),
        ParameterGroup("axis.range", "span", "limits", "rad", "max - min of every arm"),
    ),
    requirements=(),
)
ARMS_CODE = """
from typing import Any, NamedTuple


class Parameters(NamedTuple):
    gravity: Any
    arm_length: Any
    reducer_stiffness: Any
    axis: Any
    joint: Any
    limits: Any
    branch: Any
"""
ARMS_FILE = """\
format = 1
name = "arms"
mechanism = "made_up_arms"
gravity = ["0 m/s^2", "0 m/s^2", "-9.81 m/s^2"]
[arm]
length = "240 mm"
[reducer]
stiffness = "4000 N*m/rad"
""" + "".join(
    f"""
[[axis]]
axis = {axis}
joint = {joint}
limits = ["-95 deg", "40 deg"]
branch = 1
"""
    for axis, joint in (
        ("[0, -1, 0]", '["40 mm", "0 mm", "0 mm"]'),
        ("[0.866, 0.5, 0]", '["-20 mm", "34 mm", "0 mm"]'),
        ("[-0.866, 0.5, 0]", '["-20 mm", "-34 mm", "0 mm"]'),
    )
)


def write_package(folder: Path) -> tuple[str, ...]:
    """Write both as packages below a folder, and return their names."""
    for description, code in ((GANTRY, GANTRY_CODE), (ARMS, ARMS_CODE)):
        package = folder / "made_up" / description.name
        package.mkdir(parents=True)
        (package / "__init__.py").write_text(code, encoding="utf-8")
        (package / "description.json").write_text(encode(description), encoding="utf-8")
    return tuple(f"made_up.{description.name}" for description in (GANTRY, ARMS))
