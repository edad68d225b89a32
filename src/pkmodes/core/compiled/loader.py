"""Find the library of a mechanism: installed with `pkmodes`, built earlier, or built now.

A library is used only if it was built from exactly these sources and is still as it was built.  Libraries built at
first use are kept in a folder that only the user can write to; one process builds each while the others wait.
"""

from __future__ import annotations

import ctypes
import hashlib
import os
import stat
import subprocess
import sys
from collections.abc import Callable, Iterator, Sequence
from contextlib import contextmanager, suppress
from functools import cache
from importlib.resources import files
from pathlib import Path

from pkmodes.core.base.errors import shown
from pkmodes.core.compiled import build

#: Libraries installed with the package.
INSTALLED_LIBRARIES = Path(__file__).parent / "libraries"
#: Folder for libraries built at first use, instead of the user's cache.
CACHE_VARIABLE = "PKMODES_CACHE"
REQUEST_LAYOUT = 8
#: The function most recently added to the generated headers.
NEWEST_FUNCTION = "lanes_extended_statics("
COMPILER_REMEDY = "install a C compiler (gcc or clang), or name one in the environment variable CC"


class NoLibraryError(Exception):
    """No library is available."""

    def __init__(self, why: str, remedy: str) -> None:
        super().__init__(why, remedy)
        self.why, self.remedy = why, remedy


class Library:
    """A loaded library.

    - width: lanes in the widest vectors that this processor and the library have
    """

    def __init__(self, path: Path) -> None:
        self.path = path
        self._library = ctypes.CDLL(str(path))
        self.run = self._library.pkmodes_run
        self.run.argtypes, self.run.restype = [ctypes.c_void_p, ctypes.c_int], None
        self._library.pkmodes_digest.restype = ctypes.c_char_p
        self.width = int(self._library.pkmodes_width())

    @property
    def digest(self) -> str:
        """Digest of the sources it was built from."""
        return str(self._library.pkmodes_digest().decode("ascii"))

    def has(self, width: int) -> bool:
        """Return whether it has lanes of a width."""
        return bool(self._library.pkmodes_has(width))

    @property
    def is_widest(self) -> bool:
        """Whether it has the widest lanes that are built for this processor."""
        return self.has(build.widest_within(int(self._library.pkmodes_processor())))

    @property
    def layout(self) -> int:
        """Version of the layout of its requests."""
        return int(self._library.pkmodes_layout())


class Request(ctypes.Structure):
    """``struct pkmodes_request`` of request.h."""

    _fields_ = (
        ("count", ctypes.c_longlong),
        ("poses", ctypes.c_void_p),
        ("parameters", ctypes.c_void_p),
        ("effects", ctypes.c_void_p),
        ("largest_condition", ctypes.c_double),
        ("joints", ctypes.c_void_p),
        ("free", ctypes.c_void_p),
        ("massless", ctypes.c_void_p),
        ("free_count", ctypes.c_longlong),
        ("leading", ctypes.c_void_p),
        ("following", ctypes.c_void_p),
        ("fold_weights", ctypes.c_void_p),
        ("fold_count", ctypes.c_longlong),
        ("robots", ctypes.c_longlong),
        ("parameter_count", ctypes.c_longlong),
        ("effect_count", ctypes.c_longlong),
        ("joint_count", ctypes.c_longlong),
        ("path_count", ctypes.c_longlong),
        ("first_term", ctypes.c_void_p),
        ("places", ctypes.c_void_p),
        ("weights", ctypes.c_void_p),
        ("all_coordinates", ctypes.c_longlong),
        ("locked_joints", ctypes.c_longlong),
        ("term_count", ctypes.c_longlong),
        ("given_eigenvalues", ctypes.c_void_p),
        ("given_shapes", ctypes.c_void_p),
        ("modes", ctypes.c_longlong),
        ("rigid_modes", ctypes.c_longlong),
        ("frequencies", ctypes.c_void_p),
        ("eigenvalues", ctypes.c_void_p),
        ("shapes", ctypes.c_void_p),
        ("platform_shapes", ctypes.c_void_p),
        ("vibration_amplitudes", ctypes.c_void_p),
        ("joint_positions", ctypes.c_void_p),
        ("platform_motion", ctypes.c_void_p),
        ("platform_jacobian", ctypes.c_void_p),
        ("static_torque", ctypes.c_void_p),
        ("static_rotation", ctypes.c_void_p),
        ("elastic_stiffness", ctypes.c_void_p),
        ("mass_matrix", ctypes.c_void_p),
        ("stiffness_matrix", ctypes.c_void_p),
        ("eigenvalue_rates", ctypes.c_void_p),
        ("frequency_rates", ctypes.c_void_p),
        ("changes", ctypes.c_void_p),
        ("mode_rates", ctypes.c_void_p),
        ("norms", ctypes.c_void_p),
        ("motions", ctypes.c_void_p),
        ("mass_rates", ctypes.c_void_p),
        ("stiffness_rates", ctypes.c_void_p),
        ("mass_of_all", ctypes.c_void_p),
        ("stiffness_of_all", ctypes.c_void_p),
        ("codes", ctypes.c_void_p),
    )


