"""Generated model of the mechanism hexapod: see `model`."""

from .model import *  # noqa: F403
