"""Matrices as dense or sparse arrays, whichever is cheaper, and operations on either form."""

from __future__ import annotations

from typing import Any

import numpy as np
from scipy import sparse

from pkmodes.diagnosis.problem import Array

#: Asymmetry due to rounding, relative to an entry and to the largest entry.
RELATIVE, ROUNDING = 1e-9, 1e-12
#: From this many coordinates on, a matrix with at most this part of its entries is stored sparse.
MANY, FEW = 200, 0.05


def is_sparse(matrix: Any) -> bool:
    """Return whether a matrix is a SciPy sparse matrix."""
    return bool(sparse.issparse(matrix))


def entries_of(matrix: Any) -> Array:
    """Return the entries; of a sparse matrix, the stored ones."""
    entries: Array = matrix.data if is_sparse(matrix) else matrix
    return entries


def count_of(matrix: Any) -> int:
    """Return the number of nonzero entries."""
    return int(matrix.nnz) if is_sparse(matrix) else int(np.count_nonzero(matrix))


def size_of(matrix: Any) -> int:
    """Return the memory of a matrix [bytes]."""
    if is_sparse(matrix):
        return int(matrix.data.nbytes + matrix.indices.nbytes + matrix.indptr.nbytes)
    return int(matrix.nbytes)


def is_symmetric(matrix: Any) -> bool:
    """Return whether a matrix is symmetric up to rounding."""
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
    """Return a - b, where one may be dense and the other sparse."""
    if is_sparse(a) != is_sparse(b):
        a, b = (x.toarray() if is_sparse(x) else x for x in (a, b))
    return a - b


def thin(matrix: Any) -> Any:
    """Return a derivative in its cheaper form: a parameter often changes few entries."""
    n = matrix.shape[0]
    if n < MANY or count_of(matrix) > FEW * n * n:
        return matrix.toarray() if is_sparse(matrix) else matrix
    return packed(matrix)


def packed(matrix: Any) -> Any:
    """Return a symmetric matrix as a sparse one; by symmetry, its rows are used as columns."""
    if is_sparse(matrix):
        return sparse.csc_array(matrix)
    n, flat = len(matrix), np.ravel(matrix)
    places = np.flatnonzero(flat)  # several times as fast as over two axes
    starts = np.searchsorted(places, n * np.arange(n + 1))
    return sparse.csc_array((flat[places], places % n, starts), shape=matrix.shape)


def relative_change(change: Any, of: Any) -> float:
    """Return the largest change of an entry, relative to the diagonal entries of its row and column."""
    size = np.sqrt(np.abs(of.diagonal()))
    if is_sparse(change):
        entries = change.tocoo()
        rows, columns, moved = entries.row, entries.col, np.abs(entries.data)
    else:
        rows, columns = np.nonzero(change)
        moved = np.abs(change[rows, columns])
    scale = size[rows] * size[columns]
    # Entries with a zero diagonal entry (a free coordinate) have no scale.
    scale[scale == 0.0] = np.abs(entries_of(of)).max(initial=0.0)
    known = scale > 0.0
    return float((moved[known] / scale[known]).max(initial=0.0))
