"""A description with a mistake anywhere gives an error of pkmodes, or still a mechanism that works."""

from __future__ import annotations

import copy
import json
import random
import shutil
from collections.abc import Iterator
from importlib.resources import files
from pathlib import Path
from typing import Any

import pytest
from msgspec.structs import asdict

import pkmodes
from helpers.robots.sample_robots import ROBOTS
from pkmodes.core.base.errors import PkmodesError
from pkmodes.core.mechanism import registry
from pkmodes.core.mechanism.code_check import check_code
from pkmodes.core.mechanism.described import Mechanism
from pkmodes_description import DescriptionError, decode

#: A robot of each mechanism, and a pose of it.
EXAMPLES = {
    "corexy": ("corexy-printer.toml", [0.15, 0.1]),
    "linear_delta": ("linear-delta-2022.toml", [0.6, 0.0, -0.245]),
    "rotary_delta": ("clavel-delta.toml", [0.0, 0.0, -0.5]),
}
REMOVED = object()
Place = tuple[str | int, ...]
#: Examples of past tracebacks.
KNOWN = (
    (("tables", 5, "keys", 0, "field"), -1),
    (("margins", 0), None),
    (("mechanism",), -1),
    (("margins", 0, "output"), -1),
    (("tables", 0, "keys", 0, "index"), [7]),
    (("effects", 0, "parameters", 0, "unit"), "furlong"),
    (("margins", 0, "sentence"), "{0"),
    (("margins", 0, "function"), "no_function"),
    (("pose", 0, "unit"), "s"),
    (("coordinates", 0, "name"), "elsewhere"),
    (("rigid_modes",), 2**70),
    (("sample", "gravity"), [0.0, [1.0], 2.0]),
    (("drawing", "elements", 0, "points"), [0, 999]),
    (("drawing", "motions", 1), 999),
    (("drawing", "uprights"), 5),
)

