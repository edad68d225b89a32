"""Other ways to the modes of the published robot, each with what its users would do to make it fast.

All have double precision, constants folded, compilation excluded, blocks of poses that fit the cache, and arrays
for the results that were used before.  All solve the same problem: M is scaled by its diagonal and factored, then
LAPACK's symmetric solver is called, without vectors where only frequencies are wanted.
"""

from __future__ import annotations

import importlib.util
import tempfile
from collections.abc import Callable, Iterator
from concurrent.futures import ThreadPoolExecutor
from dataclasses import dataclass
from functools import cache
from pathlib import Path

import numpy as np

from peer_source import matrices, printed
from pkmodes.codegen.generation import generate
from pkmodes.core.compiled.build import compiler
from published import ROBOT, published

Array = np.ndarray
#: Of poses (N, 3); fills frequencies (N, n) and, unless None, shapes (N, n, n): a mode to a row, phi^T M phi = 1.
Run = Callable[[Array, Array, Array | None], None]
#: The same for a block, returning them.
OfBlock = Callable[[Array, bool], tuple[Array, Array | None]]
#: Poses evaluated together by the ways that evaluate arrays.
BLOCK = 2048


class MissingError(Exception):
    """A package that a way needs is not installed; the text is a line for the reader."""


@dataclass(frozen=True)
class Way:
    """A way to compute modes: for plots, for tables, and to run."""

    label: str
    name: str
    run: Run


def ways(threads: int = 1) -> Iterator[Way | MissingError]:
    """Make the ways in the order of the table; a way whose package is missing says so.

    Parameters
    ----------
    threads : int
        With more than one, only the ways that can use them.
    """
    makers = [batched, casadi_map, jax_vmap, numba_loop]
    if threads == 1:
        makers = [lambdify_loop, *makers, mujoco_differences]
    for make in makers:
        try:
            yield make(threads)
        except MissingError as missing:
            yield missing


def required(module: str, package: str) -> None:
    if importlib.util.find_spec(module) is None:
        raise MissingError(f"{package} is not installed, its row is left out: pip install '.[benchmark]'")


def frequencies_of(eigenvalues: Array) -> Array:
    return np.copysign(np.sqrt(np.abs(eigenvalues)), eigenvalues) / (2 * np.pi)


def lambdify_loop(threads: int = 1) -> Way:
    """What SymPy's users do: lambdify both matrices, call SciPy at each pose."""
    import sympy
    from scipy.linalg import eigh

    known = matrices()
    values = [entry.value for result in known.program.results for entry in result.entries]
    for symbol, step in reversed(known.program.steps):
        values = [value.xreplace({symbol: step}) for value in values]
    both = [sympy.Matrix(known.filled(name, values, sympy.Integer(0))) for name in ("M", "K")]
    evaluate = sympy.lambdify(known.function.arguments[0].symbols, both, modules="numpy", cse=True)

    def run(poses: Array, frequencies: Array, shapes: Array | None) -> None:
        for i, p in enumerate(poses):
            M, K = evaluate(*p)
            if shapes is None:
                eigenvalues = eigh(K, M, eigvals_only=True)
            else:
                eigenvalues, columns = eigh(K, M)
                shapes[i] = columns.T
            frequencies[i] = frequencies_of(eigenvalues)

    return Way("lambdify, SciPy", "(a) `sympy.lambdify` and `scipy.linalg.eigh` in a loop", run)


def lapack(M: Array, K: Array, shapes: bool) -> tuple[Array, Array | None]:
    """Solve a block of problems with NumPy's batched LAPACK."""
    scale = 1.0 / np.sqrt(np.diagonal(M, axis1=-2, axis2=-1))
    both = scale[:, :, None] * scale[:, None, :]
    inverse = np.linalg.inv(np.linalg.cholesky(M * both))
    transposed = np.swapaxes(inverse, -1, -2)
    standard = inverse @ (K * both) @ transposed
    if not shapes:
        return frequencies_of(np.linalg.eigvalsh(standard)), None
    eigenvalues, y = np.linalg.eigh(standard)
    return frequencies_of(eigenvalues), np.swapaxes(transposed @ y, -1, -2) * scale[:, None, :]


def in_blocks(one: OfBlock, threads: int = 1) -> Run:
    """Evaluate block by block, blocks on several threads."""

    def run(poses: Array, frequencies: Array, shapes: Array | None) -> None:
        def part(start: int) -> None:
            where = slice(start, start + BLOCK)
            frequencies[where], found = one(poses[where], shapes is not None)
            if shapes is not None:
                shapes[where] = found

        starts = range(0, len(poses), BLOCK)
        if threads == 1:
            for start in starts:
                part(start)
        else:
            with ThreadPoolExecutor(threads) as pool:
                list(pool.map(part, starts))

    return run


