"""``pkmodes --version``; with ``--verbose`` what a report of a problem should have."""

from __future__ import annotations

import importlib.metadata as metadata
import platform
import re
import subprocess
import sys
from collections.abc import Iterator

import click

from pkmodes.cli.printing import echo
from pkmodes.core.base.errors import PkmodesError
from pkmodes.core.base.version import VERSION
from pkmodes.core.compiled import build, loader
from pkmodes.core.mechanism import registry
from pkmodes.core.solve.backends import AUTO, choose_backend

#: Vectors of a library, by the processor's architecture and their length.
INSTRUCTIONS = {
    ("x86_64", 8): "AVX-512",
    ("x86_64", 4): "AVX2",
    ("x86_64", 2): "SSE2",
    ("aarch64", 2): "NEON",
}

#: Extras for development: no result of a user depends on them.
FOR_DEVELOPERS = ("test", "dev", "docs", "benchmark")


def print_version(ctx: click.Context, _: click.Parameter, requested: bool) -> None:
    """Print the version, with ``--verbose`` the rest, and end."""
    if not requested:
        if ctx.params.get("verbose") and not ctx.resilient_parsing:
            raise click.UsageError("--verbose belongs to --version", ctx)
        return
    echo(f"pkmodes {VERSION}")
    if ctx.params.get("verbose"):
        for name, text in facts():
            echo(f"{name}: {text}")
    ctx.exit()


def facts() -> Iterator[tuple[str, str]]:
    """Yield what the results and their speed may depend on: name and value."""
    yield "Python", f"{platform.python_version()} ({sys.executable})"
    yield "system", f"{platform.system()} {platform.release()}, {build.machine()}"
    yield from _libraries()
    try:
        name = choose_backend(AUTO)
        yield "back end", "compiled where there is a library, else numpy" if name == AUTO else name
    except PkmodesError as error:
        yield "back end", str(error)
    for name in registry.supplied_names():
        library = loader.load_existing(registry.mechanism(name).package, name)
        text = "no library; it is built at first use where there is a C compiler"
        if library is not None:
            instructions = INSTRUCTIONS.get((build.machine(), library.width), "")
            vectors = f" ({instructions})" if instructions else ""
            text = f"{library.width} poses at once{vectors}, {library.path}"
        yield f"compiled {name}", text
    cc = build.compiler()
    yield "C compiler", "none" if cc is None else f"{' '.join(cc)}{_version_of(cc)}"
    try:
        yield "compiled libraries are kept in", str(loader.cache_folder())
    except loader.NoLibraryError as error:
        yield "compiled libraries are kept in", error.why


def _libraries() -> Iterator[tuple[str, str]]:
    """Yield the versions of all libraries that pkmodes uses, those of its extras for users among them."""
    core, extras = dict[str, str](), dict[str, str]()
    for required in metadata.requires("pkmodes") or ():
        if any(f"'{extra}'" in required for extra in FOR_DEVELOPERS):
            continue
        name = re.split(r"[ ;<>=!~\[]", required, maxsplit=1)[0]
        if name != "pkmodes":
            try:
                version = metadata.version(name)
            except metadata.PackageNotFoundError:
                version = ""
            (extras if "extra ==" in required else core)[name] = version
    yield from ((name, version or "not installed") for name, version in core.items())
    present = [f"{name} {version}" for name, version in extras.items() if version and name not in core]
    yield "of the extras", ", ".join(present) or "none"


def _version_of(cc: tuple[str, ...]) -> str:
    """Return the first line of a compiler's version text."""
    try:
        output = subprocess.run(
            [*cc, "--version"], capture_output=True, timeout=60, check=False, text=True
        ).stdout
    except (OSError, subprocess.TimeoutExpired):
        return ""
    return f", {output.splitlines()[0]}" if output else ""
