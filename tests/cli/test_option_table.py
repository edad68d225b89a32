"""A table of options: one entry gives the option, the argument of the call, the files, and what excludes what."""

from __future__ import annotations

from dataclasses import dataclass
from pathlib import Path
from typing import Any

import click
import pytest

from pkmodes.cli.option_table import OptionTable, entry, option
from pkmodes.cli.options import PATH
from pkmodes.core.base.errors import OutputError, PkmodesError

CALLS: list[dict[str, Any]] = []


@dataclass(frozen=True)
class ToyOptions(OptionTable):
    """What a made-up command takes."""

    robot: Path | None = entry(click.argument("robot", type=PATH, required=False), reads="robot file")
    grid: str | None = option("--grid", only="a robot file")
    damping: float | None = option("--damping", type=float, passed=True, only="measured modes")
    kinds: str | None = option("--shapers", "kinds", passed=True)
    table: Path | None = option(
        "--out", "table", type=PATH, metavar="FILE.csv", writes="the table", endings=(".csv",)
    )
    digits: int | None = option("--digits", type=int, needs=("table", "report_to"))
    names: tuple[str, ...] = option("--name", "names", multiple=True, only="a robot file")
    quick: bool = option("--quick", is_flag=True, only="a robot file")


@click.command()
@ToyOptions.add_to
def toy(options: ToyOptions) -> None:
    """Do nothing."""
    options.check_files()
    options.check_only("measured modes" if options.robot is None else "a robot file")
    options.check_needs()
    with options.name_in_errors(method="--quick"):
        if options.kinds in ("kinds", "method"):
            raise PkmodesError("it is wrong", options.kinds, 'write kinds="zv"')
    CALLS.append(options.call_arguments("measured modes" if options.robot is None else "a robot file"))


def run(*arguments: str) -> Any:
    return toy.main([*arguments], standalone_mode=False)


def test_options_stand_in_the_order_of_the_table_and_those_of_all_commands_last() -> None:
    names = [parameter.name for parameter in toy.params]
    own = ["robot", "grid", "damping", "kinds", "table", "digits", "names", "quick"]
    assert names == [*own, "report_to", "json_file"]
    assert toy.name == "toy"
    assert toy.help == "Do nothing."


def test_arguments_of_the_call_are_those_for_what_is_computed() -> None:
    CALLS.clear()
    run("robot.toml", "--shapers", "zv", "--grid", "x=1")
    run("--damping", "0", "--shapers", "ei")
    assert CALLS == [{"kinds": "zv"}, {"kinds": "ei", "damping": 0.0}]


@pytest.mark.parametrize(
    ("arguments", "problem"),
    [
        (("--grid", "x=1"), "--grid is for a robot file"),
        (("--name", "a"), "--name is for a robot file"),
        (("--quick",), "--quick is for a robot file"),
        (("robot.toml", "--damping", "0"), "--damping is for measured modes"),
    ],
)
def test_options_for_something_else_are_refused(arguments: tuple[str, ...], problem: str) -> None:
    with pytest.raises(click.UsageError, match=problem):
        run(*arguments)


def test_an_option_for_a_file_that_is_not_written_is_refused(tmp_path: Path) -> None:
    problem = "--digits is for the table and the report, which are not written"
    with pytest.raises(PkmodesError, match=problem) as error:
        run("--digits", "3")
    assert error.match("add --out FILE.csv or --report FILE.html, or leave --digits out")
    run("--digits", "3", "--out", str(tmp_path / "table.csv"))


def test_files_are_checked_with_their_options(tmp_path: Path) -> None:
    with pytest.raises(OutputError, match=r"ends in \.csv"):
        run("--out", str(tmp_path / "table.txt"))
    with pytest.raises(OutputError, match=r"ends in \.html"):
        run("--report", str(tmp_path / "table.txt"))
    robot = tmp_path / "robot.csv"
    robot.touch()
    with pytest.raises(OutputError, match="the table would replace its own input"):
        run(str(robot), "--out", str(robot))
    with pytest.raises(OutputError, match="the result and the table would be the same file"):
        run("--json", str(tmp_path / "a.csv"), "--out", str(tmp_path / "a.csv"))


@pytest.mark.parametrize(("where", "option_name"), [("kinds", "--shapers"), ("method", "--quick")])
def test_errors_name_the_options(where: str, option_name: str) -> None:
    with pytest.raises(PkmodesError, match="it is wrong") as error:
        run("--shapers", where)
    assert error.value.where == option_name
    assert error.value.remedy == "write --shapers zv"
