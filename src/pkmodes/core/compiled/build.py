"""Build the library of a mechanism from its generated header: the same for the wheel and at first use.

Only the standard library is imported: the wheel is built where nothing else is installed.
"""

from __future__ import annotations

import hashlib
import os
import platform
import shlex
import shutil
import subprocess
import sys
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
    "processor.h",
    "request.h",
    "rows.h",
    "strain_free.h",
    "system.h",
    "tangent.h",
)
#: No contraction: every processor computes the same digits.  The loops over poses are vectors already, and the others
#: are too short to vectorise.  The next three passes take a fifth of GCC's time and gain nothing.
#: The parameter makes GCC allocate the registers of huge functions, such as the gradients of machines with six legs,
#: by its simpler method, which saves a quarter of its time at the same speed of the code.  Clang ignores all four.
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
    "-fno-gcse",
    "-fno-gcse-after-reload",
    "-fno-unswitch-loops",
    "--param=ira-max-conflict-table-size=10",
)
#: Compiler options by number of lanes; 2 is for every processor.
WIDTHS = {
    "x86_64": {
        8: ("-mavx512f", "-mavx512dq", "-mavx512vl", "-mprefer-vector-width=512"),
        4: ("-mavx2", "-mfma"),
        2: (),
    }
}
#: A program whose exit status is the largest number of lanes of its processor.
WIDEST_PROGRAM = '#include "processor.h"\nint main(void) { return processor_lanes(); }\n'
#: Why nothing is compiled on Windows: GCC's code would end the process at a misaligned vector.
WINDOWS = "GCC does not align vectors on the stack there (its bug 54412)"
#: Time after which a compiler is stopped [s].
COMPILER_TIMEOUT = 600


class BuildError(Exception):
    """The library cannot be built; the text says why."""


def machine() -> str:
    """Name of the processor's architecture: that of the platform for which Python is told to build, or this one."""
    target = os.environ.get("_PYTHON_HOST_PLATFORM", "").rpartition("-")[2]
    name = (target or platform.machine()).lower()
    return {"amd64": "x86_64", "arm64": "aarch64"}.get(name, name)


def compiler() -> tuple[str, ...] | None:
    """Find a C compiler: that of the environment variable CC, perhaps with options, or cc, gcc or clang.

    Returns the command: the path of the program, then its first arguments, such as those of ``CC="ccache gcc"``.
    None on Windows.
    """
    if sys.platform == "win32":
        return None
    command_line = os.environ.get("CC", "")
    try:
        words = shlex.split(command_line)
    except ValueError:  # an unbalanced quotation mark
        words = [command_line]
    for command in [words] if words else [["cc"], ["gcc"], ["clang"]]:
        path = shutil.which(command[0])
        if path:
            return (path, *command[1:])
    return None


