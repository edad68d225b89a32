"""Allowed imports between packages, and the cost of ``import pkmodes``."""

from __future__ import annotations

import ast
import os
import re
import subprocess
import sys
import tomllib
from importlib import import_module
from pathlib import Path

import pytest

from pkmodes import names
from pkmodes.api import APPLICATIONS

ROOT = Path(__file__).parents[1]
STANDARD = sys.stdlib_module_names
#: Parts of the runtime that may import the derivation, and only inside functions.
BRIDGE = {"src/pkmodes/codegen/derivation.py"}
#: Parts that load modules of a mechanism by name.
BY_MECHANISM = {
    "src/pkmodes/core/mechanism/described.py",
    "src/pkmodes/core/mechanism/packages.py",
    "src/pkmodes/codegen/checking/consistency.py",
}
#: What loads the functions that applications attach to classes of the core, and packages by their public names.
ATTACHES = {"src/pkmodes/core/base/attached.py", "src/pkmodes/names.py"}


def imports(file: Path, *, top_level_only: bool = False) -> set[str]:
    tree = ast.parse(file.read_text(encoding="utf-8"))
    nodes = list(tree.body) if top_level_only else list(ast.walk(tree))
    found = set()
    for node in nodes:
        if isinstance(node, ast.Import):
            found |= {alias.name.split(".")[0] for alias in node.names}
        elif isinstance(node, ast.ImportFrom) and node.level == 0:
            found.add((node.module or "").split(".")[0])
    return found - STANDARD


def files(folder: str) -> list[Path]:
    found = sorted((ROOT / folder).rglob("*.py"))
    assert found
    return found


#: Code that is copied into generated modules, not executed by the derivation.
COPIED = ROOT / "derive/pkmodes_derive/emit/numpy/eigen.py"


def test_the_derivation_imports_sympy_jinja_and_the_description_only() -> None:
    assert imports(COPIED) == {"numpy"}
    for file in files("derive"):
        assert file == COPIED or imports(file) <= {
            "pkmodes_derive",
            "pkmodes_description",
            "sympy",
            "jinja2",
        }, file
        assert "emit.numpy.eigen" not in file.read_text(encoding="utf-8"), file


def test_the_description_imports_msgspec_only() -> None:
    for file in files("src/pkmodes_description"):
        assert imports(file) <= {"pkmodes_description", "msgspec"}, file


def test_generated_code_imports_numpy_only() -> None:
    for file in files("generated"):
        assert imports(file) <= {"numpy", "pkmodes_generated"}, file


def test_the_runtime_reaches_the_derivation_through_one_module() -> None:
    for file in files("src/pkmodes"):
        text = file.read_text(encoding="utf-8")
        name = file.relative_to(ROOT).as_posix()
        assert "sympy" not in imports(file), name
        if name not in BRIDGE:
            assert "pkmodes_derive" not in imports(file), name
        else:
            assert "pkmodes_derive" not in imports(file, top_level_only=True), name
            assert "pkmodes_derive" in text


def test_only_the_bridge_and_the_mechanisms_are_imported_by_name() -> None:
    for file in files("src/pkmodes"):
        if file.relative_to(ROOT).as_posix() not in BRIDGE | BY_MECHANISM | ATTACHES:
            nodes = list(ast.walk(ast.parse(file.read_text(encoding="utf-8"))))
            names = {node.id for node in nodes if isinstance(node, ast.Name)}
            names |= {node.name for node in nodes if isinstance(node, ast.alias)}
            names |= {node.module for node in nodes if isinstance(node, ast.ImportFrom)}
            assert not names & {"import_module", "__import__", "importlib"}, file


def test_the_runtime_is_light_to_import() -> None:
    """Slow imports are deferred until needed: SymPy for generating, pint for reading units."""
    code = "import sys, pkmodes; pkmodes.load; print(sorted({m.split('.')[0] for m in sys.modules}))"
    path = os.pathsep.join(str(ROOT / part) for part in ("src", "generated", "derive"))
    run = subprocess.run(
        [sys.executable, "-c", code],
        env={**os.environ, "PYTHONPATH": path},
        capture_output=True,
        text=True,
        check=True,
    )
    loaded = set(ast.literal_eval(run.stdout))
    assert "numpy" in loaded
    assert not loaded & {"sympy", "jinja2", "pint", "click", "rich", "scipy", "pkmodes_derive"}


