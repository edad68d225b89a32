"""BLAS on one thread: for matrices of some ten rows, its threads cost more than they save.

The diagnosis of a robot takes twice the processor time on two threads.  Evaluating modes is not affected: LAPACK
solves its small problems on one thread.
"""

from __future__ import annotations

from collections.abc import Iterator
from contextlib import contextmanager


@contextmanager
def one_blas_thread() -> Iterator[None]:
    """Limit BLAS to one thread, in the whole process, as long as this lasts; also a decorator."""
    from threadpoolctl import threadpool_limits  # it finds the libraries that are loaded so far

    with threadpool_limits(limits=1, user_api="blas"):
        yield
