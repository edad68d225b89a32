"""Docstrings of all functions and classes, private ones too: what they document exists, and is documented once."""

from __future__ import annotations

import ast
import inspect
import re
from collections.abc import Iterator, Sequence
from functools import cache
from pathlib import Path

import pytest

ROOT = Path(__file__).parents[1]
FOLDERS = ("src/pkmodes", "tests/pkmodes_rig", "tests/studies", "derive")
#: Bases without fields of their own.
PLAIN = {"object", "ABC", "Protocol", "Generic", "NamedTuple", "TypedDict", "Struct", "Enum", "Exception"}
Function = ast.FunctionDef | ast.AsyncFunctionDef
Definition = Function | ast.ClassDef


def section(docstring: str, title: str) -> list[str]:
    """Return the names that a section of numpydoc documents."""
    lines = inspect.cleandoc(docstring).splitlines()
    names: list[str] = []
    for start, line in enumerate(lines[:-1]):
        if line == title and lines[start + 1] == "-" * len(title):
            for k in range(start + 2, len(lines)):
                if k + 1 < len(lines) and re.fullmatch("-{3,}", lines[k + 1]):
                    break
                if lines[k][:1] not in ("", " "):
                    names += [name.strip(" *`") for name in lines[k].split(" :")[0].split(",")]
    return names


def lists(docstring: str) -> list[list[str]]:
    """Return the names in each list of parameters or attributes, ``- name: meaning``; those of results are others."""
    found: list[list[str]] = []
    before, results = "", False
    for line in inspect.cleandoc(docstring).splitlines():
        item = re.match(r"- ([*\w]+(?:, [*\w]+)*): ", line)
        if not line.startswith(("- ", "  ")):
            results = bool(re.match(r"(Returns|Yields)\b.*:$", line))
        if item and not results:
            if not before.startswith(("- ", "  ")):
                found.append([])
            found[-1] += [name.strip("*") for name in item[1].split(", ")]
        before = line
    return found


def arguments(function: Function) -> set[str]:
    """Return the names of a function's parameters."""
    given = function.args
    plain = [*given.posonlyargs, *given.args, *given.kwonlyargs]
    return {one.arg for one in [*plain, *filter(None, (given.vararg, given.kwarg))]}


def methods(definition: ast.ClassDef) -> list[Function]:
    return [node for node in definition.body if isinstance(node, Function)]


def constructed(definition: ast.ClassDef) -> set[str]:
    """Return what the constructor of a class takes: the parameters of its own, or its annotated fields."""
    for method in methods(definition):
        if method.name in ("__init__", "__new__"):
            return arguments(method)
    return {
        node.target.id
        for node in definition.body
        if isinstance(node, ast.AnnAssign) and isinstance(node.target, ast.Name)
    }


def attributes(definition: ast.ClassDef) -> set[str]:
    """Return what instances of a class have: fields, methods and properties, and what any method assigns."""
    names = constructed(definition) | {method.name for method in methods(definition)}
    for node in ast.walk(definition):
        if isinstance(node, ast.Attribute) and isinstance(node.ctx, ast.Store):
            names.add(node.attr)
    assigned = [node for node in definition.body if isinstance(node, ast.Assign)]
    return names | {target.id for node in assigned for target in node.targets if isinstance(target, ast.Name)}


@cache
def definitions(folder: str) -> list[tuple[str, Definition]]:
    """Return the functions and classes below a folder with their places."""
    return [
        (f"{path.relative_to(ROOT)}:{node.lineno} {node.name}", node)
        for path in sorted((ROOT / folder).rglob("*.py"))
        for node in ast.walk(ast.parse(path.read_text(encoding="utf-8")))
        if isinstance(node, Definition)
    ]


@cache
def classes() -> dict[str, list[ast.ClassDef]]:
    named: dict[str, list[ast.ClassDef]] = {}
    for folder in FOLDERS:
        for _, node in definitions(folder):
            if isinstance(node, ast.ClassDef):
                named.setdefault(node.name, []).append(node)
    return named


