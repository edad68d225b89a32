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
#define LANES_BASE 2
#define LANES_POSE 1
#define LANES_INDEPENDENT 1
#define LANES_DEPENDENT 1
#define LANES_LINEAR 1
static const int LANES_INDEPENDENT_INDICES[] = {0}, LANES_DEPENDENT_INDICES[] = {1};
#include "strain_free.h"
void eliminated(const double *a, const double *b, double *x)
{
    lane A[9], B[6];
    for (int i = 0; i < 9; i++)
        A[i] = *(const lane_in_memory *)(a + i * LANES_WIDTH);
    for (int i = 0; i < 6; i++)
        B[i] = *(const lane_in_memory *)(b + i * LANES_WIDTH);
    lanes_eliminate(3, 2, A, B);
    for (int i = 0; i < 6; i++)
        *(lane_in_memory *)(x + i * LANES_WIDTH) = B[i];
}
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


def test_equations_are_solved_whatever_the_order_of_their_rows(lanes: tuple[ctypes.CDLL, int]) -> None:
    """In each lane the rows have another order, so that pivots are 0 in some of them."""
    library, width = lanes
    rng = np.random.default_rng(4)
    A = np.diag([3.0, -2.0, 0.5]) + np.triu(rng.standard_normal((width, 3, 3)), 1)
    orders = np.array([rng.permutation(3) for _ in range(width)])
    orders[0] = [2, 0, 1]
    A, B = np.take_along_axis(A, orders[:, :, None], 1), rng.standard_normal((width, 3, 2))
    x = np.empty((3, 2, width))
    a, b = (np.ascontiguousarray(np.moveaxis(array, 0, -1)) for array in (A, B))
    library.eliminated(pointer(a), pointer(b), pointer(x))
    np.testing.assert_allclose(np.moveaxis(x, -1, 0), np.linalg.solve(A, B), rtol=1e-13, atol=1e-14)
