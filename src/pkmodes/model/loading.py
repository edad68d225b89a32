"""Load a robot file as a robot or as its evaluator."""

from __future__ import annotations

from os import PathLike

from pkmodes.model.model import Model
from pkmodes.robot.reading import read_robot

__all__ = ["load", "read_robot"]


def load(path: str | PathLike[str]) -> Model:
    """Read a robot file and return its evaluator.

    Parameters
    ----------
    path : path-like
        A robot file (docs/robot-file.md).

    Returns
    -------
    Model
        The evaluator; ``Model.robot`` has the declared values.

    Raises
    ------
    RobotFileError
        If the file cannot be read or is invalid.

    Examples
    --------
    >>> model = load("robots/linear-delta-2022.toml")
    >>> model.modes([0.6, 0.0, -0.245]).frequencies.round(3)[3:]
    array([ 55.559,  60.316,  61.545, 130.801, 133.831, 134.257])
    """
    return Model(read_robot(path))
