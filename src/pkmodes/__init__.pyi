from . import diagnosis as diagnosis
from . import updating as updating
from .api import Model, load, read_robot
from .core.base.errors import NotComputedError, PkmodesError, PoseError, RobotFileError
from .core.robot.robot import Robot
from .core.robot.units import Quantity
from .core.solve.results import Modes, PoseCheck, Statics

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
