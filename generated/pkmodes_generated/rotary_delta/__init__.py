"""Generated model of the mechanism rotary_delta: see `model`."""

from pkmodes_generated.rotary_delta.model import *  # noqa: F403
