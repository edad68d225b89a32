from . import diagnosis as diagnosis
from . import updating as updating
from .api import Model, load, read_robot
from .base.errors import NotComputedError, PkmodesError, PoseError, RobotFileError
from .robot.robot import Robot
from .robot.units import Quantity
from .solve.results import Modes, PoseCheck, Statics

__version__: str
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
