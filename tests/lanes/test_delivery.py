"""Which back end runs, and what is said where there is none: environment, compiler, cache, libraries."""

from __future__ import annotations

import json
import os
import shlex
import subprocess
import sys
from collections.abc import Iterator
from pathlib import Path

import numpy as np
import pytest

import pkmodes
from pkmodes import PkmodesError
from pkmodes.compiled import build, loader
from pkmodes.solve import batch

pytestmark = pytest.mark.compiler

ROOT = Path(__file__).parents[2]
ROBOT = ROOT / "robots/corexy-printer.toml"
POSE = [0.15, 0.2]


@pytest.fixture
def fresh(monkeypatch: pytest.MonkeyPatch, tmp_path: Path) -> Iterator[Path]:
    """No library that was loaded, shipped or kept; the folder of the cache.  What is built here is built quickly."""
    monkeypatch.setattr(build, "FLAGS", ("-std=gnu11", "-O0", "-fPIC"))
    monkeypatch.setattr(build, "WIDTHS", {build.machine(): {2: ()}})
    cache = tmp_path / "cache"
    monkeypatch.setenv(loader.CACHE_VARIABLE, str(cache))
    monkeypatch.setattr(loader, "SHIPPED", tmp_path / "nothing")
    loader.load.cache_clear()
    yield cache
    loader.load.cache_clear()


def libraries(folder: Path) -> list[Path]:
    return sorted(folder.glob("*.so"))


def frequencies(backend: str = "auto") -> pkmodes.Modes:
    return pkmodes.load(ROBOT).modes(POSE, backend=backend, fields=["frequencies"])


