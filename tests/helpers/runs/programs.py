"""Programs that some tests need beside Python and a C compiler."""

from __future__ import annotations

import os
import shutil
from typing import NoReturn

import pytest

#: Debian package of each program.
PACKAGES = {
    "gcc": "gcc",
    "clang": "clang",
    "aarch64-linux-gnu-gcc": "gcc-aarch64-linux-gnu",
    "qemu-aarch64": "qemu-user",
    "arm-none-eabi-gcc": "gcc-arm-none-eabi",
    "qemu-system-arm": "qemu-system-arm",
}


def needed(*programs: str) -> None:
    """Skip the test where a program is missing, but not where CI is set: there it fails."""
    for program in programs:
        if shutil.which(program) is None:
            absent(f"{program}: install the Debian package {PACKAGES[program]}")


def absent(what: str) -> NoReturn:
    """Skip the test for want of something, or fail in CI."""
    if os.environ.get("CI"):
        pytest.fail(f"needs {what}")
    pytest.skip(f"needs {what}")
