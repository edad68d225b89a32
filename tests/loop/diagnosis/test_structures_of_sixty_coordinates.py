"""Structures of some sixty coordinates, given as arrays or sparse matrices, against closed forms."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

import numpy as np
import pytest
from scipy import linalg, sparse

from pkmodes.loop.diagnosis import Candidate, MatrixStructure, Measurements, Parameter, diagnose

FORMS: dict[str, Callable[[Any], Any]] = {
    "array": lambda matrix: matrix.toarray(),
    "csr": sparse.csr_array,
    "csc matrix": sparse.csc_matrix,
    "coo": sparse.coo_array,
}


def chain(n: int, form: str = "csr") -> Callable:
    """N masses of 1 kg and springs in a row, the first one on the ground; one of the springs may be stiffer."""

    def matrices(values, setup) -> tuple[Any, Any]:
        k = np.full(n, values["k"])
        k[n // 3] *= 1.0 + values["stiffer"]
        K = sparse.diags_array([k + np.append(k[1:], 0.0), -k[1:], -k[1:]], offsets=[0, 1, -1])
        M = sparse.diags_array(np.full(n, values["m"]))
        return FORMS[form](M), FORMS[form](K)

    return matrices


PARAMETERS = [
    Parameter("m", 1.0, "kg", sigma=0.01),
    Parameter("k", 1e4, "N/m", sigma=300.0),
    Parameter("stiffer", 0.0, lower=-0.9),
]
DECLARED = np.array([1.0, 1e4, 0.0])


def names(n: int) -> list[str]:
    return [f"mass {i}" for i in range(n)]


def structure(n: int, form: str = "csr", **options: Any) -> MatrixStructure:
    return MatrixStructure(
        PARAMETERS,
        [Candidate("stiffer", ("stiffer",))],
        chain(n, form),
        **{"channels": names(n), **options},
    )


def closed_form(n: int, count: int) -> tuple[np.ndarray, np.ndarray]:
    """Eigenvalues and shapes of the uniform chain, its lowest modes."""
    j = np.arange(1, count + 1)[:, None]
    angle = (2 * j - 1) * np.pi / (2 * n + 1)
    return 4e4 * np.sin(angle[:, 0] / 2) ** 2, np.sin(np.arange(1, n + 1) * angle) * 2 / np.sqrt(2 * n + 1)


@pytest.mark.parametrize("form", FORMS)
def test_the_lowest_modes_of_a_chain_are_those_of_the_closed_form(form: str) -> None:
    n = 60
    found = structure(n, form, modes=7).predict(DECLARED, (0, 1, 2))
    eigenvalues, shapes = closed_form(n, 7)
    assert found.eigenvalues == pytest.approx(eigenvalues[None], rel=1e-11)
    assert np.abs(found.shapes[0]) == pytest.approx(np.abs(shapes), abs=1e-9)
    stretch = shapes[:, n // 3] - shapes[:, n // 3 - 1]
    rates = np.column_stack([-eigenvalues, eigenvalues / 1e4, 1e4 * stretch**2])
    # Differences of entries of 2e4 that change by a millionth: their rounding is 1e-10 of the entries, 2e-6.
    assert found.rates[0] == pytest.approx(rates, rel=1e-7, abs=2e-6)


def test_all_modes_are_compared_or_the_lowest() -> None:
    assert structure(60).predict(DECLARED, ()).eigenvalues.shape == (1, 60)
    assert structure(60, modes=6).predict(DECLARED, ()).eigenvalues.shape == (1, 6)


@pytest.mark.parametrize("count", [1, 2, 3, 4, 10, 17])
def test_coincident_modes_are_not_missed(count: int) -> None:
    # A square membrane: lambda = 4 sin^2 + 4 sin^2, nearly all of them twice.
    k = 7
    line = sparse.diags_array([[-1.0] * (k - 1), [2.0] * k, [-1.0] * (k - 1)], offsets=[-1, 0, 1])
    one = sparse.eye_array(k)
    K = sparse.kron(line, one) + sparse.kron(one, line)
    membrane = MatrixStructure(
        [], [], lambda *_: (sparse.eye_array(k * k), K), channels=names(k * k), modes=count
    )
    side = 4 * np.sin(np.arange(1, k + 1) * np.pi / (2 * (k + 1))) ** 2
    expected = np.sort(np.add.outer(side, side).ravel())[:count]
    assert membrane.predict(np.zeros(0), ()).eigenvalues[0] == pytest.approx(expected, rel=1e-11)


def beam(elements: int, *, lumped: bool, free: bool = False) -> tuple[Any, Any]:
    """M and K of a uniform Euler-Bernoulli beam with EI = rho A = L = 1, clamped at one end or free."""
    h, n = 1.0 / elements, 2 * (elements + 1)
    stiffness = (
        np.array(
            [[12, 6 * h, -12, 6 * h], [6 * h, 4 * h * h, -6 * h, 2 * h * h]]
            + [[-12, -6 * h, 12, -6 * h], [6 * h, 2 * h * h, -6 * h, 4 * h * h]]
        )
        / h**3
    )
    inertia = (h / 420) * np.array(
        [[156, 22 * h, 54, -13 * h], [22 * h, 4 * h * h, 13 * h, -3 * h * h]]
        + [[54, 13 * h, 156, -22 * h], [-13 * h, -3 * h * h, -22 * h, 4 * h * h]]
    )
    if lumped:
        inertia = np.diag([h / 2, 0.0, h / 2, 0.0])
    M, K = np.zeros((n, n)), np.zeros((n, n))
    for e in range(elements):
        part = slice(2 * e, 2 * e + 4)
        M[part, part] += inertia
        K[part, part] += stiffness
    keep = slice(0 if free else 2, None)
    return M[keep, keep], K[keep, keep]


def of_beam(elements: int, form: Callable = sparse.csr_array, **options: Any) -> MatrixStructure:
    M, K = beam(elements, lumped=options.pop("lumped"), free=options.get("rigid", 0) > 0)
    bends = [Parameter("E", 1.0, lower=0.5)]
    return MatrixStructure(
        bends,
        [],
        lambda values, _: (form(M), form(values["E"] * K)),
        channels=names(len(K)),
        **options,
    )


#: (beta L)^2 of a cantilever and of a free beam: cos x cosh x = -1 or 1.
CLAMPED = np.array([1.875104068711961, 4.694091132974175, 7.854757438237613]) ** 2
FREE = np.array([4.730040744862704, 7.853204624095838, 10.995607838001671]) ** 2


@pytest.mark.parametrize("elements", [10, 30])
@pytest.mark.parametrize("form", [sparse.csr_array, np.asarray])
def test_a_cantilever_has_the_frequencies_of_the_closed_form(elements: int, form: Callable) -> None:
    # The error of consistent masses falls with the fourth power of the length of an element, that of lumped ones
    # with the square.
    consistent = of_beam(elements, form, lumped=False, modes=5).predict(np.ones(1), ())
    assert np.sqrt(consistent.eigenvalues[0, :3]) == pytest.approx(CLAMPED, rel=4.0 / elements**4 + 1e-7)
    lumped = of_beam(elements, form, lumped=True, modes=5).predict(np.ones(1), ())
    assert np.sqrt(lumped.eigenvalues[0, :3]) == pytest.approx(CLAMPED, rel=3.0 / elements**2)


@pytest.mark.parametrize("lumped", [True, False])
@pytest.mark.parametrize("elements", [10, 30])
def test_rigid_modes_come_first_and_the_others_are_those_of_a_free_beam(elements: int, lumped: bool) -> None:
    free = of_beam(elements, lumped=lumped, rigid=2, modes=6)
    found = free.predict(np.ones(1), (0,))
    assert np.abs(found.eigenvalues[0, :2]).max() < 1e-3
    error = 10.0 / elements ** (2 if lumped else 4) + 1e-6
    assert np.sqrt(found.eigenvalues[0, 2:5]) == pytest.approx(FREE, rel=error)
    assert found.log_rates[0, 2:, 0] == pytest.approx(0.5, rel=1e-5)


def test_a_structure_that_buckles_has_no_frequencies() -> None:
    n = 60

    def pressed(values, setup) -> tuple[Any, Any]:
        M, K = chain(n)({"m": 1.0, "k": 1e4, "stiffer": 0.0}, setup)
        return M, K - values["load"] * sparse.eye_array(n)

    column = MatrixStructure([Parameter("load", 0.0)], [], pressed, channels=names(n), modes=5)
    eigenvalues, _ = closed_form(n, 5)
    near = 0.9 * eigenvalues[0]
    # What is left of the first eigenvalue is a tenth of it, which rounding of the matrices spoils in the 6th digit.
    found = column.predict(np.array([near]), ()).eigenvalues[0]
    assert found == pytest.approx(eigenvalues - near, rel=1e-6)
    assert np.isnan(column.predict(np.array([1.1 * eigenvalues[0]]), ()).eigenvalues).all()


def test_a_diagnosis_of_a_structure_with_few_sensors() -> None:
    n, seen = 60, [4, 15, 28, 34, 46, 59]
    model = MatrixStructure(
        PARAMETERS + [Parameter("tip", 0.0, "kg", lower=0.0)],
        [Candidate("stiffer", ("stiffer",)), Candidate("tip", ("tip",))],
        lambda values, setup: (
            chain(n)(values, setup)[0] + values["tip"] * sparse.diags_array(np.eye(n)[-1]),
            chain(n)(values, setup)[1],
        ),
        channels=[f"mass {i}" for i in seen],
        coordinates=names(n),
        modes=16,
    )
    rng = np.random.default_rng(5)
    M, K = (matrix.toarray() for matrix in chain(n)({"m": 1.004, "k": 1.01e4, "stiffer": 0.0}, ""))
    M[-1, -1] += 9.0
    eigenvalues, modes = linalg.eigh(K, M, subset_by_index=(0, 7))
    f = np.sqrt(eigenvalues) / (2 * np.pi) * (1 + 0.001 * rng.standard_normal(8))
    columns = {f"mass {i}": modes[i] * (1 + 0.01 * rng.standard_normal(8)) for i in seen}
    result = diagnose(model, Measurements.from_rows(["a"] * 8, f, 0.001 * f, shapes=columns))
    assert result.verdict == "effect_found"
    assert [found.name for found in result.effects] == ["tip"]
    (tip,) = result.effects[0].parameters
    assert abs(tip.value - 9.0) < 3 * tip.sigma
