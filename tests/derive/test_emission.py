"""Emitted code: the same bytes on every run, the same numbers in every language, no name clashes."""

from __future__ import annotations

import ast
import hashlib
import json
import os
import re
import subprocess
import sys
from pathlib import Path

import pytest

from helpers.generated.emission import Emission
from pkmodes.codegen.generation import specification
from pkmodes.core.robot.reading import read_robot
from pkmodes_derive import kept, mechanisms
from pkmodes_derive.emit import layout, product
from pkmodes_derive.emit.program import arrange
from pkmodes_derive.emit.specification import Specification

ROOT = Path(__file__).parents[2]
ROBOT = ROOT / "robots" / "linear-delta-2022.toml"
MODEL = mechanisms.base("linear_delta")
DIGEST = """
import hashlib, json, sys
from pathlib import Path
from pkmodes.codegen.generation import specification
from pkmodes.core.robot.reading import read_robot
from pkmodes_derive import mechanisms
from pkmodes_derive.emit import latex, product
texts = dict(product.parametric("linear_delta"))
robot = read_robot(sys.argv[1])
texts.update({f"robot/{k}": v for k, v in product.specialised(specification(robot, "robot.toml")).items()})
texts["latex"] = latex.page(mechanisms.base("linear_delta"))
print(hashlib.sha256(json.dumps(texts, sort_keys=True).encode()).hexdigest())
"""


@pytest.fixture(scope="module")
def texts(emission: Emission) -> dict[str, str]:
    return emission.parametric("linear_delta")


@pytest.mark.slow
def test_output_does_not_depend_on_the_hash_seed(emission: Emission) -> None:
    """Nor on that of the process that emitted for all tests, or of the committed code, which are any."""
    path = os.pathsep.join(str(ROOT / part) for part in ("src", "generated", "derive"))
    run = subprocess.Popen(
        [sys.executable, "-c", DIGEST, str(ROBOT)],
        # Nothing that another process has derived: no folder for it.
        env={**os.environ, "PYTHONHASHSEED": "4242", "PYTHONPATH": path, kept.FOLDER_VARIABLE: ""},
        stdout=subprocess.PIPE,
    )
    robot = read_robot(ROBOT)
    here = dict(emission.parametric("linear_delta"))
    here |= {f"robot/{k}": v for k, v in product.specialised(specification(robot, "robot.toml")).items()}
    here["latex"] = emission.page("linear_delta")
    digest = hashlib.sha256(json.dumps(here, sort_keys=True).encode()).hexdigest()
    assert (run.communicate()[0].decode(), run.returncode) == (f"{digest}\n", 0)


def test_committed_code_is_current(texts: dict[str, str]) -> None:
    folder = ROOT / "generated" / "pkmodes_generated" / "linear_delta"
    for name, text in texts.items():
        assert (folder / name).read_bytes() == text.encode("utf-8"), f"{name}: run `make generate`"


@pytest.mark.parametrize("name", mechanisms.names())
def test_the_derivation_pages_are_current(emission: Emission, name: str) -> None:
    page = emission.page(name).encode("utf-8")
    assert (ROOT / "docs" / "derivation" / f"{name}.md").read_bytes() == page, "run `make derivation`"


def test_the_derivation_page_shows_every_function_and_every_named_value(emission: Emission) -> None:
    page = emission.page("linear_delta")
    for function in MODEL.functions:
        assert f"### {function.name}\n" in page
        for output in function.outputs:
            assert f"`{output.name}` [{output.unit}]" in page
        for symbol in function.definitions:
            family = MODEL.vocabulary[symbol].family
            assert f"\n`{family.name}` [{family.unit}]: {family.description}\n\n```math\n" in page


def test_generated_files_hold_no_date_host_path_or_carriage_return(texts: dict[str, str]) -> None:
    for name, text in texts.items():
        assert "\r" not in text
        assert str(ROOT) not in text
        assert text.endswith("\n")
        # A sentence or a command is one string, which JSON cannot break.
        assert name.endswith(".json") or max(map(len, text.splitlines())) <= layout.WIDTH


