"""Generated model of the mechanism corexy: see `model`."""

from pkmodes_generated.corexy.model import *  # noqa: F403
