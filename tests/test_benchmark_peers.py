"""The ways that the benchmark compares solve the model's problem, as far as they need no extra package."""

from __future__ import annotations

import math
from pathlib import Path

import numpy as np
import pytest

import backends_report
import peers
from peer_source import matrices, printed
from published import published, rigid_modes, valid_poses

ROOT = Path(__file__).parents[1]


def test_the_printed_program_gives_the_matrices_of_the_model() -> None:
    program = printed({"sqrt": math.sqrt})
    for p in valid_poses(3):
        values = program(*p)
        for name, expected in zip("MK", published().matrices(p), strict=True):
            found = np.array(matrices().filled(name, values))
            np.testing.assert_allclose(found, expected, rtol=0, atol=1e-14 * np.abs(expected).max())


@pytest.mark.parametrize("make", [peers.lambdify_loop, peers.batched, peers.mujoco_differences])
def test_each_way_finds_the_modes_of_the_model(make) -> None:
    poses, n = valid_poses(5), len(published().coordinates)
    frequencies, alone, shapes = np.empty((5, n)), np.empty((5, n)), np.empty((5, n, n))
    way = make()
    way.run(poses, alone, None)
    way.run(poses, frequencies, shapes)
    expected = published().frequencies(poses, backend="numpy")
    vibrations = slice(rigid_modes(), None)
    assert alone[:, vibrations] == pytest.approx(expected[:, vibrations], rel=1e-10)
    assert frequencies[:, vibrations] == pytest.approx(expected[:, vibrations], rel=1e-10)
    M, _ = published().matrices(poses)
    assert shapes @ M @ np.swapaxes(shapes, 1, 2) == pytest.approx(np.tile(np.eye(n), (5, 1, 1)), abs=1e-10)


def test_a_report_is_put_between_the_marks(tmp_path: Path) -> None:
    document = tmp_path / "compiled.md"
    document.write_text(
        f"before\n{backends_report.BEGIN}\nold\n{backends_report.END}\nafter\n", encoding="utf-8"
    )
    backends_report.put(document, "new\n")
    assert (
        document.read_text(encoding="utf-8")
        == f"before\n{backends_report.BEGIN}\nnew\n{backends_report.END}\nafter\n"
    )


def test_the_document_has_the_marks() -> None:
    found = (ROOT / "docs" / "compiled.md").read_text(encoding="utf-8")
    assert found.index(backends_report.BEGIN) < found.index(backends_report.END)
