"""The compiler that the environment names: with options, called by another program, absent, failing."""

from __future__ import annotations

import shlex
from pathlib import Path

import pytest

from helpers.generated.libraries import frequencies, libraries
from pkmodes import PkmodesError
from pkmodes.core.compiled import build

pytestmark = pytest.mark.compiler


def test_a_compiler_that_fails_is_named(fresh: Path, monkeypatch: pytest.MonkeyPatch, tmp_path: Path) -> None:
    broken = tmp_path / "mycc"
    broken.write_text("#!/bin/sh\necho 'error: no such processor' >&2\nexit 1\n")
    broken.chmod(0o755)
    monkeypatch.setenv("CC", str(broken))
    assert frequencies().backend == "numpy"
    with pytest.raises(PkmodesError, match="mycc failed: error: no such processor"):
        frequencies("compiled")
    assert not libraries(fresh)


def test_a_compiler_that_builds_nothing_is_named(
    fresh: Path, monkeypatch: pytest.MonkeyPatch, tmp_path: Path
) -> None:
    """As with ``CC=/bin/true``."""
    idle = tmp_path / "idle"
    idle.write_text("#!/bin/sh\nexit 0\n")
    idle.chmod(0o755)
    monkeypatch.setenv("CC", str(idle))
    assert frequencies().backend == "numpy"
    with pytest.raises(PkmodesError, match=r"cannot be built: .*idle reports success, but has built nothing"):
        frequencies("compiled")
    assert not libraries(fresh)


@pytest.mark.parametrize("options", ["-O1", "-g  -DNOTHING='a b'"])
def test_the_compiler_may_have_options(fresh: Path, monkeypatch: pytest.MonkeyPatch, options: str) -> None:
    found = build.compiler()
    assert found is not None
    monkeypatch.setenv("CC", f"{Path(found[0]).name} {options}")
    assert build.compiler() == (found[0], *shlex.split(options))
    assert frequencies("compiled").backend == "compiled"


def test_the_compiler_may_be_called_by_another_program(
    fresh: Path, monkeypatch: pytest.MonkeyPatch, tmp_path: Path
) -> None:
    """As by ccache."""
    found = build.compiler()
    assert found is not None
    caching = tmp_path / "my cache"
    caching.write_text('#!/bin/sh\nexec "$@"\n')
    caching.chmod(0o755)
    monkeypatch.setenv("CC", f'"{caching}" {found[0]}')
    assert frequencies("compiled").backend == "compiled"


@pytest.mark.parametrize("name", ["no-such-compiler -O1", "'gcc"])
def test_a_compiler_that_is_not_there_is_named(
    fresh: Path, monkeypatch: pytest.MonkeyPatch, name: str
) -> None:
    monkeypatch.setenv("CC", name)
    with pytest.raises(PkmodesError, match=f'the environment variable CC is "{name}".*; let CC begin with'):
        frequencies("compiled")


def test_options_with_which_no_nan_is_seen_are_refused(fresh: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    found = build.compiler()
    assert found is not None
    monkeypatch.setenv("CC", f"{found[0]} -ffast-math")
    with pytest.raises(PkmodesError, match="hide NaN, the mark of bad poses: compile without them"):
        frequencies("compiled")
