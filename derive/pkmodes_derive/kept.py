"""A cache of derived results, in the folder that the environment variable `FOLDER_VARIABLE` names.

A result is a function of the sources, the version of SymPy and its inputs, so a digest of these identifies it.
Results are stored as pickled Python objects, and loading those may run code: the folder must be the user's own.
Without the variable nothing is stored.
"""

from __future__ import annotations

import hashlib
import io
import os
import pickle
import sys
import tempfile
from collections.abc import Callable
from pathlib import Path
from typing import TypeVar

import sympy

from pkmodes_derive import sources

#: Environment variable with the folder.
FOLDER_VARIABLE = "PKMODES_DERIVED"

T = TypeVar("T")


def has_folder() -> bool:
    """Whether the environment names a folder."""
    return bool(os.environ.get(FOLDER_VARIABLE))


def derive_once(kind: str, inputs: object, derive: Callable[[], T]) -> T:
    """Return what `derive` returns, from the folder if it is stored there.

    Parameters
    ----------
    kind : str
        The kind of the result, part of the name of its file.
    inputs : object
        Everything that the result depends on besides the sources; its ``repr`` identifies it.
    """
    if not has_folder():
        return derive()
    versions = sympy.__version__, sys.version
    key = sources.digest(repr((kind, inputs, versions, sources.source_digests())))
    file = Path(os.environ[FOLDER_VARIABLE]) / f"{kind}-{key}.pickle"
    if file.exists():
        content = file.read_bytes()
    else:
        content = pickle.dumps(derive())
        file.parent.mkdir(parents=True, exist_ok=True)
        # Under a temporary name first: another process may look for the file meanwhile.
        with tempfile.NamedTemporaryFile(dir=file.parent, suffix=".part", delete=False) as part:
            part.write(content)
        Path(part.name).replace(file)
    # A new result is returned as later calls will load it.
    result: T = pickle.loads(content)
    return result


def digest_of(expressions: object) -> str:
    """Return a digest of objects that hold expressions, the same in every process."""
    content = io.BytesIO()
    pickler = pickle.Pickler(content)
    pickler.fast = True  # otherwise the bytes depend on which equal parts are one object, which is chance
    pickler.dump(expressions)
    return hashlib.sha256(content.getvalue()).hexdigest()
