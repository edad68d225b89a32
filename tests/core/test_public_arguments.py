"""Invalid arguments of public functions raise errors of this package with the documented parts."""

from __future__ import annotations

import inspect
import subprocess
import sys
from collections.abc import Callable
from pathlib import Path

import numpy as np
import pytest

import pkmodes
from helpers.robots.robot_text import PUBLISHED
from helpers.runs.processes import environment
from pkmodes import diagnosis
from pkmodes.loop.diagnosis import Candidate, MatrixStructure, Measurements, Parameter

POSE = [0.6, 0.03, -0.245]
MODEL = pkmodes.load(PUBLISHED)


class Unwilling:
    """An object that cannot be converted to an array or to text."""

    def __array__(self, *_: object, **__: object) -> np.ndarray:
        raise RuntimeError("no array")

    def __repr__(self) -> str:
        raise RuntimeError("no text")


RECURSIVE: list[object] = []
RECURSIVE.append(RECURSIVE)
#: Values that are never a valid pose, list, number, function or path.
NEVER: list[object] = [
    None,
    1j,
    np.complex128(1j),
    b"P1",
    object(),
    Unwilling(),
    RECURSIVE,
    np.array(1j),
    np.array([None]),
    [[1.0], [1.0, 2.0]],
    np.array([1, 2], dtype="m8[s]"),
    Ellipsis,
]
STRUCTURE = {
    "parameters": [Parameter("k", 1.0)],
    "candidates": [Candidate("k", ("k",))],
    "matrices": lambda values, _: (np.eye(2), values["k"] * np.eye(2)),
    "channels": ["a", "b"],
}
ROWS = {"pose": ["P1"], "frequency": [1.0], "sigma": [0.1]}
DEFAULTS = {"fields", "out", "parameters", "derivatives", "points", "damping", "mode", "shapes", "lines"}

CALLS: dict[str, Callable[[object], object]] = {
    **{
        name: getattr(MODEL, name)
        for name in ("modes", "frequencies", "check", "matrices", "statics", "platform_jacobian", "assembly")
    },
    "inverse_kinematics": MODEL.inverse_kinematics,
    "sensitivities": MODEL.sensitivities,
    "on_error": lambda x: MODEL.frequencies(POSE, on_error=x),
    "fields": lambda x: MODEL.modes(POSE, fields=x),
    "a field": lambda x: MODEL.modes(POSE, fields=[x]),
    "out": lambda x: MODEL.modes(POSE, out=x),
    "an out": lambda x: MODEL.modes(POSE, out={"frequencies": x}),
    "parameters": lambda x: MODEL.sensitivities(POSE, x),
    "a path": lambda x: MODEL.sensitivities(POSE, [x]),
    "close": lambda x: MODEL.sensitivities(POSE, ["platform.mass"], close=x),
    "carriages": lambda x: MODEL.direct_kinematics(x, 1),
    "branch": lambda x: MODEL.direct_kinematics([0.9, 0.3, 0.3], x),
    "Model": pkmodes.Model,
    "max_condition": lambda x: pkmodes.Model(MODEL.robot, x),
    "load": pkmodes.load,
    "read_robot": pkmodes.read_robot,
    "values": MODEL.robot.with_values,
    "a value": lambda x: MODEL.robot.with_values({"platform.mass": x}),
    "a whole": lambda x: MODEL.robot.with_values({"axis.span": x}),
    "a vector": lambda x: MODEL.robot.with_values({"gravity": x}),
    "a sigma": lambda x: MODEL.robot.with_values(
        {"platform.mass": {"value": 1, "sigma": "x" if x is None else x}}
    ),
    **{
        f"structure {name}": lambda x, name=name: MatrixStructure(**{**STRUCTURE, name: x})
        for name in (*STRUCTURE, "derivatives", "setups", "rigid")
    },
    "a parameter": lambda x: MatrixStructure(**{**STRUCTURE, "parameters": [x]}),
    "a parameter's value": lambda x: MatrixStructure(**{**STRUCTURE, "parameters": [Parameter("k", x)]}),
    "a parameter's name": lambda x: MatrixStructure(**{**STRUCTURE, "parameters": [Parameter(x, 1.0)]}),
    "a candidate": lambda x: MatrixStructure(**{**STRUCTURE, "candidates": [x]}),
    "a candidate's parameters": lambda x: MatrixStructure(**{**STRUCTURE, "candidates": [Candidate("k", x)]}),
    "matrices' result": lambda x: MatrixStructure(**{**STRUCTURE, "matrices": lambda *_: x}),
    **{
        f"measured {name}": lambda x, name=name: Measurements.from_rows(**{**ROWS, name: x})
        for name in (*ROWS, "points", "damping", "mode", "shapes", "lines")
    },
    "measured at": Measurements.from_rows(**ROWS).at,
}
#: Labels and mode numbers may be anything that can be converted to text.
TEXTS = {"measured pose", "measured mode"}


@pytest.mark.usefixtures("backend")
def test_every_mistake_is_an_error_of_the_package(subtests: pytest.Subtests) -> None:
    for name in CALLS:
        with subtests.test(name=name):
            for given in NEVER:
                if given is None and name.rpartition(" ")[2] in DEFAULTS:
                    continue
                if name in TEXTS and isinstance(given, list | np.ndarray):
                    continue
                with pytest.raises(pkmodes.PkmodesError) as error:
                    CALLS[name](given)
                assert all((error.value.what, error.value.where, error.value.remedy)), given
                assert "\n" not in str(error.value)


