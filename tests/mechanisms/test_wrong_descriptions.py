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
from pkmodes.base.errors import PkmodesError
from pkmodes.mechanism import registry
from pkmodes.mechanism.described import Mechanism
from pkmodes.mechanism.fitting import check_code
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
    changed = copy.deepcopy(data)
    parent = changed
    for key in place[:-1]:
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
    monkeypatch.setattr(registry, "_added", {})


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
