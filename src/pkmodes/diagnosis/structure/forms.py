"""A matrix as an array or as a sparse one, whichever is cheaper, and what is asked of it in either form."""

from __future__ import annotations

from typing import Any

import numpy as np
from scipy import sparse

from pkmodes.diagnosis.problem import Array

#: What is left unsymmetric by rounding: of an entry, and of the largest one.
RELATIVE, ROUNDING = 1e-9, 1e-12
#: From this many coordinates on, a matrix with few entries is kept sparse, whatever it was given as.
MANY, FEW = 200, 0.05


def is_sparse(matrix: Any) -> bool:
    """Whether a matrix is one of SciPy's sparse ones."""
    return bool(sparse.issparse(matrix))


def entries_of(matrix: Any) -> Array:
    """Entries, those of a sparse matrix that are stored."""
    entries: Array = matrix.data if is_sparse(matrix) else matrix
    return entries


def count_of(matrix: Any) -> int:
    """How many entries are not zero."""
    return int(matrix.nnz) if is_sparse(matrix) else int(np.count_nonzero(matrix))


def size_of(matrix: Any) -> int:
    """Memory that a matrix takes [bytes]."""
    if is_sparse(matrix):
        return int(matrix.data.nbytes + matrix.indices.nbytes + matrix.indptr.nbytes)
    return int(matrix.nbytes)


def is_symmetric(matrix: Any) -> bool:
    """Whether a matrix is symmetric but for rounding."""
    if is_sparse(matrix):
        apart, size = abs(matrix - matrix.T.tocsc()), abs(matrix)
        rounding = ROUNDING * float(size.max()) if size.nnz else 0.0
        if apart.nnz == 0 or apart.max() <= rounding:
            return True
        return bool((apart - RELATIVE * size).max() <= rounding)
    if np.array_equal(matrix, matrix.T):
        return True
    return np.allclose(matrix, matrix.T, rtol=RELATIVE, atol=ROUNDING * np.abs(matrix).max())


def minus(a: Any, b: Any) -> Any:
    """A difference, of which one may have become dense where the other is not."""
    if is_sparse(a) != is_sparse(b):
        a, b = (x.toarray() if is_sparse(x) else x for x in (a, b))
    return a - b


def thin(matrix: Any) -> Any:
    """A derivative: one parameter often changes few entries, and products with the shapes are then cheap."""
    n = matrix.shape[0]
    if n < MANY or count_of(matrix) > FEW * n * n:
        return matrix.toarray() if is_sparse(matrix) else matrix
    return packed(matrix)


def packed(matrix: Any) -> Any:
    """A symmetric matrix as a sparse one, of which rows are columns."""
    if is_sparse(matrix):
        return sparse.csc_array(matrix)
    n, flat = len(matrix), np.ravel(matrix)
    places = np.flatnonzero(flat)  # several times as fast as over two axes
    starts = np.searchsorted(places, n * np.arange(n + 1))
    return sparse.csc_array((flat[places], places % n, starts), shape=matrix.shape)


def relative_change(change: Any, of: Any) -> float:
    """Largest change of an entry, relative to the diagonal entries of its row and column."""
    size = np.sqrt(np.abs(of.diagonal()))
    if is_sparse(change):
        entries = change.tocoo()
        rows, columns, moved = entries.row, entries.col, np.abs(entries.data)
    else:
        rows, columns = np.nonzero(change)
        moved = np.abs(change[rows, columns])
    scale = size[rows] * size[columns]
    # Entries beside a zero on the diagonal (a free coordinate) have no scale of their own.
    scale[scale == 0.0] = np.abs(entries_of(of)).max(initial=0.0)
    known = scale > 0.0
    return float((moved[known] / scale[known]).max(initial=0.0))
