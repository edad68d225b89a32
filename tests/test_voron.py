"""The example of a real printer runs, and docs/explanation/voron.md and voron.csv quote its output."""

from __future__ import annotations

import importlib.util
import re
import sys
from pathlib import Path
from types import ModuleType

import pytest

ROOT = Path(__file__).parents[1]
PAGE = (ROOT / "docs/explanation/voron.md").read_text(encoding="utf-8")
TABLE = (ROOT / "docs/explanation/voron.csv").read_text(encoding="utf-8").splitlines()


@pytest.fixture(scope="module")
def example() -> ModuleType:
    spec = importlib.util.spec_from_file_location("voron_example", ROOT / "examples/voron/voron.py")
    assert spec is not None
    assert spec.loader is not None
    module = importlib.util.module_from_spec(spec)
    sys.modules[spec.name] = module
    spec.loader.exec_module(module)
    return module


@pytest.mark.slow
def test_the_page_states_what_the_example_prints(example: ModuleType) -> None:
    loop = example.close_the_loop()
    printed = example.report(loop)
    rows = example.table(loop)
    cells = [[*rows[0]], *(row.values() for row in rows)]
    assert [",".join(map(str, row)) for row in cells] == TABLE
    for (series, robot, sigma), found in loop.found.items():
        assert found.verdict == ("adequate" if (robot, sigma) == ("linear", "5 %") else "unexplained")
        assert not found.effects
        if sigma == "stated":
            assert f"{100 * found.refit.rms_relative:.1f} % |" in PAGE, (series, robot)
    assert "on preloads: rms 17.7 %" in printed
    assert "misses the second by 17.7 %" in " ".join(PAGE.split())
    assert "deviation 3.8 Hz" in printed


def test_the_page_states_the_independent_fits(example: ModuleType) -> None:
    data = {name: example.read(example.HERE / f"{name}.csv") for name in example.SERIES}
    series = {name: example.peaks(rows) for name, rows in data.items()}
    series["all seven"] = example.peaks(data["measured"], example.SLACKEST)
    for name, at in series.items():
        (line,) = re.findall(rf"^\| {name} \| .*\(.*$", PAGE, re.M)
        for law in example.LAWS:
            p = example.fitted(law, at)
            fit, apart = example.rms(example.predicted(law, at, p), at), example.left_out(law, at)
            assert f"{100 * fit:.1f} % ({100 * apart:.1f} %)" in line, (name, law)
