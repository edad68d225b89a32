"""The files in a tar archive, one after the other.

The reader in Python's library loads long names and attributes into memory, whatever their stated size, and keeps
every header: a small compressed archive may have gigabytes of both.
"""

from __future__ import annotations

import bz2
import gzip
import tarfile
from collections.abc import Callable, Iterator
from functools import partial
from pathlib import Path
from typing import Any, NamedTuple

#: Bytes of a header, and maximum size of a name or of attributes.
BLOCK_SIZE, MAX_NAME_SIZE = 512, 1 << 16
#: Bytes unpacked at once; maximum number of bytes in all that are not in files; and of headers.
PART_SIZE, MAX_OTHER_BYTES, MAX_HEADERS = 1 << 16, 1 << 26, 100_000
#: First bytes of compressed archives, and the functions that open them.
COMPRESSED: dict[bytes, Callable[..., Any]] = {b"\x1f\x8b": gzip.open, b"BZh": bz2.open}
NAME_TYPES, ATTRIBUTE_TYPES = (tarfile.GNUTYPE_LONGNAME,), (tarfile.XHDTYPE, tarfile.SOLARIS_XHDTYPE)
#: Headers that state nothing about the name of the next file.
IGNORED_TYPES = (tarfile.GNUTYPE_LONGLINK, tarfile.XGLTYPE)
SPARSE = "expected whole files in it, found one with holes"


class TarEntry(NamedTuple):
    """A file in an archive: its name, its size, and a function that returns its bytes until the next file is read."""

    name: str
    size: int
    read: Callable[[int], bytes]


def tar_files(path: Path) -> Iterator[TarEntry]:
    """Yield the regular files of an archive.

    Raises tarfile.TarError, OSError, EOFError or zlib.error if it is damaged, or no archive.
    """
    with path.open("rb") as file:
        head = file.read(4)
    open_archive = next((opener for mark, opener in COMPRESSED.items() if head.startswith(mark)), open)
    with open_archive(path, "rb") as file:
        name, size, header_count, other_bytes = "", -1, 0, 0
        while block := file.read(BLOCK_SIZE):
            if block.count(0) == BLOCK_SIZE and header_count:
                return
            info, header_count = _parse_header(block), header_count + 1
            if info.type in (*NAME_TYPES, *ATTRIBUTE_TYPES):
                content = _read(file, info.size, MAX_NAME_SIZE)
                if info.type in NAME_TYPES:
                    name = _text(content.split(b"\0")[0])
                else:
                    name, size = _attributes(content, name)
                continue
            length = info.size if size < 0 else size
            if info.isreg():
                remaining = [length]  # bytes not read yet
                yield TarEntry(name or info.name, length, partial(_read_remaining, file, remaining))
                _skip(file, remaining[0] + -length % BLOCK_SIZE)
            elif info.type in IGNORED_TYPES or info.type not in tarfile.SUPPORTED_TYPES:
                other_bytes += length
                if other_bytes > MAX_OTHER_BYTES:
                    raise tarfile.ReadError(
                        f"expected files in it, found {other_bytes:,} bytes of something else"
                    )
                _skip(file, length + -length % BLOCK_SIZE)
            if header_count > MAX_HEADERS:
                raise tarfile.ReadError(f"expected at most {MAX_HEADERS:,} entries in it, found more")
            if info.type not in IGNORED_TYPES:
                name, size = "", -1


def _parse_header(block: bytes) -> tarfile.TarInfo:
    """Parse a header.

    Raises tarfile.ReadError if it is not a header.
    """
    try:
        info = tarfile.TarInfo.frombuf(block, "utf-8", "surrogateescape")
    except tarfile.TarError:
        raise tarfile.ReadError("expected the header of a file in it") from None
    if info.size < 0:
        raise tarfile.ReadError(f"expected the size of a file in it, found {info.size}")
    if info.type == tarfile.GNUTYPE_SPARSE:
        raise tarfile.ReadError(SPARSE)
    return info


def _attributes(content: bytes, name: str) -> tuple[str, int]:
    """Return the name and the size stated in attributes; `name` and -1 if they are not stated."""
    size, position = -1, 0
    while position < len(content) and content[position]:
        digits, _, _ = content[position : position + 8].partition(b" ")
        length = int(digits) if digits.isdigit() else 0
        key, equals, value = content[position + len(digits) + 1 : position + length - 1].partition(b"=")
        if not equals or position + length > len(content):
            raise tarfile.ReadError("expected the attributes of a file in it")
        if key.startswith(b"GNU.sparse"):
            raise tarfile.ReadError(SPARSE)
        if key == b"path":
            name = _text(value)
        if key == b"size":
            if not (value.isdigit() and len(value) < 20):
                raise tarfile.ReadError("expected the size of a file in its attributes")
            size = int(value)
        position += length
    return name, size


def _text(name: bytes) -> str:
    return name.decode("utf-8", "surrogateescape")


def _read(file: Any, size: int, limit: int) -> bytes:
    """Return the bytes after a header, and skip their padding."""
    if size > limit:
        raise tarfile.ReadError(f"expected names and attributes of at most {limit:,} bytes, found {size:,}")
    content: bytes = file.read(size)
    if len(content) < size:
        raise tarfile.ReadError("unexpected end of data")
    _skip(file, -size % BLOCK_SIZE)
    return content


def _read_remaining(file: Any, remaining: list[int], limit: int) -> bytes:
    """Return the next bytes of a file, and count down those remaining."""
    content: bytes = file.read(min(limit, remaining[0]))
    if len(content) < min(limit, remaining[0]):
        raise tarfile.ReadError("unexpected end of data")
    remaining[0] -= len(content)
    return content


def _skip(file: Any, count: int) -> None:
    """Skip bytes by reading them, as not every file can seek."""
    while count > 0:
        skipped = file.read(min(count, PART_SIZE))
        if not skipped:
            raise tarfile.ReadError("unexpected end of data")
        count -= len(skipped)
