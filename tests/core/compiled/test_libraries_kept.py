"""Libraries of the user and of the package: built once, kept, built again when damaged or from other sources."""

from __future__ import annotations

import os
import subprocess
import sys
from pathlib import Path

import pytest

from helpers.generated.libraries import POSE, ROBOT, ROOT, frequencies, libraries
from pkmodes.core.compiled import build, loader

pytestmark = pytest.mark.compiler
ALL_WIDTHS = build.WIDTHS


def test_a_library_is_built_once_and_kept(fresh: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    assert frequencies("compiled").backend == "compiled"
    (kept,) = libraries(fresh)
    assert fresh.stat().st_mode & 0o077 == 0
    loader.load.cache_clear()
    monkeypatch.setattr(build, "build", lambda *_: pytest.fail("built again"))
    assert frequencies("compiled").backend == "compiled"
    loader.load.cache_clear()
    # From other sources it is another library.
    monkeypatch.setattr(build, "digest", lambda header: "0" * 64)
    with pytest.raises(pytest.fail.Exception, match="built again"):
        frequencies("compiled")
    assert kept.is_file()


def test_a_damaged_library_is_built_again_and_never_loaded(
    fresh: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    """The system ends a process that loads a truncated library, with a signal: it must not be tried."""
    frequencies("compiled")
    (kept,) = libraries(fresh)
    content = kept.read_bytes()
    real, loaded = loader.Library, []

    def library(path: Path) -> loader.Library:
        loaded.append(path.read_bytes())
        return real(path)

    def built(*_: object) -> Path:
        kept.write_bytes(content)
        return kept

    monkeypatch.setattr(loader, "Library", library)
    monkeypatch.setattr(build, "build", built)
    middle = len(content) // 2
    flipped = content[:middle] + bytes([content[middle] ^ 1]) + content[middle + 1 :]
    for damaged in (
        b"",
        content[:1000],
        content[:middle],
        content[:-1],
        content + b"x",
        flipped,
        b"not a library",
    ):
        kept.unlink()  # this process has it in memory still
        kept.write_bytes(damaged)
        loader.load.cache_clear()
        assert frequencies("compiled").backend == "compiled"
    assert set(loaded) == {content}


def test_a_damaged_library_of_the_package_is_built_again(
    fresh: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    frequencies("compiled")
    (kept,) = libraries(fresh)
    shipped = fresh.parent / "shipped"
    shipped.mkdir()
    name = f"corexy.{kept.name.split('.')[-2]}.so"
    (shipped / name).write_bytes(kept.read_bytes())
    kept.unlink()
    monkeypatch.setattr(loader, "INSTALLED_LIBRARIES", shipped)
    loader.load.cache_clear()
    assert frequencies("compiled").backend == "compiled"
    assert not libraries(fresh), "that of the package is as good"
    content = (shipped / name).read_bytes()
    (shipped / name).unlink()
    (shipped / name).write_bytes(content[:5000])
    loader.load.cache_clear()
    assert frequencies("compiled").backend == "compiled"
    assert len(libraries(fresh)) == 1


def test_a_library_for_a_lesser_processor_is_not_used_and_stays(
    fresh: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    """Machines may share a folder: each has a library with its own widest lanes."""
    monkeypatch.setattr(build, "WIDTHS", ALL_WIDTHS)
    frequencies("compiled")
    (kept,) = libraries(fresh)
    if loader.Library(kept).width == 2:
        pytest.skip("this processor is the least")
    cc = build.compiler()
    assert cc is not None
    assert build.processor_widths(cc) == (loader.Library(kept).width, 2)
    kept.unlink()
    header = (ROOT / "generated/pkmodes_generated/corexy/lanes.h").read_text(encoding="utf-8")
    lesser = build.build(header, fresh, kept.name.split(".")[0], cc, [2])
    assert not loader.Library(lesser).is_widest
    loader.load.cache_clear()
    assert frequencies("compiled").backend == "compiled"
    assert len(libraries(fresh)) == 2
    loader.load.cache_clear()
    assert loader.load("pkmodes_generated.corexy", "corexy").is_widest


def test_all_lanes_are_built_where_the_processor_cannot_be_asked(tmp_path: Path) -> None:
    says_nothing = tmp_path / "cc"
    says_nothing.write_text("#!/bin/sh\nexit 1\n", encoding="utf-8")
    says_nothing.chmod(0o755)
    assert build.processor_widths([str(says_nothing)]) == tuple(build.WIDTHS.get(build.machine(), {2: ()}))


def test_a_library_reaches_the_disk_before_it_has_its_name(
    fresh: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    """After a power failure the name may be there and the bytes not."""
    synced, real = [], os.fsync

    def fsync(descriptor: int) -> None:
        assert not libraries(fresh)
        synced.append(os.fstat(descriptor).st_size)
        real(descriptor)

    monkeypatch.setattr(os, "fsync", fsync)
    frequencies("compiled")
    (kept,) = libraries(fresh)
    assert kept.stat().st_size in synced


def test_processes_that_need_a_library_at_once_build_it_once(fresh: Path, tmp_path: Path) -> None:
    """The others wait for the first one; each compiler that runs leaves a line."""
    real, called = build.compiler(), tmp_path / "called"
    assert real is not None
    counting = tmp_path / "counting"
    counting.write_text(
        f'#!/bin/sh\ncase "$*" in *-shared*) echo x >> {called};; esac\nexec {real[0]} "$@"\n'
    )
    counting.chmod(0o755)
    program = (
        "import sys; from pathlib import Path; from pkmodes.core.compiled import build, loader; import pkmodes\n"
        "build.FLAGS = ('-std=gnu11', '-O0', '-fPIC'); build.WIDTHS = {build.machine(): {2: ()}}\n"
        "loader.INSTALLED_LIBRARIES = Path('nowhere')\n"
        f"print(pkmodes.load({str(ROBOT)!r}).modes({POSE}, backend='compiled').backend)"
    )
    environment = {**os.environ, "PYTHONPATH": os.pathsep.join(sys.path), "CC": str(counting)}
    command = [sys.executable, "-c", program]
    at_once = [
        subprocess.Popen(command, env=environment, stdout=subprocess.PIPE, text=True) for _ in range(4)
    ]
    assert [process.communicate(timeout=600)[0] for process in at_once] == ["compiled\n"] * 4
    assert called.read_text() == "x\n"
    assert len(libraries(fresh)) == 1


def test_a_file_system_without_locks_has_libraries_all_the_same(
    fresh: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    def no_locks(*_: object, **__: object) -> None:
        raise OSError(38, "Function not implemented")

    monkeypatch.setattr("filelock.FileLock.acquire", no_locks)
    assert frequencies("compiled").backend == "compiled"


def test_a_library_from_other_sources_is_not_used(fresh: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    """A library that came with the package, and then the generated code changed."""
    shipped = fresh.parent / "shipped"
    shipped.mkdir()
    monkeypatch.setattr(loader, "INSTALLED_LIBRARIES", shipped)
    header = (ROOT / "generated/pkmodes_generated/corexy" / build.HEADER).read_text(encoding="utf-8")
    cc = build.compiler()
    assert cc is not None
    build.build(header + "/* before the change */\n", shipped, "corexy", cc)
    assert frequencies("compiled").backend == "compiled"
    assert len(libraries(fresh)) == 1  # built anew


def test_two_builds_have_the_same_bytes(fresh: Path, tmp_path: Path) -> None:
    """Of a wheel, too, whose libraries are built in the same way: neither paths nor times are in them."""
    header = (ROOT / "generated/pkmodes_generated/corexy" / build.HEADER).read_text(encoding="utf-8")
    cc = build.compiler()
    assert cc is not None
    folders = [tmp_path / name for name in ("one", "another one")]
    for folder in folders:
        folder.mkdir()
        build.build(header, folder, "corexy", cc)
    (one,), (other,) = map(libraries, folders)
    assert (one.name, one.read_bytes()) == (other.name, other.read_bytes())
