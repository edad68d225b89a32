"""What a generated file says about where it comes from."""

from __future__ import annotations

from dataclasses import dataclass, fields


def harmless(text: str) -> str:
    """Text that can stand in a comment or docstring of any language: it cannot end one.

    Names and paths come from users; code must not.
    """
    text = "".join(c if c.isprintable() else "?" for c in text)
    for mark in ("*/", "/*", '"""', "\\"):
        text = text.replace(mark, "?" * len(mark))
    return text.replace('"', "'")


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

    def __post_init__(self) -> None:
        for item in fields(self):
            value = getattr(self, item.name)
            clean = harmless(value) if isinstance(value, str) else tuple(map(harmless, value))
            object.__setattr__(self, item.name, clean)

    @property
    def parametric(self) -> bool:
        """Whether the parameters are arguments, not constants."""
        return not self.constants
