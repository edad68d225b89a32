"""What docs/how-to/maps.md says about marks, and docs/how-to/cluster.md about commands and settings."""

from __future__ import annotations

import re
import shlex
from pathlib import Path

import dask
import distributed  # noqa: F401  # adds its settings to those of Dask
import yaml

from pkmodes.cli.map import map_
from pkmodes.machine.dataset.variables import EVENT_FLAGS
from pkmodes.machine.maps.tracking import MIN_CLEAR_MAC, MIN_SAME_MAC

ROOT = Path(__file__).parents[3]
PAGE = (ROOT / "docs" / "how-to/maps.md").read_text(encoding="utf-8")
BLOCK = re.compile(r"^```(\w*)\n(.*?)^```$", re.DOTALL | re.MULTILINE)


def test_the_page_on_clusters_has_programs_options_and_settings_that_exist() -> None:
    page = (ROOT / "docs" / "how-to/cluster.md").read_text(encoding="utf-8")
    found = BLOCK.findall(page)
    for language, text in found:
        if language == "python":
            compile(text, "docs/how-to/cluster.md", "exec")
    (mapped,) = re.findall(r"^pkmodes map (.*)$", page, re.MULTILINE)
    with map_.make_context("map", shlex.split(mapped), resilient_parsing=True) as context:
        assert context.params["scheduler"] == "tcp://192.168.0.10:8786"
    (settings,) = (yaml.safe_load(text) for language, text in found if language == "yaml")
    tls = settings["distributed"]["comm"]["tls"]
    known = dask.config.get("distributed.comm.tls")
    assert tls.keys() <= known.keys()
    for who in ("scheduler", "worker", "client"):
        assert tls[who].keys() <= known[who].keys()
    assert settings["distributed"]["comm"].keys() <= dask.config.get("distributed.comm").keys()


def test_marks_are_those_of_the_code() -> None:
    for name, bit in EVENT_FLAGS.items():
        assert f"| `{name}` | {bit} |" in PAGE
    assert f"at least {MIN_CLEAR_MAC:g} |" in PAGE
    assert f"below {MIN_SAME_MAC:g}, but" in PAGE