TWO = Measurements.from_rows(["a", "b"], [0.1, 0.2], [0.01, 0.01])


@pytest.mark.parametrize("call", [diagnosis.diagnose, diagnosis.compare, diagnosis.update])
@pytest.mark.parametrize(
    ("changes", "data", "parts"),
    [
        (
            {},
            "x.csv",
            ['expected measurements, found "x.csv" (data)', "diagnosis.read_measurements(path, channels)"],
        ),
        ({}, TWO, ["2 setups were measured, but the structure names none", 'pass setups=["a", "b"]']),
        (
            {"candidates": [Candidate("k", ("k",), sigma=8e4)]},
            TWO.at([0]),
            ["found 80000", "write (80000.0,)"],
        ),
        (
            {"candidates": [Candidate("k", ("k",), sigma=(1, 2))]},
            TWO.at([0]),
            ["1 standard deviation, found 2"],
        ),
        ({"candidates": [Candidate("k", ("k",), sigma=(-1.0,))]}, TWO.at([0]), ["above 0, found -1"]),
        (None, TWO, ["expected a structure, found", "for a robot, use pkmodes.loop.updating"]),
        ({}, TWO.at([]), ["found no rows"]),
    ],
)
def test_what_the_engine_is_given_is_looked_at_first(
    call: Callable[..., object], changes: dict[str, object] | None, data: object, parts: list[str]
) -> None:
    structure = MODEL if changes is None else MatrixStructure(**{**STRUCTURE, **changes})
    with pytest.raises(pkmodes.PkmodesError) as error:
        call(structure, data)
    for part in parts:
        assert part in str(error.value)


def test_one_setup_without_a_name_takes_the_measurements_of_any_label() -> None:
    rows = Measurements.from_rows(["lab"] * 2, [0.159, 0.16], [0.01, 0.01], mode=[1, 2])
    assert len(diagnosis.compare(MatrixStructure(**STRUCTURE), rows).rows) == 2


@pytest.mark.parametrize(
    ("call", "what"),
    [
        (lambda: MODEL.modes(POSE, fields="frequencies"), "a list of fields"),
        (lambda: MODEL.sensitivities(POSE, "platform.mass"), "a list of parameter paths"),
        (lambda: MatrixStructure(**{**STRUCTURE, "channels": "ab"}), "a list of names"),
        (lambda: MatrixStructure(**{**STRUCTURE, "setups": "P1"}), "a list of labels"),
        (lambda: MatrixStructure(**{**STRUCTURE, "candidates": "k"}), "a list of candidates"),
        (
            lambda: MatrixStructure(**{**STRUCTURE, "candidates": [Candidate("k", "k")]}),
            "a list of names of parameters",
        ),
        (lambda: Measurements.from_rows("a", [1.0], [0.1]), "one label for each row"),
        (lambda: Measurements.from_rows(["a"], [1.0], [0.1], mode="1"), "a list of mode numbers"),
    ],
)
def test_a_text_is_no_list_of_its_letters(call: Callable[[], object], what: str) -> None:
    with pytest.raises(pkmodes.PkmodesError, match=f"expected {what}, found"):
        call()


@pytest.mark.parametrize("given", [0, -1.0, np.nan, True, "1e6"])
def test_the_largest_condition_number_is_positive(given: object) -> None:
    with pytest.raises(pkmodes.PkmodesError, match="expected a positive number") as error:
        pkmodes.Model(MODEL.robot, given)
    assert error.match("max_condition")


#: In a Python of its own: nothing that is slow is loaded before it is asked for, and then all of it.
IMPORTED = """
import sys, pkmodes
assert not {"numpy", "scipy", "pkmodes.loop.updating", "pkmodes.loop.diagnosis"} & set(sys.modules)
pkmodes.load
assert "numpy" in sys.modules and "scipy" not in sys.modules
for part in ("updating", "diagnosis"):
    assert part in dir(pkmodes)
    for name in ("diagnose", "compare"):
        assert getattr(getattr(pkmodes, part), name).__name__ == name
from pkmodes import *
Model
"""


def test_the_package_is_nearly_free_to_import_and_has_all_its_names() -> None:
    subprocess.run([sys.executable, "-c", IMPORTED], env=environment(), check=True)
    assert {"load", "read_robot", "Model", "Modes", "Robot", "PkmodesError", "updating"} <= set(
        pkmodes.__all__
    )
    for name in pkmodes.__all__:
        thing = getattr(pkmodes, name)
        assert inspect.ismodule(thing) or (thing.__name__ == name and thing.__module__.startswith("pkmodes."))
    assert set(pkmodes.__all__) <= set(dir(pkmodes))
    with pytest.raises(AttributeError, match="opening"):
        _ = pkmodes.opening


@pytest.mark.parametrize(
    ("robot", "remedy"),
    [
        ("my robot.toml", 'read it: pkmodes.read_robot("my robot.toml")'),
        (Path("robot.toml"), 'read it: pkmodes.read_robot("robot.toml")'),
        (None, "give what pkmodes.load returns"),
        (b"robot.toml", "give what pkmodes.load returns"),
    ],
)
def test_a_path_in_place_of_a_robot_is_to_be_read(robot: object, remedy: str) -> None:
    modes = Measurements.from_rows(["a"], [10.0], [0.1])
    for called in (pkmodes.loop.updating.compare, pkmodes.loop.updating.diagnose):
        with pytest.raises(pkmodes.PkmodesError, match="expected a robot or a model, found") as error:
            called(robot, modes)  # type: ignore[arg-type]
        assert (error.value.where, error.value.remedy) == ("robot", remedy)
