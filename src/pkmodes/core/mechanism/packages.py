"""Generated code of user-defined mechanisms: imported from a folder, or from an installed package.

A folder is imported under a name derived from its path and content, so two folders of the same mechanism do not
collide, and another process finds the same one again.
"""

from __future__ import annotations

import hashlib
import json
import sys
from collections.abc import Iterable
from contextlib import suppress
from functools import cache
from importlib import import_module
from importlib.util import module_from_spec, spec_from_file_location
from os import PathLike
from pathlib import Path

from pkmodes.core.base.errors import PkmodesError

#: Entry points of this group name packages with generated code: ``five_bar = "my_robots.five_bar"``.
ENTRY_POINT_GROUP = "pkmodes.mechanisms"
MECHANISM_OPTION = "--mechanism"
PACKAGE_PREFIX = "pkmodes_folder_"
DEFINITION_FILE = "definition.py"
#: Prefix of the files in a mechanism's folder with effects that are not in the catalogue.
EFFECT_PREFIX = "effect_"
REQUIRED_FILES = ("__init__.py", "model.py", "extended.py", "drawing.py", "terms.py", "description.json")
FOLDER_REMEDY = (
    "give the folder DIR/<mechanism> written by: pkmodes generate --mechanism FILE.py ROBOT.toml --out DIR"
)

_folder_of_package: dict[str, str] = {}


@cache
def installed_packages() -> dict[str, str]:
    """Return the installed mechanism packages by mechanism name."""
    from importlib.metadata import entry_points  # slow, so imported only for a name that is otherwise unknown

    return {entry_point.name: entry_point.value for entry_point in entry_points(group=ENTRY_POINT_GROUP)}


def import_folder(path: str | PathLike[str]) -> str:
    """Import a generated folder and return the name of the package.

    Raises PkmodesError if the folder is not a generated one, or its code raises.
    """
    folder = Path(path)
    if not folder.is_dir():
        problem = "no such folder"
        if folder.is_file():
            problem = "expected the folder of a generated mechanism, found a file"
        raise PkmodesError(problem, str(folder), FOLDER_REMEDY)
    missing = [name for name in REQUIRED_FILES if not (folder / name).is_file()]
    if missing:
        problem, remedy = (
            f"expected the folder of a generated mechanism, but {missing[0]} is missing",
            FOLDER_REMEDY,
        )
        with suppress(OSError, ValueError, LookupError, TypeError, RecursionError):
            # A robot's model folder may contain the folder of its mechanism.
            name = json.loads((folder / "manifest.json").read_text(encoding="utf-8"))["mechanism"]
            if (folder / name / "description.json").is_file():
                remedy = f"give the mechanism folder inside it: {folder / name}"
        raise PkmodesError(problem, str(folder), remedy)
    content = b"\0".join((folder / name).read_bytes() for name in REQUIRED_FILES)
    folder = folder.resolve()
    package = (
        PACKAGE_PREFIX
        + hashlib.sha256(f"{folder}\0".encode("utf-8", "surrogateescape") + content).hexdigest()[:16]
    )
    if package not in sys.modules:
        _import(package, folder)
    return package


def ensure_imported(package: str, folder: str) -> str:
    """Import a folder that another process imported, unless this process has imported the package already."""
    return package if package in sys.modules else import_folder(folder)


def folder_of(package: str) -> str | None:
    """Return the folder from which this package was imported; None if it did not come from a folder."""
    return _folder_of_package.get(package)


def effect_files(package: str, effects: Iterable[str]) -> list[Path]:
    """Return the files, in a mechanism's folder, of its effects outside the catalogue."""
    folder = folder_of(package)
    files = [] if folder is None else [Path(folder) / f"{EFFECT_PREFIX}{name}.py" for name in effects]
    return [file for file in files if file.is_file()]


def package_location(package: str) -> str:
    """Return the location of a package, for messages."""
    return _folder_of_package.get(package, f"package {package}")


def _import(package: str, folder: Path) -> None:
    spec = spec_from_file_location(package, folder / "__init__.py", submodule_search_locations=[str(folder)])
    assert spec is not None  # the file exists and its name ends in .py
    assert spec.loader is not None
    module = sys.modules[package] = module_from_spec(spec)
    try:
        spec.loader.exec_module(module)
        extended = import_module(f"{package}.extended")
        import_module(f"{package}.drawing")
        import_module(f"{package}.terms")
        _ = module.Parameters, module.COORDINATES, extended.Effects, extended.COORDINATES
    except KeyboardInterrupt:
        raise
    except BaseException as error:  # SystemExit too: a file that ends the program is not a model
        for name in [name for name in sys.modules if name.startswith(package)]:
            del sys.modules[name]
        problem = f"the generated code cannot be imported: {type(error).__name__}: {error}"
        raise PkmodesError(problem, str(folder), "generate it again") from None
    _folder_of_package[package] = str(folder)
