"""A file of data that is written twice, at different times and in different places, has the same bytes.

The tests of pictures, animations and pages say the same of these.
"""

from __future__ import annotations

import time
from collections.abc import Callable
from pathlib import Path

import numpy as np
import pytest
import scipy.io

import pkmodes
from pkmodes.machine.maps import dataset

ROOT = Path(__file__).parents[1]
ROBOT = ROOT / "robots" / "linear-delta-2022.toml"
GRID = {"x": np.linspace(0.3, 0.8, 9), "y": np.linspace(-0.1, 0.1, 8), "z": -0.245}


def a_map(name: str, **options: bool) -> Callable[[Path], None]:
    return lambda folder: pkmodes.load(ROBOT).map(GRID, out=folder / name, **options).close()  # type: ignore[arg-type]


def a_model_for_matlab(folder: Path) -> None:
    model = pkmodes.load(ROBOT).state_space([0.6, 0.0, -0.245], ["motor_1"], ["p_x"], drives="held")
    model.to_mat(folder / "model.mat")


def a_response(folder: Path) -> None:
    response = pkmodes.load(ROBOT).frf(
        [0.6, 0.0, -0.245], [10.0, 20.0], inputs=["motor_1"], outputs=["p_x"], drives="held"
    )
    response.to_csv(folder / "response.csv")


WRITTEN: dict[str, Callable[[Path], None]] = {
    "map.nc": a_map("map.nc"),
    "tracked.nc": a_map("tracked.nc", tracked=True),
    "map.zarr": a_map("map.zarr"),
    "map.csv": a_map("map.csv"),
    "map.parquet": a_map("map.parquet"),
    "model.mat": a_model_for_matlab,
    "response.csv": a_response,
}


def content(folder: Path) -> dict[str, bytes]:
    return {str(file.relative_to(folder)): file.read_bytes() for file in folder.rglob("*") if file.is_file()}


@pytest.fixture(scope="module")
def written(tmp_path_factory: pytest.TempPathFactory) -> dict[str, list[dict[str, bytes]]]:
    """The files of two runs; the clock of the libraries, which counts seconds, goes on between them."""
    found: dict[str, list[dict[str, bytes]]] = {name: [] for name in WRITTEN}
    with pytest.MonkeyPatch.context() as patch:
        patch.setattr(dataset, "CHUNK_POSES", 10)  # several parts, which threads would write in any order
        for run_name in ("first", "second"):
            for name, write in WRITTEN.items():
                folder = tmp_path_factory.mktemp(f"{run_name}-{name}")
                write(folder)
                found[name].append(content(folder))
            time.sleep(1.1)
    return found


@pytest.mark.parametrize("name", WRITTEN)
def test_written_twice_is_the_same(name: str, written: dict[str, list[dict[str, bytes]]]) -> None:
    first, second = written[name]
    assert first
    assert first.keys() == second.keys()
    assert [file for file in first if first[file] != second[file]] == []


def test_what_is_written_for_matlab_can_be_read(tmp_path: Path) -> None:
    a_model_for_matlab(tmp_path)
    found = scipy.io.loadmat(tmp_path / "model.mat")
    assert found["__header__"] == b"MATLAB 5.0 MAT-file, written by pkmodes"
    assert found["__version__"] == "1.0"
    assert found["A"].shape == (12, 12)
