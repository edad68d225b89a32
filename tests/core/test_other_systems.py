"""What is not there on Windows is not needed: simulated, by hiding it from a process of its own."""

from __future__ import annotations

import os
import subprocess
import sys
from pathlib import Path

import pytest

ROOT = Path(__file__).parents[2]
#: Third-party modules are imported as they are here; those of pkmodes then again, without what Windows lacks.
CODE = """
import importlib, os, pkgutil, sys
import pkmodes

def modules():
    for found in pkgutil.walk_packages(pkmodes.__path__, "pkmodes."):
        if not found.name.endswith("__main__"):
            importlib.import_module(found.name)

modules()
for name in [name for name in sys.modules if name.partition(".")[0].startswith("pkmodes")]:
    del sys.modules[name]
for name in ("fcntl", "grp", "pwd", "resource", "termios", "tty", "posix"):
    sys.modules[name] = None
for name in ("chown", "confstr", "fork", "getuid", "killpg", "mkfifo", "sched_getaffinity", "statvfs", "uname"):
    delattr(os, name)
sys.platform = "win32"
import pkmodes
modules()

model = pkmodes.load(sys.argv[1])
from pkmodes.core.compiled import loader
loader._load_installed = lambda *_: None  # no wheel for Windows has libraries
print(model.modes([0.15, 0.2]).backend)
try:
    model.modes([0.15, 0.2], backend="compiled")
except pkmodes.PkmodesError as error:
    print(error)
print(loader.cache_folder())
"""


@pytest.mark.skipif(sys.platform == "win32", reason="this is Windows")
def test_every_module_can_be_imported_and_numpy_evaluates(tmp_path: Path) -> None:
    environment = {**os.environ, "PYTHONPATH": os.pathsep.join(sys.path), "PKMODES_CACHE": str(tmp_path)}
    environment.pop("PKMODES_BACKEND", None)
    tmp_path.chmod(0o777)  # as every folder seems to be there
    done = subprocess.run(
        [sys.executable, "-c", CODE, str(ROOT / "robots/corexy-printer.toml")],
        env=environment,
        capture_output=True,
        text=True,
        check=False,
    )
    assert done.returncode == 0, done.stderr[-2000:]
    backend, error, folder = done.stdout.splitlines()
    assert backend == "numpy"
    assert "no compiled evaluator on Windows" in error
    assert folder == str(tmp_path)
