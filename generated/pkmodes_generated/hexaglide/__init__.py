"""Generated model of the mechanism hexaglide: see `model`."""

from .model import *  # noqa: F403
