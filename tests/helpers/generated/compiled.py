"""Compile generated C and call it with arrays, for the tests that hold it against NumPy."""

from __future__ import annotations

import ctypes
import os
import shutil
import subprocess
from collections.abc import Sequence
from math import prod
from pathlib import Path

import numpy as np

from pkmodes_derive.functions import Function

COMPILER = os.environ.get("CC") or shutil.which("cc") or shutil.which("gcc") or shutil.which("clang")
FLAGS = ["-std=c99", "-O2", "-Wall", "-Wextra", "-pedantic", "-Werror", "-shared", "-fPIC"]
Pointer = ctypes.POINTER(ctypes.c_double)


def build(folder: Path, name: str, texts: dict[str, str]) -> ctypes.CDLL:
    assert COMPILER is not None, "the tests of the generated C need a C compiler: install gcc or clang"
    for file, text in texts.items():
        (folder / file).write_text(text, encoding="utf-8")
    library = folder / f"{name}.so"
    subprocess.run([COMPILER, *FLAGS, str(folder / f"{name}.c"), "-o", str(library), "-lm"], check=True)
    return ctypes.CDLL(str(library))


def packed(parameters: tuple) -> np.ndarray:
    """A struct of parameters: doubles only, in the order of the fields, so without padding."""
    return np.concatenate([np.ravel(value) for value in parameters]).astype(float)


def call(
    library: ctypes.CDLL, prefix: str, function: Function, inputs: Sequence, groups: Sequence[tuple] = ()
) -> tuple[np.ndarray, ...]:
    """Call a generated function; `groups` are the structs of parameters that it takes."""
    arguments: list = []
    keep = []
    for argument, value in zip(function.arguments, inputs, strict=True):
        if argument.scalar:
            arguments.append(ctypes.c_double(value))
        else:
            keep.append(np.ascontiguousarray(value, dtype=float))
            arguments.append(keep[-1].ctypes.data_as(Pointer))
    for group in groups:
        keep.append(packed(group))
        arguments.append(keep[-1].ctypes.data_as(Pointer))
    # Poisoned, so that an entry that is not written is seen.
    outputs = [np.full(prod(o.shape), np.nan) for o in function.outputs]
    arguments += [o.ctypes.data_as(Pointer) for o in outputs]
    getattr(library, f"{prefix}_{function.name}")(*arguments)
    return tuple(o.reshape(d.shape) for o, d in zip(outputs, function.outputs, strict=True))
