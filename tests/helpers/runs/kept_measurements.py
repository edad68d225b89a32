"""What the rig measured, kept in tests/rig_measurements: it computes for seconds what a test compares at once.

A measurement depends on what is measured, the sources of the rig and the version of MuJoCo: a digest of these is kept
with it.  Where the digest is another one, the rig measures again; ``--update-golden`` keeps what it then found.
"""

from __future__ import annotations

import ast
import hashlib
import json
from collections.abc import Callable, Iterator
from pathlib import Path
from typing import Any

import mujoco
import numpy as np
import pytest

TESTS = Path(__file__).parents[2]
FOLDER = TESTS / "rig"


class KeptMeasurements:
    """A file of measurements, by name.

    Parameters
    ----------
    name : str
        Of the file.
    source : str
        The module of the rig that measures, such as ``pkmodes_rig.moves``: a change of it, or of what it imports of
        the rig, makes what is kept invalid.
    """

    def __init__(self, name: str, source: str, config: pytest.Config) -> None:
        self._file, self._update = FOLDER / f"{name}.json", config.getoption("update_golden")
        files = sorted(_sources(source))
        texts = {path.relative_to(TESTS).as_posix(): path.read_text(encoding="utf-8") for path in files}
        self._rig = [mujoco.__version__, texts]
        self._kept = json.loads(self._file.read_text(encoding="utf-8")) if self._file.exists() else {}

    def value(self, name: str, of: object, measure: Callable[[], Any]) -> Any:
        """Return what `measure` returns, numbers or text, which depends on `of`."""
        given = json.dumps([self._rig, of], default=lambda one: np.asarray(one).tolist())
        digest = hashlib.sha256(given.encode()).hexdigest()[:16]
        one = self._kept.get(name)
        if one is None or one["digest"] != digest:
            one = self._kept[name] = {"digest": digest, "value": measure()}
            if self._update:
                lines = (f"{json.dumps(key)}: {json.dumps(self._kept[key])}" for key in sorted(self._kept))
                FOLDER.mkdir(exist_ok=True)
                self._file.write_text("{\n" + ",\n".join(lines) + "\n}\n", encoding="utf-8")
        return one["value"]


def _sources(module: str) -> Iterator[Path]:
    """Yield the file of a module of the rig, and of those that it imports."""
    waiting, seen = [module], set()
    while waiting:
        name = waiting.pop()
        place = TESTS.joinpath(*name.split("."))
        path = next((one for one in (place.with_suffix(".py"), place / "__init__.py") if one.is_file()), None)
        if name in seen or path is None:
            continue
        seen.add(name)
        yield path
        for node in ast.walk(ast.parse(path.read_text(encoding="utf-8"))):
            if isinstance(node, ast.ImportFrom) and node.module:
                waiting += [node.module, *(f"{node.module}.{one.name}" for one in node.names)]
