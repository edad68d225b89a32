"""Expressions in every language: exact numbers, correct function names, no functions that a language lacks."""

from __future__ import annotations

import ctypes
import subprocess
from collections.abc import Mapping
from pathlib import Path

import numpy as np
import pytest
from sympy import (
    Abs,
    Expr,
    Float,
    Integer,
    Rational,
    Symbol,
    acos,
    asin,
    atan,
    atan2,
    besselj,
    cos,
    diff,
    exp,
    lambdify,
    log,
    pi,
    sign,
    sin,
    sqrt,
    sstr,
    symbols,
    tan,
)
from sympy.printing.codeprinter import PrintMethodNotImplementedError

from helpers.generated.compiled import COMPILER, FLAGS
from helpers.generated.emission import Emission
from pkmodes_derive import emit
from pkmodes_derive.emit import product
from pkmodes_derive.emit.backend import Backend
from pkmodes_derive.emit.c99 import printer as c99
from pkmodes_derive.emit.identity import digest
from pkmodes_derive.emit.numpy import printer as numpy
from pkmodes_derive.emit.program import Program
from pkmodes_derive.emit.provenance import Provenance
from pkmodes_derive.emit.registry import BACKENDS
from pkmodes_derive.functions import Argument, Function, Model, Output
from pkmodes_derive.specialise import number
from pkmodes_derive.vocabulary import Vocabulary

a, b = symbols("a b", real=True)
#: Functions of a and b in (-1, 1): those that closures of mechanisms with arms need, and more.
EXPRESSIONS: dict[str, Expr] = {
    "sine_and_cosine": sin(a) * cos(b),
    "arm": atan2(a, b) + acos(a * b),
    "angle": atan2(b * sin(a), Rational(1, 2) - a),
    "inverse": asin(a) - atan(b),
    "others": exp(a) * log(2 + b) + tan(a),
    "powers": (2 + a) ** Rational(3, 2) / sqrt(2 + b) + pi * a**3,
}
PROVENANCE = Provenance("sample", "sample", "A sample.", "a test", "pytest", "pytest", constants=("none",))
VALUES = [(0.3, -0.7), (-0.4, 0.2), (-0.6, -0.5), (0.8, 0.1)]


def model() -> Model:
    vocabulary = Vocabulary()
    x, y = (vocabulary.declare(name, "1", f"argument {name}", name) for name in "ab")
    arguments = (Argument("v", (x, y), "1", "both arguments"),)
    functions = tuple(
        Function(name, "A sample.", "made up for a test", arguments, (Output("r", (), (e,), "1", "it"),), {})
        for name, e in EXPRESSIONS.items()
    )
    return Model("sample", (("a", "1"),), vocabulary, (), functions)


@pytest.fixture(scope="module")
def texts() -> dict[str, str]:
    return product.write_models((model(), PROVENANCE))[0]


def test_numbers_are_printed_exactly() -> None:
    for value in (0.1, 1 / 3, 2.42e6, 1.7e-05, 0.16000000000000003):
        assert repr(value) in numpy.expression(Float(value) * a)
        assert f"R({value!r})" in c99.expression(Float(value) * a)
    assert number(10.0) == Integer(10)
    assert float(number(0.1)) == 0.1


def test_printers_avoid_library_calls_for_small_powers() -> None:
    assert c99.expression(a**2 + 1 / b) == "(a*a) + 1/b"
    assert c99.expression((a + b) ** 2) == "((a + b)*(a + b))"
    assert numpy.expression(sqrt(a) / b) == "np.sqrt(a)/b"
    assert c99.expression(Rational(1, 6) * a) == "(R(1.0)/R(6.0))*a"


@pytest.mark.parametrize(
    ("expression", "in_numpy", "in_c"),
    [
        (sin(a), "np.sin(a)", "R(sin)(a)"),
        (cos(a), "np.cos(a)", "R(cos)(a)"),
        (tan(a), "np.tan(a)", "R(tan)(a)"),
        (acos(a), "np.arccos(a)", "R(acos)(a)"),
        (asin(a), "np.arcsin(a)", "R(asin)(a)"),
        (atan2(a, b), "_arctan2(a, b)", "R(atan2)(a, b)"),
        (Abs(a), "np.abs(a)", "R(fabs)(a)"),
        (sign(a), "np.sign(a)", "(pkmodes_real)(((a) > 0) - ((a) < 0))"),
        (1 / sqrt(a), "1.0/np.sqrt(a)", "1/R(sqrt)(a)"),
        (pi * a, "np.pi*a", "R(3.141592653589793)*a"),
        (sqrt(2) * a, "np.sqrt(2)*a", "R(sqrt)(2)*a"),
    ],
)
def test_functions_have_the_names_of_the_language(expression: Expr, in_numpy: str, in_c: str) -> None:
    assert numpy.expression(expression) == in_numpy
    assert c99.expression(expression) == in_c