#: The core, from the ground up: each imports itself and those before it.
CORE = ("base", "linalg", "mechanism", "robot", "compiled", "system", "solve", "model", "support")
#: Of the diagnosis likewise.
DIAGNOSIS_PARTS = (
    "problem",
    "criteria",
    "structure",
    "matrices",
    "arguments",
    "match",
    "fit",
    "search",
    "readings",
    "posterior",
    "verdict",
    "damping",
    "beyond",
    "one_state",
    "states",
    "diagnose",
    "compare",
    "update",
)
#: The rooms from the ground up, with their folders in the same order: each imports itself and those before it.
ROOMS = {
    "core": (),
    "codegen": (),
    "loop": ("robot_files", "measured", "diagnosis", "sensitivity", "updating"),
    "modaltest": ("identification", "signals", "campaign"),
    "machine": ("dataset", "shaping", "response", "maps"),
    "pages": ("view", "plots", "figures", "report"),
    "cli": (),
}
#: Which rooms a room knows: an arrow is an entry here.
KNOWS = {
    "core": (),
    "codegen": ("core",),
    "loop": ("core",),
    "modaltest": ("core", "loop"),
    "machine": ("core", "loop", "modaltest"),
    "pages": ("core", "loop", "modaltest", "machine"),
    "cli": ("core", "codegen", "loop", "modaltest", "machine", "pages"),
}
#: Modules beside the folders: names that users import, and the entry of the command line.
NAMES = {"__init__.py", "__main__.py", "api.py", "interrupts.py", "mechanism.py", "names.py"}
#: What the engine of the diagnosis may import besides itself: it knows no robots.
DIAGNOSIS = (
    "core.base",
    "core.linalg",
    "core.robot.columns",
    "core.support",
    "loop.measured",
    "loop.diagnosis",
)
#: Most lines of a module.
MOST = 400
#: Modules of one idea that is longer, most of it docstrings or a table: the evaluator of a robot, its fields, what a
#: mechanism declares.
LONG = {
    "src/pkmodes/core/model.py": 725,
    "src/pkmodes/core/solve/fields.py": 440,
    "src/pkmodes/loop/diagnosis/problem.py": 420,
    "src/pkmodes_description/structure.py": 450,
    "derive/pkmodes_derive/machine.py": 630,
    "derive/pkmodes_derive/parts.py": 440,
}


def modules_imported(file: Path) -> set[str]:
    """Names of the modules of the runtime that a file imports, inside functions and for type checkers too."""
    names = set()
    for node in ast.walk(ast.parse(file.read_text(encoding="utf-8"))):
        if isinstance(node, ast.Import):
            names |= {alias.name for alias in node.names}
        elif isinstance(node, ast.ImportFrom):
            assert node.level == 0, (file, "relative imports hide the floor")
            names |= {f"{node.module}.{alias.name}" for alias in node.names}
    return {name for name in names if name.split(".")[0] == "pkmodes"}


def test_every_folder_of_the_runtime_has_its_place() -> None:
    root = ROOT / "src/pkmodes"
    assert {file.name for file in root.glob("*.py")} == NAMES
    assert {file.parent.name for file in root.glob("*/__init__.py")} == set(ROOMS)
    for room, folders in ROOMS.items():
        if folders:
            assert {file.parent.name for file in (root / room).glob("*/__init__.py")} == set(folders)
    assert {room: folders for room, folders in ROOMS.items() if folders} == {
        room: packages for room, packages in names.ROOMS.items() if room != "core"
    }
    assert {
        file.stem if file.name != "__init__.py" else file.parent.name
        for file in [*(root / "core").glob("*.py"), *(root / "core").glob("*/__init__.py")]
    } == {"core", *CORE}
    assert all((file.parent / "__init__.py").is_file() for file in root.rglob("*.py"))


