"""What a generated file says about where it comes from."""

from __future__ import annotations

from dataclasses import dataclass


@dataclass(frozen=True)
class Provenance:
    """Header of a generated file; digests are in the manifest, so that files change only when code does.

    Attributes
    ----------
    name : str
        Module name; also the prefix of C names.
    title : str
        First line of the module docstring.
    origin : str
        What it was derived from, in words.
    generator : str
        Name and version of generator and SymPy.
    command : str
        Command that regenerates it.
    constants : tuple of str
        For a specialised model, the parameters that were folded in, one line each.
    """

    name: str
    title: str
    origin: str
    generator: str
    command: str
    constants: tuple[str, ...] = ()

    @property
    def parametric(self) -> bool:
        """Whether the parameters are arguments, not constants."""
        return not self.constants
