"""A verdict is one entry: everything that names the verdicts follows from the table, also for a made-up one."""

from __future__ import annotations

import json
import re
from collections.abc import Iterator
from dataclasses import replace
from pathlib import Path
from typing import Any, get_args

import jsonschema
import pytest

from helpers.diagnoses.examples import example
from helpers.pages.report_examples import made_up
from helpers.runs.shared import Shared
from pkmodes import updating
from pkmodes.cli import cli, run
from pkmodes.core.support.documents import schema_of
from pkmodes.loop.diagnosis.verdict import document, findings, verdicts
from pkmodes.loop.diagnosis.verdict.verdicts import NOT_MEASURED, VERDICTS, Colour, Verdict, Word

ROOT = Path(__file__).parents[3]
DIAGNOSE = [
    "diagnose",
    *(str(ROOT / "examples/closed_loop" / name) for name in ("robot.toml", "measured.csv")),
]
HEARSAY = Verdict("hearsay", "Someone said so", True, "open", "ask the others", settled=False)


@pytest.fixture
def hearsay(monkeypatch: pytest.MonkeyPatch, shared: Shared) -> str:
    """A verdict that the engine does not know, given by it."""
    monkeypatch.setitem(VERDICTS, HEARSAY.word, HEARSAY)
    result = example(shared, "closed_loop", candidates=("gearbox_compliance",))
    said = replace(result, verdict=HEARSAY.word, reason="someone said so", effects=(), survivors=())
    monkeypatch.setattr(updating, "diagnose", lambda *_, **__: said)
    return HEARSAY.word


def enumerations(part: Any) -> Iterator[list[str]]:
    """Yield what the schema allows wherever it describes a verdict."""
    if isinstance(part, dict):
        for key, value in part.items():
            if key == "verdict" and "enum" in value:
                yield value["enum"]
            yield from enumerations(value)


def schema() -> dict[str, Any]:
    return json.loads((ROOT / "docs/schemas/diagnose.schema.json").read_text(encoding="utf-8"))


@pytest.mark.usefixtures("no_drawing")
def test_a_made_up_verdict_reaches_exit_code_terminal_json_and_page(
    hearsay: str, tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    page, content = tmp_path / "page.html", tmp_path / "content.json"
    options = ["--candidates", "gearbox_compliance", "--report", str(page), "--json", str(content)]
    assert run([*DIAGNOSE, *options, "--fail-on", "any"]) == 1
    assert "workshop-delta: hearsay\n  someone said so\n" in capsys.readouterr().out
    assert json.loads(content.read_text(encoding="utf-8"))["verdict"] == hearsay
    html = page.read_text(encoding="utf-8")
    assert 'class="summary tone-open"' in html
    assert "Verdict: <code>hearsay</code>" in html
    assert "Someone said so</h2>" in html
    assert "No next measurement is proposed: ask the others." in html
    assert "No correction: the verdict is hearsay." in html


def test_the_command_line_knows_a_made_up_verdict(hearsay: str, capsys: pytest.CaptureFixture[str]) -> None:
    assert run([*DIAGNOSE, "--candidates", "gearbox_compliance", "--fail-on", hearsay]) == 1
    capsys.readouterr()
    assert run([*DIAGNOSE, "--fail-on", "hearsy"]) == 2
    assert 'did you mean "hearsay"?' in capsys.readouterr().err


def test_the_schema_allows_the_verdicts_of_the_table() -> None:
    allowed = list(enumerations(schema()))
    assert allowed[:2] == [sorted(VERDICTS)] * 2, "the verdict, and those of the stability"
    assert allowed[2:] == [sorted([*VERDICTS, NOT_MEASURED])], "the verdict on the damping"
    assert get_args(Word) == tuple(VERDICTS)
    content = made_up(2, 2)[0].as_json()
    jsonschema.Draft202012Validator(schema()).validate(content)
    with pytest.raises(jsonschema.ValidationError, match="hearsay"):
        jsonschema.Draft202012Validator(schema()).validate(content | {"verdict": HEARSAY.word})


def test_a_made_up_entry_reaches_the_schema(monkeypatch: pytest.MonkeyPatch) -> None:
    source = Path(verdicts.__file__).read_text(encoding="utf-8")
    entry = "VERDICTS['hearsay'] = ADEQUATE\n"
    table: dict[str, Any] = {"__name__": verdicts.__name__}
    exec(source.replace("\nif TYPE_CHECKING:", f"\n{entry}if TYPE_CHECKING:"), table)
    for module in (document, findings):
        monkeypatch.setattr(module, "Word", table["Word"])
    monkeypatch.setattr(document, "DampingWord", table["DampingWord"])
    described = schema_of(document.DiagnoseDocument, "pkmodes diagnose --json")
    words = [*VERDICTS, HEARSAY.word]
    assert list(enumerations(described)) == [sorted(words), sorted(words), sorted([*words, NOT_MEASURED])]
    content = made_up(2, 2)[0].as_json() | {"verdict": HEARSAY.word}
    jsonschema.Draft202012Validator(described).validate(content)


def test_only_an_adequate_model_passes_and_only_a_settled_one_is_saved() -> None:
    assert [word for word, verdict in VERDICTS.items() if not verdict.fails] == ["adequate"]
    assert [word for word, verdict in VERDICTS.items() if verdict.settled] == ["adequate", "effect_found"]
    assert len({verdict.sentence for verdict in VERDICTS.values()}) == len(VERDICTS)


def test_every_colour_is_one_of_the_page() -> None:
    style = (ROOT / "src/pkmodes/pages/report/templates/style.css").read_text(encoding="utf-8")
    assert {verdict.colour for verdict in VERDICTS.values()} <= {*get_args(Colour)}
    for colour in get_args(Colour):
        assert len(re.findall(rf"--{colour}: #\w+;", style)) == 2, "light and dark"
        assert colour == "plain" or f".tone-{colour} {{ --tone: var(--{colour}); }}" in style


def test_the_texts_name_the_verdicts_in_their_order() -> None:
    listed = ", ".join([*VERDICTS][:-1]) + f" or {[*VERDICTS][-1]}"
    assert f"The verdict is {listed}, " in " ".join((cli.commands["diagnose"].help or "").split())
    quoted = ", ".join(f"`{word}`" for word in [*VERDICTS][:-1]) + f" or `{[*VERDICTS][-1]}`"
    assert f"| `verdict` | text | {quoted} |" in (ROOT / "docs/reference/json.md").read_text(encoding="utf-8")
    table = (
        (ROOT / "docs/reference/verdicts.md").read_text(encoding="utf-8").partition("| verdict | when |")[2]
    )
    assert re.findall(r"^\| `(\w+)` \|", table.partition("\n\n")[0], flags=re.MULTILINE) == [*VERDICTS]