@pytest.mark.parametrize("backend", BACKENDS, ids=lambda backend: backend.name)
def test_an_unknown_function_is_refused(backend: Backend) -> None:
    with pytest.raises(PrintMethodNotImplementedError):
        backend.printer(besselj(1, a))


@pytest.mark.parametrize("backend", BACKENDS, ids=lambda backend: backend.name)
def test_every_language_prints_what_mechanisms_need(backend: Backend) -> None:
    for expression in EXPRESSIONS.values():
        assert "a" in backend.printer(expression)


def test_a_folder_with_a_back_end_is_registered_once() -> None:
    folder = Path(emit.__file__).parent
    defined = {init.parent.name for init in folder.glob("*/__init__.py") if "BACKEND = " in init.read_text()}
    assert defined == {backend.printer.__module__.split(".")[-2] for backend in BACKENDS}
    assert len({backend.name for backend in BACKENDS}) == len(BACKENDS) == len(defined)


def test_another_back_end_is_one_entry(monkeypatch: pytest.MonkeyPatch) -> None:
    """It prints the programs of all languages, and knows the digest of the C source."""

    def files(model: Model, programs: Mapping[str, Program], provenance: Provenance) -> dict[str, str]:
        lines = [
            f"{name} = {sstr(entry.value)}" for name, p in programs.items() for entry in p.results[0].entries
        ]
        return {f"{provenance.name}.txt": "\n".join([provenance.identity.digest, *lines])}

    before, _ = product.write_models((model(), PROVENANCE))
    monkeypatch.setattr(product, "BACKENDS", (Backend("text", sstr, model=files), *BACKENDS))
    after, _ = product.write_models((model(), PROVENANCE))
    text = after.pop("sample.txt")
    assert text.splitlines()[0] == digest(before["sample.c"])
    assert all(f"\n{name} = " in text for name in EXPRESSIONS)
    assert after == before


def executed(texts: dict[str, str]) -> dict:
    module: dict = {}
    exec(compile(texts["sample.py"], "sample.py", "exec"), module)
    return module


@pytest.mark.parametrize("name", EXPRESSIONS)
def test_numpy_functions_take_batches_and_complex_steps(texts: dict[str, str], name: str) -> None:
    function, expression = executed(texts)[name], EXPRESSIONS[name]
    expected = [float(expression.evalf(30, subs={a: x, b: y})) for x, y in VALUES]
    np.testing.assert_allclose(function(VALUES), expected, rtol=1e-14)
    assert function(VALUES[0]) == pytest.approx(expected[0], rel=1e-14)
    for i, variable in enumerate((a, b)):
        step = np.array(VALUES, complex)
        step[:, i] += 1e-40j
        rates = [float(diff(expression, variable).evalf(30, subs={a: x, b: y})) for x, y in VALUES]
        np.testing.assert_allclose(function(step).imag / 1e-40, rates, rtol=1e-13, atol=1e-15)
        np.testing.assert_allclose(function(step).real, expected, rtol=1e-14)


def test_only_what_needs_it_has_the_function_for_complex_angles(
    texts: dict[str, str], emission: Emission
) -> None:
    assert texts["sample.py"].count("def _arctan2(y, x):") == 1
    assert "_arctan2" not in emission.parametric("linear_delta")["model.py"]


@pytest.mark.compiler
def test_c_gives_the_same(texts: dict[str, str], tmp_path: Path) -> None:
    for file, text in texts.items():
        (tmp_path / file).write_text(text, encoding="utf-8")
    library = tmp_path / "sample.so"
    assert COMPILER is not None
    subprocess.run([COMPILER, *FLAGS, str(tmp_path / "sample.c"), "-o", str(library), "-lm"], check=True)
    loaded = ctypes.CDLL(str(library))
    for name, expression in EXPRESSIONS.items():
        for x, y in VALUES:
            result = ctypes.c_double()
            getattr(loaded, f"sample_{name}")((ctypes.c_double * 2)(x, y), ctypes.byref(result))
            assert result.value == pytest.approx(float(lambdify((a, b), expression, "math")(x, y)), rel=1e-14)


def test_no_name_is_without_its_module(texts: dict[str, str]) -> None:
    """SymPy prints bare names of functions unless told otherwise."""
    known = set(executed(texts))
    for line in texts["sample.py"].splitlines():
        for name in ("sin", "cos", "sqrt", "atan2", "acos", "pi", "math"):
            assert f" {name}(" not in line, line
    assert "math" not in known


def test_symbols_are_printed_as_they_are() -> None:
    s = Symbol("theta_1_2_st", real=True)
    assert numpy.expression(-s) == c99.expression(-s) == "-theta_1_2_st"
