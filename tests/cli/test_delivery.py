"""Files, standard output and exit codes: a failure of one does not affect the others."""

from __future__ import annotations

import dataclasses
import errno
import json
import os
import pickle
import resource
import subprocess
import sys
from collections.abc import Iterator
from contextlib import contextmanager, redirect_stdout
from pathlib import Path
from typing import get_args, get_type_hints

import pytest

from helpers.diagnoses.diagnose_command import unwritable
from helpers.robots.robot_text import PUBLISHED, published
from helpers.runs.processes import ROOT, environment
from pkmodes import read_robot, updating
from pkmodes.cli import run
from pkmodes.loop.diagnosis import Diagnosis
from pkmodes.loop.diagnosis.verdict import verdicts

ROBOT = ROOT / "examples" / "closed_loop" / "robot.toml"
MODES = ROOT / "examples" / "closed_loop" / "measured.csv"
DIAGNOSE = ["diagnose", str(ROBOT), str(MODES), "--candidates", "gearbox_compliance"]
VERDICTS = get_args(get_type_hints(Diagnosis)["verdict"])


def shell(command: str, *arguments: str, program: str = "-m pkmodes") -> subprocess.CompletedProcess[str]:
    """Run a shell line in which ``$PK "$@"`` is a pkmodes command with these arguments."""
    # Streams are buffered, as a user has them: what is left in a buffer is written when the interpreter ends.
    variables = environment(PK=f"{sys.executable} {program}")
    variables.pop("PYTHONUNBUFFERED", None)
    return subprocess.run(
        ["bash", "-o", "pipefail", "-c", command, "bash", *arguments],
        env=variables,
        capture_output=True,
        text=True,
        check=False,
    )


@contextmanager
def nobody_reading() -> Iterator[None]:
    """Let standard output be a pipe whose reader is gone."""
    reading, writing = os.pipe()
    os.close(reading)
    with os.fdopen(writing, "w", encoding="utf-8") as pipe, redirect_stdout(pipe):
        yield


@pytest.fixture(scope="module")
def program(found: Diagnosis, tmp_path_factory: pytest.TempPathFactory) -> str:
    """``pkmodes`` as a file that has `found` already: how a process ends does not depend on it."""
    folder = tmp_path_factory.mktemp("program")
    (folder / "found.pickle").write_bytes(pickle.dumps(found))
    (folder / "pkmodes_with_a_diagnosis.py").write_text(
        "import pickle\n"
        "from pathlib import Path\n"
        "from pkmodes import updating\n"
        "from pkmodes.__main__ import main\n"
        "found = pickle.loads(Path(__file__).with_name('found.pickle').read_bytes())\n"
        "updating.diagnose = lambda *_, **__: found\n"
        "main()\n",
        encoding="utf-8",
    )
    return str(folder / "pkmodes_with_a_diagnosis.py")


#: Ways in which standard output is closed, and the resulting exit code.
DEAF = {"| true": 0, "| head -0": 0, ">&-": 0, "> /dev/full": 2}


@pytest.mark.parametrize(("reader", "code"), DEAF.items(), ids=DEAF)
def test_files_are_written_whoever_reads(tmp_path: Path, program: str, reader: str, code: int) -> None:
    files = ["--save-robot", str(tmp_path / "my saved.toml"), "--json", str(tmp_path / "result.json")]
    done = shell(f'$PK "$@" {reader}', *DIAGNOSE, *files, program=program)
    assert done.returncode == code
    assert done.stderr.count("\n") == (code > 0), done.stderr
    assert "effects.gearbox_compliance.compliance" in read_robot(tmp_path / "my saved.toml").declared
    assert json.loads((tmp_path / "result.json").read_text(encoding="utf-8"))["verdict"] == "effect_found"


def test_json_for_a_closed_pipe_still_saves_the_robot(tmp_path: Path, program: str) -> None:
    saved = tmp_path / "saved.toml"
    done = shell('$PK "$@" --json - | true', *DIAGNOSE, "--save-robot", str(saved), program=program)
    assert done.returncode == 0
    assert saved.is_file()


def test_a_reader_that_leaves_does_not_turn_a_failure_into_success(program: str) -> None:
    assert shell('$PK "$@" | true', *DIAGNOSE, "--fail-on", "any", program=program).returncode == 1


