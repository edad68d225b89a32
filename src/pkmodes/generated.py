"""The functions of a generated module, each with what it takes besides its own arguments."""

from __future__ import annotations

from collections.abc import Callable
from functools import cache
from inspect import Parameter, signature
from typing import Any


class Generated:
    """The functions of a generated module, with the robot's parameters and effects supplied where they take them.

    What a function does not depend on it does not take: that of one mechanism may have a constant where that of
    another has a formula.

    Parameters
    ----------
    module
        A generated model: that of a mechanism, or of a single robot.
    parameters : Parameters, optional
        The robot; none for the model of a single one.
    effects : Effects, optional
        Its effects, for an extended model.
    """

    def __init__(self, module: Any, parameters: Any = None, effects: Any = None) -> None:
        self._module, self._supplied = module, {"parameters": parameters, "effects": effects}

    @property
    def coordinates(self) -> int:
        """How many generalised coordinates it has."""
        return len(self._module.COORDINATES)

    def has(self, *names: str) -> bool:
        """Whether the module has all of these functions."""
        return all(hasattr(self._module, name) for name in names)

    def __getattr__(self, name: str) -> Callable[..., Any]:
        function = getattr(self._module, name)
        supplied = [self._supplied[taken] for taken in _taken(function) if self._supplied[taken] is not None]
        return lambda *arguments: function(*arguments, *supplied)


@cache
def _taken(function: Callable[..., Any]) -> tuple[str, ...]:
    """Which of the parameters and effects a function takes."""
    found = signature(function).parameters
    every = any(one.kind is Parameter.VAR_POSITIONAL for one in found.values())
    return tuple(name for name in ("parameters", "effects") if every or name in found)
