"""Docstrings of the public names: complete, in the form of numpydoc, and on the site's pages."""

from __future__ import annotations

import doctest
import importlib
import inspect
import re
from collections.abc import Iterator, Mapping
from functools import cached_property
from pathlib import Path

import pytest
from numpydoc.validate import validate

import pkmodes
from pkmodes.api import APPLICATIONS

ROOT = Path(__file__).parents[1]
#: The public names of each module that has a page.
MODULES = {
    "pkmodes": (),
    "pkmodes.updating": (),
    "pkmodes.diagnosis": (),
    "pkmodes.figures": (),
    "pkmodes.view": (),
    "pkmodes.report": (),
    "pkmodes.shaping": ("Shaper", "residual", "shaper"),
    "pkmodes.response.frequency_response": ("FrequencyResponse",),
    "pkmodes.response.state_space": ("StateSpace",),
    "pkmodes.mechanism": ("add_folder", "mechanism", "names"),  # the rest is for the runtime
}
#: Methods of public classes that these inherit.
INHERITED = {"pkmodes.core.model": ("Model",)}
#: Functions of applications that are methods of `pkmodes.Model`.
ATTACHED = {module: (name,) for module, name in (place.split(":") for place in APPLICATIONS.values())}
#: Format, summaries, parameters, results and exceptions.  An extended summary, an example and See Also are not asked
#: of every name.
CHECKS = re.compile(r"GL0[35-9]|GL10|SS0[1-6]|PR0[1-9]|PR10|RT0[1-5]|YD01")
#: The interface between a model and the engine, which few implement: one sentence says what to return.
ENGINE = ("pkmodes.loop.diagnosis.problem.Structure", "pkmodes.loop.diagnosis.matrices.MatrixStructure.")


def public() -> Iterator[tuple[str, object]]:
    """Yield the public names with what they name."""
    yield from named_in(MODULES)


def named_in(modules: Mapping[str, tuple[str, ...]]) -> Iterator[tuple[str, object]]:
    """Yield names of modules, by default all that they export, with what they name."""
    for module, chosen in modules.items():
        found = importlib.import_module(module)
        for name in chosen or found.__all__:
            if not inspect.ismodule(getattr(found, name)):  # it has its own entry
                yield f"{module}.{name}", getattr(found, name)


def documented() -> Iterator[str]:
    """Yield functions, classes, and the public methods that these define, by the module that defines them."""
    for _, thing in (*public(), *named_in(INHERITED), *named_in(ATTACHED)):
        name = f"{thing.__module__}.{thing.__qualname__}"
        yield name
        for attribute, value in vars(thing).items() if inspect.isclass(thing) else ():
            if not attribute.startswith("_") and (
                inspect.isfunction(value) or isinstance(value, classmethod | property | cached_property)
            ):
                yield f"{name}.{attribute}"


def test_a_docstring_is_complete(subtests: pytest.Subtests) -> None:
    names = sorted({*documented()})
    assert names
    for name in names:
        with subtests.test(name=name):
            found = validate(name)
            problems = [f"{code}: {text}" for code, text in found["errors"] if CHECKS.fullmatch(code)]
            if found["type"] in ("type", "class") and "\n    Parameters\n" not in found["docstring"]:
                # Only pkmodes creates it: the docstring has its attributes.
                problems = [text for text in problems if not text.startswith("PR01")]
            assert name.startswith(ENGINE) or not problems, "\n".join(problems)


def test_the_examples_print_what_they_say(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.chdir(ROOT)
    modules = {inspect.getmodule(thing) for _, thing in (*public(), *named_in(ATTACHED))} | {
        inspect.getmodule(pkmodes.Model.check)
    }
    found = [doctest.testmod(module) for module in modules]
    assert sum(one.attempted for one in found) >= 14
    assert not sum(one.failed for one in found)


def test_the_pages_list_every_public_name_once() -> None:
    named: list[str] = []
    for page in (ROOT / "docs/reference/api").glob("*.md"):
        module = ""
        for kind, argument in re.findall(
            r"^\.\. (\w+):: ([\w.]+)$", page.read_text(encoding="utf-8"), re.MULTILINE
        ):
            module = argument if kind == "currentmodule" else module
            if kind.startswith("auto"):
                named.append(argument if "." in argument else f"{module}.{argument}")
    assert len(named) == len({*named})
    assert {name for name, _ in public()} <= {*named}
    for name in {*named} - {name for name, _ in public()}:
        assert name.count(".") > 1, f"{name}: neither public nor named with its module"