def test_files_and_exit_codes_of_other_commands_do_not_depend_on_the_reader(
    copy: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    result = copy / "result.json"
    for arguments in (
        ["modes", str(PUBLISHED), "--pose", "0.6,0,-0.245"],
        ["compare", str(ROBOT), str(MODES)],
    ):
        with nobody_reading():
            assert run([*arguments, "--json", str(result)]) == 0
        assert json.loads(result.read_text(encoding="utf-8"))
        result.unlink()
    (copy / "model" / "linear_delta_2022.h").unlink()
    with nobody_reading():
        assert run(["check", str(copy / "model")]) == 1
    assert capsys.readouterr().err == ""


@pytest.fixture
def small_files() -> Iterator[None]:
    """No file may have more than 8 kB, as on a full disk."""
    before = resource.getrlimit(resource.RLIMIT_FSIZE)
    resource.setrlimit(resource.RLIMIT_FSIZE, (8192, before[1]))
    yield
    resource.setrlimit(resource.RLIMIT_FSIZE, before)


@pytest.mark.parametrize(
    ("command", "out", "place"),
    [("show", "page.html", "page.html"), ("figures", "pictures", "pictures/workspace.svg")],
)
@pytest.mark.usefixtures("small_files")
def test_a_full_disk_is_told_with_the_file_and_nothing_is_left(
    tmp_path: Path,
    monkeypatch: pytest.MonkeyPatch,
    capsys: pytest.CaptureFixture[str],
    command: str,
    out: str,
    place: str,
) -> None:
    monkeypatch.setattr("pkmodes.pages.figures.files.image_bytes", lambda *_, **__: b"drawn" * 2000)
    monkeypatch.chdir(tmp_path)
    grid = ["--grid", "x=0.4:0.7:8,y=0:0.1:5,z=-0.245"] if command == "figures" else []
    assert run([command, str(PUBLISHED), "--out", out, *grid]) == 2
    assert capsys.readouterr() == (
        "",
        f"error: cannot write: file too large ({place}); choose another place or make room\n",
    )
    assert list(tmp_path.iterdir()) == []


@pytest.mark.parametrize("place", ["2> /dev/full", "2>&-", "2>&- >&-"])
def test_an_error_that_nobody_hears_keeps_its_exit_code(place: str) -> None:
    assert shell(f'$PK "$@" {place}', "modes", "absent.toml", "--pose", "0,0,0").returncode == 2


@pytest.mark.parametrize("option", ["--save-robot", "--report"])
@pytest.mark.usefixtures("diagnosed", "no_drawing")
def test_what_cannot_be_written_does_not_take_the_answer_along(
    tmp_path: Path, capsys: pytest.CaptureFixture[str], option: str
) -> None:
    target = unwritable(tmp_path, "saved.toml" if option == "--save-robot" else "report.html")
    out = tmp_path / "result.json"
    assert run([*DIAGNOSE, option, str(target), "--json", str(out)]) == 2
    captured = capsys.readouterr()
    assert captured.out.startswith("workshop-delta: effect_found")
    assert "wrote" not in captured.out
    assert captured.err.startswith("error: cannot write")
    assert captured.err.count("\n") == 1
    assert not out.exists()
    assert not target.exists()


@pytest.mark.parametrize("filled", ["write", "replace"])
@pytest.mark.parametrize("fits", [0, 1, 2])
@pytest.mark.parametrize("older", [False, True])
@pytest.mark.usefixtures("diagnosed", "no_drawing")
def test_where_the_disk_fills_all_files_of_a_diagnosis_are_written_or_none(
    tmp_path: Path,
    monkeypatch: pytest.MonkeyPatch,
    capsys: pytest.CaptureFixture[str],
    filled: str,
    fits: int,
    older: bool,
) -> None:
    """The disk is full after some of the three files; those that were there are as they were."""
    names = {"--json": "result.json", "--save-robot": "saved.toml", "--report": "report.html"}
    before = {tmp_path / name: f"an older {name}" for name in names.values()} if older else {}
    for path, text in before.items():
        path.write_text(text, encoding="utf-8")
    given = [part for option, name in names.items() for part in (option, str(tmp_path / name))]
    done = []

    def full(kind: str) -> None:
        if kind == filled and len(done) == fits:
            raise OSError(errno.ENOSPC, os.strerror(errno.ENOSPC))
        done.extend([kind] if kind == filled else [])

    opened, replace = os.fdopen, Path.replace

    def written(handle: int, *arguments: object, **settings: object) -> object:
        if Path(f"/proc/self/fd/{handle}").resolve().parent == tmp_path:
            try:
                full("write")
            except OSError:
                os.close(handle)
                raise
        return opened(handle, *arguments, **settings)  # type: ignore[call-overload]

    def replaced(path: Path, target: Path) -> Path:
        if len(done) <= fits and not done.count("undone"):
            try:
                full("replace")
            except OSError:
                done.append("undone")
                raise
        return replace(path, target)

    with monkeypatch.context() as patch:
        patch.setattr("pkmodes.core.support.writing.os.fdopen", written)
        patch.setattr(Path, "replace", replaced)
        assert run([*DIAGNOSE, *given]) == 2
    captured = capsys.readouterr()
    assert "none of the 3 files is written" in captured.err
    assert captured.err.endswith("choose another place or make room\n")
    assert "wrote" not in captured.out
    assert captured.out.startswith("workshop-delta: effect_found"), "the answer is printed all the same"
    assert {path: path.read_text(encoding="utf-8") for path in tmp_path.iterdir()} == before


def test_the_verdicts_are_those_of_the_engine() -> None:
    assert tuple(verdicts.VERDICTS) == VERDICTS


@pytest.mark.parametrize(
    ("fail_on", "failures"),
    [
        (None, set()),
        ("any", set(VERDICTS) - {"adequate"}),
        ("effect_found,ambiguous,unexplained,insufficient_data", set(VERDICTS) - {"adequate"}),
        (" unexplained , ambiguous", {"unexplained", "ambiguous"}),
        ("adequate", {"adequate"}),
        ("adequate,any", set(VERDICTS)),
    ],
)
def test_the_exit_code_is_what_the_script_asked_for(
    found: Diagnosis,
    monkeypatch: pytest.MonkeyPatch,
    capsys: pytest.CaptureFixture[str],
    fail_on: str | None,
    failures: set[str],
) -> None:
    options = [] if fail_on is None else ["--fail-on", fail_on]
    for verdict in VERDICTS:
        given = dataclasses.replace(found, verdict=verdict)
        monkeypatch.setattr(updating, "diagnose", lambda *_, given=given, **__: given)
        assert run([*DIAGNOSE, *options]) == (verdict in failures), verdict
        captured = capsys.readouterr()
        assert f"workshop-delta: {verdict}" in captured.out
        assert captured.err == "", verdict


@pytest.mark.parametrize(
    ("fail_on", "message"),
    [
        ("unexplaned", 'unknown verdict "unexplaned" (--fail-on); did you mean "unexplained"?'),
        ("xyz", 'unknown verdict "xyz" (--fail-on); choose from adequate, effect_found, '),
        ("ambiguous,ANY", 'unknown verdict "ANY" (--fail-on); '),
        ("", 'expected names separated by commas, found "" (--fail-on)'),
    ],
)
def test_an_unknown_verdict_is_refused_before_anything_is_computed(
    monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str], fail_on: str, message: str
) -> None:
    monkeypatch.setattr(updating, "diagnose", lambda *_, **__: pytest.fail("computed"))
    assert run([*DIAGNOSE, "--fail-on", fail_on]) == 2
    captured = capsys.readouterr()
    assert captured.out == ""
    assert captured.err.startswith(f"error: {message}")
    assert captured.err.count("\n") == 1


