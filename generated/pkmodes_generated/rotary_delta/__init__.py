"""Generated model of the mechanism rotary_delta: see `model`."""

from .model import *  # noqa: F403