#: References within a description that lead nowhere, and how the message begins.
REFERENCES = (
    ("linear_delta", ("pose", 1, "name"), "x", '"x" occurs twice in pose'),
    ("linear_delta", ("drives", 1, "name"), "1", '"1" occurs twice in drives'),
    ("linear_delta", ("independent",), ["x_1", "x_2", "x_1"], '"x_1" occurs twice in independent'),
    ("linear_delta", ("directions",), ["x", "y", "y"], '"y" occurs twice in directions'),
    ("linear_delta", ("scales", 0, "coordinate"), "q", '"q" in scales is none of x_1'),
    ("corexy", ("rigid_modes",), 5, "there are 5 rigid modes of 4 coordinates"),
    ("linear_delta", ("tables", 1, "shared_by"), "platform", '"platform" in shared_by is none of axis'),
    ("linear_delta", ("tables", 7, "shared_by"), "axis", "the table axis is both repeated and shared"),
    ("linear_delta", ("tables", 0, "keys", 0, "field"), "", "platform.mass: it has to belong either to"),
    (
        "linear_delta",
        ("tables", 7, "keys", 4, "elements"),
        ["a", "b", "c"],
        "axis.limits: 3 elements of a pair",
    ),
    ("linear_delta", ("effects", 12, "coordinates", 0, "name"), "x_1", '"x_1" occurs twice in coordinates'),
    ("linear_delta", ("directions",), ["x", "y", "q"], '"q" in directions is none of x, y, z'),
    ("linear_delta", ("rotations",), ["z"], '"rz" in rotations is none of x, y, z'),
    ("linear_delta", ("pose", 0, "unit"), "mm", '"mm" in the units of pose is none of m, rad'),
    ("linear_delta", ("tables", 1, "name"), "platform", '"platform" occurs twice in tables'),
    ("linear_delta", ("tables", 1, "keys", 1, "name"), "length", '"length" occurs twice in link'),
    (
        "linear_delta",
        ("tables", 0, "keys", 0, "dimension"),
        "weight",
        'platform.mass: "weight" in dimension is none of length',
    ),
    (
        "linear_delta",
        ("tables", 7, "keys", 0, "elements"),
        ["x", "y", "x"],
        'axis.origin: "x" occurs twice in elements',
    ),
    (
        "linear_delta",
        ("tables", 6, "keys", 0, "effect"),
        "frame_compliance.weight",
        'frame.mass: "frame_compliance.weight" in effect is none of axis_belt_stiffness.factor_1',
    ),
    ("linear_delta", ("tables", 7, "keys", 5, "default"), 1.0, "axis.branch: a choice cannot have a default"),
    ("linear_delta", ("tables", 7, "keys", 5, "choices"), [], "axis.branch: 0 choices of a choice"),
    ("linear_delta", ("tables", 0, "keys", 0, "choices"), [1], "platform.mass: 1 choices of a quantity"),
    ("linear_delta", ("wholes", 1, "path"), "axis.span", '"axis.span" occurs twice in wholes'),
    ("linear_delta", ("wholes", 0, "unit"), "rad", 'axis.span: there is no field "limits" of pairs in rad'),
    ("linear_delta", ("wholes", 0, "field"), "joint", 'axis.span: there is no field "joint" of pairs in m'),
    ("linear_delta", ("margins", 0, "sentence"), "{} is far", '"" in the sentence of the margin reachable'),
    ("linear_delta", ("effects", 1, "name"), "belt_mass", '"belt_mass" occurs twice in effects'),
    (
        "linear_delta",
        ("effects", 0, "parameters", 1, "name"),
        "factor_1",
        '"effects.axis_belt_stiffness.factor_1" occurs twice in the parameters of axis_belt_stiffness',
    ),
    (
        "linear_delta",
        ("effects", 4, "requirements", 0, "places"),
        ["effects.belt_tension_stiffness.force"],
        '"effects.belt_tension_stiffness.force" in the places of belt_tension_stiffness_margin is none of',
    ),
    (
        "linear_delta",
        ("effects", 4, "requirements", 0, "sentence"),
        "above {force}",
        '"{force}" in the sentence of belt_tension_stiffness_margin is no value beside',
    ),
    (
        "corexy",
        ("requirements", 0, "sentence"),
        "above {force}",
        '"{force}" in the sentence of run_margin is no value beside',
    ),
    ("corexy", ("drawing", "elements", 0, "turns"), "q", '"q" in turns of left rail is none of x'),
    ("corexy", ("drawing", "motions"), [], "the drawing has no points"),
    ("corexy", ("drawing", "motions", 0), 6, "the motions of the drawing are not numbered from 0"),
    ("corexy", ("drawing", "elements", 0, "points"), [1, 50], "left rail in the drawing: the points [1, 50]"),
    (
        "corexy",
        ("drawing", "elements", 5, "points"),
        [0, 7, 8],
        "tool head in the drawing: the points [0, 7, 8]",
    ),
    ("corexy", ("drawing", "elements", 11, "spring"), 8, "belt 1 in the drawing: there is no spring 8"),
)
#: Descriptions that are complete in themselves, but not those of the code.
CODE = (
    ("corexy", ("coordinates", 0, "unit"), "rad", "the units of the coordinates are"),
    ("corexy", ("directions",), ["x"], "the number of directions is 1, expected 2"),
    ("corexy", ("drives", 1), REMOVED, "the number of drives is 1, expected 2"),
    ("corexy", ("rigid_modes",), 1, "the number of rigid modes is 1, expected 2"),
    ("linear_delta", ("drawing", "uprights"), 0, "TypeError: drawing_points() missing"),
    (
        "corexy",
        ("drawing", "motions", 49),
        19,
        "the number of motions of the drawn points is 20, expected 19",
    ),
    ("corexy", ("tables", 5, "keys", 1, "index"), [0], "the keys of workspace use an index twice"),
    ("corexy", ("tables", 7, "count"), 3, "the shape of belt_specific_stiffness is (3,)"),
    (
        "corexy",
        ("requirements", 0, "places"),
        ["belt_path.1.lengths.1"],
        "the number of places of run_margin is 1",
    ),
    (
        "corexy",
        ("drawing", "springs"),
        [{"name": "one", "unit": "N/m", "description": "of all runs"}] * 9,
        "the number of springs is 9, expected 8",
    ),
    ("linear_delta", ("differences",), [["origin", "link_length"]], "the shape of origin and link_length is"),
    ("linear_delta", ("scales", 0, "index"), [], "the shape of pulley_radius is (3,), expected ()"),
    ("linear_delta", ("sample", "platform_mass"), "1", "TypeError: expected numbers in the sample, found"),
    ("linear_delta", ("sample", "more"), 1.0, "the fields of the sample are "),
    ("linear_delta", ("tables", 0, "keys", 0), REMOVED, "the fields of the keys are "),
    ("linear_delta", ("tables", 0, "keys", 0, "index"), [7], "IndexError: "),
    ("corexy", ("tables", 5, "keys", 1), REMOVED, "the number of values of workspace is 2, expected 4"),
    (
        "linear_delta",
        ("effects", 12, "coordinates"),
        [{"name": f"psi_{j}", "unit": "rad", "description": "wind-up"} for j in (2, 1, 3)],
        "the order of coordinates is ",
    ),
    ("linear_delta", ("effects", 8, "parameters", 0, "name"), "weight", "the parameters of effects are "),
    (
        "linear_delta",
        ("independent",),
        ["x_1", "x_2"],
        "the number of independent coordinates is 2, expected 3",
    ),
    (
        "corexy",
        ("pose",),
        [{"name": name, "unit": "m", "description": name} for name in "xyz"],
        "ValueError: expected an array of shape (..., 2), found shape (3,)",
    ),
    ("linear_delta", ("margins", 0, "names"), [["1", "2"]], "the number of names for "),
    (
        "linear_delta",
        ("effects", 4, "requirements", 0, "places"),
        [f"effects.belt_tension_stiffness.{name}" for name in ("coefficient", "tension")],
        "the number of places of belt_tension_stiffness_margin is 2, expected 1",
    ),
    ("corexy", ("drawing", "motions"), [0, 1, 2, 3, 4] * 12, "the number of drawn points is 60, expected 50"),
)


