"""Generated model of the mechanism corexy: see `model`."""

from .model import *  # noqa: F403
