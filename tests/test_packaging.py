"""What pyproject.toml says of the sdist and of the long description."""

from __future__ import annotations

import re
import tomllib
from pathlib import Path

ROOT = Path(__file__).parents[1]
HATCH = tomllib.loads((ROOT / "pyproject.toml").read_text(encoding="utf-8"))["tool"]["hatch"]


def test_all_links_of_the_long_description_are_absolute_and_exist() -> None:
    """As the build puts them into the README: an index shows it without the repository."""
    text = (ROOT / "README.md").read_text(encoding="utf-8")
    relative = re.findall(r"\]\((?!\w+:|#)([^)#]+)", text)
    assert len(relative) > 10
    for substitution in HATCH["metadata"]["hooks"]["fancy-pypi-readme"]["substitutions"]:
        text = re.sub(substitution["pattern"], substitution["replacement"], text)
    links = re.findall(r"(!?)\[[^\]]*\]\(([^)]+)\)", text)
    begin = r"https://pkmodes\.invalid/(raw|blob)/v\$HFPR_VERSION/([^#]+)"
    own = [(image, match) for image, link in links if (match := re.match(begin, link))]
    assert [match[2] for _, match in own] == relative
    for image, match in own:
        assert match[1] == ("raw" if image else "blob")
        assert (ROOT / match[2]).exists()
    assert all(link.startswith(("https://", "#")) for _, link in links)
    assert "<img" not in text


def test_the_sdist_has_what_a_wheel_is_built_from() -> None:
    targets = HATCH["build"]["targets"]
    listed = targets["sdist"]["include"]
    assert all((ROOT / name.lstrip("/")).exists() for name in listed)
    needed = [*targets["wheel"]["packages"], targets["wheel"]["hooks"]["custom"]["path"], "README.md"]
    for path in needed:
        assert any(f"/{path}/".startswith(f"{name}/") for name in listed), path
