"""The pictures of pages are those that their scripts draw from the present program."""

from __future__ import annotations

import importlib.util
from pathlib import Path
from xml.etree import ElementTree

import numpy as np
import pytest
from PIL import Image, ImageChops

from helpers.pages.documentation import ROOT

FOLDER = ROOT / "docs/figures"


def texts(picture: Path) -> list[str]:
    """Return titles, labels and numbers on the axes, which follow from what is drawn."""
    return [
        "".join(element.itertext())
        for element in ElementTree.parse(picture).iter("{http://www.w3.org/2000/svg}text")
    ]


def alike(one: Path, other: Path) -> bool:
    """Whether two pictures differ by the edges of letters at most, which libraries draw differently."""
    with Image.open(one) as first, Image.open(other) as second:
        if first.size != second.size:
            return False
        difference = ImageChops.difference(first.convert("RGB"), second.convert("RGB"))
    return float(np.mean(np.asarray(difference) > 40)) < 0.005


@pytest.mark.parametrize(
    ("name", "page_name"),
    [
        ("tutorial", "tutorial/tutorial"),
        ("signals", "how-to/signals"),
        ("shapers", "how-to/shapers"),
        ("six_legs", "tutorial/gallery"),
    ],
)
def test_the_pictures_are_current(name: str, page_name: str, tmp_path: Path) -> None:
    pytest.importorskip("matplotlib")
    spec = importlib.util.spec_from_file_location(f"{name}_pictures", FOLDER / f"{name}.py")
    assert spec is not None
    assert spec.loader is not None
    script = importlib.util.module_from_spec(spec)
    spec.loader.exec_module(script)
    script.main([str(tmp_path)])
    drawn = sorted(tmp_path.iterdir())
    assert {path.stem for path in drawn} >= set(script.PICTURES)
    page = (ROOT / f"docs/{page_name}.md").read_text(encoding="utf-8")
    for path in drawn:
        assert f"(../figures/{path.name})" in page
        remedy = f"run: python docs/figures/{name}.py ({path.name})"
        if path.suffix == ".svg":
            assert texts(path) == texts(FOLDER / path.name), remedy
            assert len(texts(path)) > 10
        else:
            assert alike(path, FOLDER / path.name), remedy
