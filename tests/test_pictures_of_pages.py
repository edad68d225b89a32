"""The pictures of pages are those that their scripts draw from the present program."""

from __future__ import annotations

import importlib.util
from pathlib import Path
from xml.etree import ElementTree

import pytest

from helpers.pages.documentation import ROOT

FOLDER = ROOT / "docs/figures"


def texts(picture: Path) -> list[str]:
    """Return titles, labels and numbers on the axes, which follow from what is drawn."""
    return [
        "".join(element.itertext())
        for element in ElementTree.parse(picture).iter("{http://www.w3.org/2000/svg}text")
    ]


@pytest.mark.parametrize("name", ["tutorial", "signals"])
def test_the_pictures_are_current(name: str, tmp_path: Path) -> None:
    pytest.importorskip("matplotlib")
    spec = importlib.util.spec_from_file_location(f"{name}_pictures", FOLDER / f"{name}.py")
    assert spec is not None
    assert spec.loader is not None
    script = importlib.util.module_from_spec(spec)
    spec.loader.exec_module(script)
    script.main([str(tmp_path)])
    drawn = sorted(tmp_path.iterdir())
    assert [path.stem for path in drawn] == sorted(script.PICTURES)
    page = (ROOT / f"docs/{name}.md").read_text(encoding="utf-8")
    for path in drawn:
        assert f"(figures/{path.name})" in page
        assert texts(path) == texts(FOLDER / path.name), f"run: python docs/figures/{name}.py ({path.name})"
        assert len(texts(path)) > 10
