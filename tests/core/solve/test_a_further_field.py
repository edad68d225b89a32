"""A further field of the modes takes an entry in the table and a function: results, maps and JSON then have it."""

from __future__ import annotations

import json
import re
from pathlib import Path

import numpy as np
import pytest

import pkmodes
from pkmodes.cli import run
from pkmodes.core.compiled.evaluator import Evaluator
from pkmodes.core.solve import mode_fields
from pkmodes.core.solve.fields import FIELDS, MODE, Field
from pkmodes.core.solve.results import Modes

ROBOT = Path(__file__).parents[3] / "robots/linear-delta-2022.toml"
GRID = {"x": np.linspace(0.4, 0.6, 3), "y": [0.02, 5.0], "z": -0.245}
POSES = [[0.6, 0.02, -0.245], [9.0, 0.0, 0.0], [0.5, 0.03, -0.245]]
BACKENDS = ["numpy", pytest.param("compiled", marks=pytest.mark.compiler)]


def lightness(shapes: np.ndarray, mass_matrix: np.ndarray) -> np.ndarray:
    """Made up: the share of a mode's energy that moves the first coordinate."""
    return np.asarray((shapes @ mass_matrix)[..., 0] * shapes[..., 0])


@pytest.fixture(autouse=True)
def registered(monkeypatch: pytest.MonkeyPatch) -> None:
    entry = Field(
        name="lightnesses",
        dims=(MODE,),
        needs=("shapes", "mass_matrix"),
        function=lightness,
        variable="lightness",
        key="lightnesses_1",
        units="kg",
        text="made up",
        symbol="l",
    )
    monkeypatch.setitem(FIELDS, entry.name, entry)


@pytest.fixture
def model() -> pkmodes.Model:
    return pkmodes.load(ROBOT)


def expected(model: pkmodes.Model, poses: object, backend: str = "auto") -> np.ndarray:
    modes = model.modes(poses, "nan", fields=["shapes", "mass_matrix"], backend=backend)
    return lightness(modes.shapes, modes.mass_matrix)


@pytest.mark.parametrize("backend", BACKENDS)
def test_modes_have_it(model: pkmodes.Model, backend: str) -> None:
    assert "lightnesses" in Modes.FIELDS
    assert "lightnesses" in Modes.fields_of(model.mechanism)
    modes = model.modes(POSES, "nan", backend=backend)
    np.testing.assert_allclose(modes.lightnesses, expected(model, POSES, backend), rtol=1e-12, atol=1e-15)
    assert np.isnan(modes.lightnesses[1]).all()
    assert np.isfinite(modes.lightnesses[::2]).all()
    assert "lightnesses (3, 9)" in repr(modes)
    with pytest.raises(pkmodes.NotComputedError, match="the field lightnesses was not requested"):
        _ = model.modes(POSES[0], fields=["shapes"]).lightnesses


@pytest.mark.parametrize("backend", BACKENDS)
def test_it_is_computed_alone_part_by_part_in_an_array_of_the_caller(
    model: pkmodes.Model, backend: str, monkeypatch: pytest.MonkeyPatch
) -> None:
    whole = model.modes(POSES * 4, "nan", backend=backend).lightnesses
    out = np.empty((12, 9))
    monkeypatch.setattr(mode_fields, "POSES_PER_THREAD", 5)
    modes = pkmodes.load(ROBOT).modes(POSES * 4, "nan", out={"lightnesses": out}, backend=backend, threads=1)
    assert modes.lightnesses is out
    np.testing.assert_array_equal(out, whole)


def test_the_notebook_shows_it(model: pkmodes.Model) -> None:
    html = str(model.modes(POSES, "nan")._repr_html_())
    assert "l1 [kg]" in html
    assert f"{model.modes(POSES[0]).lightnesses[3]:.3f}" in html


