"""The header of a generated file, which states its origin."""

from __future__ import annotations

import shlex
from dataclasses import dataclass, field, fields, replace

from pkmodes_derive.emit.identity import Identity, digest

#: Text in the second and third lines of a generated file, in the comments of any language.
MARKS = ("By pkmodes_derive ", "Do not edit: regenerate with `")
#: Placeholder for a robot file whose name cannot be printed.
ANY_ROBOT = "ROBOT.toml"


def harmless(text: str) -> str:
    """Return text that cannot end a comment or docstring of any language.

    Names and paths come from users and must not become code.
    """
    text = "".join(c if c.isprintable() else "?" for c in text)
    for mark in ("*/", "/*", '"""', "\\"):
        text = text.replace(mark, "?" * len(mark))
    return text.replace('"', "'")


def pasteable(path: str) -> str:
    """Return a path as one word of a shell command that is safe in a comment of any language.

    An extra pair of quotes within quotes does not change the word for the shell but splits the end of a comment.
    """
    if not path.isprintable():
        return ANY_ROBOT
    word = shlex.quote(f"./{path}" if path.startswith("-") else path)
    return word.replace("*/", "*''/").replace("/*", "/''*")


def is_generated(text: str) -> bool:
    """Return whether a text begins with the header of a generated file."""
    lines = text.split("\n", 3)
    return len(lines) > 2 and all(mark in line for mark, line in zip(MARKS, lines[1:], strict=False))


@dataclass(frozen=True)
class Provenance:
    """Header of a generated file; digests are in the manifest, so that files change only when code does.

    Attributes
    ----------
    name : str
        Prefix of C names, and name of the C files.
    module : str
        Name of the Python module.
    title : str
        First line of the module docstring.
    origin : str
        What it was derived from, in words.
    generator : str
        Name and version of generator and SymPy.
    command : str
        Command that regenerates it; its paths are `pasteable`.  It appears only in comments.
    place : str
        Where to run the command, as the end of a sentence; empty for anywhere.
    constants : tuple of str
        For a specialised model, the parameters that were folded in, one line each.
    identity : Identity
        Constants of the code that tell one model from another.
    """

    name: str
    module: str
    title: str
    origin: str
    generator: str
    command: str
    place: str = ""
    constants: tuple[str, ...] = ()
    identity: Identity = field(default_factory=Identity)

    def __post_init__(self) -> None:
        for item in fields(self):
            if item.name in ("command", "identity"):  # one needs its quotes, the other has none
                continue
            value = getattr(self, item.name)
            clean = harmless(value) if isinstance(value, str) else tuple(map(harmless, value))
            object.__setattr__(self, item.name, clean)

    @property
    def parametric(self) -> bool:
        """Whether the parameters are arguments, not constants."""
        return not self.constants

    def of_source(self, text: str) -> Provenance:
        """Return the same with the digest of a C source."""
        return replace(self, identity=replace(self.identity, digest=digest(text)))
