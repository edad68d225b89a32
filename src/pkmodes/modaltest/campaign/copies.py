"""Files of equal content: a copy is not a second measurement, and would make scatter and repeatability zero."""

from __future__ import annotations

import hashlib
from collections.abc import Sequence
from itertools import combinations
from pathlib import Path

from pkmodes.core.base.errors import MeasurementError
from pkmodes.modaltest.campaign.campaign import Record


def find_copies(paths: Sequence[Path]) -> list[tuple[Path, Path]]:
    """Return the pairs of files of equal content, the earlier one first; files that cannot be read have none."""
    sizes = [path.stat().st_size if path.is_file() else None for path in paths]
    pairs = [
        (i, k) for i, k in combinations(range(len(paths)), 2) if sizes[i] is not None and sizes[i] == sizes[k]
    ]
    digests: dict[int, bytes] = {}
    for i in {i for pair in pairs for i in pair}:
        with paths[i].open("rb") as file:
            digests[i] = hashlib.file_digest(file, "sha256").digest()
    return [(paths[i], paths[k]) for i, k in pairs if digests[i] == digests[k]]


def copy_messages(record: Record) -> list[str]:
    """Return a sentence for each repeat of a record that is a copy of another."""
    return [
        f"{record.pose}: {copy.name} is a copy of {first.name}: a copy is not a repeat, and lowers the scatter"
        for paths in record.setups.values()
        for first, copy in find_copies(paths)
    ]


def refuse_copied_visits(records: Sequence[Record], source: str) -> None:
    """Refuse files of equal content under two labels, from which repeatability would be estimated.

    A table of modes may hold the rows of several poses.

    Raises MeasurementError.
    """
    labels = [
        (path, record)
        for record in records
        if record.kind != "modes"
        for paths in record.setups.values()
        for path in paths
    ]
    for first, copy in find_copies([path for path, _ in labels]):
        poses = {record.pose for path, record in labels if path in (first, copy)}
        if len(poses) > 1:
            problem = f"expected new measurements under {' and '.join(sorted(poses))}, found the same content in both"
            remedy = 'measure the pose again, or write a number such as "0.2 %" as repeatability'
            raise MeasurementError(problem, f"{source}: {first.name}, {copy.name}", remedy)
