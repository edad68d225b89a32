"""Build the library of a mechanism from its generated header: the same for the wheel and at first use.

Only the standard library is imported: the wheel is built where nothing else is installed.
"""

from __future__ import annotations

import hashlib
import os
import platform
import shutil
import subprocess
import tempfile
from collections.abc import Sequence
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path

HEADER = "lanes.h"
FOLDER = Path(__file__).parent
SOURCES = (
    "kernel.c",
    "dispatch.c",
    "eigen.h",
    "gradient.h",
    "lane.h",
    "request.h",
    "rows.h",
    "system.h",
    "tangent.h",
)
#: No contraction: every processor computes the same digits.  The loops over poses are vectors already, and the others
#: are too short to be made into vectors.
FLAGS = (
    "-std=gnu11",
    "-O3",
    "-fPIC",
    "-fvisibility=hidden",
    "-fno-math-errno",
    "-fno-trapping-math",
    "-ffp-contract=off",
    "-fno-tree-vectorize",
    "-fno-tree-slp-vectorize",
)
#: Lanes and what they need of the compiler; 2 is for every processor.
WIDTHS = {
    "x86_64": {
        8: ("-mavx512f", "-mavx512dq", "-mavx512vl", "-mprefer-vector-width=512"),
        4: ("-mavx2", "-mfma"),
        2: (),
    }
}
#: Seconds after which a compiler that says nothing is given up.
PATIENCE = 600


class BuildError(Exception):
    """The library cannot be built; the text says why."""


def machine() -> str:
    """Name of the processor's architecture."""
    return {"amd64": "x86_64", "arm64": "aarch64"}.get(platform.machine().lower(), platform.machine().lower())


def compiler() -> str | None:
    """Find a C compiler: that of the environment variable CC, or cc, gcc or clang.

    Returns
    -------
    str or None
        Its path.
    """
    own = os.environ.get("CC", "").strip()
    for name in [own] if own else ["cc", "gcc", "clang"]:
        path = shutil.which(name)
        if path:
            return path
    return None


def digest(header: str) -> str:
    """SHA-256 of all that a library is built from, except the compiler.

    Parameters
    ----------
    header : str
        Text of the generated header.
    """
    texts = [
        header,
        *((FOLDER / name).read_text(encoding="utf-8") for name in SOURCES),
        repr((FLAGS, WIDTHS)),
    ]
    sha = hashlib.sha256()
    for text in texts:
        sha.update(hashlib.sha256(text.replace("\r\n", "\n").encode("utf-8")).digest())
    return sha.hexdigest()


def build(header: str, target: Path, cc: str) -> None:
    """Compile and link a library, and put it in place whole or not at all.

    Parameters
    ----------
    header : str
        Text of the generated header.
    target : Path
        The library; its folder exists.
    cc : str
        The compiler.

    Raises
    ------
    BuildError
        If the compiler fails, with what it says.
    OSError
        If the library cannot be written.
    """
    with tempfile.TemporaryDirectory(prefix="pkmodes-") as name:
        folder = Path(name)
        (folder / HEADER).write_text(header, encoding="utf-8")
        for source in SOURCES:
            shutil.copyfile(FOLDER / source, folder / source)
        widths = WIDTHS.get(machine(), {2: ()})
        jobs = [
            [*FLAGS, *options, f"-DLANES_WIDTH={width}", f"-DLANES_RUN=pkmodes_run_{width}", "-c", "kernel.c"]
            + ["-o", f"kernel_{width}.o"]
            for width, options in widths.items()
        ]
        has = [f"-DPKMODES_HAS_{width}" for width in widths]
        digested = f'-DPKMODES_DIGEST="{digest(header)}"'
        jobs.append([*FLAGS, *has, digested, "-c", "dispatch.c", "-o", "dispatch.o"])
        with ThreadPoolExecutor(os.cpu_count()) as pool:
            list(pool.map(lambda job: _run([cc, *job], folder), jobs))
        objects = [job[-1] for job in jobs]
        _run([cc, "-shared", "-o", "library.so", *objects, "-lm"], folder)
        # Next to its place first: a library that is being written is never loaded.
        with tempfile.NamedTemporaryFile(dir=target.parent, prefix=".", suffix=".so", delete=False) as file:
            part = Path(file.name)
        try:
            shutil.copyfile(folder / "library.so", part)
            part.chmod(0o755)
            part.replace(target)
        except OSError:
            part.unlink(missing_ok=True)
            raise


def _run(command: Sequence[str], folder: Path) -> None:
    try:
        run = subprocess.run(
            command,
            cwd=folder,
            capture_output=True,
            text=True,
            errors="replace",
            timeout=PATIENCE,
            check=False,
        )
    except (OSError, subprocess.TimeoutExpired) as error:
        raise BuildError(f"{command[0]} cannot be run: {error}") from None
    if run.returncode:
        said = next((line for line in run.stderr.splitlines() if "error" in line), run.stderr.strip()[:300])
        raise BuildError(f"{command[0]} failed: {said}")
