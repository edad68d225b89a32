"""The C for controllers on other processors, under emulation: one machine's results are those of the other."""

from __future__ import annotations

import importlib
import re
from collections.abc import Iterator
from pathlib import Path
from typing import Any

import numpy as np
import pytest

from helpers.runs.programs import needed
from helpers.runs.shared import Shared

pytestmark = pytest.mark.compiler
ROOT = Path(__file__).parents[2]
STUDY = ROOT / "docs/studies/microcontroller"
ROBOTS = (
    *("linear-delta-2022", "linear-delta-2022-identified", "clavel-delta", "corexy-printer"),
    *("cartesian-printer", "bed-slinger"),
)
#: Their rows of the table are written by the study only: a test would take a minute for each.
SIX_LEGGED = ("hexapod", "hexaglide")


@pytest.fixture(scope="module")
def targets() -> Iterator[Any]:
    with pytest.MonkeyPatch.context() as patch:
        patch.syspath_prepend(STUDY)
        yield importlib.import_module("targets")


@pytest.fixture(scope="module")
def measured(targets: Any, shared: Shared, tmp_path_factory: pytest.TempPathFactory) -> Any:
    """Return what is measured of a robot on the microcontroller."""

    def measure(name: str) -> Any:
        needed("arm-none-eabi-gcc", "qemu-system-arm")
        file = ROOT / "robots" / f"{name}.toml"
        return shared.value(
            f"cortex_m7_{name}",
            lambda: targets.firmware(file, targets.ROBOTS[name], tmp_path_factory.mktemp("cortex_m7")),
        )

    return measure


def test_all_robots_are_measured(targets: Any) -> None:
    assert tuple(targets.ROBOTS) == ROBOTS + SIX_LEGGED
    assert {path.stem for path in (ROOT / "robots").glob("*.toml")} == set(targets.ROBOTS)


@pytest.mark.parametrize("name", ROBOTS)
def test_two_compilers_and_two_processors_give_the_same_bits(
    subtests: pytest.Subtests, targets: Any, tmp_path: Path, name: str
) -> None:
    """Without contraction of products and sums: frequencies, damping ratios, amplitudes and shaped commands."""
    needed("gcc", "clang", "aarch64-linux-gnu-gcc", "qemu-aarch64")
    program = targets.Program.write(ROOT / "robots" / f"{name}.toml", targets.ROBOTS[name], 100, tmp_path)
    for single in (False, True):
        with subtests.test(single=single):
            options = ["-O2", "-ffp-contract=off", *(["-DPKMODES_FLOAT"] if single else [])]
            found = {}
            for compiler in ("gcc", "clang"):
                image = program.built([compiler, *options], compiler)
                found[compiler] = program.run([str(image)], single)
            image = program.built(["aarch64-linux-gnu-gcc", "-static", *options], "aarch64")
            found["aarch64"] = program.run(["qemu-aarch64", str(image)], single)
            expected = found.pop("gcc")
            good = expected.status == 0
            assert np.count_nonzero(good) > 60
            for results in found.values():
                np.testing.assert_array_equal(results.status, expected.status)
                for field in ("frequencies", "damping_ratios", "amplitudes", "command"):
                    one, other = (getattr(each, field)[good] for each in (results, expected))
                    np.testing.assert_array_equal(one, other)


@pytest.mark.parametrize("name", ROBOTS)
def test_a_microcontroller_has_room_for_it(measured: Any, name: str) -> None:
    """A Cortex-M7 with a floating-point unit for float only."""
    found = measured(name)
    assert found.double == ()
    assert found.flash < 32 * 1024
    assert max(found.results.stack) < 4 * 1024
    assert min(found.results.stack) > 256  # the paint is washed off where something ran
    assert np.count_nonzero(found.results.status == 0) > 60
    assert found.error < 1e-4


def test_arithmetic_with_double_would_be_found(targets: Any, tmp_path: Path) -> None:
    """As `PKMODES_FLOAT` forgotten would leave it."""
    needed("arm-none-eabi-gcc")
    program = targets.Program.write(
        ROOT / "robots/corexy-printer.toml", targets.ROBOTS["corexy-printer"], 2, tmp_path
    )
    command = [option for option in targets.CORTEX_M7 if option != "-DPKMODES_FLOAT"]
    image = program.built(command, "double.elf", targets.IMAGE)
    assert targets.double_routines(image)


def test_the_table_of_the_page_is_what_is_measured(targets: Any, measured: Any) -> None:
    """Sizes to a tenth, since compilers differ between versions."""
    page = targets.PAGE.read_text(encoding="utf-8")
    (shown,) = re.findall(re.escape(targets.BEGIN) + r"\n(.*?)\n" + re.escape(targets.END), page, re.S)
    found = targets.table({name: measured(name) for name in ROBOTS})
    rows = [
        [re.findall(r"[\d.]+(?:e-\d+)?", line.split("|", 2)[2]) for line in text.splitlines()]
        for text in (shown, found)
    ]
    rows[0] = rows[0][: -len(SIX_LEGGED)]
    assert len(rows[0]) == len(rows[1]) == 2 + len(ROBOTS)
    for one, other in zip(*rows, strict=True):
        np.testing.assert_allclose([float(x) for x in one], [float(x) for x in other], rtol=0.1)
