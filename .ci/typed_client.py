"""A program of a user who checks types: `mypy --strict` against the installed package must find nothing wrong in it.

``.ci/floors`` checks it, and that a mistake in it is found.
"""

from __future__ import annotations

from typing import Any, assert_type

import numpy as np
from numpy.typing import NDArray

import pkmodes
from pkmodes import diagnosis, updating


def first_vibration(file: str, poses: NDArray[np.float64]) -> NDArray[np.float64]:
    """Return the first frequency that is not of a rigid mode, for each pose [Hz]."""
    model = pkmodes.load(file)
    assert_type(model, pkmodes.Model)
    assert_type(model.robot, pkmodes.Robot)
    modes = model.modes(poses, drives="held")
    assert_type(modes, pkmodes.Modes)
    assert_type(modes.frequencies, NDArray[np.float64])
    try:
        return model.frequencies(poses)[..., modes.rigid_modes]
    except pkmodes.PoseError as error:
        raise SystemExit(error.remedy) from None


def cause(robot: str, measured: str) -> dict[str, Any]:
    """Return what a diagnosis says, as JSON."""
    model = pkmodes.load(robot)
    found = updating.diagnose(model, updating.read(measured))
    assert_type(found, diagnosis.Diagnosis)
    assert_type(found.verdict, str)
    return found.as_json()


#: What --strict must find, so that the package cannot become untyped without notice.
WRONG: int = pkmodes.load("robot.toml")  # type: ignore[assignment]
