"""Every code block of every page runs, and prints the output shown."""

from __future__ import annotations

import contextlib
import io
import os
import re
import shlex
import subprocess
import sys
import tomllib
from collections.abc import Sequence
from pathlib import Path

import pytest

import pkmodes
from helpers.generated.compiled import COMPILER
from helpers.pages.documentation import ELSEWHERE, HINT, PAGES, ROOT, Block, blocks, same
from helpers.robots.robot_text import published
from helpers.runs.processes import without_progress
from pkmodes import updating
from pkmodes.cli import run
from pkmodes.core.robot.reading import robot_from_document
from pkmodes.modaltest.campaign.campaign import read_campaign

COMMENT = re.compile(r"(^|\s)#.*")
#: Characters with a meaning beside words, quotation marks, comments and lines that go on.
NEEDS_A_SHELL = re.compile(r"[|&;<>$`*?~!(){}\[\]\\]")
LANGUAGES = {"python", "sh", "text", "toml", "csv", "c", "yaml", "dockerfile"}
RUN = [page for page in PAGES if any(block.elsewhere is None for block in blocks(page))]
#: Pages with a diagnosis or several compilations; the others take a few seconds at most.
LONG = {
    "docs/reference/command-line.md",
    "docs/tutorial/tutorial.md",
    "docs/explanation/diagnosis.md",
    "docs/tutorial/hexapod-campaign.md",
}


def commands_of(text: str) -> list[list[str]] | None:
    """Return the arguments of commands of pkmodes, None where anything else is among them, or a shell is needed."""
    lines = [COMMENT.sub("", line) for line in text.replace("\\\n", " ").splitlines()]
    if any(NEEDS_A_SHELL.search(line) for line in lines):
        return None
    commands = [words for line in lines if (words := shlex.split(line))]
    return [words[1:] for words in commands] if all(words[0] == "pkmodes" for words in commands) else None


class Reader:
    """Follows one page from top to bottom in a folder of its own."""

    def __init__(self, page: str, folder: Path) -> None:
        self.page, self.folder = page, folder
        self.names: dict[str, object] = {"__name__": "page"}  # starts no processes
        self.printed = ""
        for name in ("robots", "examples", "docs"):
            (folder / name).symlink_to(ROOT / name)
        for name, command in (("pkmodes", f"{sys.executable} -m pkmodes"), ("python", sys.executable)):
            script = folder / "bin" / name
            script.parent.mkdir(exist_ok=True)
            script.write_text(f'#!/bin/sh\nexec {command} "$@"\n')
            script.chmod(0o755)
        if page != "docs/reference/command-line.md":  # whose commands create the folders that they need
            (folder / "build").mkdir()
        self.environment = {
            **os.environ,
            "PATH": os.pathsep.join([str(folder / "bin"), os.environ["PATH"]]),
            "PYTHONPATH": os.pathsep.join(str(ROOT / part) for part in ("src", "generated", "derive")),
            "COLUMNS": "110",
        }

    def follow(self, block: Block) -> None:
        """Do what a block says."""
        name, more = block.hint("file"), block.hint("append")
        if name or more:
            with (self.folder / str(name or more)).open("a" if more else "w", encoding="utf-8") as file:
                file.write(block.text if name else f"\n{block.text}")
        getattr(self, f"_{block.language}")(block)

    def _python(self, block: Block) -> None:
        out = io.StringIO()
        with contextlib.redirect_stdout(out), contextlib.chdir(self.folder):
            exec(compile(block.text, f"{block.page}:{block.line}", "exec"), self.names)
        self.printed = out.getvalue()
        shown = [line.removeprefix("# ") for line in block.text.splitlines() if line.startswith("# ")]
        if shown:
            assert self.printed.splitlines() == shown

    def _sh(self, block: Block) -> None:
        commands = commands_of(block.text)
        if commands is not None:
            self._run(commands, int(block.hint("exit") or 0))
            return
        if re.search(r"^cc ", block.text, re.MULTILINE) and not COMPILER:
            pytest.skip("no C compiler")
        done = subprocess.run(
            ["bash", "-e", "-o", "pipefail", "-c", block.text],
            cwd=self.folder,
            env=self.environment,
            stdout=subprocess.PIPE,
            stderr=subprocess.STDOUT,
            text=True,
            check=False,
        )
        self.printed = without_progress(done.stdout)
        assert done.returncode == int(block.hint("exit") or 0), done.stdout

    def _run(self, commands: Sequence[Sequence[str]], code: int) -> None:
        """Run commands of pkmodes in this process: loading the libraries anew would take longer than most of them."""
        printed = io.StringIO()
        with pytest.MonkeyPatch.context() as patch:
            patch.chdir(self.folder)
            patch.setenv("COLUMNS", self.environment["COLUMNS"])
            with contextlib.redirect_stdout(printed), contextlib.redirect_stderr(printed):
                codes = [run(words) for words in commands]
        self.printed = without_progress(printed.getvalue())
        assert codes == [*[0] * (len(codes) - 1), code], self.printed

    def _text(self, block: Block) -> None:
        if "drawing" not in block.hints:
            same(
                block.text,
                self.printed,
                fit="from a fit" in block.hints,
                shortened="shortened" in block.hints,
            )

    def _toml(self, block: Block) -> None:
        tables = tomllib.loads(block.text)
        if "record" in tables:
            path = self.folder / "block.toml"
            path.write_text(block.text, encoding="utf-8")
            read_campaign(path)
        elif "fragment" not in block.hints and not block.hint("append"):
            path = self.folder / "block.toml"
            path.write_text(block.text, encoding="utf-8")
            pkmodes.read_robot(path)
        elif tables.keys() == {"effects"}:
            path = self.folder / "block.toml"
            path.write_text(f"{published()}\n{block.text}", encoding="utf-8")
            pkmodes.read_robot(path)

    def _csv(self, block: Block) -> None:
        path = self.folder / "block.csv"
        path.write_text(block.text, encoding="utf-8")
        lines = [line for line in block.text.splitlines() if not line.startswith("#")]
        assert len(updating.read(path).frequency) == len(lines) - 1

    def _c(self, block: Block) -> None:
        assert block.hint("file"), "a later command compiles it"


