"""Generated C refuses flags under which the compiler assumes that there is no NaN: bad poses would pass as good."""

from __future__ import annotations

import subprocess
from pathlib import Path

import pytest

from helpers.generated.compiled import COMPILER
from helpers.generated.generated_robots import Robot
from pkmodes.core.compiled import build
from pkmodes_derive import mechanisms

pytestmark = pytest.mark.compiler

GENERATED = Path(__file__).parents[2] / "generated" / "pkmodes_generated"
SOURCES = sorted(GENERATED.glob("*/*.c"))
HEADERS = sorted(GENERATED.glob("*/lanes.h"))
REFUSED = (["-ffast-math"], ["-Ofast"], ["-O2", "-ffinite-math-only"])
ACCEPTED = (["-O3"], ["-ffast-math", "-fno-finite-math-only"])


def read(source: Path, flags: list[str]) -> str:
    """Return what the compiler says when it reads a file."""
    command = [str(COMPILER), *flags, "-E", "-o", "/dev/null", f"-I{source.parent}", "-x", "c", str(source)]
    return subprocess.run(command, capture_output=True, text=True, check=False).stderr


@pytest.mark.parametrize("source", [*SOURCES, *HEADERS], ids=lambda file: "/".join(file.parts[-2:]))
def test_every_generated_file_refuses_finite_math(source: Path) -> None:
    for flags in REFUSED:
        said = read(source, flags)
        assert "hide NaN" in said, flags
        assert "compile without them" in said
    for flags in ACCEPTED:
        assert not read(source, flags), flags


def test_all_of_them_are_found() -> None:
    assert len(SOURCES) == 2 * len(HEADERS) == 2 * len(mechanisms.names())


def test_a_robots_code_refuses_finite_math(robot: Robot) -> None:
    sources = [robot.out / name for name in robot.written if name.endswith(".c")]
    assert sources
    for source in sources:
        assert "hide NaN" in read(source, ["-ffast-math"])
        assert not read(source, ["-O2"])


def test_a_compiler_with_fast_math_is_told_apart_when_a_library_is_built(tmp_path: Path) -> None:
    fast = tmp_path / "fast-cc"
    fast.write_text(f'#!/bin/sh\nexec {COMPILER} -ffast-math "$@"\n', encoding="utf-8")
    fast.chmod(0o755)
    (header,) = (file for file in HEADERS if file.parent.name == "corexy")
    with pytest.raises(build.BuildError, match=r"-ffast-math, .* hide NaN") as caught:
        build.build(header.read_text(encoding="utf-8"), tmp_path, "library", (str(fast),))
    assert "compile without them" in str(caught.value)
    assert not list(tmp_path.glob("*.so"))
