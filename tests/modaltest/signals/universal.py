"""Writes universal files byte by byte, by the letter of the format: nothing here uses the code under test."""

from __future__ import annotations

import struct
from collections.abc import Sequence

import numpy as np

END = b"    -1\n"


def header58(
    *,
    function: int = 1,
    response: tuple[int, int] = (12, 1),
    reference: tuple[int, int] = (0, 0),
    ordinate: int = 2,
    count: int = 4,
    spacing: int = 1,
    start: float = 0.0,
    step: float = 0.01,
    abscissa: tuple[int, str] = (17, "s"),
    quantity: tuple[int, str] = (12, "m/s^2"),
    denominator: tuple[int, str] = (0, "NONE"),
    ids: Sequence[str] = ("NONE", "NONE", "NONE", "NONE", "NONE"),
) -> bytes:
    lines = list(ids)
    lines.append(
        f"{function:5d}{1:10d}{0:5d}{0:10d} {'NONE':>10}{response[0]:10d}{response[1]:4d}"
        f" {'NONE':>10}{reference[0]:10d}{reference[1]:4d}"
    )
    lines.append(f"{ordinate:10d}{count:10d}{spacing:10d}{start:13.5E}{step:13.5E}{0.0:13.5E}")
    for data_type, label in (abscissa, quantity, denominator, (0, "NONE")):
        lines.append(f"{data_type:10d}{0:5d}{0:5d}{0:5d} {'NONE':20} {label:20}")
    return "".join(f"{line}\n" for line in lines).encode("utf-8")


def dataset(number: int, body: bytes) -> bytes:
    return END + f"{number:6d}\n".encode() + body + END


def dataset58(numbers: Sequence[float], **header: object) -> bytes:
    """A dataset of text, with the numbers in the order of the file, six in a line."""
    text = [f"{number:13.5E}" for number in numbers]
    lines = ["".join(text[i : i + 6]) + "\n" for i in range(0, len(text), 6)]
    return dataset(58, header58(**header) + "".join(lines).encode())  # type: ignore[arg-type]


def dataset58b(
    numbers: bytes,
    *,
    order: int = 1,
    close: bytes = b"\n    -1\n",
    size: int | None = None,
    form: int = 2,
    **header: object,
) -> bytes:
    """A binary dataset with these bytes as data."""
    declared = len(numbers) if size is None else size
    first = f"    58b{order:6d}{form:6d}{11:12d}{declared:12d}{0:6d}{0:6d}{0:12d}{0:12d}\n".encode()
    return END + first + header58(**header) + numbers + close  # type: ignore[arg-type]


def packed(numbers: Sequence[float], code: str, order: int = 1) -> bytes:
    return struct.pack(f"{'<' if order == 1 else '>'}{len(numbers)}{code}", *numbers)


def frf58(
    H: np.ndarray,
    step: float,
    *,
    response: tuple[int, int] = (1, 3),
    reference: tuple[int, int] = (1, 3),
    above: tuple[int, str] = (12, "NONE"),
    below: tuple[int, str] = (13, "NONE"),
    function: int = 4,
) -> bytes:
    """A dataset of a function of frequency with lines from 0 Hz, in double precision."""
    return dataset58b(
        np.asarray(H, complex).tobytes(),
        function=function,
        ordinate=6,
        count=len(H),
        step=step,
        response=response,
        reference=reference,
        abscissa=(18, "Hz"),
        quantity=above,
        denominator=below,
    )