@cache
def load(package: str, name: str) -> Library:
    """Load the library of a mechanism; build it where there is none yet.

    - package: Python package with the generated code of the mechanism

    Raises NoLibraryError if there is none and none can be built.
    """
    header_file = files(package).joinpath(build.HEADER)
    if not header_file.is_file():
        raise NoLibraryError(
            f"the generated code of {name} has no {build.HEADER}",
            "generate it again with this version of pkmodes",
        )
    header = header_file.read_text(encoding="utf-8")
    if NEWEST_FUNCTION not in header:
        raise NoLibraryError(
            f"the {build.HEADER} of {name} was generated by an earlier version of pkmodes",
            "generate it again with this version of pkmodes",
        )
    digest = build.digest(header)
    return _load_installed(name, digest) or _load_or_build(name, header, digest)


def load_existing(package: str, name: str) -> Library | None:
    """Load the library of a mechanism if there is one; nothing is built.

    - package, name: as of `load`
    """
    header, cc = files(package).joinpath(build.HEADER), build.compiler()
    if not header.is_file():
        return None
    digest = build.digest(header.read_text(encoding="utf-8"))
    library = _load_installed(name, digest)
    if library is not None or cc is None:
        return library
    with suppress(NoLibraryError, OSError):
        return _load_cached(cache_folder(), _stem(name, digest, cc), digest)
    return None


def _stem(name: str, digest: str, cc: Sequence[str]) -> str:
    """Return the beginning of the name of a library in the cache."""
    return f"{name}-{digest[:16]}-{_toolchain_digest(cc)}"


def _load_installed(name: str, digest: str) -> Library | None:
    """Return the library installed with the package, None if there is none for these sources and this machine."""
    with suppress(OSError):  # built for another system, or unreadable
        for path in _intact_libraries(INSTALLED_LIBRARIES, name):
            library = _load_file(path, digest)
            if library is not None:
                return library
    return None


def _load_or_build(name: str, header: str, digest: str) -> Library:
    """Return the library from the cache, after building it if necessary."""
    cc = build.compiler()
    if cc is None:
        raise NoLibraryError(*_no_compiler())
    folder = cache_folder()
    stem = _stem(name, digest, cc)
    try:
        library = _load_cached(folder, stem, digest)
        if library is None:
            _check_executable(folder)
            with _build_lock(folder / f".{stem}.lock"):
                library = _load_cached(folder, stem, digest)  # another process may have built it meanwhile
                if library is None:
                    # Intact ones are for other processors that share the folder.
                    damaged = [path for path in folder.glob(f"{stem}.*.so") if not build.is_intact(path)]
                    built = build.build(header, folder, stem, cc, build.processor_widths(cc))
                    for path in damaged:
                        if path != built:
                            path.unlink(missing_ok=True)
                    library = _load_cached(folder, stem, digest)
    except build.BuildError as error:
        raise NoLibraryError(f"the library of {name} cannot be built: {error}", COMPILER_REMEDY) from None
    except OSError as error:
        raise NoLibraryError(f"the library of {name} cannot be kept: {error}", _cache_remedy()) from None
    if library is None:
        raise NoLibraryError(
            f"the library that {cc[0]} has built cannot be used: {folder / stem}", COMPILER_REMEDY
        )
    return library


def _load_cached(folder: Path, stem: str, digest: str) -> Library | None:
    """Return the library that was built earlier, None if there is no intact one.

    Raises NoLibraryError if the system refuses to load it: building it again would not help.
    """
    for path in _intact_libraries(folder, stem, _check_private):
        try:
            library = _load_file(path, digest)
        except OSError as error:
            remedy = (
                f"{_cache_remedy()} from which programs can be run, or delete that file to build it again"
            )
            raise NoLibraryError(f"the compiled library cannot be loaded: {error}", remedy) from None
        if library is not None and library.is_widest:
            return library
    return None


