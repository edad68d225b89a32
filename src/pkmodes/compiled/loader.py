"""Find the library of a mechanism: installed with `pkmodes`, built earlier, or built now.

A library is used only if it was built from exactly these sources.  Libraries built at first use are kept in a folder
that only the user can write to.
"""

from __future__ import annotations

import ctypes
import hashlib
import os
import stat
import subprocess
from functools import cache
from importlib.resources import files
from pathlib import Path

from pkmodes.compiled import build

#: Libraries installed with the package.
SHIPPED = Path(__file__).parent / "libraries"
#: Folder for libraries built at first use, instead of the user's cache.
CACHE_VARIABLE = "PKMODES_CACHE"
LAYOUT = 4
INSTALL = "install a C compiler (gcc or clang), or name one in the environment variable CC"


class UnavailableError(Exception):
    """No library is available.

    Parameters
    ----------
    why, remedy : str
    """

    def __init__(self, why: str, remedy: str) -> None:
        super().__init__(why, remedy)
        self.why, self.remedy = why, remedy


class Library:
    """A loaded library.

    Attributes
    ----------
    width : int
        Lanes in the widest vectors of this processor.
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
        ("frequencies", ctypes.c_void_p),
        ("eigenvalues", ctypes.c_void_p),
        ("shapes", ctypes.c_void_p),
        ("platform_shapes", ctypes.c_void_p),
        ("joint_positions", ctypes.c_void_p),
        ("mass_matrix", ctypes.c_void_p),
        ("stiffness_matrix", ctypes.c_void_p),
        ("eigenvalue_rates", ctypes.c_void_p),
        ("frequency_rates", ctypes.c_void_p),
        ("changes", ctypes.c_void_p),
        ("mode_rates", ctypes.c_void_p),
        ("norms", ctypes.c_void_p),
        ("motions", ctypes.c_void_p),
        ("codes", ctypes.c_void_p),
    )


@cache
def load(package: str, name: str) -> Library:
    """Load the library of a mechanism; build it where there is none yet.

    Parameters
    ----------
    package : str
        Python package with the generated code of the mechanism.
    name : str
        Its name.

    Raises
    ------
    UnavailableError
        If there is none and none can be built.
    """
    header_file = files(package).joinpath(build.HEADER)
    if not header_file.is_file():
        raise UnavailableError(
            f"the generated code of {name} has no {build.HEADER}",
            "generate it again with this version of pkmodes",
        )
    header = header_file.read_text(encoding="utf-8")
    wanted = build.digest(header)
    shipped = SHIPPED / f"{name}.so"
    library = _loaded(shipped, wanted) if shipped.is_file() else None
    return library or _built(name, header, wanted)


def _built(name: str, header: str, wanted: str) -> Library:
    """Return the library from the cache, after building it if necessary."""
    cc = build.compiler()
    if cc is None:
        raise UnavailableError("there is no compiled library, and no C compiler to build it with", INSTALL)
    folder = _cache()
    path = folder / f"{name}-{wanted[:16]}-{_version(cc)}.so"
    try:
        library = None
        if path.is_file():
            _check_private(path)
            library = _loaded(path, wanted)  # None for a damaged file
        if library is None:
            build.build(header, path, cc)
            library = _loaded(path, wanted)
    except build.BuildError as error:
        raise UnavailableError(f"the library of {name} cannot be built: {error}", INSTALL) from None
    except OSError as error:
        raise UnavailableError(f"the library of {name} cannot be kept: {error}", _elsewhere()) from None
    if library is None:
        raise UnavailableError(f"the library that {cc} has built cannot be loaded: {path}", INSTALL)
    return library


def _loaded(path: Path, wanted: str) -> Library | None:
    """Load a file; return None if it was built from other sources or for another processor."""
    try:
        library = Library(path)
        return library if (library.layout, library.digest) == (LAYOUT, wanted) else None
    except (OSError, AttributeError):
        return None


def _cache() -> Path:
    """Return the user's folder for libraries, created if necessary.

    Raises
    ------
    UnavailableError
        If it cannot be made, or others can write to it.
    """
    own = os.environ.get(CACHE_VARIABLE, "")
    home = os.environ.get("XDG_CACHE_HOME", "")
    try:
        folder = Path(own) if own else (Path(home) if home else Path.home() / ".cache") / "pkmodes"
        folder.mkdir(mode=0o700, parents=True, exist_ok=True)
        _check_private(folder)
    except (OSError, RuntimeError) as error:
        raise UnavailableError(f"no folder for compiled libraries: {error}", _elsewhere()) from None
    return folder


def _elsewhere() -> str:
    return f"name a folder of your own in the environment variable {CACHE_VARIABLE}"


def _check_private(path: Path) -> None:
    """Refuse a path that other users can write to: code from it would be run."""
    status = path.stat()
    if hasattr(os, "getuid") and status.st_uid != os.getuid():
        raise PermissionError(f"{path} belongs to another user")
    if status.st_mode & (stat.S_IWGRP | stat.S_IWOTH):
        raise PermissionError(f"others can write to {path}")


@cache
def _version(cc: str) -> str:
    """Return a short digest of a compiler, its version and the processor architecture."""
    try:
        said = subprocess.run([cc, "--version"], capture_output=True, timeout=60, check=False).stdout
    except (OSError, subprocess.TimeoutExpired):
        said = b""
    return hashlib.sha256(f"{cc}\0{build.machine()}\0".encode() + said).hexdigest()[:8]