#: Folders of tests that are not named after folders of the runtime: of derive/, generated/ and the rig, and what
#: tests use.
BESIDE = {"derive", "generated", "rig", "golden", "helpers", "planar_pair", "pkmodes_rig", "studies"}


def test_tests_are_in_folders_with_the_names_of_what_they_test() -> None:
    folders = {
        folder.relative_to(ROOT / "tests").as_posix()
        for folder in (ROOT / "tests").rglob("*")
        if any(folder.glob("test_*.py"))
    }
    outside = {folder for folder in folders if folder.split("/")[0] not in BESIDE}
    assert {folder.split("/")[0] for folder in outside} == set(ROOMS)
    assert {folder for folder in outside if not (ROOT / "src/pkmodes" / folder).is_dir()} == {
        "codegen/own_mechanism"
    }
    assert (ROOT / "derive/pkmodes_derive/effects").is_dir()
    assert {folder for folder in folders if folder.split("/")[0] == "derive"} == {"derive", "derive/effects"}


def test_the_page_on_the_architecture_lists_the_folders_and_names_files_that_exist() -> None:
    page = (ROOT / "docs/explanation/architecture.md").read_text(encoding="utf-8")
    expected = [
        name for room, folders in ROOMS.items() for name in (room, *(f"{room}/{one}" for one in folders))
    ]
    listed = [
        name for name in re.findall(r"^\| `([\w/]+)/` \|", page, re.MULTILINE) if not name.startswith("core/")
    ]
    assert listed == expected
    assert re.findall(r"^\| `core/(\w+)(?:/|\.py)` \|", page, re.MULTILINE) == list(CORE)
    named = re.findall(r"`((?:src|derive|tests|docs)/[\w/.]+)`", page)
    assert len(named) > 15
    for name in named:
        assert (ROOT / name).exists(), name


@pytest.mark.parametrize("name", [*ROOMS, "loop/diagnosis"])
def test_the_readme_of_a_folder_names_files_that_exist(name: str) -> None:
    folder = ROOT / "src/pkmodes" / name
    named = re.findall(r"`([\w/]+\.py)`", (folder / "README.md").read_text(encoding="utf-8"))
    assert len(named) >= 6
    for name in named:
        assert (folder / name).is_file(), name


@pytest.mark.parametrize("room", ROOMS)
def test_a_room_imports_only_those_that_it_knows(room: str) -> None:
    assert list(KNOWS) == list(ROOMS)
    known = {room, *KNOWS[room]} | ({"api"} if room == "cli" else set())
    used = {name.split(".")[1] for file in files(f"src/pkmodes/{room}") for name in modules_imported(file)}
    assert used <= known
    assert used >= set(KNOWS[room]), "an arrow that nobody needs"


@pytest.mark.parametrize(
    ("room", "folder"), [(room, folder) for room, folders in ROOMS.items() for folder in folders]
)
def test_a_folder_of_a_room_imports_only_those_before_it(room: str, folder: str) -> None:
    before = set(ROOMS[room][: ROOMS[room].index(folder) + 1])
    for file in files(f"src/pkmodes/{room}/{folder}"):
        inside = (name.split(".") for name in modules_imported(file))
        assert {parts[2] for parts in inside if parts[1] == room} <= before, file


@pytest.mark.parametrize(
    ("folder", "part"),
    [*(("core", part) for part in CORE), *(("loop/diagnosis", part) for part in DIAGNOSIS_PARTS)],
)
def test_a_part_of_a_folder_imports_only_those_before_it(folder: str, part: str) -> None:
    parts = {"core": CORE, "loop/diagnosis": DIAGNOSIS_PARTS}[folder]
    before = set(parts[: parts.index(part) + 1])
    found = ROOT / "src/pkmodes" / folder / part
    for file in sorted(found.rglob("*.py")) or [found.with_suffix(".py")]:
        inside = (name.split(".") for name in modules_imported(file))
        place = folder.split("/")
        used = {parts[len(place) + 1] for parts in inside if parts[1 : len(place) + 1] == place}
        assert used <= before, file


