"""Where a report comes from: the input files by name and content, without their folders."""

from __future__ import annotations

import hashlib
from collections.abc import Sequence
from dataclasses import dataclass
from pathlib import Path

from pkmodes.core.base.errors import PkmodesError


@dataclass(frozen=True)
class Source:
    """An input file.

    Attributes
    ----------
    role : str
        What it is, such as "robot file".
    name : str
        Its name without the folder.
    digest : str
        SHA-256 of its bytes, in hexadecimal digits.
    """

    role: str
    name: str
    digest: str

    @classmethod
    def of(cls, role: str, path: Path) -> Source:
        """Read a file.

        Parameters
        ----------
        role : str
            What it is, such as "robot file".
        path : Path
            Where it is.

        Returns
        -------
        Source
            With its name and the digest of its content.

        Raises
        ------
        PkmodesError
            If it cannot be read.
        """
        try:
            with path.open("rb") as file:  # in blocks: signals may be gigabytes
                digest = hashlib.file_digest(file, "sha256").hexdigest()
        except OSError as error:
            problem = f"cannot read the {role}: {(error.strerror or str(error)).lower()}"
            raise PkmodesError(problem, str(path), "check the place") from None
        return cls(role, path.name, digest)


def known_sources(roles: Sequence[tuple[str, str]]) -> tuple[Source, ...]:
    """Return the sources for those places that are files; the others are objects from a script.

    - roles: roles and places
    """
    sources = []
    for role, path in roles:
        try:
            is_file = Path(path).is_file()
        except (OSError, ValueError):  # a name that no file can have
            continue
        if is_file:
            sources.append(Source.of(role, Path(path)))
    return tuple(sources)