def batched(threads: int = 1) -> Way:
    """Generated NumPy code of this robot, and NumPy's batched solver."""
    with tempfile.TemporaryDirectory() as folder:
        generate(ROBOT, Path(folder))
        path = Path(folder) / "linear_delta_2022.py"
        spec = importlib.util.spec_from_file_location(path.stem, path)
        module = importlib.util.module_from_spec(spec)
        spec.loader.exec_module(module)
    run = in_blocks(lambda poses, shapes: lapack(*module.modal_matrices(poses), shapes), threads)
    return Way("NumPy, batched eigh", "(b) generated NumPy code and batched `numpy.linalg.eigh`", run)


def casadi_map(threads: int = 1) -> Way:
    """CasADi's graph of the same program as C, mapped over a block, on the memory of NumPy's arrays.

    Without a C compiler CasADi interprets the graph, which takes 1 us instead of 0.15.
    """
    required("casadi", "CasADi")
    import casadi

    pose = casadi.SX.sym("p", 3)
    values = printed({"sqrt": casadi.sqrt})(*casadi.vertsplit(pose))
    M, K = (casadi.densify(casadi.SX(_rows(casadi, matrices().filled(x, values)))) for x in "MK")
    n, cc = M.shape[0], " ".join(compiler() or ())
    with tempfile.TemporaryDirectory() as folder:
        how = {"compiler": cc, "linker": cc, "flags": ["-O3", "-march=native"], "cleanup": False}
        how["directory"] = f"{folder}/"
        options = {"jit": True, "compiler": "shell", "jit_cleanup": False, "jit_options": how} if cc else {}
        function = casadi.Function("matrices", [pose], [M, K], options)

    @cache
    def mapped(count: int) -> casadi.Function:
        return function.map(count)

    def one(poses: Array, shapes: bool) -> tuple[Array, Array | None]:
        # Column-major and symmetric: the matrices of a block stand one after the other.
        poses, M, K = np.ascontiguousarray(poses), *np.empty((2, len(poses), n, n))
        buffer, evaluate = mapped(len(poses)).buffer()
        buffer.set_arg(0, memoryview(poses))
        buffer.set_res(0, memoryview(M))
        buffer.set_res(1, memoryview(K))
        evaluate()
        return lapack(M, K, shapes)

    return Way(
        "CasADi, batched eigh",
        "(c) CasADi `map` of generated C, and the solver of (b)",
        in_blocks(one, threads),
    )


def _rows(casadi: object, rows: list[list]) -> object:
    return casadi.vertcat(*(casadi.horzcat(*row) for row in rows))


def jax_vmap(threads: int = 1) -> Way:
    """JAX: the program, the reduction and the solver for one pose, mapped and compiled."""
    required("jax", "JAX")
    import jax

    jax.config.update("jax_enable_x64", True)
    jax.config.update("jax_platforms", "cpu")
    import jax.numpy as jnp

    program = printed({"sqrt": jnp.sqrt})

    def solved(p: jax.Array, shapes: bool) -> tuple:
        values = program(*p)
        M, K = (jnp.array(matrices().filled(name, values)) for name in "MK")
        scale = 1.0 / jnp.sqrt(jnp.diagonal(M))
        both = scale[:, None] * scale
        L = jnp.linalg.cholesky(M * both, symmetrize_input=False)
        left = jax.scipy.linalg.solve_triangular(L, K * both, lower=True)
        standard = jax.scipy.linalg.solve_triangular(L, left.T, lower=True)
        if not shapes:
            return jnp.linalg.eigvalsh(standard, symmetrize_input=False), None
        eigenvalues, y = jnp.linalg.eigh(standard, symmetrize_input=False)
        return eigenvalues, jax.scipy.linalg.solve_triangular(L, y, lower=True, trans=1).T * scale

    compiled = {
        shapes: jax.jit(jax.vmap(lambda p, shapes=shapes: solved(p, shapes))) for shapes in (False, True)
    }

    def one(poses: Array, shapes: bool) -> tuple[Array, Array | None]:
        eigenvalues, modes = compiled[shapes](poses)
        return frequencies_of(np.asarray(eigenvalues)), None if modes is None else np.asarray(modes)

    # Several calls at a time lock each other out of XLA's own threads for good: blocks one after the other.
    return Way("JAX", "(d) JAX `vmap` and `jit`", in_blocks(one))


