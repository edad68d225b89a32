"""From a robot file to a robot or its evaluator.

Reading units and schemas costs more than the rest of the package together, so it is imported when a file is
read and not before.
"""

from __future__ import annotations

from os import PathLike

from pkmodes.model import Model
from pkmodes.robot.robot import Robot


def read_robot(path: str | PathLike[str]) -> Robot:
    """Read and validate a robot file.

    Parameters
    ----------
    path : path-like
        A robot file (docs/robot-file.md).

    Raises
    ------
    RobotFileError
        If the file cannot be read or anything in it is wrong.
    """
    from pkmodes.robot import reading

    return reading.read_robot(path)


def load(path: str | PathLike[str]) -> Model:
    """Read a robot file and return its evaluator.

    Parameters
    ----------
    path : path-like
        A robot file (docs/robot-file.md).

    Raises
    ------
    RobotFileError
        If the file cannot be read or anything in it is wrong.

    Examples
    --------
    >>> model = load("robots/linear-delta-2022.toml")
    >>> model.modes([0.6, 0.0, -0.245]).frequencies.round(3)[3:]
    array([ 55.559,  60.316,  61.545, 130.801, 133.831, 134.257])
    """
    return Model(read_robot(path))
