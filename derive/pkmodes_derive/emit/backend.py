"""Backends, one for each language that models are written in."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import dataclass

from pkmodes_derive.emit.program import Program
from pkmodes_derive.emit.provenance import Provenance
from pkmodes_derive.functions import Model


@dataclass(frozen=True)
class Backend:
    """A language that models are written in; a subpackage defines it as ``BACKEND``.

    Attributes
    ----------
    name : str
        Name of the language.
    files : callable
        ``files(model, programs, provenance)`` returns texts by file name; `programs` has the program of each function
        of the model by name, which every language prints unchanged.
    """

    name: str
    files: Callable[[Model, Mapping[str, Program], Provenance], dict[str, str]]
