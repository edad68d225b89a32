"""Terms beside the causes of the catalogue: a cause is claimed only where no term explains the data better.

The truth is a chain of masses and springs that the tests assemble with NumPy.
"""

from __future__ import annotations

from collections.abc import Callable

import numpy as np
import pytest

from helpers.diagnoses.chains import Frame, at, joined
from pkmodes.loop.diagnosis import Diagnosis, MatrixStructure, Measurements, diagnose
from pkmodes.loop.diagnosis.problem import Candidate, Parameter

FRAME = Frame()
NOTHING = np.zeros((6, 6))


class ByStorey(MatrixStructure):
    """A structure whose terms are its storeys, one by one."""

    def with_terms(self) -> MatrixStructure:
        extended = super().with_terms()
        own = [p.name for p in self.parameters if p.name.startswith("storey ")]
        extended.candidates += tuple(
            Candidate(f"parameter:{name}", (name,), f"the stiffness of {name} alone", True, form="parameter")
            for name in own
        )
        return extended


def test_a_claimed_cause_with_a_value_for_each_joint_is_tried_one_by_one() -> None:
    frame = Frame()
    storeys = [Parameter(f"storey {i}", 1.0, lower=0.3, upper=3.0) for i in range(2, 7)]

    def matrices(values: dict[str, float], setup: str) -> tuple[np.ndarray, np.ndarray]:
        M, K = frame.matrices({"mass": 1.0, "storey": values["storey"]}, setup)
        for i, p in enumerate(storeys, start=2):
            K = K + 4e5 * (values[p.name] - 1.0) * joined(6, i - 1, i)
        return M, K

    group = Candidate("unequal storeys", tuple(p.name for p in storeys), "the storeys are not equally stiff")
    structure = ByStorey(
        [Parameter("storey", 1.0, sigma=0.03), *storeys],
        [group],
        matrices,
        channels=frame.names,
        setups=frame.setups,
    )
    data = frame.measured(lambda _: (-0.04 * np.eye(6), -0.06 * 4e5 * joined(6, 3, 4)))
    found = diagnose(structure, data, terms=True)
    assert found.verdict == "effect_found"
    assert found.effects[0].name == "unequal storeys"
    assert found.beyond is not None
    assert found.beyond.status == "found"
    first, *others = found.beyond.document().classes[0].members
    assert first.term == "parameter:storey 4"
    assert [one.term for one in others] in ([], ["unequal storeys"])
    value = first.parameters["storey 4"]
    assert value.value == pytest.approx(0.94, abs=3.0 * value.sigma + 0.003)
    assert not found.reason.startswith("Not in the catalogue")


def of_two_candidates(data: Measurements, terms: bool) -> Diagnosis:
    """Diagnose with two candidates: springs from two floors to the ground, and a coupling of these floors."""
    sizes = [Parameter(name, 0.0, "N/m", lower=0.0) for name in ("grounded", "coupled")]

    def matrices(values: dict[str, float], setup: str) -> tuple[np.ndarray, np.ndarray]:
        M, K = FRAME.matrices(values, setup)
        both = joined(6, 2) + joined(6, 5)
        return M, K + values["grounded"] * both + values["coupled"] * (joined(6, 2, 5) - both)

    structure = MatrixStructure(
        [Parameter("mass", 1.0, sigma=0.005), Parameter("storey", 1.0, sigma=0.03), *sizes],
        [Candidate(f"{size.name} floors", (size.name,), f"floors 2 and 5 are {size.name}") for size in sizes],
        matrices,
        channels=FRAME.names,
        setups=FRAME.setups,
    )
    return diagnose(structure, data, terms=terms)


def test_two_causes_are_not_claimed_where_one_term_explains_the_data_better() -> None:
    data = FRAME.measured(lambda _: (NOTHING, 8.0e3 * joined(6, 2, 5)))
    catalogue = of_two_candidates(data, terms=False)
    assert [effect.name for effect in catalogue.effects] == ["grounded floors", "coupled floors"]
    found = of_two_candidates(data, terms=True)
    assert (found.verdict, found.rule, found.effects) == ("ambiguous", "claims.one_term", ())
    assert found.survivors == (("grounded floors + coupled floors",),)
    assert found.beyond is not None
    assert found.beyond.status == "found"
    assert found.beyond.classes[0].finding.members == (
        "spring:floor 2/floor 5",
        "grounded floors + coupled floors",
    )
    assert found.reason.startswith("Narrowed to two: a spring between floor 2 and floor 5, or ")
    assert found.reason.endswith(
        "grounded floors and coupled floors together would explain the residual, but a spring between floor 2 and "
        "floor 5 (spring:floor 2/floor 5) would do so alone"
    )


def test_two_causes_are_claimed_where_no_term_explains_the_data() -> None:
    both = joined(6, 2) + joined(6, 5)
    data = FRAME.measured(lambda _: (NOTHING, 3.0e4 * both + 1.2e4 * (joined(6, 2, 5) - both)))
    found = of_two_candidates(data, terms=True)
    assert (found.verdict, found.rule) == ("effect_found", "claims.found")
    assert found.beyond is None


