"""The structure of universal files: datasets between delimiters, each read line by line or as a block of bytes.

A dataset is opened and closed by a line ``-1`` in the first six columns; its number is in the first six columns of
the line after the opening.  A ``b`` in column seven marks a binary dataset, which states its numbers of header lines
and of bytes (https://www.ceas3.uc.edu/sdrluff/files/58b.asc): there, a delimiter may be part of the data.

Numbers in text may touch: Fortran writes them into columns, without blanks between them.
"""

from __future__ import annotations

import re
import warnings
from collections.abc import Iterator
from dataclasses import dataclass
from typing import BinaryIO, NoReturn

import numpy as np

from pkmodes.core.base.errors import MeasurementError, shown
from pkmodes.modaltest.signals.functions import Array

DELIMITER = b"    -1"
#: Longest line of text, far above the 80 columns of the format: longer ones are binary data.
MAX_LINE_LENGTH = 4096
INCOMPLETE = "the file is damaged or incomplete: copy or export it again"
#: A number; Fortran leaves out the E of an exponent with three digits, and writes D for double precision.
NUMBER = re.compile(rb"[+-]?(?:\d+\.?\d*|\.\d+)(?:[EeDd][+-]?\d+|[+-]\d{3}(?![\d.]))?")
#: Bytes in numbers and between them.
NUMERALS = b"0123456789+-.eEdD \t\r\n"
#: Texts that programs write for a missing value.
NOT_A_NUMBER = re.compile(
    rb"[+-]?(?:nan(?:\(ind\))?|inf(?:inity)?|1\.#(?:qnan|snan|ind|inf)\d*)", re.IGNORECASE
)
NUMBER_OR_GAP = re.compile(rb"nan|" + NUMBER.pattern)
EXPONENT = re.compile(rb"(?<=[\d.])[Dd](?=[+-]?\d)|(?<=[\d.])(?=[+-]\d{3}$)")
#: Lines converted at once.
CHUNK_LINES = 20_000


@dataclass(frozen=True)
class BinaryLayout:
    """Declarations in the first line of a binary dataset: its byte order, header lines and bytes."""

    order: str
    lines: int
    bytes: int


@dataclass(frozen=True)
class Dataset:
    """The beginning of a dataset: its number, and the storage of its data."""

    number: int
    where: str
    binary: BinaryLayout | None


class Scanner:
    """A universal file that is read from its beginning to its end.

    - file: open for reading
    - size: size of the file [bytes]
    - source: the file, for messages
    """

    def __init__(self, file: BinaryIO, size: int, source: str) -> None:
        self.file, self.size, self.source = file, size, source
        self.where = source

    @property
    def remaining(self) -> int:
        """Number of bytes from the current position to the end."""
        return self.size - self.file.tell()

    def datasets(self) -> Iterator[Dataset]:
        """Yield each dataset at the first line after its number; its reader must leave the file after its end."""
        count = 0
        while (line := self._next_line()) is not None:
            if not line.strip():
                continue
            count += 1
            start = self.file.tell() - len(line)
            self.where = f"{self.source}: dataset {count} at byte {start}"
            if not is_delimiter(line):
                problem = f"expected a line -1 that opens a dataset, found {shown(decode_line(line).strip())}"
                self.refuse(problem)
            line = self.line("the number of a dataset")
            number, flag, rest = line[:6].strip(), line[6:7], line[7:]
            if not number.isdigit() or flag not in (b"", b" ", b"b", b"\r", b"\n"):
                self.refuse(f"expected the number of a dataset, found {shown(decode_line(line).strip())}")
            name = f"{count} ({number.decode()}{flag.decode().strip()})"
            self.where = f"{self.source}: dataset {name} at byte {start}"
            binary = None
            if flag == b"b":
                fields = rest.split()
                if len(fields) < 4 or not all(field.isdigit() for field in fields[:4]):
                    problem = (
                        "expected the byte order, the format and the numbers of lines and bytes after 58b"
                    )
                    self.refuse(f"{problem}, found {shown(decode_line(rest).strip())}")
                order, form, lines, size = map(int, fields[:4])
                if order not in (1, 2):
                    self.refuse(f"expected byte order 1 (little endian) or 2 (big endian), found {order}")
                if form != 2:
                    remedy = "export the file with IEEE numbers, or as text"
                    self.refuse(f"expected numbers of format 2 (IEEE 754), found format {form}", remedy)
                binary = BinaryLayout("<" if order == 1 else ">", lines, size)
            yield Dataset(int(number), self.where, binary)
        if count == 0:
            self.refuse("expected datasets, found none")

    def line(self, expected: str) -> bytes:
        """Return the next line with its line end.

        Raises MeasurementError if there is none.
        """
        line = self._next_line()
        if line is None:
            self.refuse(f"expected {expected}, found the end of the file")
        return line

    def skip_to_end(self) -> None:
        """Skip the lines of a dataset up to and including the one that closes it."""
        while not is_delimiter(self.line("a line -1 that closes the dataset")):
            pass

    def skip_binary(self, binary: BinaryLayout) -> None:
        """Skip a binary dataset up to and including the line that closes it."""
        for number in range(binary.lines):
            self.line(f"line {number + 1} of the header")
        self.skip_bytes(binary.bytes)
        self.close()

    def close(self) -> None:
        """Read the line that closes a dataset, which may follow binary data without a line end."""
        line = self.line("a line -1 that closes the dataset")
        if not line.strip():
            line = self.line("a line -1 that closes the dataset")
        if not is_delimiter(line):
            self.refuse(
                f"expected a line -1 after the declared data, found {shown(decode_line(line).strip())}"
            )

    def skip_bytes(self, count: int) -> int:
        """Skip a block of data; return where it begins."""
        self.check_remaining(count)
        start = self.file.tell()
        self.file.seek(count, 1)
        return start

    def check_remaining(self, count: int) -> None:
        """Refuse a dataset that declares more bytes than the file has."""
        if count > self.remaining:
            self.refuse(f"expected {count} bytes of data, found {self.remaining} to the end of the file")

    def refuse(self, what: str, remedy: str = INCOMPLETE) -> NoReturn:
        """Raise an error at the current dataset."""
        raise MeasurementError(what, self.where, remedy)

    def _next_line(self) -> bytes | None:
        line = self.file.readline(MAX_LINE_LENGTH)
        if len(line) == MAX_LINE_LENGTH:
            self.refuse("expected lines of text, found binary data")
        return line or None


