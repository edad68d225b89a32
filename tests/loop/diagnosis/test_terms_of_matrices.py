"""Terms of a `MatrixStructure`: a mass at each coordinate, springs to ground and between coordinates."""

from __future__ import annotations

import numpy as np
import pytest
from scipy import sparse
from scipy.linalg import eigh

from helpers.diagnoses.chains import chain
from pkmodes.core.base.errors import PkmodesError
from pkmodes.loop.diagnosis import Candidate, MatrixStructure, Parameter
from pkmodes.loop.diagnosis.matrices import at_measured_setups
from pkmodes.loop.diagnosis.problem import Extensible

NAMES = ("a", "b", "c")


def structure(**options: object) -> MatrixStructure:
    """Three masses of 2 kg in a row on springs of 900 N/m, the first one on the ground."""
    M, K = chain(np.full(3, 2.0), np.full(3, 900.0))
    given: dict[str, object] = {"channels": NAMES, **options}
    parameters = [Parameter("k", 1.0, sigma=0.01)]
    return MatrixStructure(parameters, [], lambda values, _: (M, values["k"] * K), **given)  # type: ignore[arg-type]


def solved(M: np.ndarray, K: np.ndarray) -> np.ndarray:
    return np.asarray(eigh(K, M, eigvals_only=True))


def test_a_structure_has_a_mass_and_springs_at_every_coordinate() -> None:
    plain = structure()
    assert isinstance(plain, Extensible)
    terms = plain.with_terms().candidates
    assert [one.name for one in terms] == [
        *("mass:a", "mass:b", "mass:c"),
        *("spring:a", "spring:b", "spring:c"),
        *("spring:a/b", "spring:a/c", "spring:b/c"),
    ]
    assert [one.form for one in terms] == ["mass"] * 3 + ["spring"] * 6
    assert not any(one.claimable for one in terms)
    assert terms[7].sentence == "a spring between a and c"
    added = plain.with_terms().parameters[1:]
    assert [p.name for p in added][:1] == ["mass:a.mass"]
    assert {(p.value, p.lower, p.unit) for p in added[3:]} == {(0.0, 0.0, "N/m")}
    assert plain.candidates == ()
    assert plain.with_terms().with_terms().candidates == terms


@pytest.mark.parametrize(
    ("term", "mass", "stiffness"),
    [
        ("mass:b.mass", np.diag([0.0, 0.7, 0.0]), np.zeros((3, 3))),
        ("spring:c.stiffness", np.zeros((3, 3)), np.diag([0.0, 0.0, 0.7])),
        ("spring:a/c.stiffness", np.zeros((3, 3)), np.array([[0.7, 0, -0.7], [0, 0, 0], [-0.7, 0, 0.7]])),
    ],
)
@pytest.mark.parametrize("kind", [np.asarray, sparse.csr_array])
def test_modes_with_a_term_are_those_of_matrices_written_by_hand(
    term: str, mass: np.ndarray, stiffness: np.ndarray, kind: type
) -> None:
    M, K = chain(np.full(3, 2.0), np.full(3, 900.0))
    given = MatrixStructure([], [], lambda *_: (kind(M), kind(K)), channels=NAMES)
    extended = given.with_terms()
    i = [p.name for p in extended.parameters].index(term)
    values = np.zeros(len(extended.parameters))
    values[i] = 100.0
    found = extended.predict(values, [i], shape_rates=True)
    np.testing.assert_allclose(found.eigenvalues[0], solved(M + 100 / 0.7 * mass, K + 100 / 0.7 * stiffness))
    ahead, behind = values.copy(), values.copy()
    ahead[i], behind[i] = 100.001, 99.999
    after, before = extended.predict(ahead, []), extended.predict(behind, [])
    np.testing.assert_allclose(
        found.rates[..., 0], (after.eigenvalues - before.eigenvalues) / 0.002, rtol=1e-5, atol=1e-6
    )
    assert found.shape_rates is not None
    signs = np.sign((after.shapes * before.shapes).sum(axis=2, keepdims=True))
    moved = (after.shapes * signs - before.shapes) / 0.002
    same = np.sign((before.shapes * found.shapes).sum(axis=2, keepdims=True))
    np.testing.assert_allclose(found.shape_rates[..., 0], moved * same, rtol=1e-4, atol=1e-7)


def test_an_absent_term_changes_nothing_and_the_callable_sees_its_own_values_only() -> None:
    seen = []

    def matrices(values: dict[str, float], setup: str) -> tuple[np.ndarray, np.ndarray]:
        seen.append({*values})
        M, K = chain(np.full(3, 2.0), np.full(3, 900.0))
        return M, values["k"] * K

    given = MatrixStructure([Parameter("k", 1.0, sigma=0.01)], [], matrices, channels=NAMES)
    extended = at_measured_setups(given, ["P1"])
    assert isinstance(extended, MatrixStructure)
    extended = extended.with_terms()
    values = np.array([1.0, *np.zeros(9)])
    found, plain = extended.predict(values, [0]), given.predict(np.array([1.0]), [0])
    np.testing.assert_array_equal(found.eigenvalues, plain.eigenvalues)
    np.testing.assert_array_equal(found.rates, plain.rates)
    calls = len(seen)
    values[3] = 0.5
    extended.predict(values, [3])
    assert len(seen) == calls  # the supplied matrices are the same
    assert all(names == {"k"} for names in seen)


def test_terms_are_named_after_coordinates_or_numbered_where_sensors_are_between_them() -> None:
    named = structure(channels=("b",), coordinates=NAMES, units=("t", "N/mm")).with_terms()
    assert named.candidates[0].name == "mass:a"
    assert named.parameters[1].unit == "t"
    assert named.parameters[4].unit == "N/mm"
    numbered = structure(channels=("s",), sensors=[[0.5, 0.5, 0.0]]).with_terms()
    assert numbered.candidates[6].name == "spring:coordinate 1/coordinate 2"


def test_a_candidate_of_the_name_of_a_term_stays_in_its_place() -> None:
    M, K = chain(np.full(3, 2.0), np.full(3, 900.0))
    own = Parameter("m", 0.0, "kg", lower=0.0)
    given = MatrixStructure(
        [own], [Candidate("mass:a", ("m",))], lambda values, _: (M + values["m"], K), channels=NAMES
    ).with_terms()
    assert [one.name for one in given.candidates].count("mass:a") == 1
    assert given.candidates[0].form == ""


def test_units_are_two_texts() -> None:
    with pytest.raises(PkmodesError, match="expected the units of M and K"):
        structure(units=("kg",))
