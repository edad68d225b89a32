"""Methods that applications attach to a class of the core, which names them and imports none."""

from __future__ import annotations

from importlib import import_module
from typing import Any


class Attached:
    """A function of an application as a method: it is loaded at its first use, and then stands in the class itself.

    Parameters
    ----------
    place : str
        Module and name of the function, ``"pkmodes.maps.mapping:map_of"``; its first argument is the instance.
    """

    def __init__(self, place: str) -> None:
        self._place = place

    def __set_name__(self, owner: type, name: str) -> None:
        self._owner, self._name = owner, name

    def __get__(self, instance: Any, owner: type) -> Any:
        module, _, name = self._place.partition(":")
        function = getattr(import_module(module), name)
        setattr(self._owner, self._name, function)
        return function.__get__(instance, owner)
