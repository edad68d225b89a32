"""The help of every command, in a terminal of 80 columns, and the examples in it."""

from __future__ import annotations

import re
from pathlib import Path

import click
import pytest

from helpers.runs.processes import ROOT
from pkmodes.cli import cli, run


@pytest.mark.parametrize("command", ["", *cli.commands])
def test_help_fits_80_columns_and_shows_an_example(
    command: str, capsys: pytest.CaptureFixture[str], monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setenv("COLUMNS", "80")
    assert run([*([command] if command else []), "--help"]) == 0
    lines = capsys.readouterr().out.splitlines()
    assert max(map(len, lines)) <= 80
    assert any(line.startswith(f"    pkmodes {command}") for line in lines)
    words = " ".join(lines).replace(",", " ").split()
    options = cli.commands[command].params if command else []
    assert [
        one.opts for one in options if isinstance(one, click.Option) and not {*one.opts} <= {*words}
    ] == []


def test_every_command_is_listed_once_with_a_whole_sentence(
    capsys: pytest.CaptureFixture[str], monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setenv("COLUMNS", "80")
    assert run(["--help"]) == 0
    listed = re.findall(r"^  ([a-z]+) +([A-Z].*)$", capsys.readouterr().out, re.MULTILINE)
    assert sorted(name for name, _ in listed) == sorted(cli.commands)
    assert all(sentence.endswith(".") and "..." not in sentence for _, sentence in listed)


#: Of commands that take a moment: the beginning of what each example prints.
EXAMPLES = {
    "modes": ["linear-delta-2022 at "],
    "sensitivities": ["linear-delta-2022, motors free: Of the chosen quantities, mode 3 depends most on"],
    "compare": ["workshop-delta, motors free: ", "first:  linear-delta-2022 "],
    "diagnose": ["workshop-delta: effect_found"],
}


@pytest.mark.parametrize("command", EXAMPLES)
def test_the_examples_work(
    command: str, tmp_path: Path, capsys: pytest.CaptureFixture[str], monkeypatch: pytest.MonkeyPatch
) -> None:
    assert run([command, "--help"]) == 0
    text = capsys.readouterr().out.partition("Example")[2].replace("\\\n", " ")
    examples = [line.split() for line in text.splitlines() if line.startswith("    pkmodes ")]
    for folder in ("robots", "examples"):
        (tmp_path / folder).symlink_to(ROOT / folder)
    monkeypatch.chdir(tmp_path)
    for example, printed in zip(examples, EXAMPLES[command], strict=True):
        assert run(example[1:]) == 0
        assert capsys.readouterr().out.startswith(printed)
        if "--save-robot" in example:
            assert (tmp_path / example[example.index("--save-robot") + 1]).is_file()
