"""A format of signal files: how its files are recognised, and how they are read."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from pathlib import Path

from pkmodes.signals.functions import SignalFile


@dataclass(frozen=True)
class Asked:
    """What is wanted of a file.

    Attributes
    ----------
    rate : float, optional
        Sampling rate [Hz] of signals without a column of times.
    sensors : frozenset of str, optional
        Names of the sensors whose functions are wanted; all by default.  Forces in time are always read.
    """

    rate: float | None = None
    sensors: frozenset[str] | None = None

    def wants(self, *names: str) -> bool:
        """Return whether a sensor that has any of these names is wanted."""
        return self.sensors is None or not self.sensors.isdisjoint(names)


@dataclass(frozen=True)
class SignalFormat:
    """A file format.

    Attributes
    ----------
    name : str
        For messages.
    suffixes : tuple of str
        Of its files, in lower case with the dot.
    recognises : callable
        Whether a file that begins with some bytes is of this format.
    read : callable
        The content of a file.  Raises `MeasurementError`.
    """

    name: str
    suffixes: tuple[str, ...]
    recognises: Callable[[bytes], bool]
    read: Callable[[Path, Asked], SignalFile]