def test_programs_define_before_use_and_use_what_they_define(subtests: pytest.Subtests) -> None:
    for function in MODEL.functions:
        with subtests.test(function.name):
            program = arrange(function)
            known = set(program.inputs)
            used = set()
            for symbol, expression in program.steps:
                assert expression.free_symbols <= known, symbol
                assert symbol not in known, f"{symbol} is assigned twice"
                known.add(symbol)
                used |= expression.free_symbols
            for result in program.results:
                for entry in result.entries:
                    assert entry.value.free_symbols <= known
                    used |= entry.value.free_symbols
            assert {symbol for symbol, _ in program.steps} <= used, "a value is computed and not used"


def test_names_in_c_do_not_shadow_each_other(subtests: pytest.Subtests) -> None:
    for function in MODEL.functions:
        with subtests.test(function.name):
            arguments = (
                [a.name for a in function.arguments] + [o.name for o in function.outputs] + ["parameters"]
            )
            assert len(set(arguments)) == len(arguments)
            program = arrange(function)
            symbols = {s.name for s, _ in program.steps} | {s.name for s in program.inputs}
            scalars = {a.name for a in function.arguments if a.scalar}
            assert not symbols & (set(arguments) - scalars)


def test_operation_counts_have_not_grown(texts: dict[str, str]) -> None:
    """The baseline is changed only by hand: an increase in operations must be deliberate."""
    baseline = json.loads(Path(__file__).with_name("operation_counts.json").read_text(encoding="utf-8"))
    counts = {name: n["emitted"] for name, n in json.loads(texts["manifest.json"])["operations"].items()}
    assert counts.keys() == baseline.keys()
    assert {name: n for name, n in counts.items() if n > baseline[name]} == {}


def test_modal_matrices_stay_below_a_third_of_the_trial_derivation() -> None:
    """1,900 operations for M_ss and the gravity Hessian alone was the figure to beat."""
    function = next(f for f in MODEL.functions if f.name == "modal_matrices")
    assert arrange(function).operations < 600


def test_generated_module_parses_and_imports_only_numpy(texts: dict[str, str]) -> None:
    tree = ast.parse(texts["model.py"])
    imports = {a.name for node in ast.walk(tree) if isinstance(node, ast.Import) for a in node.names}
    modules = {node.module for node in ast.walk(tree) if isinstance(node, ast.ImportFrom)}
    assert imports == {"numpy"}
    assert modules == {"math", "typing"}


def test_every_generated_function_documents_shapes_units_and_source(texts: dict[str, str]) -> None:
    tree = ast.parse(texts["model.py"])
    functions = [n for n in tree.body if isinstance(n, ast.FunctionDef) and not n.name.startswith("_")]
    assert len(functions) == len(MODEL.functions)
    for function in functions:
        text = ast.get_docstring(function) or ""
        assert "Parameters\n----------" in text
        assert "Returns\n-------" in text
        assert "shape (...)" in text or "shape (..., " in text
        assert "operations" in text


def test_no_step_is_another_name_for_a_value(subtests: pytest.Subtests) -> None:
    for function in MODEL.functions:
        with subtests.test(function.name):
            for symbol, expression in arrange(function).steps:
                assert not expression.is_Symbol, symbol
                assert not expression.is_number, symbol


def test_of_a_symmetric_matrix_each_value_is_evaluated_once(texts: dict[str, str]) -> None:
    for function in MODEL.functions:
        for result in arrange(function).results:
            places = [place for entry in result.entries for place in entry.places]
            assert len(set(places)) == len(places)
            if result.output.symmetric:
                assert {(*first, row, column) for *first, column, row in places} == set(places)
                assert all(e.places[0][-2] <= e.places[0][-1] for e in result.entries)
    stiffness = next(f for f in MODEL.functions if f.name == "stiffness_matrix")
    assert stiffness.outputs[0].symmetric
    assert "    K_out[..., 0, 3] = K_out[..., 3, 0] = -R_p_1*k_1_3\n" in texts["model.py"]
    assert "    K[0][3] = K[3][0] = -R_p_1*k_1_3;\n" in texts["linear_delta.c"]


