"""The pictures of docs/signals.md are those of the page's own campaign."""

from __future__ import annotations

import importlib.util
from pathlib import Path
from xml.etree import ElementTree

import pytest

from helpers.pages.documentation import ROOT

FOLDER = ROOT / "docs/figures"


def texts(picture: Path) -> list[str]:
    """Return labels and numbers on the axes, which follow from what is drawn."""
    return [
        "".join(element.itertext())
        for element in ElementTree.parse(picture).iter("{http://www.w3.org/2000/svg}text")
    ]


def test_the_pictures_are_current(tmp_path: Path) -> None:
    pytest.importorskip("matplotlib")
    spec = importlib.util.spec_from_file_location("signals_pictures", FOLDER / "signals.py")
    assert spec is not None
    assert spec.loader is not None
    script = importlib.util.module_from_spec(spec)
    spec.loader.exec_module(script)
    script.main([str(tmp_path)])
    page = (ROOT / "docs/signals.md").read_text(encoding="utf-8")
    assert sorted(path.stem for path in tmp_path.iterdir()) == sorted(script.PICTURES)
    for path in sorted(tmp_path.iterdir()):
        assert f"(figures/{path.name})" in page
        assert texts(path) == texts(FOLDER / path.name), f"run: python docs/figures/signals.py ({path.name})"
        assert len(texts(path)) > 10
