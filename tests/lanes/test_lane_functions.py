"""What lane.h adds to the operators of the compiler, for every width of lanes that this processor has."""

from __future__ import annotations

import ctypes
import subprocess
from pathlib import Path

import numpy as np
import pytest

from pkmodes.core.compiled import build
from pkmodes.core.compiled.loader import load

pytestmark = pytest.mark.compiler

SOURCE = """
#include "lane.h"
void signs(const double *x, double *of_lanes, double *of_one)
{
    *(lane_in_memory *)of_lanes = lanes_sign((lane)*(const lane_in_memory *)x);
    for (int w = 0; w < LANES_WIDTH; w++)
        of_one[w] = lanes_sign(x[w]);
}
void transposed(const double *x, double *y)
{
    lane rows[LANES_WIDTH];
    for (int w = 0; w < LANES_WIDTH; w++)
        rows[w] = *(const lane_in_memory *)(x + w * LANES_WIDTH);
    lanes_transpose(rows);
    for (int w = 0; w < LANES_WIDTH; w++)
        *(lane_in_memory *)(y + w * LANES_WIDTH) = rows[w];
}
"""
WIDTHS = build.WIDTHS.get(build.machine(), {2: ()})


@pytest.fixture(params=WIDTHS)
def lanes(request: pytest.FixtureRequest, tmp_path: Path) -> tuple[ctypes.CDLL, int]:
    width, cc = request.param, build.compiler()
    if width > load("pkmodes_generated.corexy", "corexy").width:
        pytest.skip("this processor has no lanes of this width")
    (tmp_path / "lanes.c").write_text(SOURCE, encoding="utf-8")
    options = [*build.FLAGS, *WIDTHS[width], f"-DLANES_WIDTH={width}", f"-I{build.FOLDER}"]
    options.remove("-fvisibility=hidden")
    command = [*cc, *options, "-shared", "lanes.c", "-o", "lanes.so", "-lm"]
    subprocess.run(command, cwd=tmp_path, check=True)
    return ctypes.CDLL(str(tmp_path / "lanes.so")), width


def pointer(array: np.ndarray) -> ctypes.c_void_p:
    return ctypes.c_void_p(array.ctypes.data)


def test_signs(lanes: tuple[ctypes.CDLL, int]) -> None:
    library, width = lanes
    for x in np.array([2.0, -3.0, 0.0, -0.0, 1e-310, -np.inf, 5.0, -1.0]).reshape(-1, width):
        of_lanes, of_one = np.full(width, 9.0), np.full(width, 9.0)
        library.signs(pointer(x), pointer(of_lanes), pointer(of_one))
        np.testing.assert_array_equal(of_lanes, np.sign(x))
        np.testing.assert_array_equal(of_one, np.sign(x))


def test_rows_become_columns(lanes: tuple[ctypes.CDLL, int]) -> None:
    library, width = lanes
    x = np.arange(float(width * width)).reshape(width, width)
    y = np.zeros_like(x)
    library.transposed(pointer(x), pointer(y))
    np.testing.assert_array_equal(y, x.T)
