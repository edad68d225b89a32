"""Poses in tables of other libraries: columns are taken by name, whatever their order."""

from __future__ import annotations

import math
from collections.abc import Callable
from pathlib import Path
from typing import Any

import numpy as np
import pandas
import pyarrow
import pytest
import xarray

import pkmodes
from pkmodes.core.robot.pose_table import ordered_by_name
from pkmodes.pages.view import scene

ROBOT = Path(__file__).parents[3] / "robots" / "linear-delta-2022.toml"
POSES = np.array([[0.6, 0.05, -0.245], [0.55, -0.02, -0.25]])
REVERSED = pandas.DataFrame(POSES[:, ::-1], columns=["z", "y", "x"])
MIXED = pandas.DataFrame(
    {
        "pose": ["A", "B"],
        "z [mm]": [-245, -250],
        "frequency": [40.0, 41.0],
        "x": POSES[:, 0],
        " y [cm] ": [5.0, -2.0],
    }
)


def structured() -> np.ndarray:
    array = np.empty(2, dtype=[("z", "f8"), ("x", "f8"), ("y", "f8")])
    for name, i in (("x", 0), ("y", 1), ("z", 2)):
        array[name] = POSES[:, i]
    return array


class OfPolars:
    """As a table of polars, which is not installed here: names, and columns by name."""

    columns = ["y", "z", "x"]  # noqa: RUF012 - polars has a list

    def __getitem__(self, name: str) -> np.ndarray:
        return POSES[:, "xyz".index(name)]


TABLES = {
    "columns in another order": REVERSED,
    "units and other columns": MIXED,
    "pyarrow": pyarrow.Table.from_pandas(REVERSED),
    "structured": structured(),
    "polars": OfPolars(),
    "xarray": xarray.DataArray(POSES[:, ::-1], dims=("pose", "part"), coords={"part": ["z", "y", "x"]}),
}


@pytest.fixture(scope="module")
def model() -> pkmodes.Model:
    return pkmodes.load(ROBOT)


@pytest.mark.parametrize("table", TABLES.values(), ids=TABLES)
def test_columns_are_taken_by_name(model: pkmodes.Model, table: Any) -> None:
    expected = model.modes(POSES)
    found = model.modes(table)
    np.testing.assert_array_equal(found.poses, POSES)
    np.testing.assert_array_equal(found.frequencies, expected.frequencies)


METHODS: dict[str, Callable[[pkmodes.Model, Any], Any]] = {
    "frequencies": lambda model, poses: model.frequencies(poses),
    "numpy": lambda model, poses: model.frequencies(poses, backend="numpy"),
    "matrices": lambda model, poses: model.matrices(poses)[1],
    "statics": lambda model, poses: model.statics(poses).torques,
    "jacobian": lambda model, poses: model.platform_jacobian(poses),
    "condition": lambda model, poses: model.condition(poses),
    "inverse": lambda model, poses: model.inverse_kinematics(poses),
    "assembly": lambda model, poses: model.assembly(poses),
    "check": lambda model, poses: model.check(poses).poses if hasattr(model.check(poses), "poses") else 0,
    "rates": lambda model, poses: (
        model.sensitivities(poses, ["platform.mass"], fields=["frequencies"]).frequencies
    ),
    "sensitivities": lambda model, poses: model.sensitivities(poses, ["platform.mass"]).stiffness_matrix,
    "map": lambda model, poses: model.map(poses)["frequency"].values,
    "scene": lambda model, poses: scene(model, poses).poses,
}


@pytest.mark.parametrize("method", METHODS.values(), ids=METHODS)
def test_every_method_takes_them_by_name(model: pkmodes.Model, method: Callable[..., Any]) -> None:
    np.testing.assert_array_equal(method(model, REVERSED), method(model, POSES))


def test_one_row_is_a_pose(model: pkmodes.Model) -> None:
    np.testing.assert_array_equal(model.modes(REVERSED.iloc[1]).poses, POSES[1])


def test_coordinates_are_taken_by_name_too(model: pkmodes.Model) -> None:
    q = model.inverse_kinematics(POSES)
    table = pandas.DataFrame({"x_3 [mm]": q[:, 2] * 1000.0, "x_1": q[:, 0], "x_2": q[:, 1]})
    np.testing.assert_allclose(model.direct_kinematics(table, 1), model.direct_kinematics(q, 1), rtol=1e-14)
    with pytest.raises(pkmodes.PoseError, match='expected one column "x_1", found none'):
        model.direct_kinematics(REVERSED, 1)


def test_units_are_converted_to_the_nearest_double() -> None:
    table = pandas.DataFrame({"x [mm]": [600.0, -245.3], "a [deg]": [180.0, 30.0]})
    found = np.asarray(ordered_by_name(table, {"a": "rad", "x": "m"}, "poses"))
    assert found[:, 1].tolist() == [0.6, -0.2453]
    np.testing.assert_allclose(found[:, 0], [math.pi, math.pi / 6], rtol=4e-16)


@pytest.mark.parametrize(
    ("table", "said"),
    [
        (
            pandas.DataFrame(POSES),
            'expected one column "x", found none among "0, 1, 2" (poses); name them x, y, z',
        ),
        (
            pandas.DataFrame(POSES, columns=["X", "Y", "W"]),
            'expected one column "z", found none among "X, Y, W"',
        ),
        (REVERSED[["z", "y"]], 'expected one column "x", found none'),
        (pandas.DataFrame(POSES, columns=["x", "x", "z"]), 'expected one column "x", found 2'),
        (REVERSED["x"], 'expected one column "x", found none'),
        (
            REVERSED.rename(columns={"x": "x [kg]"}),
            'expected a unit such as "mm" for x: "kg" is another kind of unit',
        ),
        (REVERSED.astype({"y": str}), 'expected numbers in the column "y", found values of type'),
        (REVERSED > 0, 'expected numbers in the column "x", found values of type bool'),
        (pyarrow.Table.from_pandas(REVERSED[["z", "y"]]), 'expected one column "x", found none'),
        (REVERSED.iloc[:0], "expected at least one pose"),
        (REVERSED["x"].iloc[0:1], 'expected one column "x"'),
    ],
)
def test_other_tables_are_refused(model: pkmodes.Model, table: Any, said: str) -> None:
    for method in (model.modes, model.map, model.statics):
        with pytest.raises(pkmodes.PoseError) as error:
            method(table)
        assert said in str(error.value)


def test_what_has_no_names_is_taken_as_before(model: pkmodes.Model) -> None:
    expected = model.frequencies(POSES)
    unnamed = xarray.DataArray(POSES, dims=("pose", "part"))
    for given in (POSES.tolist(), tuple(map(tuple, POSES)), unnamed, unnamed.assign_coords(part=[0, 1, 2])):
        np.testing.assert_array_equal(model.frequencies(given), expected)
