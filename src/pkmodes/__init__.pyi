from .api import Model, load, read_robot
from .core.base.errors import NotComputedError, PkmodesError, PoseError, RobotFileError
from .core.robot.robot import Robot
from .core.robot.units import Quantity
from .core.solve.results import Modes, PoseCheck, Statics
from .loop import diagnosis as diagnosis
from .loop import updating as updating

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
