"""How to find the values of a robot file, and their usual uncertainty.

One table by path, for values with a description of their own; another by dimension, for all others.
"""

from __future__ import annotations

from typing import NamedTuple


class MeasuringMethod(NamedTuple):
    """How to find a value, a sentence without its full stop, and its usual relative standard deviation, if any."""

    instruction: str
    sigma: str = ""


#: How to find a value, by its path in a robot file without the number of an entry.
BY_PATH = {
    "gravity": MeasuringMethod("choose the frame; where z points up, gravity is -9.81 m/s^2 along z"),
    "platform.mass": MeasuringMethod(
        "weigh it with its tool and half of the cables and hoses that hang from it", "2 %"
    ),
    "platform.center": MeasuringMethod("take it from CAD, or balance the platform on an edge"),
    "toolhead.mass": MeasuringMethod("weigh it with half of the cables and hoses that hang from it", "2 %"),
    "beam.mass": MeasuringMethod(
        "weigh it with its rail, carriages and the motor that it carries, without the tool head", "2 %"
    ),
    "bed.mass": MeasuringMethod(
        "weigh it with its plate, carriage and half of its cables, without a print", "2 %"
    ),
    "gantry.mass": MeasuringMethod(
        "weigh the beam with its rail and carriages, without the tool head", "2 %"
    ),
    "carriage.mass": MeasuringMethod(
        "weigh it with all that moves with it, without the rotor of the motor", "2 %"
    ),
    "carriage.length": MeasuringMethod("measure from one belt clamp to the other with a caliper"),
    "link.length": MeasuringMethod(
        "take the distance of its joints from the drawing, or measure it with a caliper"
    ),
    "link.mass": MeasuringMethod("weigh both rods with their joints", "2 %"),
    "arm.length": MeasuringMethod(
        "take the distance of its two axes from the drawing, or measure it with a caliper"
    ),
    "arm.center": MeasuringMethod("take it from CAD, or balance the arm on an edge"),
    "arm.inertia": MeasuringMethod(
        "take it from CAD, or let the arm swing: m g center (T / (2 pi))^2, T its period", "5 %"
    ),
    "belt.specific_stiffness": MeasuringMethod(
        "data sheet of the belt: a force, divided by the strain at that force and by the width of that belt",
        "10 %",
    ),
    "belt.width": MeasuringMethod("data sheet of the belt, or a caliper"),
    "pulley.radius": MeasuringMethod("to the cords of the belt: number of teeth * pitch / (2 pi)"),
    "pulley.inertia": MeasuringMethod("take it from CAD; m r^2 / 2 for a solid disc", "5 %"),
    "motor.inertia": MeasuringMethod(
        "data sheet of the motor: its rotor; add brake, coupling and gearbox input", "5 %"
    ),
    "motor.gear_ratio": MeasuringMethod("data sheet of the gearbox; 1 without one"),
    "motor.travel": MeasuringMethod(
        "lead of the screw / (2 pi), divided by the ratio of a gearbox before it"
    ),
    "reducer.stiffness": MeasuringMethod("data sheet of the reducer", "10 %"),
    "frame.mass": MeasuringMethod("estimate it from CAD"),
    "damping.ratio": MeasuringMethod("identify it from measured signals, with pkmodes identify"),
    "axis.limits": MeasuringMethod("move the machine to both of its stops"),
    "axis.lengths": MeasuringMethod(
        "measure along the run, from the clamp on the slide to the motor pulley, with a tape"
    ),
    "workspace.x": MeasuringMethod("move the tool head to both of its stops"),
    "workspace.y": MeasuringMethod("move the tool head, or the bed, to both of its stops"),
    "belt_path.direction": MeasuringMethod("move the tool head by hand, and see which run grows"),
    "belt_path.lengths": MeasuringMethod(
        "measure along the run, from the tool head to the motor pulley, with a tape"
    ),
    "effects.servo_stiffness.stiffness": MeasuringMethod(
        "for a stepper motor, see docs/how-to/stepper-printer.md"
    ),
    "effects.gearbox_inertia.inertia": MeasuringMethod("data sheet of the gearbox, at its output"),
    "effects.gantry_racking.compliance": MeasuringMethod(
        "push one end of the beam along its guides with a known force: the difference of two dial gauges over their "
        "distance is the angle; divide it by force times distance to the middle"
    ),
    "effects.payload.mass": MeasuringMethod("weigh the payload"),
}
#: How to find other values, by dimension (`pkmodes_description.UNITS`).
BY_DIMENSION = {
    "length": MeasuringMethod("take it from the drawing, or measure it"),
    "mass": MeasuringMethod("weigh it", "2 %"),
    "moment of inertia": MeasuringMethod("take it from CAD or a data sheet", "5 %"),
    "acceleration": MeasuringMethod("choose the frame first"),
    "specific stiffness": MeasuringMethod(
        "data sheet: a force, divided by the strain at that force and by the width", "10 %"
    ),
    "stiffness": MeasuringMethod(
        "load it with a known force, and read its displacement from a dial gauge", "10 %"
    ),
    "torsional stiffness": MeasuringMethod(
        "data sheet, or lock one side, load the other and measure the angle", "10 %"
    ),
    "compliance": MeasuringMethod("load it with a known force, and read its displacement from a dial gauge"),
    "torsional compliance": MeasuringMethod("data sheet: 1 / torsional stiffness, on the output side"),
    "linear density": MeasuringMethod("weigh a piece, and divide by its length"),
    "angle": MeasuringMethod("take it from the drawing, or measure it"),
    "force": MeasuringMethod("measure it with a tension meter, or by the tone of a free span"),
    "reciprocal force": MeasuringMethod("measure the stiffness at two forces"),
    "viscous friction": MeasuringMethod(
        "measure the force at two speeds: its difference, divided by that of the speeds"
    ),
    "torsional viscous friction": MeasuringMethod(
        "measure the torque at two speeds: its difference, divided by that of the speeds"
    ),
    "frequency": MeasuringMethod(
        "hold what it hangs on, tap it, and measure the frequency at which it rings"
    ),
    "number": MeasuringMethod(""),
}


def measuring_method(path: str, dimension: str) -> MeasuringMethod:
    """Return how to find the value at a path."""
    return BY_PATH.get(path) or BY_DIMENSION[dimension]
