"""A file format, of measurements or of signals: how its files are recognised, and how they are read."""

from __future__ import annotations

from collections.abc import Callable, Collection, Mapping, Sequence
from dataclasses import dataclass, field
from os import PathLike
from types import MappingProxyType
from typing import Generic, TypeVar

from pkmodes.core.base.drives import FREE
from pkmodes.loop.measured.columns import POSITION
from pkmodes.loop.measured.measurements import Measurements


@dataclass(frozen=True)
class Machine:
    """What the files of a measured machine may contain: its coordinates, poses and settings.

    - channels: coordinates at which shapes may be measured.  A mapping gives their SI units.
    - positions: whether the pose components are required.  If not, either all or none of them must be present.
    - components: possible sets of pose components, each with SI units
    - settings: paths of values that may be set, with their SI units
    - drives: what the motors did, if the user states it: "free" or "held"
    - state: the state of the machine whose rows are read, of a file with rows of several
    - others: returns the columns that measurements of other machines may have, by the name of the machine, for errors
      about such columns
    - usual_drives: what the motors did if neither the user nor the file says so
    """

    channels: Collection[str] | Mapping[str, str]
    positions: bool = True
    components: Sequence[Mapping[str, str]] = (POSITION,)
    settings: Mapping[str, str] = field(default_factory=lambda: MappingProxyType({}))
    drives: str | None = None
    state: str | None = None
    others: Callable[[], Mapping[str, Collection[str]]] = dict
    usual_drives: str = FREE


#: Function that reads a format of measurements, from the path of a file and the machine.
Reader = Callable[[str | PathLike[str], Machine], Measurements]
Read_co = TypeVar("Read_co", bound=Callable[..., object], covariant=True)


@dataclass(frozen=True)
class Format(Generic[Read_co]):
    """A file format.

    - name: name in messages
    - suffixes: suffixes of its files, in lower case with the dot
    - recognises: whether a file that begins with some bytes is of this format
    - read: reads a file, from its path and what is expected of it.  Raises `MeasurementError`.
    """

    name: str
    suffixes: tuple[str, ...]
    recognises: Callable[[bytes], bool]
    read: Read_co
