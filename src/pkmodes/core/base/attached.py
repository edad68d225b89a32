"""Methods that applications attach to a class of the core, which names them and imports none."""

from __future__ import annotations

from collections.abc import Callable
from functools import cached_property
from importlib import import_module
from typing import Any


class Attached:
    """A function of an application as a method, loaded at its first use.

    - target: module and name of the function, ``"pkmodes.machine.maps.mapping:map_of"``; its first argument is the
    instance
    """

    def __init__(self, target: str) -> None:
        self._target = target

    @cached_property
    def _function(self) -> Callable[..., Any]:
        module, _, name = self._target.partition(":")
        function: Callable[..., Any] = getattr(import_module(module), name)
        return function

    def __get__(self, instance: Any, owner: type) -> Any:
        return self._function.__get__(instance, owner)