def digest(header: str) -> str:
    """SHA-256 of all that a library is built from, except the compiler.

    - header: text of the generated header
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


def checksum(library: Path) -> str:
    """Digest of the bytes of a library: a file is intact if this is the digest in its name."""
    with library.open("rb") as file:
        return hashlib.file_digest(file, "sha256").hexdigest()[:32]


def is_intact(library: Path) -> bool:
    """Whether a library has the bytes that were built; the system ends a process that loads a truncated one."""
    return library.name.split(".")[-2] == checksum(library)


def processor_widths(cc: Sequence[str]) -> tuple[int, ...]:
    """Find the widths that this processor uses: its widest, and 2 for a single pose.

    - cc: the compiler, from `compiler`

    Returns some of `WIDTHS`; all those of this architecture where a program cannot be compiled or run.
    """
    all_widths = tuple(WIDTHS.get(machine(), {2: ()}))
    with tempfile.TemporaryDirectory(prefix="pkmodes-") as name:
        folder = Path(name)
        (folder / "widest.c").write_text(WIDEST_PROGRAM, encoding="utf-8")
        shutil.copyfile(FOLDER / "processor.h", folder / "processor.h")
        try:
            _run([*cc, "widest.c", "-o", "widest"], folder)
            widest = subprocess.run([folder / "widest"], timeout=COMPILER_TIMEOUT, check=False).returncode
        except (BuildError, OSError, subprocess.TimeoutExpired):
            return all_widths
    return tuple(sorted({widest_within(widest), 2}, reverse=True)) if widest > 1 else all_widths


def widest_within(lanes: int) -> int:
    """Return the widest of `WIDTHS` for this architecture that a processor with lanes has."""
    return max(width for width in WIDTHS.get(machine(), {2: ()}) if width <= lanes)


def build(
    header: str, folder: Path, stem: str, cc: Sequence[str], widths: Sequence[int] | None = None
) -> Path:
    """Compile and link a library, and put it in place completely or not at all.

    - header: text of the generated header
    - folder: where the library will be; it exists
    - stem: beginning of the library's name; the checksum of the library and ``.so`` follow
    - cc: the compiler, from `compiler`
    - widths: lanes that the library will have, 2 among them; by default all of `WIDTHS` for this architecture

    Raises BuildError if the compiler fails, with its message.
    Raises OSError if the library cannot be written.
    """
    with tempfile.TemporaryDirectory(prefix="pkmodes-") as name:
        build_folder = Path(name)
        (build_folder / HEADER).write_text(header, encoding="utf-8")
        for source in SOURCES:
            shutil.copyfile(FOLDER / source, build_folder / source)
        options_of = WIDTHS.get(machine(), {2: ()})
        built_widths = tuple(options_of) if widths is None else tuple(widths)
        jobs = [
            [
                *FLAGS,
                *options_of[width],
                f"-DLANES_WIDTH={width}",
                f"-DLANES_RUN=pkmodes_run_{width}",
                "-c",
                "kernel.c",
            ]
            + ["-o", f"kernel_{width}.o"]
            for width in built_widths
        ]
        width_flags = [f"-DPKMODES_HAS_{width}" for width in built_widths]
        digest_flag = f'-DPKMODES_DIGEST="{digest(header)}"'
        jobs.append([*FLAGS, *width_flags, digest_flag, "-c", "dispatch.c", "-o", "dispatch.o"])
        with ThreadPoolExecutor(os.cpu_count()) as pool:
            list(pool.map(lambda job: _run([*cc, *job], build_folder), jobs))
        objects = [job[-1] for job in jobs]
        _run([*cc, "-shared", "-o", "library.so", *objects, "-lm"], build_folder)
        library = folder / f"{stem}.{checksum(build_folder / 'library.so')}.so"
        # Next to its place first: a library that is being written is never loaded.
        with tempfile.NamedTemporaryFile(dir=folder, prefix=".", suffix=".part", delete=False) as file:
            temporary = Path(file.name)
        try:
            with temporary.open("wb") as destination, (build_folder / "library.so").open("rb") as source_file:
                shutil.copyfileobj(source_file, destination)
                destination.flush()
                os.fsync(destination.fileno())  # else its name may survive a power failure, but not its bytes
            temporary.chmod(0o755)
            temporary.replace(library)
        except OSError:
            temporary.unlink(missing_ok=True)
            raise
    return library


def _run(command: Sequence[str], folder: Path) -> None:
    try:
        run = subprocess.run(
            command,
            cwd=folder,
            capture_output=True,
            text=True,
            errors="replace",
            timeout=COMPILER_TIMEOUT,
            check=False,
        )
    except (OSError, subprocess.TimeoutExpired) as error:
        raise BuildError(f"{command[0]} cannot be run: {error}") from None
    if not run.returncode and not (folder / command[command.index("-o") + 1]).is_file():
        raise BuildError(f"{command[0]} reports success, but has built nothing")
    if run.returncode:
        message = next(
            (line for line in run.stderr.splitlines() if "error" in line), run.stderr.strip()[:300]
        )
        raise BuildError(f"{command[0]} failed: {message}")