def is_delimiter(line: bytes) -> bool:
    """Return whether a line opens or closes a dataset."""
    return line.startswith(DELIMITER) and line.rstrip() == DELIMITER


def decode_line(line: bytes) -> str:
    """Return a line as text: UTF-8, or Latin-1, which most old measuring systems write."""
    try:
        return line.decode("utf-8")
    except UnicodeDecodeError:
        return line.decode("latin-1")


def is_universal_file(head: bytes) -> bool:
    """Return whether a file begins with the opening of a dataset."""
    lines = head.lstrip(b"\r\n").splitlines()
    return len(lines) > 1 and is_delimiter(lines[0]) and lines[1][:6].strip().isdigit()


def parse_numbers(text: bytes) -> Array | None:
    """Return the numbers in a text, NaN for missing values; None if it contains anything else.

    - text: numbers, separated by blanks or in adjacent columns
    """
    has_missing = bool(text.translate(None, NUMERALS))
    if has_missing:
        text = NOT_A_NUMBER.sub(b" nan ", text)
        if text.replace(b" nan ", b"").translate(None, NUMERALS):
            return None
    if not text.strip():
        return np.empty(0)
    try:
        with warnings.catch_warnings():
            # NumPy before 2.3 raises this warning instead of an error.
            warnings.simplefilter("error", DeprecationWarning)
            return np.fromstring(text, sep=" ")
    except (ValueError, DeprecationWarning):
        pass
    if NUMBER.sub(b"", text.replace(b" nan ", b" ")).strip():
        return None
    numerals = NUMBER_OR_GAP.findall(text) if has_missing else NUMBER.findall(text)
    return np.array([float(EXPONENT.sub(b"E", number)) for number in numerals])


def read_numbers(scanner: Scanner, count: int) -> Array:
    """Read numbers, and the line that closes their dataset.

    - scanner: at the first line of the numbers
    - count: number that the dataset declares

    Returns (count,).
    Raises MeasurementError if there are more or fewer, or anything else is between them, or the dataset is not
    closed.
    """
    # Checked before allocating memory: a damaged header may declare any number.
    if 2 * count > scanner.remaining:
        scanner.refuse(f"expected {count} values, found {scanner.remaining} bytes to the end of the file")
    values, filled, closed = np.empty(count), 0, False
    while not closed:
        lines: list[bytes] = []
        while len(lines) < CHUNK_LINES and not closed:
            line = scanner.line("more values, or a line -1 that closes the dataset")
            closed = is_delimiter(line)
            if not closed:
                lines.append(line)
        numbers = parse_numbers(b"".join(lines))
        if numbers is None:
            bad_line = next((line for line in lines if parse_numbers(line) is None), lines[0])
            scanner.refuse(f"expected numbers, found {shown(decode_line(bad_line).strip())}")
        if filled + numbers.size > count:
            scanner.refuse(f"expected {count} values as declared, found more")
        values[filled : filled + numbers.size] = numbers
        filled += numbers.size
    if filled < count:
        scanner.refuse(f"expected {count} values as declared, found {filled}")
    return values