def test_every_part_of_the_diagnosis_has_its_place() -> None:
    found = (ROOT / "src/pkmodes/loop/diagnosis").iterdir()
    named = {one.stem for one in found if one.suffix == ".py" or (one / "__init__.py").is_file()}
    assert named == {*DIAGNOSIS_PARTS, "__init__"}


def test_the_engine_of_the_diagnosis_knows_no_robots() -> None:
    allowed = tuple(f"pkmodes.{name}." for name in DIAGNOSIS)
    for file in files("src/pkmodes/loop/diagnosis"):
        assert all(f"{name}.".startswith(allowed) for name in modules_imported(file)), file


def test_type_checkers_see_the_functions_that_are_attached() -> None:
    tree = ast.parse((ROOT / "src/pkmodes/api.py").read_text(encoding="utf-8"))
    (model,) = (node for node in tree.body if isinstance(node, ast.ClassDef))
    imported = {
        alias.name: f"{node.module}:{alias.name}"
        for node in ast.walk(tree)
        if isinstance(node, ast.ImportFrom)
        for alias in node.names
    }
    seen = {
        node.targets[0].id: imported[node.value.id]
        for node in ast.walk(model)
        if isinstance(node, ast.Assign)
        and isinstance(node.targets[0], ast.Name)
        and isinstance(node.value, ast.Name)
    }
    assert seen == APPLICATIONS


def test_packages_are_imported_without_their_rooms_and_type_checkers_know() -> None:
    stubs = {stub.stem: stub for stub in (ROOT / "src/pkmodes").glob("*.pyi") if stub.stem != "__init__"}
    room_of = {package: room for room, packages in names.ROOMS.items() for package in packages}
    pages = {page.stem for page in (ROOT / "docs/reference/api").glob("*.md")} - {"pkmodes", "mechanism"}
    assert {*stubs} == pages
    for name, stub in stubs.items():
        assert stub.read_text(encoding="utf-8") == f"from pkmodes.{room_of[name]}.{name} import *\n"
    for name, room in room_of.items():
        public, inside = (import_module(f"pkmodes.{place}") for place in (name, f"{room}.{name}"))
        assert public is inside
        assert inside.__spec__ is not None
        assert inside.__spec__.name == f"pkmodes.{room}.{name}"


def test_a_module_of_a_package_is_loaded_once_under_both_names() -> None:
    code = "import sys, pkmodes.machine.maps.workspace as inside, pkmodes.maps.workspace as public"
    code += "; print(public is inside, sys.modules['pkmodes.maps'].__spec__.name)"
    path = os.pathsep.join(str(ROOT / part) for part in ("src", "generated"))
    run = subprocess.run(
        [sys.executable, "-c", code],
        env={**os.environ, "PYTHONPATH": path},
        capture_output=True,
        text=True,
        check=True,
    )
    assert run.stdout == "True pkmodes.machine.maps\n"


def test_no_module_imports_itself_through_others() -> None:
    """No circle among modules, whether it is imported at the top, inside a function, or for type checkers."""
    root = ROOT / "src"
    modules = {
        ".".join(file.relative_to(root).with_suffix("").parts).removesuffix(".__init__"): file
        for file in files("src/pkmodes")
    }
    imported = {}
    for name, file in modules.items():
        used = {one if one in modules else one.rpartition(".")[0] for one in modules_imported(file)}
        imported[name] = used - {name}
    while imported:
        leaves = {name for name, used in imported.items() if not used & imported.keys()}
        assert leaves, sorted(imported)
        imported = {name: used for name, used in imported.items() if name not in leaves}


def test_no_mechanism_is_named_outside_its_own_folder() -> None:
    """Neither in the runtime nor in the derivation: mechanisms differ only in their declarations."""
    names = [
        folder.parent.name for folder in (ROOT / "generated/pkmodes_generated").glob("*/description.json")
    ]
    assert "linear_delta" in names
    for file in (
        file
        for part in ("src/pkmodes", "src/pkmodes_description", "derive")
        for file in sorted((ROOT / part).rglob("*"))
    ):
        if not file.is_file() or "__pycache__" in file.parts or file.suffix == ".so":
            continue
        if file == ROOT / "src/pkmodes/cli/examples.py":  # folders and pages may be called as a machine is
            continue
        text = file.read_text(encoding="utf-8")
        # Exceptions are mechanisms/<name>/ in the derivation, and mechanisms/<name>.py in the checks.
        own = [name for name in names if name in (file.stem, *file.parts) and "mechanisms" in file.parts]
        place = file.relative_to(ROOT).as_posix()
        assert not [name for name in names if name in text and name not in own], place


