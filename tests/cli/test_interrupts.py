"""Ctrl-C at any moment: one line, exit code 130, and no traceback, even while libraries are being loaded."""

from __future__ import annotations

import os
import signal
import subprocess
import sys
import time
from pathlib import Path

import click
import pytest

from helpers.robots.robot_text import PUBLISHED
from helpers.runs.processes import ROOT, environment, interruptible
from pkmodes.cli import run

MODES = ["modes", str(PUBLISHED), "--pose", "0.6,0,-0.245"]
CHECK = ["check", str(PUBLISHED)]
#: The two ways to start: the second is what an installed console script does.
STARTS = [["-m", "pkmodes"], ["-c", "import sys; from pkmodes.__main__ import main; sys.exit(main())"]]
#: Interrupts the process when it looks for a module, or reports that it does.
HOOK = """
import os, signal, sys

class Finder:
    def find_spec(self, name, path=None, target=None):
        if name == os.environ.get("INTERRUPT_AT"):
            os.kill(os.getpid(), signal.SIGINT)
        if name == os.environ.get("TELL_AT"):
            os.write(1, b"now\\n")

sys.meta_path.insert(0, Finder())
"""
#: Longer than any machine takes [s].
TIMEOUT = 600
pytestmark = pytest.mark.skipif(os.name != "posix", reason="sends POSIX signals")


def start(
    folder: Path, how: list[str], arguments: list[str], *, ignoring: bool = False, **variables: str
) -> subprocess.Popen[bytes]:
    (folder / "sitecustomize.py").write_text(HOOK, encoding="utf-8")
    return subprocess.Popen(
        [sys.executable, *how, *arguments],
        env=environment(folder, **variables),
        stdout=subprocess.PIPE,
        stderr=subprocess.PIPE,
        preexec_fn=None if ignoring else interruptible,
    )


def expect_one_line(process: subprocess.Popen[bytes]) -> None:
    _, err = process.communicate(timeout=TIMEOUT)
    assert err.decode() == "error: interrupted (pkmodes); run it again\n"
    assert process.returncode == 130


@pytest.mark.parametrize("how", STARTS, ids=["-m", "script"])
@pytest.mark.parametrize(
    "module",
    [
        "pkmodes.cli",
        "click",
        "numpy",
        "numpy.linalg",
        "pkmodes.core.model",
        "pkmodes.core.robot",
        "msgspec",
        "tomllib",
        "rich",
    ],
)
def test_an_interrupt_while_a_library_is_loaded(tmp_path: Path, how: list[str], module: str) -> None:
    expect_one_line(start(tmp_path, how, MODES, INTERRUPT_AT=module))


@pytest.mark.parametrize("script", [False, True], ids=["-m", "script"])
@pytest.mark.parametrize("module", ["lazy_loader", "pkmodes.core.base.version", "pkmodes.__main__"])
def test_an_interrupt_while_the_package_itself_is_loaded(tmp_path: Path, script: bool, module: str) -> None:
    """As early as anything of pkmodes runs; before that, only Python does."""
    (tmp_path / "pkmodes").write_text(STARTS[1][1], encoding="utf-8")
    how = [str(tmp_path / "pkmodes")] if script else STARTS[0]
    expect_one_line(start(tmp_path, how, MODES, INTERRUPT_AT=module))


#: Warns as libraries do, while a command runs.
WARNING = """
import sys

class Finder:
    def find_spec(self, name, path=None, target=None):
        if name == "pkmodes.core.compiled.evaluator":
            import logging, warnings
            warnings.warn("invalid value encountered in divide", RuntimeWarning)
            warnings.warn("this font has no such glyph", UserWarning)
            logging.getLogger("matplotlib.font_manager").warning("building the font cache")

sys.meta_path.insert(0, Finder())
"""


def test_warnings_of_libraries_are_not_shown_unless_asked_for(tmp_path: Path) -> None:
    (tmp_path / "sitecustomize.py").write_text(WARNING, encoding="utf-8")
    variables = environment(tmp_path)
    variables.pop("PYTHONWARNINGS", None)
    for options, said in (([], False), (["-W", "default"], True)):
        done = subprocess.run(
            [sys.executable, *options, "-m", "pkmodes", *MODES],
            env=variables,
            capture_output=True,
            check=True,
        )
        assert (b"invalid value" in done.stderr) == said
        assert (b"font cache" in done.stderr) == said
        assert bool(done.stderr) == said


def test_a_program_that_imports_the_package_keeps_its_interrupts() -> None:
    # Set first: a process that is started in the background inherits that interrupts are ignored.
    code = (
        "import signal; signal.signal(signal.SIGINT, signal.default_int_handler); import pkmodes;"
        "print(signal.getsignal(signal.SIGINT) is signal.default_int_handler)"
    )
    done = subprocess.run(
        [sys.executable, "-c", code], capture_output=True, text=True, check=True, cwd=ROOT / "src"
    )
    assert done.stdout == "True\n"


@pytest.mark.parametrize("module", ["msgspec", "jinja2", "sympy", "sympy.core", "pkmodes_derive.mechanisms"])
def test_an_interrupt_while_the_generator_is_loaded(tmp_path: Path, module: str) -> None:
    expect_one_line(start(tmp_path, STARTS[0], CHECK, INTERRUPT_AT=module))


@pytest.mark.parametrize("delay", [0.0, 0.02, 0.05, 0.1, 0.2, 0.4])
def test_an_interrupt_at_some_early_moment(tmp_path: Path, delay: float) -> None:
    """Counted from the import of the first module of the command line; before that, only Python runs."""
    process = start(tmp_path, STARTS[0], CHECK, TELL_AT="pkmodes.cli")
    assert process.stdout is not None
    assert process.stdout.readline() == b"now\n"
    time.sleep(delay)
    process.send_signal(signal.SIGINT)
    expect_one_line(process)


def test_an_interrupt_while_arguments_are_read(
    monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    def interrupted(*_: object, **__: object) -> None:
        raise KeyboardInterrupt

    monkeypatch.setattr(click.Group, "make_context", interrupted)
    assert run(MODES) == 130
    assert capsys.readouterr().err == "error: interrupted (pkmodes); run it again\n"


def test_an_ignored_interrupt_stays_ignored(tmp_path: Path) -> None:
    """As for a shell's background job."""
    before = signal.signal(signal.SIGINT, signal.SIG_IGN)
    try:
        process = start(tmp_path, STARTS[0], MODES, ignoring=True, INTERRUPT_AT="numpy")
    finally:
        signal.signal(signal.SIGINT, before)
    _, err = process.communicate(timeout=TIMEOUT)
    assert (process.returncode, err) == (0, b"")
