"""The public functions of the generated model, found by inspection, and arguments to call each one with.

Tests run through these instead of through a list of names, so that a function that is added to the model is
tested from then on, or makes a test fail that says what is missing.
"""

from __future__ import annotations

import inspect
from collections.abc import Callable
from typing import Any

import numpy as np

from pkmodes_generated.linear_delta import model
from helpers.robots.sample_robots import Sample

#: Every public function of the generated module by its name.
FUNCTIONS: dict[str, Callable[..., Any]] = {
    name: member
    for name, member in inspect.getmembers(model, inspect.isfunction)
    if member.__module__ == model.__name__ and not name.startswith("_")
}
#: That of the robot alone is no function of a pose, and has a test of its own.
TRAVEL = FUNCTIONS.pop("travel_margin")
#: Names of the arguments of each, in order.
SIGNATURES: dict[str, tuple[str, ...]] = {
    name: tuple(inspect.signature(function).parameters) for name, function in FUNCTIONS.items()
}
#: Trailing axes of each argument.
CORE_SHAPES: dict[str, tuple[int, ...]] = {
    "p": (3,),
    "x": (3,),
    "assembly": (),
    "x_dot": (3,),
    "q_dot": (9,),
    "delta_q": (9,),
}


def arguments(name: str, robot: Sample, seed: int = 0) -> dict[str, Any]:
    """Arguments of one function at the pose of a sample; velocities and displacements at random."""
    rng = np.random.default_rng(seed)
    x = model.inverse_kinematics(robot.pose, robot.parameters)
    known = {
        "p": robot.pose,
        "x": x,
        "assembly": np.sign(model.jacobian_condition(robot.pose, robot.parameters)[0]),
        "x_dot": rng.normal(size=3),
        # a carriage that moves at 1 m/s turns pulleys of some 30 mm at 30 rad/s
        "q_dot": rng.normal(size=9) * np.repeat([1.0, 30.0], [3, 6]),
        "delta_q": rng.normal(size=9) * np.repeat([1e-3, 3e-2], [3, 6]),
        "parameters": robot.parameters,
    }
    return {argument: known[argument] for argument in SIGNATURES[name]}


def outputs(name: str, **given: Any) -> tuple[Any, ...]:
    """Call one function; always a tuple of its outputs."""
    result = FUNCTIONS[name](**given)
    return result if isinstance(result, tuple) else (result,)


def scale(expected: np.ndarray) -> np.ndarray:
    """Size against which an error in an array is measured: its largest entry.

    Rows of the 9 by 9 matrices have different units; there the scale of an entry is the geometric mean of the
    two diagonal entries beside it, as for a positive semidefinite matrix, so that a pulley of 1e-4 kg m^2 is
    held to the same relative error as a carriage of 1 kg.
    """
    if expected.shape[-2:] == (9, 9):
        diagonal = np.sqrt(np.einsum("...ii->...i", expected))
        return diagonal[..., :, None] * diagonal[..., None, :]
    return np.max(np.abs(expected), initial=0.0)
