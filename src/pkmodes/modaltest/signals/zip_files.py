"""Zip archives, whose directories are checked before they are read."""

from __future__ import annotations

import struct
import zipfile
from pathlib import Path

#: Maximum size of the central directory in bytes: an entry has 46 and its name, and takes ten times as much memory.
MAX_DIRECTORY_SIZE = 1_000_000
#: First bytes of the last record of an archive, and of that of an archive with more entries; their sizes, and the
#: longest comment after the first.
END_MARK, END_64_MARK = b"PK\x05\x06", b"PK\x06\x06"
END_SIZE, END_64_SIZE, MAX_COMMENT_SIZE = 22, 56 + 20, 1 << 16


def open_zip(path: Path) -> zipfile.ZipFile:
    """Open an archive.

    Raises zipfile.BadZipFile if it is no zip archive, or has very many files.
    """
    length = path.stat().st_size
    with path.open("rb") as file:
        file.seek(max(0, length - END_SIZE - MAX_COMMENT_SIZE - END_64_SIZE))
        tail = file.read()
    end_offset = tail.rfind(END_MARK)
    size = (
        struct.unpack_from("<I", tail, end_offset + 12)[0] if 0 <= end_offset <= len(tail) - END_SIZE else 0
    )
    end_64_offset = tail.rfind(END_64_MARK, 0, max(end_offset, 0))
    if 0 <= end_64_offset <= len(tail) - END_64_SIZE and size == 0xFFFFFFFF:
        size = struct.unpack_from("<Q", tail, end_64_offset + 40)[0]
    if MAX_DIRECTORY_SIZE < size <= length:  # a larger one is damage, which the reader reports
        raise zipfile.BadZipFile(f"expected an archive of a few files, found {size:,} bytes of their names")
    return zipfile.ZipFile(path)
