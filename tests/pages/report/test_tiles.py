"""The tiles at the head of a page: a value that is wider than its tile is wrapped within it."""

from __future__ import annotations

from dataclasses import replace
from pathlib import Path

import pytest

from helpers.pages.browser import opened
from helpers.pages.report_examples import made_up
from pkmodes.loop.diagnosis.verdict.findings import Finding, Value
from pkmodes.pages.report import report

#: Values with their standard deviations: many digits, a power of ten, and a short one.
VALUES = ((-1234.56789012, 4e-8), (-1.23456789e-7, 2e-14), (0.3, 0.01))
#: The tiles whose text is not within them, as drawn.
OUTSIDE = """
() => [...document.querySelectorAll(".numbers > div")].filter(tile => {
  const box = tile.getBoundingClientRect();
  return [...tile.children].some(part => {
    const range = document.createRange();
    range.selectNodeContents(part);
    return [...range.getClientRects()].some(line => line.left < box.left - 1 || line.right > box.right + 1);
  });
}).map(tile => tile.textContent)
"""


@pytest.mark.parametrize("width", [390, 1280])
def test_a_wide_value_stays_within_its_tile(width: int, tmp_path: Path) -> None:
    result, data = made_up(4, 3)
    values = tuple(
        Value(f"effects.{'x' * length}.mass", value, sigma, "kg*m^2")
        for length, (value, sigma) in zip((4, 60, 8), VALUES, strict=True)
    )
    effect = Finding("payload", ("payload",), values, {"payload": values}, 1e-9, "the payload")
    target = tmp_path / "page.html"
    target.write_text(report(replace(result, effects=(effect,)), data=data, title="robot"), encoding="utf-8")
    with opened(target, width=width) as view:
        tiles = view.page.locator(".numbers > div").all_inner_texts()
        assert any("\u22121234.56789012" in tile for tile in tiles)
        assert view.page.evaluate(OUTSIDE) == []
        assert not view.sideways
