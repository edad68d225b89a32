"""Generated model of the mechanism cartesian: see `model`."""

from .model import *  # noqa: F403