def test_the_compiled_library_is_the_default(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.delenv("PKMODES_BACKEND", raising=False)
    assert frequencies().backend == "compiled"
    assert frequencies("numpy").backend == "numpy"
    np.testing.assert_allclose(
        frequencies("numpy").frequencies, frequencies().frequencies, rtol=1e-12, atol=1e-4
    )


def test_the_environment_decides_where_nothing_is_asked_for(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setenv("PKMODES_BACKEND", "numpy")
    assert frequencies().backend == "numpy"
    assert frequencies("compiled").backend == "compiled"
    monkeypatch.setenv("PKMODES_BACKEND", "fortran")
    with pytest.raises(PkmodesError, match=r'"numpy" or "compiled", found "fortran" .*PKMODES_BACKEND'):
        frequencies()


@pytest.mark.parametrize("backend", ["C", None, 3, ["numpy"]])
def test_an_unknown_back_end_is_refused(backend: str) -> None:
    with pytest.raises(PkmodesError, match=r'expected "auto", "numpy" or "compiled", found .* \(backend\)'):
        frequencies(backend)


@pytest.mark.parametrize("threads", [0, -1, 1.5, True, "2"])
def test_threads_are_a_positive_integer(threads: object) -> None:
    with pytest.raises(PkmodesError, match=r"expected a positive integer, found .* \(threads\)"):
        pkmodes.load(ROBOT).frequencies(POSE, threads=threads)


def test_without_compiler_and_library_numpy_does_the_work(
    fresh: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(build.shutil, "which", lambda name: None)
    assert frequencies().backend == "numpy"
    with pytest.raises(PkmodesError, match=r"no C compiler to build it with .*; install a C compiler"):
        frequencies("compiled")
    assert not libraries(fresh)


def test_without_a_library_numpy_compares_whatever_the_environment_asks_for(
    fresh: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    """A comparison chooses no back end: what cannot be had must not refuse the user's measurements."""
    robot, measured = (ROOT / "examples/closed_loop" / name for name in ("robot.toml", "measured.csv"))
    declared = pkmodes.read_robot(robot)
    monkeypatch.setenv("PKMODES_BACKEND", "numpy")
    expected = pkmodes.updating.compare(declared, pkmodes.updating.read(measured, robot=declared))
    monkeypatch.setattr(build.shutil, "which", lambda name: None)
    monkeypatch.setenv("PKMODES_BACKEND", "compiled")
    comparison = pkmodes.updating.compare(declared, pkmodes.updating.read(measured, robot=declared))
    assert comparison.chi2_per_dof == expected.chi2_per_dof


def test_a_compiler_that_fails_is_named(fresh: Path, monkeypatch: pytest.MonkeyPatch, tmp_path: Path) -> None:
    broken = tmp_path / "mycc"
    broken.write_text("#!/bin/sh\necho 'error: no such processor' >&2\nexit 1\n")
    broken.chmod(0o755)
    monkeypatch.setenv("CC", str(broken))
    assert frequencies().backend == "numpy"
    with pytest.raises(PkmodesError, match="mycc failed: error: no such processor"):
        frequencies("compiled")
    assert not libraries(fresh)


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

    def built(header: str, folder: Path, stem: str, cc: tuple[str, ...]) -> Path:
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
    monkeypatch.setattr(loader, "SHIPPED", shipped)
    loader.load.cache_clear()
    assert frequencies("compiled").backend == "compiled"
    assert not libraries(fresh), "that of the package is as good"
    content = (shipped / name).read_bytes()
    (shipped / name).unlink()
    (shipped / name).write_bytes(content[:5000])
    loader.load.cache_clear()
    assert frequencies("compiled").backend == "compiled"
    assert len(libraries(fresh)) == 1


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
        "import sys; from pathlib import Path; from pkmodes.compiled import build, loader; import pkmodes\n"
        "build.FLAGS = ('-std=gnu11', '-O0', '-fPIC'); build.WIDTHS = {build.machine(): {2: ()}}\n"
        "loader.SHIPPED = Path('nowhere')\n"
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


def test_a_library_from_other_sources_is_not_used(fresh: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    """A library that came with the package, and then the generated code changed."""
    shipped = fresh.parent / "shipped"
    shipped.mkdir()
    monkeypatch.setattr(loader, "SHIPPED", shipped)
    header = (ROOT / "generated/pkmodes_generated/corexy" / build.HEADER).read_text(encoding="utf-8")
    cc = build.compiler()
    assert cc is not None
    build.build(header + "/* before the change */\n", shipped, "corexy", cc)
    assert frequencies("compiled").backend == "compiled"
    assert len(libraries(fresh)) == 1  # built anew


def test_the_command_line_says_which_back_end_ran(tmp_path: Path) -> None:
    environment = {**os.environ, "PYTHONPATH": os.pathsep.join(sys.path)}
    for backend in ("numpy", "compiled"):
        command = [sys.executable, "-m", "pkmodes", "modes", str(ROBOT), "--pose", "0.15,0.2", "--json", "-"]
        found = subprocess.run(
            command,
            env={**environment, "PKMODES_BACKEND": backend},
            capture_output=True,
            text=True,
            check=True,
        )
        assert json.loads(found.stdout)["backend"] == backend


def test_out_is_filled_in_place_whatever_its_strides() -> None:
    model = pkmodes.load(ROBOT)
    poses = np.random.default_rng(1).uniform(0.01, 0.29, (40, 2))
    wide = np.full((40, 8), -1.0)
    model.modes(poses, out={"frequencies": wide[:, ::2]}, backend="compiled")
    np.testing.assert_array_equal(wide[:, ::2], model.frequencies(poses))
    assert (wide[:, 1::2] == -1.0).all()
    with pytest.raises(PkmodesError, match=r"expected an array of shape \(40, 4\) and type float64"):
        model.frequencies(poses, out=np.empty((40, 5)), backend="compiled")


def test_a_refused_batch_leaves_the_callers_array_alone() -> None:
    model = pkmodes.load(ROBOT)
    out = np.full((2, 4), -1.0)
    with pytest.raises(pkmodes.PoseError, match="pose 1 at"):
        model.frequencies([POSE, [9.0, 0.0]], out=out, backend="compiled")
    assert (out == -1.0).all()


@pytest.mark.parametrize("backend", ["compiled", "numpy"])
def test_a_joint_that_is_too_soft_leaves_the_callers_arrays_alone(backend: str) -> None:
    """NumPy refuses it, after the compiled evaluator; a pose out of reach is refused first."""
    plain = pkmodes.load(ROOT / "robots/linear-delta-2022.toml")
    model = plain.with_values({"effects.clamp_compliance.compliance": 100.0})
    poses = [[0.6, 0.05, -0.245]] * 2
    rates, frequencies = np.full((2, 1, 9), 7.0), np.full((2, 9), 7.0)
    with pytest.raises(pkmodes.PoseError, match="so soft"):
        model.sensitivities(poses, ["gravity.x"], out={"frequencies": rates}, backend=backend)
    with pytest.raises(pkmodes.PoseError, match="so soft"):
        model.frequencies(poses, out=frequencies, backend=backend)
    assert (rates == 7.0).all()
    assert (frequencies == 7.0).all()
    with pytest.raises(pkmodes.PoseError, match="pose 1 at"):
        model.frequencies([*poses[:1], [9.0, 9.0, 9.0]], backend=backend)


def test_poses_that_are_left_to_numpy_are_evaluated_in_parts(monkeypatch: pytest.MonkeyPatch) -> None:
    """The joint is too stiff for the compiled evaluator."""
    plain = pkmodes.load(ROOT / "robots/linear-delta-2022.toml")
    model = plain.with_values({"effects.gearbox_compliance.compliance": 1e-30})
    poses = np.array([0.6, 0.05, -0.245]) + np.linspace(0.0, 0.02, 7)[:, None]
    by_numpy = model.frequencies(poses, backend="numpy")
    monkeypatch.setattr(batch, "CHUNK", 3)
    np.testing.assert_array_equal(model.frequencies(poses, backend="compiled"), by_numpy)


def test_messages_are_those_of_numpy() -> None:
    model = pkmodes.load(ROBOT)
    for poses in ([9.0, 0.0], [[0.1, 0.1], [np.nan, 0.0]], [[0.1, 0.1], [0.1, -1.0], [7.0, 0.0]]):
        texts = []
        for backend in ("numpy", "compiled"):
            with pytest.raises(pkmodes.PoseError) as error:
                model.modes(poses, backend=backend)
            texts.append(str(error.value))
        assert texts[0] == texts[1]
