"""Check that the ways that `backends.py` compares solve the same problem, as far as they need no extra package.

    python benchmarks/check_peers.py

`backends.py` runs it before it measures, and CI runs it alone.
"""

from __future__ import annotations

import math
import tempfile
from pathlib import Path

import numpy as np

import backends_report
import peers
from peer_source import matrices, printed
from published import published, rigid_modes, valid_poses

ROOT = Path(__file__).parents[1]


def check_program() -> None:
    """The printed program gives the matrices of the model."""
    program = printed({"sqrt": math.sqrt})
    for p in valid_poses(3):
        values = program(*p)
        for name, expected in zip("MK", published().matrices(p), strict=True):
            matrix = np.array(matrices().filled(name, values))
            np.testing.assert_allclose(matrix, expected, rtol=0, atol=1e-14 * np.abs(expected).max())


def check_way(way: peers.Way) -> None:
    """A way finds the modes of the model, and their frequencies alone."""
    poses, n = valid_poses(5), len(published().coordinates)
    frequencies, alone, shapes = np.empty((5, n)), np.empty((5, n)), np.empty((5, n, n))
    way.run(poses, alone, None)
    way.run(poses, frequencies, shapes)
    vibrations = slice(rigid_modes(), None)
    expected = published().frequencies(poses, backend="numpy")[:, vibrations]
    np.testing.assert_allclose(alone[:, vibrations], expected, rtol=1e-10, err_msg=way.label)
    np.testing.assert_allclose(frequencies[:, vibrations], expected, rtol=1e-10, err_msg=way.label)
    M, _ = published().matrices(poses)
    unit = shapes @ M @ np.swapaxes(shapes, 1, 2)
    np.testing.assert_allclose(unit, np.tile(np.eye(n), (5, 1, 1)), rtol=0, atol=1e-10, err_msg=way.label)


def check_report() -> None:
    """A report is put between the marks of a document, and docs/explanation/compiled.md has them."""
    begin, end = backends_report.BEGIN, backends_report.END
    with tempfile.TemporaryDirectory() as folder:
        document = Path(folder) / "compiled.md"
        document.write_text(f"before\n{begin}\nold\n{end}\nafter\n", encoding="utf-8")
        backends_report.put(document, "new\n")
        assert document.read_text(encoding="utf-8") == f"before\n{begin}\nnew\n{end}\nafter\n"
    text = (ROOT / "docs" / "explanation/compiled.md").read_text(encoding="utf-8")
    assert text.index(begin) < text.index(end)


def main() -> None:
    check_report()
    check_program()
    for make in (peers.lambdify_loop, peers.batched, peers.mujoco_differences):
        check_way(make())
    print("the ways that benchmarks/backends.py compares agree")


if __name__ == "__main__":
    main()
