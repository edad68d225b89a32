"""Generated model of the mechanism linear_delta: see `model`."""

from pkmodes_generated.linear_delta.model import *  # noqa: F403
