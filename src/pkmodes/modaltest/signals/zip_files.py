"""Zip archives, whose directories are checked before they are read."""

from __future__ import annotations

import struct
import zipfile
from pathlib import Path

#: Most bytes of the central directory: an entry has 46 and its name, and takes ten times as much memory.
LARGEST_DIRECTORY = 1_000_000
#: First bytes of the last record of an archive, and of that of an archive with more entries; their sizes, and the
#: longest comment after the first.
END, END_64 = b"PK\x05\x06", b"PK\x06\x06"
SIZE, SIZE_64, COMMENT = 22, 56 + 20, 1 << 16


def opened_zip(path: Path) -> zipfile.ZipFile:
    """Open an archive.

    Raises zipfile.BadZipFile if it is no zip archive, or has very many files.
    """
    length = path.stat().st_size
    with path.open("rb") as file:
        file.seek(max(0, length - SIZE - COMMENT - SIZE_64))
        tail = file.read()
    at = tail.rfind(END)
    size = struct.unpack_from("<I", tail, at + 12)[0] if 0 <= at <= len(tail) - SIZE else 0
    at_64 = tail.rfind(END_64, 0, max(at, 0))
    if 0 <= at_64 <= len(tail) - SIZE_64 and size == 0xFFFFFFFF:
        size = struct.unpack_from("<Q", tail, at_64 + 40)[0]
    if LARGEST_DIRECTORY < size <= length:  # a larger one is damage, which the reader reports
        raise zipfile.BadZipFile(f"expected an archive of a few files, found {size:,} bytes of their names")
    return zipfile.ZipFile(path)
