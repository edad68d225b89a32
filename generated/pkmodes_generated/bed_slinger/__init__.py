"""Generated model of the mechanism bed_slinger: see `model`."""

from .model import *  # noqa: F403