def line_of(definition: ast.ClassDef) -> list[ast.ClassDef] | None:
    """Return a class and its bases; None if some base is not defined here."""
    line = [definition]
    for base in definition.bases:
        name = ast.unparse(base).partition("[")[0].rpartition(".")[2]
        if name in PLAIN:
            continue
        inherited = [one for known in classes().get(name, []) if (one := line_of(known))]
        if not inherited:
            return None
        line += [each for one in inherited for each in one]
    return line


def problems(definition: Definition) -> Iterator[str]:
    """Yield what the sections and lists of a docstring name without reason, or twice."""
    docstring = ast.get_docstring(definition)
    if docstring is None:
        return
    sections = {title: section(docstring, title) for title in ("Parameters", "Attributes")}
    listed = lists(docstring)
    for title, names in (*sections.items(), *(("List", names) for names in listed)):
        for name in sorted({name for name in names if names.count(name) > 1}):
            yield f"{title}: {name} is there twice"
    if isinstance(definition, ast.ClassDef):
        line = line_of(definition)
        if line is None:
            return
        known = {
            "Parameters": {name for one in line for name in constructed(one)},
            "Attributes": {name for one in line for name in attributes(one)},
        }
    else:
        known = {"Parameters": arguments(definition), "Attributes": set()}
    for title, names in sections.items():
        yield from (f"{title}: there is no {name}" for name in names if name not in known[title])
    either = known["Parameters"] | known["Attributes"]
    yield from (f"List: there is no {name}" for names in listed for name in names if name not in either)


@pytest.mark.parametrize("folder", FOLDERS)
def test_what_a_docstring_documents_exists(folder: str) -> None:
    wrong = [f"{place}: {problem}" for place, node in definitions(folder) for problem in problems(node)]
    assert not wrong, "\n".join(wrong)
    documented = [
        node for _, node in definitions(folder) if "\n    ----" in (ast.get_docstring(node, False) or "")
    ]
    assert len(documented) > 10, "the check reads the sections"


@pytest.mark.parametrize(
    ("source", "expected"),
    [
        (
            "def f(a, *b):\n    '''S.\n\n    Parameters\n    ----------\n    a, *b : int\n        X.\n    '''",
            [],
        ),
        ("def f(a):\n    '''S.\n\n    Parameters\n    ----------\n    c : int\n    '''", ["there is no c"]),
        (
            "def f(a):\n    '''S.\n\n    Parameters\n    ----------\n    a : int\n    a : int\n    '''",
            ["twice"],
        ),
        (
            "class A:\n    '''S.\n\n    Attributes\n    ----------\n    c : int\n    '''\n    a: int",
            ["there is no c"],
        ),
        ("class A:\n    '''S.\n\n    Attributes\n    ----------\n    c : int\n    '''\n    c: int", []),
        ("def f(a, b, *c):\n    '''S.\n\n    - a, b: x: y,\n      z: w\n    - *c: v\n    '''", []),
        ("def f(a):\n    '''S.\n\n    - a: x\n    - c: y\n    '''", ["there is no c"]),
        ("def f(a):\n    '''S.\n\n    - a: x\n      y\n    - a: z\n    '''", ["twice"]),
        (
            "def f(a):\n    '''S.\n\n    - a: x\n\n    Returns, in this order:\n    - b: y\n    - c: w\n    '''",
            [],
        ),
        ("class A:\n    '''S.\n\n    - a: x\n\n    Its attributes:\n    - a: y\n    '''\n    a: int", []),
        ("class A:\n    '''S.\n\n    - c: x\n    '''\n    a: int", ["there is no c"]),
    ],
)
def test_the_check_finds_what_it_is_for(source: str, expected: Sequence[str]) -> None:
    definition = ast.parse(source).body[0]
    assert isinstance(definition, Definition)
    found = list(problems(definition))
    assert len(found) == len(expected)
    assert all(part in text for part, text in zip(expected, found, strict=True))