def numba_loop(threads: int = 1) -> Way:
    """Numba: the program, the reduction written out, and LAPACK for the standard problem, a compiled loop."""
    required("numba", "numba")
    import math

    from numba import njit, prange, set_num_threads

    if threads > 1:
        set_num_threads(threads)
    known, n = matrices(), len(published().coordinates)
    evaluate = njit(printed({"sqrt": math.sqrt}))
    (rM, cM, vM), (rK, cK, vK) = ((known.rows[x], known.columns[x], known.values[x]) for x in "MK")

    @njit
    def reduced(M: Array, K: Array, scale: Array) -> None:
        """M becomes L of the scaled M = L L^T, K becomes L^-1 S K S L^-T."""
        for i in range(n):
            scale[i] = 1.0 / math.sqrt(M[i, i])
        for i in range(n):
            for j in range(n):
                M[i, j] *= scale[i] * scale[j]
                K[i, j] *= scale[i] * scale[j]
        for j in range(n):
            for i in range(j, n):
                total = M[i, j]
                for k in range(j):
                    total -= M[i, k] * M[j, k]
                M[i, j] = math.sqrt(total) if i == j else total / M[j, j]
        for _ in range(2):  # L^-1 K, then the same of its transpose
            for i in range(n):
                for k in range(i):
                    for j in range(n):
                        K[i, j] -= M[i, k] * K[k, j]
                for j in range(n):
                    K[i, j] /= M[i, i]
            for i in range(n):
                for j in range(i):
                    K[i, j], K[j, i] = K[j, i], K[i, j]

    @njit
    def matrices_at(p: Array, M: Array, K: Array) -> None:
        values = evaluate(p[0], p[1], p[2])
        M[:], K[:] = 0.0, 0.0
        for e in range(len(rM)):
            M[rM[e], cM[e]] = values[vM[e]]
        for e in range(len(rK)):
            K[rK[e], cK[e]] = values[vK[e]]

    @njit(parallel=threads > 1)
    def all_frequencies(poses: Array, eigenvalues: Array) -> None:
        for i in prange(len(poses)):
            M, K, scale = np.empty((n, n)), np.empty((n, n)), np.empty(n)
            matrices_at(poses[i], M, K)
            reduced(M, K, scale)
            eigenvalues[i] = np.linalg.eigvalsh(K)

    @njit(parallel=threads > 1)
    def all_modes(poses: Array, eigenvalues: Array, shapes: Array) -> None:
        for pose in prange(len(poses)):
            M, K, scale = np.empty((n, n)), np.empty((n, n)), np.empty(n)
            matrices_at(poses[pose], M, K)
            reduced(M, K, scale)
            eigenvalues[pose], y = np.linalg.eigh(K)
            for mode in range(n):
                for i in range(n - 1, -1, -1):
                    total = y[i, mode]
                    for k in range(i + 1, n):
                        total -= M[k, i] * y[k, mode]
                    y[i, mode] = total / M[i, i]
                for i in range(n):
                    shapes[pose, mode, i] = y[i, mode] * scale[i]

    def run(poses: Array, frequencies: Array, shapes: Array | None) -> None:
        if shapes is None:
            all_frequencies(poses, frequencies)
        else:
            all_modes(poses, frequencies, shapes)
        frequencies[:] = frequencies_of(frequencies)

    return Way("numba", "(e) numba `njit`, LAPACK in a compiled loop", run)


def mujoco_differences(threads: int = 1) -> Way:
    """MuJoCo's numeric route: M from the engine, K by central differences of its joint forces.

    Assembling the engine at a pose is not counted, only moving it.
    """
    required("mujoco", "MuJoCo")
    from scipy.linalg import eigh

    from pkmodes_rig.mujoco_engine import Engine

    parameters = published().robot.parameters
    belt = np.concatenate([np.ones(3), np.tile(1 / parameters.pulley_radius, 2)])  # per metre of belt
    scale, steps = np.outer(belt, belt), 2e-5 * belt

    @cache
    def assembled(*pose: float) -> Engine:
        return Engine(parameters, np.array(pose))

    def run(poses: Array, frequencies: Array, shapes: Array | None) -> None:
        for i, p in enumerate(poses):
            engine = assembled(*p.tolist())
            M, K = engine.mass_matrix(), np.zeros(scale.shape)
            for k, step in enumerate(np.diag(steps)):
                for sign in (1, -1):
                    engine.move(sign * step)
                    K[k] += sign * engine.gradient() / (2 * steps[k])
            engine.move(np.zeros(len(steps)))
            if shapes is None:
                eigenvalues = eigh(K * scale, M * scale, eigvals_only=True)
            else:
                eigenvalues, columns = eigh(K * scale, M * scale)
                shapes[i] = (columns * belt[:, None]).T
            frequencies[i] = frequencies_of(eigenvalues)

    return Way("MuJoCo", "(f) MuJoCo, stiffness by differences of forces, in a loop", run)
