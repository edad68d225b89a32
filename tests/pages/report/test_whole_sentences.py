"""Sentences are shown whole, on pages, in figures and on a terminal, however long they are; labels may be cut."""

from __future__ import annotations

import re
from dataclasses import replace
from html import unescape

import pytest

from helpers.pages.report_examples import made_up
from helpers.robots.robot_text import PUBLISHED
from pkmodes import read_robot
from pkmodes.cli.diagnosis_tables import show_diagnosis
from pkmodes.loop.diagnosis.verdict.findings import Examined
from pkmodes.pages.plots import scores
from pkmodes.pages.plots.scores import _row_label
from pkmodes.pages.report import report
from pkmodes.pages.report.formatting import MAX_LABEL_LENGTH, clean, label_cell, shorten, typeset_sentences

#: Longer than any limit that a label or a sentence ever had.
LONG = "what was measured there cannot be told from what was measured elsewhere " * 40


def long_sentence(end: str) -> str:
    return f"{LONG}{end}"


def read(html: str) -> str:
    return " ".join(unescape(re.sub(r"<[^>]*>", " ", html)).split())


def test_every_sentence_of_a_diagnosis_is_whole(capsys: pytest.CaptureFixture[str]) -> None:
    made, data = made_up(4, 3)
    tested = Examined("belt_mass", 0.1, (), True, long_sentence("ends a candidate"))
    result = replace(
        made,
        verdict="ambiguous",
        effects=(),
        survivors=(("payload",), ("belt_mass",)),
        reason=long_sentence("ends the reason"),
        headline=long_sentence("ends the headline"),
        not_separated=long_sentence("ends why nothing is proposed"),
        notes=(long_sentence("ends a note"),),
        candidates=(made.candidates[0], tested),
    )
    page = read(report(result, data=data))
    for end in ("the reason", "the headline", "why nothing is proposed", "a note", "a candidate"):
        assert f"elsewhere ends {end}" in page
    show_diagnosis(read_robot(PUBLISHED), result)
    printed = " ".join(capsys.readouterr().out.split())
    for end in ("the reason", "why nothing is proposed", "a note"):
        assert f"elsewhere ends {end}" in printed


def test_only_what_a_file_names_is_shortened() -> None:
    assert clean(LONG) == LONG
    assert typeset_sentences(LONG) == LONG
    assert len(shorten(LONG)) == MAX_LABEL_LENGTH
    assert shorten(LONG)[-1] == "\u2026"
    assert shorten("P1") == "P1"
    assert label_cell(LONG).text == shorten(LONG)
    assert label_cell(LONG).terminal_text == LONG, "a terminal has it in full"


def test_a_row_of_a_figure_has_its_words_whole_or_not_at_all() -> None:
    assert _row_label("the belts are heavy", "belt_mass") == "the belts are heavy (belt_mass)"
    assert _row_label("w" * (scores.MAX_LABEL_LENGTH - len("belt_mass")), "belt_mass").startswith("www")
    assert _row_label(LONG, "belt_mass") == "belt_mass"
    assert _row_label("", "effects.payload.mass") == "payload.mass"
