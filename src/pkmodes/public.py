"""What `pkmodes` offers to a program: the names that the package itself hands on when the first is asked for."""

from pkmodes.errors import NotComputedError, PkmodesError, PoseError, RobotFileError
from pkmodes.loading import load, read_robot
from pkmodes.model import Model
from pkmodes.results import Modes, PoseCheck, Statics
from pkmodes.robot.robot import Robot
from pkmodes.robot.units import Quantity

__all__ = [
    "Model",
    "Modes",
    "NotComputedError",
    "PkmodesError",
    "PoseCheck",
    "PoseError",
    "Quantity",
    "Robot",
    "RobotFileError",
    "Statics",
    "load",
    "read_robot",
]
