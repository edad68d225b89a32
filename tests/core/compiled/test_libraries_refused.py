"""Folders and libraries that are not used: of other people, without the right to run, refused by the system."""

from __future__ import annotations

import os
import subprocess
from pathlib import Path

import pytest

from helpers.generated.libraries import frequencies, libraries
from pkmodes import PkmodesError
from pkmodes.core.compiled import build, loader

pytestmark = pytest.mark.compiler


def test_what_the_system_refuses_to_load_is_not_compiled_again(
    fresh: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    frequencies("compiled")
    (kept,) = libraries(fresh)

    def refused(path: str) -> None:
        raise OSError(f"{path}: failed to map segment from shared object")

    monkeypatch.setattr(loader.ctypes, "CDLL", refused)
    monkeypatch.setattr(build, "build", lambda *_: pytest.fail("built again"))
    loader.load.cache_clear()
    assert frequencies().backend == "numpy"
    with pytest.raises(PkmodesError) as error:
        frequencies("compiled")
    assert f"the compiled library cannot be loaded: {kept}: failed to map segment" in error.value.what
    assert "install a C compiler" not in error.value.remedy
    assert "name a folder of your own in the environment variable PKMODES_CACHE" in error.value.remedy


def test_nothing_is_compiled_for_a_folder_from_which_nothing_can_be_loaded(
    fresh: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    fresh.mkdir(mode=0o700)
    mount = ["mount", "-t", "tmpfs", "-o", "noexec,mode=700", "none", str(fresh)]
    if subprocess.run(mount, capture_output=True).returncode:
        pytest.skip("a file system cannot be mounted here: needs the right to")
    try:
        monkeypatch.setattr(build, "build", lambda *_: pytest.fail("built"))
        with pytest.raises(
            PkmodesError, match=r"noexec .*; name a folder of your own .* from which programs"
        ):
            frequencies("compiled")
    finally:
        subprocess.run(["umount", str(fresh)], check=True)


@pytest.mark.parametrize("mode", [0o777, 0o770])
def test_a_folder_that_others_can_write_to_is_not_used(fresh: Path, mode: int) -> None:
    fresh.mkdir()
    fresh.chmod(mode)
    assert frequencies().backend == "numpy"
    with pytest.raises(
        PkmodesError, match=r"others can write to .*; name a folder of your own in .*PKMODES_CACHE"
    ):
        frequencies("compiled")


def test_a_library_that_others_can_write_to_is_not_loaded(fresh: Path) -> None:
    frequencies("compiled")
    (kept,) = libraries(fresh)
    kept.chmod(0o777)
    loader.load.cache_clear()
    with pytest.raises(PkmodesError, match="others can write to"):
        frequencies("compiled")


@pytest.mark.skipif(not hasattr(os, "getuid") or os.getuid() != 0, reason="only root can give files away")
def test_a_library_of_another_user_is_not_loaded(fresh: Path) -> None:
    frequencies("compiled")
    (kept,) = libraries(fresh)
    os.chown(kept, 12345, -1)
    loader.load.cache_clear()
    with pytest.raises(PkmodesError, match="belongs to another user"):
        frequencies("compiled")


def test_a_folder_that_cannot_be_made_is_said(fresh: Path) -> None:
    fresh.write_text("a file")
    assert frequencies().backend == "numpy"
    with pytest.raises(PkmodesError, match="no folder for compiled libraries"):
        frequencies("compiled")