def test_the_runtime_imports_no_generated_code_by_its_name() -> None:
    for file in files("src/pkmodes"):
        assert "pkmodes_generated" not in imports(file), file


def test_the_runtime_imports_nothing_that_is_not_installed_with_it() -> None:
    """Not the virtual rig, which is not in the wheel, nor what only tests and benchmarks need."""
    project = tomllib.loads((ROOT / "pyproject.toml").read_text(encoding="utf-8"))["project"]
    extras = project["optional-dependencies"]
    of_users = ("map", "parquet", "cluster", "plot", "report", "control", "hdf5", "zstd")
    declared = [*project["dependencies"], *(one for name in of_users for one in extras[name])]
    installed = {re.split(r"[\[>=<]", one)[0].lower().replace("-", "_") for one in declared}
    # Those that the declared ones need or bring: pandas by xarray, Pillow and mpl_toolkits by matplotlib.
    installed |= {"pkmodes_description", "pkmodes_derive", "pandas", "PIL", "mpl_toolkits"}
    for file in files("src/pkmodes"):
        assert imports(file) <= installed, file


def test_the_virtual_rig_shares_no_code_with_the_model() -> None:
    """It imports only the robot file reader and the named tuples of parameters; the studies judge the diagnosis."""
    for file in files("tests/pkmodes_rig"):
        tree = ast.parse(file.read_text(encoding="utf-8"))
        taken = {
            (node.module, alias.name)
            for node in ast.walk(tree)
            if isinstance(node, ast.ImportFrom) and (node.module or "").split(".")[0].startswith("pkmodes")
            for alias in node.names
            if not (node.module or "").startswith("pkmodes_rig")
        }
        assert {name for _, name in taken} <= {"Parameters", "Robot", "robot_from_document"}, file


def test_templates_contain_no_mathematics() -> None:
    """No arithmetic operator in a template: it may only place text."""
    templates = sorted((ROOT / "derive/pkmodes_derive/emit").rglob("*.j2"))
    assert templates
    for template in templates:
        text = template.read_text(encoding="utf-8")
        for opening, closing in (("{{", "}}"), ("{%", "%}")):
            for part in text.split(opening)[1:]:
                code = part.split(closing)[0]
                assert not set("*/+") & set(code), (template.name, code)


def test_modules_stay_short() -> None:
    for folder in ("src", "derive"):
        for file in files(folder):
            most = LONG.get(file.relative_to(ROOT).as_posix(), MOST)
            assert len(file.read_text(encoding="utf-8").splitlines()) <= most, file


#: Names of two classes, and why neither is renamed.
TWICE = {
    "Candidate": "of a diagnosis and of a comparison of shapers: both in the reference",
    "CandidateDocument": "of the same two: the name stands in their JSON schemas",
    "Drawing": "of a mechanism's description and of a figure: both are for users",
    "Model": "of the core, and with the methods of the applications",
    "Picture": "a file of a figure and a block of a page: both are for users",
    "Table": "of a robot file and a block of a page: both are for users",
}


def test_a_class_name_means_one_thing() -> None:
    found: dict[str, list[str]] = {}
    for file in files("src"):
        for node in ast.walk(ast.parse(file.read_text(encoding="utf-8"))):
            if isinstance(node, ast.ClassDef):
                found.setdefault(node.name, []).append(file.relative_to(ROOT).as_posix())
    assert {name: len(places) for name, places in found.items() if len(places) > 1} == dict.fromkeys(
        TWICE, 2
    ), {name: places for name, places in found.items() if len(places) > 1 and name not in TWICE}
