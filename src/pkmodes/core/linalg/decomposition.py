"""The singular value decomposition, also where LAPACK's divide and conquer does not converge."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

Array = NDArray[np.float64]


def thin_svd(matrix: Array) -> tuple[Array, Array, Array]:
    """Return the thin singular value decomposition of a matrix.

    LAPACK's divide and conquer (gesdd), which NumPy calls, does not converge for a few matrices of low rank, such as
    the signatures of many causes with the same effect.  The slower QR iteration (gesvd) then takes its place.

    - matrix: (a, b)

    Returns U, s and Vh, (a, k), (k,) and (k, b), with k the smaller of a and b.
    Raises numpy.linalg.LinAlgError if a number is not finite.
    """
    try:
        U, s, Vh = np.linalg.svd(matrix, full_matrices=False)
    except np.linalg.LinAlgError:
        if not np.isfinite(matrix).all():
            raise
        import scipy.linalg  # slow to import, and rarely needed

        U, s, Vh = scipy.linalg.svd(matrix, full_matrices=False, lapack_driver="gesvd")
    return U, s, Vh
