"""The robot files and examples that come with pkmodes: ``robots/`` and ``examples/``, as in a checkout."""

from __future__ import annotations

import tomllib
from pathlib import Path
from typing import Any

from pkmodes.core.base.errors import PkmodesError

ROBOTS, EXAMPLES = "robots", "examples"
#: Where the build of a wheel (``hatch_build.py``) puts the two folders, and where they lie in a checkout.
ROOTS = (Path(__file__).parents[2] / "supplied", Path(__file__).parents[4])


def supplied(*names_requested: str) -> dict[str, bytes]:
    """Return the content of files that come with pkmodes by their names, such as ``robots/clavel-delta.toml``.

    - *names_requested: folders, or files in them

    Raises PkmodesError if pkmodes was installed without them.
    """
    root = next((root for root in ROOTS if (root / ROBOTS).is_dir()), None)
    if root is None:
        problem = "found no robot files and examples beside the installed program"
        raise PkmodesError(problem, str(ROOTS[0]), "install pkmodes again, from its wheel")
    paths = (file for place in names_requested for file in (root / place, *(root / place).rglob("*")))
    names = {file.relative_to(root): file for file in paths if file.is_file()}
    return {
        name.as_posix(): names[name].read_bytes()
        for name in sorted(names)
        if not any(part.startswith((".", "__")) for part in name.parts)  # files that programs leave there
    }


def robot_of(mechanism: str) -> dict[str, Any] | None:
    """Return the parsed robot file of a mechanism that comes with pkmodes, None where there is none.

    Of several, that with the shortest name: it is the plain one.
    """
    parsed = {name: tomllib.loads(content.decode()) for name, content in supplied(ROBOTS).items()}
    matching = [name for name, document in parsed.items() if document["mechanism"] == mechanism]
    return parsed[min(matching, key=len)] if matching else None
