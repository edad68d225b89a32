"""The notebooks of examples/ run where `pkmodes examples` leaves them, and show the numbers of the documentation.

They are kept with what they show, to be read without running them; ``--update-golden`` stores that anew.
"""

from __future__ import annotations

import os
import re
import sys
from html import unescape
from pathlib import Path

import nbformat
import pytest
from nbclient import NotebookClient

from helpers.commands.answers import printed

ROOT = Path(__file__).parents[1]
NOTEBOOKS = {path.stem: path for path in sorted((ROOT / "examples/notebooks").glob("*.ipynb"))}


def shown(name: str, folder: Path, monkeypatch: pytest.MonkeyPatch, update: bool) -> list[str]:
    """Execute a notebook as the command leaves it in an empty folder; return the text that each cell shows.

    That is what the notebook is kept with, but for the digits of its numbers.

    The kernel runs in the folder of the notebook, as that of Jupyter does.
    """
    printed("examples", "notebooks", "--out", folder)
    monkeypatch.setenv("PYTHONPATH", os.pathsep.join(path for path in sys.path if path))  # of the kernel
    place = folder / "examples" / "notebooks"
    notebook = nbformat.read(place / f"{name}.ipynb", as_version=4)
    kept = nbformat.read(NOTEBOOKS[name], as_version=4)
    client = NotebookClient(
        notebook, timeout=600, record_timing=False, resources={"metadata": {"path": str(place)}}
    )
    client.execute()
    if update:
        for cell, run in zip(kept.cells, notebook.cells, strict=True):
            if cell["cell_type"] == "code":
                cell["outputs"], cell["execution_count"] = run["outputs"], run["execution_count"]
        text = nbformat.writes(kept) + "\n"
        NOTEBOOKS[name].write_text(re.sub(r" object at 0x[0-9a-f]+", " object", text), encoding="utf-8")
    found = texts_of(notebook)
    assert list(map(_wordy, texts_of(kept))) == list(map(_wordy, found)), "run with --update-golden"
    return found


def texts_of(notebook: nbformat.NotebookNode) -> list[str]:
    """Return the text that each cell of code shows."""
    return [
        "".join(
            output["text"] if output["output_type"] == "stream" else _text(output["data"]["text/html"])
            for output in cell["outputs"]
        )
        for cell in notebook.cells
        if cell["cell_type"] == "code"
    ]


def _wordy(text: str) -> str:
    """Return text without its numbers, whose last digits may differ between machines."""
    return re.sub(r"[\d.]+", "0", text)


def _text(html: str) -> str:
    return " ".join(unescape(re.sub(r"<[^>]*>", " ", html)).split())


@pytest.mark.slow
def test_from_a_robot_file_to_modes_and_maps(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, pytestconfig: pytest.Config
) -> None:
    update = bool(pytestconfig.getoption("update_golden"))
    cells = shown("modes_and_maps", tmp_path, monkeypatch, update)
    robot, free, held, statics, sensitivities, a_map, picture, changed = cells
    assert "belt.width 0.015 \u2013 m width of each belt" in robot
    assert "55.559 60.316 61.545 130.801 133.831 134.257" in free  # README
    assert "32.267 36.236 39.654" in held
    assert "0.4932 -0.2466 -0.2466" in statics
    belt = re.search(r"belt\.width\s+(\S+)", sensitivities)
    assert belt is not None
    assert float(belt[1]) == pytest.approx(0.278, abs=2e-3)
    assert a_map == "The first frequency lies between 45.1 and 58.2 Hz.\n"
    assert "Natural frequencies." in picture
    assert re.fullmatch(
        r"The first frequency rises by (\S+ Hz), 8\.6 Hz, (\S+ Hz)\n", changed
    )  # docs/how-to/python.md


@pytest.mark.slow
def test_from_measurements_to_the_cause(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, pytestconfig: pytest.Config
) -> None:
    update = bool(pytestconfig.getoption("update_golden"))
    cells = shown("cause_from_measurements", tmp_path, monkeypatch, update)
    compared, found, corrected, early, proposed = cells
    assert "The differences are larger than the measurement errors." in compared
    assert "Cause found: the gearboxes wind up; " in found
    assert re.search(r"before: as declared\s+0\.71", found)  # README
    assert re.search(r"after: with the cause\s+0\.17", found)
    assert "The differences are within the measurement errors." in corrected
    assert (tmp_path / "examples/notebooks/corrected.toml").is_file()
    assert "Several explanations remain." in early
    assert "gearbox_compliance" in early, "the true one is among them"
    assert re.match(r"With (motor shafts clamped|motors free), at \S+ m, \S+ m, \S+ m\n", proposed)


@pytest.mark.parametrize("name", NOTEBOOKS)
def test_a_notebook_is_kept_with_what_it_shows(name: str) -> None:
    notebook = nbformat.read(NOTEBOOKS[name], as_version=4)
    nbformat.validate(notebook)
    assert all(texts_of(notebook))
    codes = [cell for cell in notebook.cells if cell["cell_type"] == "code"]
    assert [cell["execution_count"] for cell in codes] == list(range(1, len(codes) + 1))
    assert not any(cell["metadata"] for cell in notebook.cells)
    assert "/tmp/" not in NOTEBOOKS[name].read_text(encoding="utf-8")
    assert notebook.metadata.keys() == {"kernelspec", "language_info"}
    assert "pkmodes examples notebooks" in notebook.cells[0]["source"]
    page = (ROOT / "docs/index.md").read_text(encoding="utf-8")
    assert f"examples/notebooks/{name}.ipynb" in page
