"""What a language is to a product: a name, and the files that it writes."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import dataclass

from pkmodes_derive.emit.program import Program
from pkmodes_derive.emit.provenance import Provenance
from pkmodes_derive.functions import Model


@dataclass(frozen=True)
class Backend:
    """A language that models are written in; a folder beside this module defines it as ``BACKEND``.

    Attributes
    ----------
    name : str
        Of the language.
    files : callable
        ``files(model, programs, provenance)`` returns texts by file name; `programs` holds one program for each
        function of the model, by name, which every language prints as it stands.
    """

    name: str
    files: Callable[[Model, Mapping[str, Program], Provenance], dict[str, str]]