def of_a_storey(data: Measurements, storey: int, terms: bool = True) -> Diagnosis:
    """Diagnose with a candidate for the stiffness of one storey alone."""
    size = Parameter("stiffer", 0.0, "N/m", lower=-2e5)

    def matrices(values: dict[str, float], setup: str) -> tuple[np.ndarray, np.ndarray]:
        M, K = FRAME.matrices(values, setup)
        return M, K + values["stiffer"] * joined(6, storey - 1, storey)

    structure = MatrixStructure(
        [Parameter("mass", 1.0, sigma=0.005), Parameter("storey", 1.0, sigma=0.03), size],
        [Candidate(f"storey {storey}", ("stiffer",), f"storey {storey} is stiffer", local=True)],
        matrices,
        channels=FRAME.names,
        setups=FRAME.setups,
    )
    return diagnose(structure, data, terms=terms)


def test_a_value_of_one_place_is_not_claimed_where_a_term_explains_more() -> None:
    data = FRAME.measured(lambda _: (0.9 * at(6, 1), NOTHING))
    assert of_a_storey(data, 6, terms=False).verdict == "effect_found"
    found = of_a_storey(data, 6)
    assert (found.verdict, found.rule, found.effects) == ("ambiguous", "claims.one_term", ())
    assert (
        "storey 6 would explain the residual, but so would a mass at floor 1 (mass:floor 1)" in found.reason
    )


def test_a_value_of_one_place_is_not_claimed_beside_a_term_that_the_data_do_not_exclude() -> None:
    data = FRAME.measured(lambda _: (NOTHING, 6e3 * joined(6, 2, 3)))
    assert of_a_storey(data, 3, terms=False).verdict == "effect_found"
    found = of_a_storey(data, 3)
    assert (found.verdict, found.rule, found.effects) == ("ambiguous", "claims.one_term", ())
    assert (
        "storey 3 would explain the residual, but so would a mass at floor 6 (mass:floor 6)" in found.reason
    )


def of_one_candidate(
    data: Measurements,
    change: np.ndarray,
    progress: Callable[[str], object] | None = None,
    terms: bool = True,
) -> Diagnosis:
    """Diagnose with one candidate, a change of the stiffness matrix."""
    size = Parameter("size", 0.0, "N/m", lower=-0.5e5, upper=0.5e5)

    def matrices(values: dict[str, float], setup: str) -> tuple[np.ndarray, np.ndarray]:
        M, K = FRAME.matrices(values, setup)
        return M, K + values["size"] * change

    structure = MatrixStructure(
        [Parameter("mass", 1.0, sigma=0.005), Parameter("storey", 1.0, sigma=0.03), size],
        [Candidate("change", ("size",), "the stiffness differs")],
        matrices,
        channels=FRAME.names,
        setups=FRAME.setups,
    )
    return diagnose(structure, data, terms=terms, progress=progress)


def test_one_cause_is_not_claimed_where_a_term_is_better_by_more_than_chance() -> None:
    both = joined(6, 5) + joined(6, 6)
    data = FRAME.measured(lambda _: (NOTHING, 5e3 * joined(6, 5)))
    assert of_one_candidate(data, both, terms=False).verdict == "effect_found"
    found = of_one_candidate(data, both)
    assert (found.verdict, found.rule, found.effects) == ("ambiguous", "claims.one_term", ())
    assert (
        "change would explain the residual, but so would a spring between floor 5 and the ground"
        in found.reason
    )


@pytest.mark.parametrize("size", [1e3, 2e3, 5e3])
def test_one_cause_is_claimed_where_a_term_is_no_better_than_by_chance(size: float) -> None:
    """Of 27 terms, one explains the noise better than the truth: by 4.5 of the criterion at most here."""
    every = joined(6, 1) + joined(6, 2) + joined(6, 3) + joined(6, 4) + joined(6, 5) + joined(6, 6)
    found = of_one_candidate(FRAME.measured(lambda _: (NOTHING, size * every)), every)
    assert (found.verdict, found.rule, found.beyond) == ("effect_found", "claims.found", None)


def test_no_term_is_fitted_where_none_could_explain_as_much_as_the_cause() -> None:
    alternating = joined(6, 1, 2) - joined(6, 2, 3) + joined(6, 3, 4) - joined(6, 4, 5) + joined(6, 5, 6)
    progress: list[str] = []
    found = of_one_candidate(
        FRAME.measured(lambda _: (NOTHING, 1e4 * alternating)), alternating, progress.append
    )
    assert found.verdict == "effect_found"
    assert progress
    assert not [line for line in progress if "terms" in line]


def test_a_value_of_one_place_is_claimed_beside_a_term_that_is_the_same() -> None:
    found = of_a_storey(FRAME.measured(lambda _: (NOTHING, 3e4 * joined(6, 2, 3))), 3)
    assert (found.verdict, found.rule, found.beyond) == ("effect_found", "claims.found", None)