def test_structural_zeros_are_written_at_once(texts: dict[str, str]) -> None:
    assert "    memset(K, 0, sizeof(pkmodes_real[9][9]));\n" in texts["linear_delta.c"]
    for name in ("linear_delta.c", "linear_delta_extended.c"):
        emitted = texts[name].split("/* Rounding, ")[0]
        assert not re.search(r" = 0(\.0)?;$", emitted, flags=re.MULTILINE)
        assert set(re.findall(r"#include <(.*)>", texts[name])) <= {"math.h", "stddef.h", "string.h"}


def test_the_glossary_has_one_entry_for_a_family(texts: dict[str, str]) -> None:
    for text in (texts["model.py"], texts["extended.py"]):
        glossary = re.findall(r"^\* (\w+) \[", ast.get_docstring(ast.parse(text)) or "", flags=re.MULTILINE)
        assert len(set(glossary)) == len(glossary)
        assert len(glossary) < 40
    assert "* X_by_Y [unit of X / unit of Y]: derivative of X with respect to" in texts["extended.py"]
    assert "* k_j_s [N/m]: stiffness of span s of belt j" in texts["model.py"]


def test_long_assignments_are_broken_before_operators() -> None:
    expression = " + ".join(f"term_{i}*factor_{i}" for i in range(12))
    lines = layout.assignment("target", expression, "    ", parentheses=True)
    assert lines[0] == "    target = ("
    assert all(len(line) <= layout.WIDTH for line in lines)
    assert "".join(line.strip() for line in lines[1:-1]).replace(" ", "") == expression.replace(" ", "")
    assert all(line.strip()[0] in "t+" for line in lines[1:-1])


def test_robot_names_become_identifiers() -> None:
    def identifier(name: str) -> str:
        return Specification(name, "linear_delta", "robot.toml", {}, {}).identifier

    assert identifier("linear-delta-2022") == "linear_delta_2022"
    assert identifier("3-axis printer") == "robot_3_axis_printer"
    assert identifier("class") == "robot_class"
    assert identifier("Δ/../x") == "x"
    assert identifier("***") == "robot"


def test_manifest_digests_are_those_of_the_outputs(texts: dict[str, str]) -> None:
    manifest = json.loads(texts["manifest.json"])
    for name, digest in manifest["outputs"].items():
        assert hashlib.sha256(texts[name].encode()).hexdigest() == digest
    assert set(manifest["outputs"]) == set(texts) - {"manifest.json"}
    assert "chain.py" in manifest["sources"]
    assert "emit/numpy/module.py.j2" in manifest["sources"]


def test_every_generated_source_says_where_it_comes_from(texts: dict[str, str]) -> None:
    for name in ("model.py", "linear_delta.c", "linear_delta.h"):
        head = "\n".join(texts[name].splitlines()[:4])
        for words in (
            "Generated from the derivation of linear_delta",
            "SymPy 1.",
            "Do not edit: regenerate with",
        ):
            assert words in head, name


def test_the_derivation_page_shows_the_second_route(emission: Emission) -> None:
    page = emission.page("linear_delta")
    assert len(MODEL.relations) >= 6
    for relation in MODEL.relations:
        assert relation.description in page


def test_rigid_modes_are_the_nullity_of_the_elastic_hessian(texts: dict[str, str]) -> None:
    """Three axes, each free to move with its belt; an exact rank at unrelated values."""
    assert MODEL.rigid_modes == 3
    assert "RIGID_MODES = 3\n" in texts["model.py"]
