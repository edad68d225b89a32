"""What was derived before is found again, and only where nothing that it depends on has changed."""

from __future__ import annotations

import sys
from collections.abc import Callable
from pathlib import Path

import pytest
import sympy

from helpers.commands.adding_a_mechanism import DEFINITION
from pkmodes_derive import mechanisms, sources
from pkmodes_derive.emit import product
from pkmodes_derive.kept import FOLDER_VARIABLE, derive_once, digest_of

X, Y = sympy.symbols("x y", real=True)


@pytest.fixture
def folder(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    monkeypatch.setenv(FOLDER_VARIABLE, str(tmp_path / "derived"))
    return tmp_path / "derived"


def refused(*_: object) -> object:
    raise AssertionError("derived again")


@pytest.mark.usefixtures("folder")
def test_what_is_found_is_what_was_derived() -> None:
    assert derive_once("sum", "a", lambda: X + 2 * Y) == X + 2 * Y
    assert derive_once("sum", "a", refused) == X + 2 * Y


def change_a_source(monkeypatch: pytest.MonkeyPatch) -> None:
    digests = {**sources.source_digests(), "chain.py": "0" * 64}
    monkeypatch.setattr(sources, "source_digests", lambda: digests)


CHANGES: dict[str, Callable[[pytest.MonkeyPatch], None]] = {
    "a source": change_a_source,
    "SymPy": lambda monkeypatch: monkeypatch.setattr(sympy, "__version__", "1.0"),
    "Python": lambda monkeypatch: monkeypatch.setattr(sys, "version", "3.0"),
}


@pytest.mark.usefixtures("folder")
@pytest.mark.parametrize("change", CHANGES)
def test_it_is_derived_again_after_a_change(change: str, monkeypatch: pytest.MonkeyPatch) -> None:
    assert derive_once("sum", "a", lambda: "before") == "before"
    CHANGES[change](monkeypatch)
    assert derive_once("sum", "a", lambda: "after") == "after"


@pytest.mark.usefixtures("folder")
def test_results_are_told_apart_by_their_kind_and_by_what_they_are_derived_from() -> None:
    values = {(what, of): f"{what} of {of}" for what in ("sum", "product") for of in ("a", ("a", "b"), None)}
    for (what, of), value in values.items():
        assert derive_once(what, of, lambda value=value: value) == value
    for (what, of), value in values.items():
        assert derive_once(what, of, refused) == value


def test_what_fails_is_not_kept(folder: Path) -> None:
    with pytest.raises(AssertionError, match="derived again"):
        derive_once("sum", "a", refused)
    assert not folder.exists()
    assert derive_once("sum", "a", lambda: 1) == 1


def test_without_a_folder_nothing_is_kept(folder: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setenv(FOLDER_VARIABLE, "")
    assert [derive_once("sum", "a", lambda value=value: value) for value in (1, 2)] == [1, 2]
    assert not folder.exists()


def test_the_digest_of_expressions_is_that_of_their_parts_not_of_their_sharing() -> None:
    part, again = ((sympy.sin(X), Y) for _ in range(2))
    assert part is not again
    assert digest_of((part, part)) == digest_of((part, again))
    assert digest_of((part, X)) != digest_of((part, Y))
    assert digest_of(X) != digest_of(sympy.Symbol("x")), "assumptions tell symbols apart"


@pytest.mark.usefixtures("folder")
def test_products_of_another_definition_of_the_same_name_are_derived(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(mechanisms, "_added", {})

    def derived(definition: str) -> dict[str, str]:
        mechanisms.add("kept_one", definition, "kept_one.py")
        return product.parametric("kept_one", "kept_one.py")

    other = DEFINITION.replace('TITLE = "', 'TITLE = "another ')
    first = derived(DEFINITION)
    assert derived(other) != first
    monkeypatch.setattr(product, "arrange", refused)
    assert derived(DEFINITION) == first
