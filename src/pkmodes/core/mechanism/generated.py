"""The functions of a generated module, with the robot's parameters and effects bound."""

from __future__ import annotations

from collections.abc import Callable
from functools import cache
from inspect import Parameter, signature
from typing import Any


class Generated:
    """The functions of a generated module, with parameters and effects supplied to those that take them.

    A function takes only the arguments on which it depends, and these differ between mechanisms: a result may be
    constant for one and a formula for another.

    - module: the generated model of a mechanism or of a single robot
    - parameters: the robot; omitted for the model of a single robot
    - effects: the robot's effects, for an extended model
    """

    def __init__(self, module: Any, parameters: Any = None, effects: Any = None) -> None:
        self._module, self._bound = module, {"parameters": parameters, "effects": effects}

    @property
    def coordinates(self) -> int:
        """Number of generalised coordinates."""
        return len(self._module.COORDINATES)

    def has(self, *names: str) -> bool:
        """Return whether the module has all of these functions."""
        return all(hasattr(self._module, name) for name in names)

    def __getattr__(self, name: str) -> Callable[..., Any]:
        function = getattr(self._module, name)
        bound = [
            self._bound[name_taken]
            for name_taken in _bound_arguments(function)
            if self._bound[name_taken] is not None
        ]
        return lambda *arguments: function(*arguments, *bound)


@cache
def _bound_arguments(function: Callable[..., Any]) -> tuple[str, ...]:
    """Return which of ``parameters`` and ``effects`` a function takes."""
    signature_parameters = signature(function).parameters
    variadic = any(parameter.kind is Parameter.VAR_POSITIONAL for parameter in signature_parameters.values())
    return tuple(name for name in ("parameters", "effects") if variadic or name in signature_parameters)
