"""What `pkmodes` offers to a program: the names that the package itself hands on when the first is asked for."""

from pkmodes.errors import PkmodesError, PoseError, RobotFileError
from pkmodes.loading import load, read_robot
from pkmodes.model import Model
from pkmodes.results import Modes, Statics
from pkmodes.robot.robot import Robot

__all__ = [
    "Model",
    "Modes",
    "PkmodesError",
    "PoseError",
    "Robot",
    "RobotFileError",
    "Statics",
    "load",
    "read_robot",
]
