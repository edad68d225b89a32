"""The registry of mechanisms: those that come with pkmodes, those that were added, and installed packages."""

from __future__ import annotations

import copyreg
from collections.abc import Iterator
from contextlib import contextmanager
from functools import cache
from importlib.resources import files
from os import PathLike

from pkmodes.core.base.errors import PkmodesError, nearest_name, shown
from pkmodes.core.mechanism.code_check import check_code
from pkmodes.core.mechanism.described import Mechanism, described_mechanism
from pkmodes.core.mechanism.packages import (
    MECHANISM_OPTION,
    effect_files,
    ensure_imported,
    folder_of,
    import_folder,
    installed_packages,
    package_location,
)
from pkmodes_description import FILE_NAME, DescriptionError

__all__ = ["Mechanism", "add", "add_folder", "mechanism", "names", "supplied_names", "temporarily_registered"]

#: The package of the generated models.
SUPPLIED_PACKAGE = "pkmodes_generated"
#: Packages of other mechanisms, by mechanism name: see `add`.
_package_by_name: dict[str, str] = {}


def names() -> tuple[str, ...]:
    """Return the names of all known mechanisms: supplied with pkmodes, added, or installed as a package.

    Returns
    -------
    tuple of str
        In alphabetical order.
    """
    return tuple(sorted({*supplied_names(), *_package_by_name, *installed_packages()}))


@cache
def supplied_names() -> tuple[str, ...]:
    """Return the names of the mechanisms that come with pkmodes."""
    return tuple(
        sorted(entry.name for entry in files(SUPPLIED_PACKAGE).iterdir() if (entry / FILE_NAME).is_file())
    )


def mechanism(name: str) -> Mechanism:
    """Return the mechanism with a given name.

    Parameters
    ----------
    name : str
        As in the robot file.

    Returns
    -------
    Mechanism
        Its description and its generated functions.

    Raises
    ------
    PkmodesError
        If there is none (the message suggests the nearest), or the package installed under that name cannot be read.
    """
    if name in _package_by_name:
        return _load(_package_by_name[name])
    if name in supplied_names():
        return _load(f"{SUPPLIED_PACKAGE}.{name}")
    if name in installed_packages():
        return _checked_mechanism(installed_packages()[name])
    remedy = nearest_name(
        name, names(), f"known: {', '.join(names())}; add one of your own with {MECHANISM_OPTION}"
    )
    raise PkmodesError(f"unknown mechanism {shown(name)}", "mechanism", remedy)


def add(package: str) -> Mechanism:
    """Register a mechanism whose description and functions were generated into a separate package.

    - package: import name of the package, which contains a ``description.json`` and a module ``extended``

    Raises PkmodesError if it cannot be imported, or has the name of a mechanism supplied with pkmodes.
    """
    new_mechanism = _load_or_explain(package)
    may_replace_supplied = package == f"{SUPPLIED_PACKAGE}.{new_mechanism.name}" or effect_files(
        package, new_mechanism.effects
    )
    if new_mechanism.name in supplied_names() and not may_replace_supplied:
        problem = f"{shown(new_mechanism.name)} is already the name of a mechanism supplied with pkmodes"
        raise PkmodesError(problem, package_location(package), "give your mechanism another name")
    _package_by_name[new_mechanism.name] = package
    return new_mechanism


def add_folder(path: str | PathLike[str]) -> Mechanism:
    """Register a mechanism that ``pkmodes generate --mechanism FILE.py ...`` wrote into a folder.

    Robot files can then name it.  If the name was added before, the present content of the folder replaces it; a
    supplied mechanism generated with your own effects (``--effect FILE.py``) replaces the supplied one.

    Parameters
    ----------
    path : path-like
        The folder of the mechanism, ``DIR/<mechanism>``.

    Returns
    -------
    Mechanism
        Its description and its generated functions.

    Raises
    ------
    PkmodesError
        If the folder is not one of these, its code cannot be imported or does not match its description, or it has
        the name of a mechanism supplied with pkmodes.
    """
    package = import_folder(path)
    _checked_mechanism(package)
    return add(package)


@contextmanager
def temporarily_registered(path: str | PathLike[str]) -> Iterator[Mechanism]:
    """Register the mechanism in a folder for the duration of the context."""
    previous = dict(_package_by_name)
    try:
        yield add_folder(path)
    finally:
        _package_by_name.clear()
        _package_by_name.update(previous)


def _unpickle(package: str, folder: str | None) -> Mechanism:
    """Restore a mechanism from another process and register it, as it was registered there."""
    if folder is not None:
        package = ensure_imported(package, folder)
    restored = _load(package)
    if restored.name not in names():
        _package_by_name[restored.name] = package
    return restored


copyreg.pickle(Mechanism, lambda instance: (_unpickle, (instance.package, folder_of(instance.package))))


@cache
def _load(package: str) -> Mechanism:
    return described_mechanism(package)


def _load_or_explain(package: str) -> Mechanism:
    remedy = "generate it again, or name the package that has its description.json"
    try:
        return _load(package)
    except DescriptionError as error:
        problem = f"cannot read the description of a mechanism: {error}"
        raise PkmodesError(problem, package_location(package), remedy) from None
    except (ImportError, OSError, ValueError, LookupError, TypeError) as error:
        problem = f"cannot read the description of a mechanism: {type(error).__name__}: {error}"
        raise PkmodesError(problem, package_location(package), remedy) from None


@cache
def _checked_mechanism(package: str) -> Mechanism:
    """Return the mechanism in a package after comparing its description with its code."""
    loaded = _load_or_explain(package)
    check_code(loaded)
    return loaded
