"""Commands in the process of the tests: what they print, and what they refuse."""

from __future__ import annotations

import io
import json
from contextlib import redirect_stderr, redirect_stdout
from typing import Any, NamedTuple

import pytest

from pkmodes.cli import run


def from_json(text: str) -> Any:
    """Read JSON strictly: NaN and Infinity are not JSON."""
    return json.loads(text, parse_constant=lambda name: pytest.fail(f"{name} is no JSON"))


class Answer(NamedTuple):
    """Exit code and output of a command."""

    code: int
    out: str
    err: str

    @property
    def json(self) -> dict[str, Any]:
        """Return the JSON on standard output."""
        return from_json(self.out)


def answer(*arguments: object) -> Answer:
    """Run a command to its end, whatever that is."""
    out, err = io.StringIO(), io.StringIO()
    with redirect_stdout(out), redirect_stderr(err):
        code = run([*map(str, arguments)])
    return Answer(code, out.getvalue(), err.getvalue())


def printed(*arguments: object) -> str:
    """Return what a command prints that succeeds and has nothing to remark."""
    code, out, err = answer(*arguments)
    assert (code, err) == (0, "")
    return out


def refused(*arguments: object) -> str:
    """Return the error of a command that refuses what it is given: one line, with what to do, and nothing else."""
    code, out, err = answer(*arguments)
    assert (code, out) == (2, "")
    assert err.startswith("error: ")
    assert err.count("\n") == 1, err
    assert err.rstrip().rpartition("; ")[2], "what to do is missing"
    return err