def nodes(data: Any, place: Place = ()) -> Iterator[tuple[Place, Any]]:
    """Yield every node below the root with its place."""
    entries = data.items() if isinstance(data, dict) else enumerate(data) if isinstance(data, list) else ()
    for key, value in entries:
        yield (*place, key), value
        yield from nodes(value, (*place, key))


def wrong(value: Any) -> list[Any]:
    """What a node may become by mistake."""
    others: list[Any] = [REMOVED, None, -1, "", [], {}, True, 1.5]
    if isinstance(value, str):
        others += ["another text", [value]]
    elif isinstance(value, list):
        others += [{str(i): entry for i, entry in enumerate(value)}, value[:-1], [*value, *value[:1]]]
    elif isinstance(value, dict):
        others += [list(value.values()), {**value, "more": 1}]
    elif isinstance(value, bool):
        others += [not value]
    return [other for other in others if other != value]


def mutations(data: Any) -> list[tuple[Place, Any]]:
    return [(place, other) for place, value in nodes(data) for other in wrong(value)]


def few_of_each(data: Any) -> list[tuple[Place, Any]]:
    """The mutations of the first, a middle and the last node of every kind: places that differ by indices only."""
    kinds: dict[Place, list[Place]] = {}
    for place, _ in nodes(data):
        kinds.setdefault(tuple(0 if isinstance(key, int) else key for key in place), []).append(place)
    chosen = {places[i] for places in kinds.values() for i in (0, len(places) // 2, -1)}
    return [(place, other) for place, other in mutations(data) if place in chosen]


def mutated(data: Any, place: Place, other: Any) -> str:
    # Only what holds the place is copied: the rest is written, not changed.
    changed = parent = copy.copy(data)
    for key in place[:-1]:
        parent[key] = copy.copy(parent[key])
        parent = parent[key]
    if other is REMOVED:
        del parent[place[-1]]
    else:
        parent[place[-1]] = other
    return json.dumps(changed)


class Folder:
    """A copy of the code of a mechanism under another name, whose description may be changed."""

    def __init__(self, name: str, place: Path) -> None:
        self.folder, self.robot = place / "mutated", place / "robot.toml"
        shutil.copytree(Path(str(files(f"pkmodes_generated.{name}"))), self.folder)
        self.file = self.folder / "description.json"
        self.data = json.loads(self.file.read_text(encoding="utf-8")) | {"mechanism": "mutated"}
        self.file.write_text(json.dumps(self.data), encoding="utf-8")
        robot, self.pose = EXAMPLES[name]
        text = (ROBOTS / robot).read_text(encoding="utf-8")
        self.robot.write_text(
            text.replace(f'mechanism = "{name}"', 'mechanism = "mutated"'), encoding="utf-8"
        )

    def use(self, place: Place, other: Any) -> str:
        """Read a mutated description and compute modes: return the error, empty if there is none."""
        self.file.write_text(mutated(self.data, place, other), encoding="utf-8")
        try:
            with registry.temporarily_registered(self.folder):
                robot = pkmodes.read_robot(self.robot)
                pkmodes.Model(robot).modes(self.pose, on_error="nan")
        except PkmodesError as error:
            assert error.what
            assert error.where
            assert error.remedy
            return str(error)
        return ""


@pytest.fixture(autouse=True)
def _numpy_here_only(monkeypatch: pytest.MonkeyPatch) -> None:
    """No mutated mechanism is compiled, or known to other tests."""
    monkeypatch.setenv("PKMODES_BACKEND", "numpy")
    monkeypatch.setattr(registry, "_package_by_name", {})


@pytest.fixture(params=EXAMPLES)
def folder(request: pytest.FixtureRequest, tmp_path: Path) -> Folder:
    return Folder(request.param, tmp_path)


def test_the_description_itself_works(folder: Folder) -> None:
    assert folder.use(("title",), "another title") == ""


@pytest.mark.parametrize(("place", "other"), KNOWN)
def test_a_known_mistake_is_refused(place: Place, other: Any, tmp_path: Path) -> None:
    folder = Folder("linear_delta", tmp_path)
    assert "description" in folder.use(place, other)
    assert folder.use(("title",), "another title") == ""


def test_a_reference_to_nothing_is_named(subtests: pytest.Subtests) -> None:
    for name, place, other, what in REFERENCES:
        with subtests.test(f"{name}, {place}"):
            text = files(f"pkmodes_generated.{name}").joinpath("description.json").read_text(encoding="utf-8")
            decode(text.encode())
            with pytest.raises(DescriptionError) as error:
                decode(mutated(json.loads(text), place, other).encode())
            assert str(error.value).startswith(what)


@pytest.mark.parametrize("place", [("scales", 0, "coordinate"), ("drawing", "elements", 0, "turns")])
def test_coordinates_of_effects_may_be_scaled_and_drawn(place: Place) -> None:
    text = files("pkmodes_generated.linear_delta").joinpath("description.json").read_text(encoding="utf-8")
    decode(mutated(json.loads(text), place, "psi_2").encode())


def test_code_that_is_not_the_described_is_named(subtests: pytest.Subtests) -> None:
    for name, place, other, what in CODE:
        with subtests.test(f"{name}, {place}"):
            package = f"pkmodes_generated.{name}"
            data = json.loads(files(package).joinpath("description.json").read_text(encoding="utf-8"))
            check_code(Mechanism(package=package, **asdict(decode(json.dumps(data).encode()))))
            wrong = Mechanism(package=package, **asdict(decode(mutated(data, place, other).encode())))
            with pytest.raises(PkmodesError, match="does not fit its code") as error:
                check_code(wrong)
            assert f"does not fit its code: {what}" in error.value.what


def test_a_sample_of_mistakes(folder: Folder) -> None:
    chosen = random.Random(20261122).sample(mutations(folder.data), 30)
    refused = [bool(folder.use(place, other)) for place, other in chosen]
    assert 15 < sum(refused) < 30


def test_mistakes_everywhere(folder: Folder, monkeypatch: pytest.MonkeyPatch) -> None:
    """The steps of `add_folder`, without importing the same code again for each of thousands of descriptions."""
    package = registry.add_folder(folder.folder).package
    refused = working = 0
    for place, other in few_of_each(folder.data):
        try:
            description = decode(mutated(folder.data, place, other).encode())
        except DescriptionError as error:
            assert str(error)
            refused += 1
            continue
        mechanism = Mechanism(package=package, **asdict(description))
        monkeypatch.setattr(registry, "mechanism", lambda name, known=mechanism: known)
        try:
            check_code(mechanism)
            pkmodes.Model(pkmodes.read_robot(folder.robot)).modes(folder.pose, on_error="nan")
            working += 1
        except PkmodesError:
            refused += 1
    assert refused > 5 * working > 0


def test_text_that_is_no_description(tmp_path: Path) -> None:
    folder = Folder("corexy", tmp_path)
    for text in ("", "{", "[" * 100_000, "null", '{"mechanism": 1e999}', "\udcff", '{"mechanism": NaN}'):
        folder.file.write_bytes(text.encode("utf-8", "surrogateescape"))
        with pytest.raises(PkmodesError, match="cannot read the description of a mechanism"):
            registry.add_folder(folder.folder)
