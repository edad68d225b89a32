"""``--report`` of compare and diagnose: targets, delivery with the other files, and missing libraries."""

from __future__ import annotations

import json
import sys
from itertools import product
from pathlib import Path

import pytest

from pkmodes import read_robot, updating
from pkmodes.cli import run
from pkmodes.core.base.errors import PkmodesError
from pkmodes.loop.diagnosis import Diagnosis
from pkmodes.pages.report import report

ROOT = Path(__file__).parents[2]
LOOP = [str(ROOT / "examples" / "closed_loop" / name) for name in ("robot.toml", "measured.csv")]
DIAGNOSE = ["diagnose", *LOOP, "--candidates", "gearbox_compliance"]


@pytest.fixture
def nothing_computed(monkeypatch: pytest.MonkeyPatch) -> None:
    for name in ("diagnose", "compare"):
        monkeypatch.setattr(updating, name, lambda *_, **__: pytest.fail("computed"))


@pytest.mark.usefixtures("diagnosed", "no_drawing")
def test_all_files_are_written_and_named(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    targets = {name: tmp_path / name for name in ("result.json", "saved.toml", "report.html")}
    options = ["--json", "--save-robot", "--report"]
    pairs = zip(options, map(str, targets.values()), strict=True)
    assert run([*DIAGNOSE, *(part for pair in pairs for part in pair)]) == 0
    captured = capsys.readouterr()
    assert all(target.is_file() for target in targets.values())
    assert f"\nwrote {targets['report.html']}\n" in captured.out
    assert f"\nwrote {targets['saved.toml']}; next: " in captured.out
    assert captured.err == ""
    assert sorted(tmp_path.iterdir()) == sorted(targets.values())


@pytest.mark.usefixtures("diagnosed", "no_drawing")
def test_json_on_standard_output_is_nothing_else(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    target = tmp_path / "report.html"
    assert run([*DIAGNOSE, "--json", "-", "--report", str(target)]) == 0
    captured = capsys.readouterr()
    assert json.loads(captured.out)["verdict"] == "effect_found"
    assert captured.err == f"\nwrote {target}\n"


@pytest.mark.usefixtures("diagnosed", "no_drawing")
def test_an_older_report_is_replaced_and_the_same_result_gives_the_same_bytes(tmp_path: Path) -> None:
    target = tmp_path / "report.html"
    target.write_text("an older one", encoding="utf-8")
    assert run([*DIAGNOSE, "--report", str(target)]) == 0
    first = target.read_bytes()
    assert first.startswith(b"<!DOCTYPE html>")
    assert run([*DIAGNOSE, "--report", str(target)]) == 0
    assert target.read_bytes() == first


WRONG_TARGETS = [
    ("absent/report.html", "does not exist"),
    ("", "expected the name of a file"),
    ("-", "expected the name of a file"),
    (".", "expected "),
    ("report.nc", 'expected a name that ends in .html, found "report.nc"'),
    ("report", "write report.html"),
    (LOOP[0], "the report would replace its own input"),
    (LOOP[1], "the report would replace its own input"),
    ("result.json", "the result and the report would be the same file"),
]


@pytest.mark.usefixtures("nothing_computed")
def test_a_wrong_target_is_refused_before_anything_is_computed(
    subtests: pytest.Subtests,
    tmp_path: Path,
    monkeypatch: pytest.MonkeyPatch,
    capsys: pytest.CaptureFixture[str],
) -> None:
    for (target, message), command in product(WRONG_TARGETS, ["diagnose", "compare"]):
        with subtests.test(f"{target}, {message}, {command}"):
            monkeypatch.chdir(tmp_path)
            before = [Path(name).read_bytes() for name in LOOP]
            assert run([command, *LOOP, "--json", "result.json", "--report", target]) == 2
            captured = capsys.readouterr()
            assert captured.out == ""
            assert captured.err.startswith("error: ")
            assert message in captured.err
            assert "--report" in captured.err
            assert captured.err.count("\n") == 1
            assert [Path(name).read_bytes() for name in LOOP] == before
            assert not list(tmp_path.iterdir())


@pytest.mark.usefixtures("nothing_computed")
def test_two_targets_are_not_the_same_file(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    target = str(tmp_path / "both")
    assert run([*DIAGNOSE, "--save-robot", target, "--report", target]) == 2
    assert "the corrected robot and the report would be the same file" in capsys.readouterr().err


@pytest.mark.usefixtures("nothing_computed")
@pytest.mark.parametrize("missing", ["matplotlib", "jinja2"])
def test_a_missing_library_is_named_before_anything_is_computed(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str], missing: str
) -> None:
    for name in [name for name in sys.modules if name.split(".")[0] == missing]:
        monkeypatch.delitem(sys.modules, name)
    monkeypatch.setitem(sys.modules, missing, None)
    assert run(["compare", *LOOP, "--report", str(tmp_path / "report.html")]) == 2
    captured = capsys.readouterr()
    assert captured.err.count("\n") == 1
    assert (
        f"{missing} is not installed; reports need it (optional dependency); install it with: "
        in captured.err
    )
    assert "pip install 'pkmodes[report]'" in captured.err
    assert not list(tmp_path.iterdir())


def test_a_missing_input_is_reported_as_without_a_report(
    tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    lines = []
    for options in ([], ["--report", str(tmp_path / "report.html")]):
        assert run(["compare", LOOP[0], "absent.csv", *options]) == 2
        lines.append(capsys.readouterr().err)
    assert lines[0] == lines[1]


def test_wrong_arguments_from_python_are_refused(found: Diagnosis) -> None:
    robot = read_robot(LOOP[0])
    other = updating.read(ROOT / "examples" / "closed_loop" / "measured.csv").at([0, 1])
    with pytest.raises(PkmodesError, match="expected the measurements of the result"):
        report(found, robot=robot, data=other)
    with pytest.raises(PkmodesError, match="expected a diagnosis or a comparison"):
        report(42)  # type: ignore[arg-type]
