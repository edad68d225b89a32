"""``pkmodes --version``; with ``--verbose`` also the facts that a bug report should state."""

from __future__ import annotations

import importlib.metadata as metadata
import platform
import re
import subprocess
import sys
from collections.abc import Iterator
from contextlib import suppress

import click

from pkmodes.cli.printing import echo
from pkmodes.core.base.errors import PkmodesError
from pkmodes.core.base.version import VERSION
from pkmodes.core.compiled import build, loader
from pkmodes.core.mechanism import registry
from pkmodes.core.solve.backends import AUTO, choose_backend

#: Instruction sets of a compiled library, by the processor's architecture and the length of the vectors.
INSTRUCTION_SETS = {
    ("x86_64", 8): "AVX-512",
    ("x86_64", 4): "AVX2",
    ("x86_64", 2): "SSE2",
    ("aarch64", 2): "NEON",
}

#: Extras for development: no result of a user depends on them.
DEVELOPER_EXTRAS = ("test", "dev", "docs", "benchmark")


def print_version(ctx: click.Context, _: click.Parameter, requested: bool) -> None:
    """Print the version, with ``--verbose`` the rest, and end."""
    if not requested:
        if ctx.params.get("verbose") and not ctx.resilient_parsing:
            raise click.UsageError("--verbose belongs to --version", ctx)
        return
    echo(f"pkmodes {VERSION}")
    if ctx.params.get("verbose"):
        for name, text in version_facts():
            echo(f"{name}: {text}")
    ctx.exit()


def version_facts() -> Iterator[tuple[str, str]]:
    """Yield name and value of everything on which results and their speed may depend."""
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
            instructions = INSTRUCTION_SETS.get((build.machine(), library.width), "")
            vectors = f" ({instructions})" if instructions else ""
            text = f"{library.width} poses at once{vectors}, {library.path}"
        yield f"compiled {name}", text
    compiler = build.compiler()
    version_text = ""
    if compiler is not None:
        with suppress(OSError, subprocess.TimeoutExpired):
            version_text = subprocess.run(
                [*compiler, "--version"], capture_output=True, timeout=60, check=False, text=True
            ).stdout
    first_line = f", {version_text.splitlines()[0]}" if version_text else ""
    yield "C compiler", "none" if compiler is None else f"{' '.join(compiler)}{first_line}"
    try:
        yield "compiled libraries are kept in", str(loader.cache_folder())
    except loader.NoLibraryError as error:
        yield "compiled libraries are kept in", error.why


def _libraries() -> Iterator[tuple[str, str]]:
    """Yield the versions of all libraries that pkmodes uses, including those of its extras for users."""
    core, extras = dict[str, str](), dict[str, str]()
    for requirement in metadata.requires("pkmodes") or ():
        if any(f"'{extra}'" in requirement for extra in DEVELOPER_EXTRAS):
            continue
        name = re.split(r"[ ;<>=!~\[]", requirement, maxsplit=1)[0]
        if name != "pkmodes":
            try:
                version = metadata.version(name)
            except metadata.PackageNotFoundError:
                version = ""
            (extras if "extra ==" in requirement else core)[name] = version
    yield from ((name, version or "not installed") for name, version in core.items())
    installed_extras = [
        f"{name} {version}" for name, version in extras.items() if version and name not in core
    ]
    yield "installed extras", ", ".join(installed_extras) or "none"