@pytest.mark.parametrize("columns", ["0", "1", "7", "-5", "abc", "", "00", "99999999999"])
def test_any_width_of_the_terminal_prints_everything(
    monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str], columns: str
) -> None:
    monkeypatch.setenv("COLUMNS", columns)
    assert run(["modes", str(PUBLISHED), "--pose", "0.6,0,-0.245"]) == 0
    out = capsys.readouterr().out
    monkeypatch.delenv("COLUMNS")
    assert run(["modes", str(PUBLISHED), "--pose", "0.6,0,-0.245"]) == 0
    plain = capsys.readouterr().out
    assert "55.559" in plain
    assert set(plain.split()) <= set(out.split())
    if columns in ("0", "00"):  # not known, as where nobody says it
        assert out == plain


def test_a_file_name_that_is_not_utf_8_is_no_traceback(
    tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    folder = tmp_path / os.fsdecode(b"caf\xe9")
    try:
        folder.mkdir()
    except OSError:
        pytest.skip("this file system has UTF-8 names only")
    (folder / "robot.toml").write_text(published(), encoding="utf-8")
    target = str(folder / "model")
    for out in ("-", str(tmp_path / "out.json")):
        with (tmp_path / "printed").open("w", encoding="utf-8") as file, redirect_stdout(file):
            assert run(["generate", str(folder / "robot.toml"), "--out", target, "--json", out]) == 0
        assert capsys.readouterr().err == ""
    assert json.loads((tmp_path / "out.json").read_text(encoding="utf-8"))["out"] == target


GRID = ["--grid", "x=0.6,y=0,z=-0.245"]


@pytest.mark.parametrize(
    ("name", "arguments"),
    [
        ("a.json", ["modes", str(PUBLISHED), "--pose", "0.6,0,-0.245", "--json"]),
        ("a.html", ["map", str(PUBLISHED), *GRID, "--report"]),
        ("a.nc", ["map", str(PUBLISHED), *GRID, "--out"]),
        ("a.html", ["show", str(PUBLISHED), "--out"]),
        ("a", ["figures", str(PUBLISHED), "--out"]),
        ("a", ["generate", str(PUBLISHED), "--out"]),
        ("a.toml", [*DIAGNOSE, "--save-robot"]),
    ],
)
def test_a_link_that_leads_back_to_itself_is_refused(
    tmp_path: Path, capsys: pytest.CaptureFixture[str], name: str, arguments: list[str]
) -> None:
    loop = tmp_path / name
    loop.symlink_to(loop)
    assert run([*arguments, str(loop)]) == 2
    error = capsys.readouterr().err
    assert error.startswith("error: ")
    assert error.count("\n") == 1
    assert "symbolic links" in error
