"""Generated code gives vibrations at least six digits, or says that it cannot: the references have 80 digits."""

from __future__ import annotations

import ctypes
import subprocess
from pathlib import Path

import numpy as np
import pytest

from helpers.generated.compiled import COMPILER, packed
from helpers.references.high_precision import solved
from helpers.references.high_precision_mechanisms import mp
from helpers.references.oracle import Oracle
from helpers.robots.sample_robots import Sample, published
from pkmodes_derive.emit.numpy import eigen
from pkmodes_generated import linear_delta

FOLDER = Path(__file__).parents[2] / "generated" / "pkmodes_generated" / "linear_delta"
UNSOLVED = -1


def uneven(thin: float) -> Sample:
    """A linear delta with one thin belt, without gravity, which would mix modes."""
    robot = published((0.6, 0.03, -0.245))
    width = np.asarray(robot.parameters.belt_width) * [1.0, 1.0, thin]
    return robot._replace(parameters=robot.parameters._replace(belt_width=width, gravity=np.zeros(3)))


def expected(robot: Sample) -> np.ndarray:
    M, K = (mp.matrix(np.array(a, dtype=object).tolist()) for a in Oracle(*robot).modal_matrices())
    return np.asarray(np.sqrt(solved(M, K).values()[3:]) / (2 * np.pi))


def found_by_numpy(robot: Sample) -> np.ndarray | None:
    def matrices(p: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
        return linear_delta.modal_matrices(p, robot.parameters)

    try:
        return np.asarray(eigen._modes(robot.pose[None], np.zeros(1, int), matrices, 3)[0][0])
    except np.linalg.LinAlgError as error:
        assert "lost in rounding" in str(error)
        return None


@pytest.fixture(scope="module")
def library(tmp_path_factory: pytest.TempPathFactory) -> ctypes.CDLL:
    target = tmp_path_factory.mktemp("library") / "linear_delta.so"
    flags = ["-std=c99", "-O1", "-shared", "-fPIC"]
    subprocess.run(
        [str(COMPILER), *flags, str(FOLDER / "linear_delta.c"), "-o", str(target), "-lm"], check=True
    )
    return ctypes.CDLL(str(target))


THIN = (1.0, 1e-3, 1e-5, 1e-8, 1e-12)


def test_numpy_has_six_digits_or_raises() -> None:
    refused = []
    for thin in THIN:
        found = found_by_numpy(uneven(thin))
        if found is None:
            refused.append(thin)
        else:
            np.testing.assert_allclose(found[3:], expected(uneven(thin)), rtol=1e-6)
    assert refused == [1e-12]


@pytest.mark.compiler
def test_c_has_six_digits_or_is_unsolved(library: ctypes.CDLL) -> None:
    refused = []
    for thin in THIN:
        robot, f = uneven(thin), np.full(9, np.nan)
        given = np.ascontiguousarray(robot.pose), packed(robot.parameters), f
        pointers = [ctypes.c_void_p(a.ctypes.data) for a in given]
        status = library.linear_delta_modes(*pointers, None)
        if status:
            assert status == UNSOLVED
            refused.append(thin)
        else:
            np.testing.assert_allclose(f[3:], expected(robot), rtol=1e-6)
    assert refused == [1e-12]
