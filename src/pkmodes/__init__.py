"""Vibration modes of parallel robots with compliant transmissions.

`load` reads a robot file and returns a `Model`, whose ``modes``, ``matrices`` and ``statics`` take one pose or
an array of poses.  Coordinates, signs and frames are stated in docs/model.md.
"""

from types import ModuleType

from pkmodes.errors import NotComputedError, PkmodesError, PoseError, RobotFileError
from pkmodes.loading import load, read_robot
from pkmodes.model import Model
from pkmodes.results import Modes, PoseCheck, Statics
from pkmodes.robot.robot import Robot
from pkmodes.robot.units import Quantity

__version__ = "0.1.0"

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


def __getattr__(name: str) -> ModuleType:
    """Load what compares with measurements when it is used: it needs SciPy, which takes long to import."""
    if name == "closing":
        import pkmodes.closing

        return pkmodes.closing
    if name == "diagnosis":
        import pkmodes.diagnosis

        return pkmodes.diagnosis
    raise AttributeError(f"module {__name__!r} has no attribute {name!r}")


def __dir__() -> list[str]:
    return sorted({*globals(), "closing", "diagnosis"})