def test_datasets_and_tables_have_it(model: pkmodes.Model) -> None:
    pytest.importorskip("xarray")
    modes = model.modes(POSES, "nan")
    dataset, table = modes.to_dataset(), modes.to_table()
    assert dataset["lightness"].dims == ("pose", "mode")
    assert dataset["lightness"].attrs == {"units": "kg", "long_name": "made up"}
    np.testing.assert_array_equal(dataset["lightness"], modes.lightnesses[:, 3:])
    np.testing.assert_array_equal(table["lightness"], modes.lightnesses[:, 3:].ravel())
    assert "lightness" not in model.modes(POSES, "nan", fields=["shapes"]).to_dataset()


@pytest.mark.parametrize("backend", BACKENDS)
@pytest.mark.parametrize("name", [None, "map.nc", "map.csv"])
def test_maps_have_it(model: pkmodes.Model, backend: str, name: str | None, tmp_path: Path) -> None:
    pytest.importorskip("xarray")
    out = None if name is None else tmp_path / name
    with model.map(GRID, out=out, backend=backend) as dataset:
        lightnesses = dataset["lightness"].transpose("z", "y", "x", "mode").values
        poses = [[x, y, -0.245] for y in GRID["y"] for x in GRID["x"]]
        wanted = expected(model, poses, backend)[:, 3:].reshape(1, 2, 3, 6)
        np.testing.assert_allclose(lightnesses, wanted, rtol=1e-12, atol=1e-15)
    if name == "map.csv":
        assert "lightness" in (tmp_path / name).read_text().splitlines()[0].split(",")


def test_tracked_maps_order_it_as_the_frequencies(model: pkmodes.Model) -> None:
    pytest.importorskip("xarray")
    grid = {"x": np.linspace(0.3, 0.8, 40), "y": 0.0, "z": -0.245}
    plain, tracked = model.map(grid), model.map(grid, tracked=True)
    rank = tracked["rank"].values.astype(int) - 1
    assert (rank != np.arange(6)).any()
    np.testing.assert_array_equal(
        tracked["lightness"].values, np.take_along_axis(plain["lightness"].values, rank, axis=-1)
    )


def test_json_has_it(tmp_path: Path) -> None:
    out = tmp_path / "modes.json"
    assert run(["modes", str(ROBOT), "--pose", "0.6,0.02,-0.245", "--json", str(out)]) == 0
    modes = pkmodes.load(ROBOT).modes(POSES[0])
    assert json.loads(out.read_text(encoding="utf-8"))["lightnesses_1"] == modes.lightnesses.tolist()


@pytest.mark.compiler
@pytest.mark.parametrize("compliance", [0.0, 1e-7])
def test_the_compiled_evaluator_runs_once(compliance: float, monkeypatch: pytest.MonkeyPatch) -> None:
    """Also with arrays of the caller that have to stay as they are if a pose is refused."""
    model = pkmodes.load(ROBOT).with_values({"effects.clamp_compliance.compliance": compliance})
    runs: list[int] = []
    honest = Evaluator.run

    def counted(self, points, arrays, *args, **kwargs):  # type: ignore[no-untyped-def]
        runs.extend([len(points)] if arrays else [])  # without arrays it only checks the poses
        return honest(self, points, arrays, *args, **kwargs)

    monkeypatch.setattr(Evaluator, "run", counted)
    poses = np.array([POSES[0]] * 3)
    out = {"frequencies": np.empty((3, 9)), "lightnesses": np.empty((3, 9))}
    model.modes(poses, out=out, backend="compiled")
    assert runs == [3]
    runs.clear()
    model.sensitivities(poses, ["gravity.x"], out={"frequencies": np.empty((3, 1, 9))}, backend="compiled")
    assert runs == [3]


def test_the_documentation_of_modes_has_every_field(monkeypatch: pytest.MonkeyPatch) -> None:
    """The class is documented by hand; the table holds it to be complete."""
    monkeypatch.undo()
    documented = re.findall(r"^    (\w[\w, ]*) : ", str(Modes.__doc__), re.MULTILINE)
    names = [name for line in documented for name in line.split(", ")]
    assert [name for name in names if name in Modes.FIELDS] == list(Modes.FIELDS)
    for name, field in FIELDS.items():
        assert name not in Modes.FIELDS or name in Modes.__annotations__
        assert not field.variable or field.text
        assert not (field.in_modes and field.variable and not field.key)