@pytest.mark.usefixtures("no_drawing")
@pytest.mark.parametrize(
    "page", [pytest.param(page, marks=pytest.mark.slow if page in LONG else ()) for page in RUN]
)
def test_the_blocks_of_a_page_run_and_print_what_it_shows(
    page: str, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    reader = Reader(page, tmp_path)
    for block in blocks(page):
        if block.elsewhere is None:
            try:
                reader.follow(block)
            except Exception as error:
                error.add_note(f"{page}:{block.line}")
                raise


def test_every_block_says_what_it_is(subtests: pytest.Subtests) -> None:
    """A block without a language would be skipped, and a misspelt comment would be overlooked."""
    for page in PAGES:
        with subtests.test(page=page):
            for block in blocks(page):
                place = f"{page}:{block.line}"
                if page.startswith("docs/") or block.elsewhere is None:
                    assert block.language in LANGUAGES, f"{place}: {block.language!r}"
                for hint in block.hints:
                    assert HINT.fullmatch(hint), f"{place}: {hint!r}"


def test_the_list_of_blocks_that_are_not_run_is_current() -> None:
    for (page, start), reason in ELSEWHERE.items():
        assert any(block.text.startswith(start) for block in blocks(page)), (page, start)
        if (found := re.match(r"tests/\S+", reason)) is not None:
            assert (ROOT / found[0]).is_file(), reason


def test_commands_are_told_from_what_needs_a_shell() -> None:
    shown = "# first\npkmodes modes 'a b.toml' \\\n    --pose 1,2  # there; (or not)\n\npkmodes check\n"
    assert commands_of(shown) == [["modes", "a b.toml", "--pose", "1,2"], ["check"]]
    for text in (
        "pkmodes check | head",
        "A=1 pkmodes check",
        "pkmodes check\ncc -c a.c",
        "pkmodes check *.toml",
    ):
        assert commands_of(text) is None


def test_outputs_are_compared() -> None:
    """What the comparison lets pass, and what not."""
    same("rms 0.688 %\n", "  rms\n0.688 %")
    same("rms 0.688 %", "rms 0.690 %", fit=True)
    same("b 2\nd 4", "a 1 b 2 c 3 d 4", shortened=True)
    for shown, printed, options in (
        ("rms 0.688 %", "rms 0.689 %", {}),
        ("rms 0.688 %", "rms 0.788 %", {"fit": True}),
        ("rms 0.688 %", "rms 0.688 % more", {}),
        ("rms 0.688 % more", "rms 0.688 %", {}),
        ("d 4\nb 2", "a 1 b 2 c 3 d 4", {"shortened": True}),
    ):
        with pytest.raises(AssertionError):
            same(shown, printed, **options)


def test_the_belts_of_the_example_give_the_frequencies_named_below_them() -> None:
    """docs/model.md: a fragment of a robot file, and what it changes."""
    text = (ROOT / "docs/model.md").read_text(encoding="utf-8")
    (fragment,) = (block.text for block in blocks("docs/model.md") if "[[belt_path]]" in block.text)
    (said,) = re.findall(r"modes at x = y = 150 mm are at ([\d.]+) and ([\d.]+) Hz with held motors", text)
    given = (ROOT / "robots/corexy-printer.toml").read_text(encoding="utf-8")
    start = given.index("[[belt_path]]")
    rest = re.search(r"^\[(?!\[belt_path)", given[start:], re.MULTILINE)
    changed = given[:start] + fragment + ("" if rest is None else "\n" + given[start + rest.start() :])
    robot = robot_from_document(tomllib.loads(changed), "corexy-printer.toml")
    frequencies = pkmodes.Model(robot).frequencies([0.15, 0.15])
    assert [f"{value:.2f}" for value in frequencies] == list(said)
