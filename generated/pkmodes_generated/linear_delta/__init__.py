"""Generated model of the mechanism linear_delta: see `model`."""

from .model import *  # noqa: F403
