"""What one core can do, and where the compiled evaluator spends its time: measured in small C programs."""

from __future__ import annotations

import ctypes
import subprocess
from collections.abc import Callable
from pathlib import Path

import numpy as np

from peers import MissingError
from pkmodes.core.compiled import build
from published import published

HERE = Path(__file__).parent


def compiled(source: str, folder: Path, flags: list[str]) -> ctypes.CDLL:
    cc = build.compiler()
    if cc is None:
        raise MissingError("there is no C compiler: the peak and the parts are left out")
    library = folder / f"{Path(source).stem}-{len(list(folder.iterdir()))}.so"
    command = [*cc, *flags, "-shared", "-fPIC", str(HERE / source), "-o", str(library), "-lm"]
    done = subprocess.run(command, capture_output=True, text=True, check=False)
    if done.returncode:
        raise MissingError(f"{source} cannot be compiled, its rows are left out: {done.stderr.strip()[:200]}")
    return ctypes.CDLL(str(library))


class Peak:
    """The peak of a core and the time of QL's rotations, the best of all measurements so far.

    A measurement takes less than a millisecond, so that some are not interrupted.

    Attributes
    ----------
    width : int
        Doubles in a vector.
    fused, separate : float
        Operations per second with fused and with separate products and sums.
    rotation, three_rotations : float
        Seconds of a rotation in every lane, and of three independent ones together.
    """

    def __init__(self, folder: Path) -> None:
        flags = ["-std=gnu11", "-O3", "-march=native", "-fno-math-errno", "-fno-trapping-math"]
        self._fused = compiled("peak.c", folder, [*flags, "-ffp-contract=fast"])
        self._separate = compiled("peak.c", folder, [*flags, "-ffp-contract=off", "-DSEPARATE"])
        for library in (self._fused, self._separate):
            for name in ("peak", "rotation", "three_rotations"):
                function = getattr(library, name)
                function.restype = ctypes.c_double
                function.argtypes = [ctypes.c_long, *[ctypes.c_double] * (2 if name == "peak" else 1)]
        self.width = int(self._fused.width())
        self.fused = self.separate = 0.0
        self.rotation = self.three_rotations = np.inf

    def measure(self) -> None:
        self.fused = max(self.fused, self._fused.peak(100_000, 1.0, 0.999))
        self.separate = max(self.separate, self._separate.peak(100_000, 1.0, 0.999))
        self.rotation = min(self.rotation, self._separate.rotation(10_000, 1.0))
        self.three_rotations = min(self.three_rotations, self._separate.three_rotations(10_000, 1.0))


def parts(poses: np.ndarray, folder: Path, width: int) -> tuple[Callable[[], None], np.ndarray, int]:
    """Prepare the measurement of the eigensolver's parts.

    Returns
    -------
    measure : callable
        Fills the array.
    best : ndarray, shape (3,)
        Smallest times of the reduction, the tridiagonalisation and QL [s per pose].
    together : int
        Poses that are solved together.
    """
    options = [*build.WIDTHS.get(build.machine(), {2: ()})[width], f"-DLANES_WIDTH={width}"]
    library = compiled(
        "parts.c", folder, [*build.FLAGS, *options, "-fvisibility=default", f"-I{build.FOLDER}"]
    )
    together = int(library.together())
    M, K = published().matrices(poses[: 100 * together])
    best = np.full(3, np.inf)

    def measure() -> None:
        found = np.zeros(3)
        library.parts(ctypes.c_long(len(M)), *(ctypes.c_void_p(x.ctypes.data) for x in (M, K, found)))
        np.minimum(best, found / len(M), out=best)

    return measure, best, together
