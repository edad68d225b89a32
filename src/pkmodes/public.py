"""The public names of `pkmodes`, loaded together; ``pkmodes.__all__`` lists them."""

from pkmodes.errors import NotComputedError as NotComputedError
from pkmodes.errors import PkmodesError as PkmodesError
from pkmodes.errors import PoseError as PoseError
from pkmodes.errors import RobotFileError as RobotFileError
from pkmodes.loading import load as load
from pkmodes.loading import read_robot as read_robot
from pkmodes.model import Model as Model
from pkmodes.results import Modes as Modes
from pkmodes.results import PoseCheck as PoseCheck
from pkmodes.results import Statics as Statics
from pkmodes.robot.robot import Robot as Robot
from pkmodes.robot.units import Quantity as Quantity
