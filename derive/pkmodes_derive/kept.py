"""What was derived before, where the environment variable `FOLDER_VARIABLE` names a folder for it.

Everything derived is a function of the sources, the version of SymPy and what it is derived from, so a digest of
these tells it apart.  It is kept as Python objects, and loading those may run code: the folder must be one's own.
Without the variable nothing is kept.
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

#: Names the folder.
FOLDER_VARIABLE = "PKMODES_DERIVED"

T = TypeVar("T")


def has_folder() -> bool:
    """Whether there is a folder."""
    return bool(os.environ.get(FOLDER_VARIABLE))


def derive_once(kind: str, inputs: object, derive: Callable[[], T]) -> T:
    """Return what `derive` returns, from the folder if it is there.

    Parameters
    ----------
    kind : str
        The kind of the result, part of the name of its file.
    inputs : object
        Everything that the result depends on beside the sources; its ``repr`` tells it apart.
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
        # Next to its place first: another process may look for it meanwhile.
        with tempfile.NamedTemporaryFile(dir=file.parent, suffix=".part", delete=False) as part:
            part.write(content)
        Path(part.name).replace(file)
    # What was derived just now is returned as it will be found.
    result: T = pickle.loads(content)
    return result


def digest_of(expressions: object) -> str:
    """Return a digest of objects that hold expressions, the same in every process."""
    content = io.BytesIO()
    pickler = pickle.Pickler(content)
    pickler.fast = True  # else which equal parts are one object would tell, and that is chance
    pickler.dump(expressions)
    return hashlib.sha256(content.getvalue()).hexdigest()
