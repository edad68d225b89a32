"""``pkmodes --version --verbose``: what a report of a problem should have."""

from __future__ import annotations

import platform
import re

import numpy as np
import pytest
import scipy
import xarray

import pkmodes
from helpers.robots.robot_text import PUBLISHED
from pkmodes.cli import run
from pkmodes.core.mechanism import registry


@pytest.mark.parametrize("order", [("--version", "--verbose"), ("--verbose", "--version")])
def test_the_verbose_version_says_what_results_may_depend_on(
    order: tuple[str, str], capsys: pytest.CaptureFixture[str], monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setenv("PKMODES_BACKEND", "numpy")
    assert run(order) == 0
    first, *lines = capsys.readouterr().out.splitlines()
    assert first == f"pkmodes {pkmodes.__version__}"
    found = dict(line.split(": ", 1) for line in lines)
    assert found["Python"].startswith(f"{platform.python_version()} (")
    assert (found["numpy"], found["scipy"]) == (np.__version__, scipy.__version__)
    assert found["back end"] == "numpy"
    assert f"xarray {xarray.__version__}" in found["installed extras"]
    assert "pytest" not in found["installed extras"]
    for name in registry.supplied_names():
        assert re.match(r"[248] poses at once \(\S+\), \S+\.so$|no library; ", found[f"compiled {name}"])
    assert found["C compiler"]


def test_verbose_belongs_to_the_version(capsys: pytest.CaptureFixture[str]) -> None:
    assert run(["--verbose", "modes", str(PUBLISHED), "--pose", "0.6,0,-0.245"]) == 2
    assert capsys.readouterr().err == "error: --verbose belongs to --version (pkmodes); see pkmodes --help\n"


def test_a_wrong_back_end_is_said_with_the_version(
    capsys: pytest.CaptureFixture[str], monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setenv("PKMODES_BACKEND", "fortran")
    assert run(["--version", "--verbose"]) == 0
    assert "\nback end: expected " in capsys.readouterr().out
