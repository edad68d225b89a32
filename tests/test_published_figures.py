"""What the paper writes about its figures, as docs/figures.md reports it."""

from __future__ import annotations

import importlib
import re
from pathlib import Path

import pytest

from documentation import same

ROOT = Path(__file__).parents[1]
STUDY = ROOT / "docs/studies/published_figures"


def test_the_table_of_the_page_is_what_the_study_finds(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.syspath_prepend(STUDY)
    claims = importlib.import_module("claims")
    page = (ROOT / "docs/figures.md").read_text(encoding="utf-8")
    (shown,) = re.findall(re.escape(claims.BEGIN) + r"\n(.*?)" + re.escape(claims.END), page, re.S)
    found = claims.table()
    for one, other in zip(shown.splitlines(), found.splitlines(), strict=True):
        same(one, other, fit=True)
    assert found.count("yes:") + found.count("**no**:") == 2 * len(claims.CLAIMS)


@pytest.mark.parametrize("name", ["identified", "declared"])
def test_the_page_has_its_pictures(name: str) -> None:
    page = (ROOT / "docs/figures.md").read_text(encoding="utf-8")
    pictures = re.findall(rf"\((figures/{name}/\w+\.png)\)", page)
    assert len(pictures) >= 4
    for picture in pictures:
        assert (ROOT / "docs" / picture).read_bytes().startswith(b"\x89PNG"), picture
