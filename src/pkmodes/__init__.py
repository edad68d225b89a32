"""Vibration modes of parallel robots with compliant transmissions.

`load` reads a robot file and returns a `Model`, whose ``modes``, ``matrices`` and ``statics`` take one pose or
an array of poses.  docs/model.md defines the coordinates, signs and frames.
"""

# ruff: noqa: F403, F405 - type checkers see where the names come from without anything being loaded
TYPE_CHECKING = False  # as in typing, without importing it
if TYPE_CHECKING:
    from pkmodes.public import *

__version__ = "0.1.0"

__all__ = [
    "Model",
    "Modes",
    "NotComputedError",
    "PkmodesError",
    "PoseCheck",
    "PoseError",
    "Quantity",
    "Robot",
    "RobotFileError",
    "Statics",
    "load",
    "read_robot",
]


def __getattr__(name: str) -> object:
    """Load the public names when the first is used: the command line has to start before NumPy is loaded.

    Modules that compare with measurements are loaded separately: they need SciPy, which takes even longer.
    """
    if name == "updating":
        import pkmodes.updating

        return pkmodes.updating
    if name == "closing":
        import pkmodes.closing

        return pkmodes.closing
    if name == "diagnosis":
        import pkmodes.diagnosis

        return pkmodes.diagnosis
    if name == "public" or name.startswith("__"):
        raise AttributeError(f"module {__name__!r} has no attribute {name!r}")
    import pkmodes.public

    found = globals()
    found.update({entry: vars(pkmodes.public)[entry] for entry in __all__ if entry in vars(pkmodes.public)})
    if name not in found:
        raise AttributeError(f"module {__name__!r} has no attribute {name!r}")
    return found[name]


def __dir__() -> list[str]:
    return sorted({*globals(), *__all__, "updating", "diagnosis"})