def _intact_libraries(
    folder: Path, stem: str, check: Callable[[Path], None] = lambda _: None
) -> Iterator[Path]:
    """Yield the libraries of that name that are still as they were built."""
    for path in sorted(folder.glob(f"{stem}.*.so")):
        with suppress(FileNotFoundError):  # damaged, and just replaced by another process
            check(path)
            if build.is_intact(path):
                yield path


def _load_file(path: Path, digest: str) -> Library | None:
    """Load a file; return None if it was built from other sources."""
    try:
        library = Library(path)
        return library if (library.layout, library.digest) == (REQUEST_LAYOUT, digest) else None
    except AttributeError:
        return None


@contextmanager
def _build_lock(lock: Path) -> Iterator[None]:
    """Wait until no other process builds the same library; where files cannot be locked, do not wait."""
    from filelock import FileLock, Timeout

    file_lock = FileLock(lock, timeout=build.COMPILER_TIMEOUT)
    try:
        file_lock.acquire()
    except Timeout:
        problem = f"another process has been building the library for {build.COMPILER_TIMEOUT} s"
        raise NoLibraryError(problem, f"end that process, or delete {lock}") from None
    except (OSError, NotImplementedError):
        pass
    try:
        yield
    finally:
        file_lock.release()


def _check_executable(folder: Path) -> None:
    """Refuse a file system from which nothing can be loaded, before anything is compiled for it."""
    if hasattr(os, "statvfs") and os.statvfs(folder).f_flag & getattr(os, "ST_NOEXEC", 0):
        problem = f"libraries cannot be loaded from {folder}: its file system is mounted with noexec"
        raise NoLibraryError(problem, f"{_cache_remedy()} from which programs can be run")


def _no_compiler() -> tuple[str, str]:
    """Return why there is no compiler, and the remedy."""
    if sys.platform == "win32":
        return f"there is no compiled evaluator on Windows: {build.WINDOWS}", "let NumPy evaluate"
    problem, cc = "there is no compiled library, and no C compiler to build it with", os.environ.get("CC", "")
    if not cc.strip():
        return problem, COMPILER_REMEDY
    remedy = "let CC begin with the name or path of a compiler, or leave it out"
    return f"{problem}: the environment variable CC is {shown(cc)}", remedy


def cache_folder() -> Path:
    """Return the user's folder for libraries, created if necessary.

    Raises NoLibraryError if it cannot be made, or others can write to it.
    """
    configured = os.environ.get(CACHE_VARIABLE, "")
    home = os.environ.get("XDG_CACHE_HOME", "")
    try:
        folder = (
            Path(configured) if configured else (Path(home) if home else Path.home() / ".cache") / "pkmodes"
        )
        folder.mkdir(mode=0o700, parents=True, exist_ok=True)
        _check_private(folder)
    except (OSError, RuntimeError) as error:
        raise NoLibraryError(f"no folder for compiled libraries: {error}", _cache_remedy()) from None
    return folder


def _cache_remedy() -> str:
    return f"name a folder of your own in the environment variable {CACHE_VARIABLE}"


def _check_private(path: Path) -> None:
    """Refuse a path that other users can write to: code from it would be run.  Windows has no such modes."""
    if sys.platform == "win32":
        return
    status = path.stat()
    if status.st_uid != os.getuid():
        raise PermissionError(f"{path} belongs to another user")
    if status.st_mode & (stat.S_IWGRP | stat.S_IWOTH):
        raise PermissionError(f"others can write to {path}")


@cache
def _toolchain_digest(cc: Sequence[str]) -> str:
    """Return a short digest of a compiler, its version, the processor architecture and the C library."""
    try:
        version = subprocess.run([*cc, "--version"], capture_output=True, timeout=60, check=False).stdout
    except (OSError, subprocess.TimeoutExpired):
        version = b""
    try:
        system = os.confstr("CS_GNU_LIBC_VERSION")
    except (AttributeError, OSError, ValueError):  # another system
        system = ""
    identification = "\0".join((*cc, build.machine(), str(system), ""))
    return hashlib.sha256(identification.encode("utf-8", "surrogateescape") + version).hexdigest()[:8]
