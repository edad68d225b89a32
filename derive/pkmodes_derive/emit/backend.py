"""A back end: a language that models are written in.  `registry` has the list of them."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import dataclass

from sympy import Expr

from pkmodes_derive.emit.program import Program
from pkmodes_derive.emit.provenance import Provenance
from pkmodes_derive.functions import Model
from pkmodes_description import Description

#: Texts by file name.
Texts = dict[str, str]
Programs = Mapping[str, Program]


def _no_model(model: Model, programs: Programs, provenance: Provenance) -> Texts:
    return {}


def _no_mechanism(
    base: Model, extended: Model, description: Description, provenance: Provenance
) -> tuple[Texts, dict[str, Program]]:
    return {}, {}


@dataclass(frozen=True)
class Backend:
    """A language that models are written in; a subpackage, with its printer and templates, defines it as ``BACKEND``.

    Attributes
    ----------
    name : str
        Name of the language.
    printer : callable
        Returns an expression as text; it raises an error for a function that the language does not have.
    model : callable
        ``model(model, programs, provenance)`` returns the files of one model; `programs` has the program of each of
        its functions by name, which every language prints unchanged.
    mechanism : callable
        ``mechanism(base, extended, description, provenance)`` returns the files of a mechanism that need both of its
        models together, and the programs that they print.
    source : str
        Ending of the file whose digest identifies a model in every language; empty for none.
    """

    name: str
    printer: Callable[[Expr], str]
    model: Callable[[Model, Programs, Provenance], Texts] = _no_model
    mechanism: Callable[[Model, Model, Description, Provenance], tuple[Texts, dict[str, Program]]] = (
        _no_mechanism
    )
    source: str = ""
