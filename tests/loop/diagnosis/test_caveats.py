"""What stands beside a verdict: what was refitted and by how much, what the data cannot see, which sigma counts."""

from __future__ import annotations

import re
from dataclasses import replace

import numpy as np
import pytest

from helpers.pages.page_reading import read
from helpers.pages.report_examples import made_up
from helpers.robots.small_structures import of_signatures, with_changes
from pkmodes.loop.diagnosis import Diagnosis, diagnose
from pkmodes.loop.diagnosis.verdict import caveats
from pkmodes.loop.diagnosis.verdict.findings import Corrected, Unseen, explain_saved_sigma, with_saved_sigma
from pkmodes.pages.report import report


def refitted(
    value: float, sigma: float = 0.1, prior: float | None = 1.0, unseen: float | None = None
) -> Corrected:
    """A value declared as 10 that was refitted."""
    other = None if unseen is None else Unseen(unseen, "clamps")
    return Corrected("effects.servo.stiffness", value, sigma, "N*m/rad", 10.0, prior, False, other)


def test_what_was_refitted_is_said_with_its_size_in_standard_deviations_of_the_prior() -> None:
    said = "servo.stiffness from 10 to 12.00 +- 0.10 N*m/rad (+2.0 sigma)"
    assert caveats.refitted_in_words([refitted(12.0)]) == said
    small = replace(refitted(9.8), name="mass", unit="1")
    assert caveats.refitted_in_words([small]) == "mass from 10 to 9.80 +- 0.10 (-0.2 sigma)"
    assert caveats.refitted_in_words([small, refitted(12.0)]) == caveats.refitted_in_words([refitted(12.0)])
    assert caveats.refitted_in_words([refitted(12.0, prior=None)]) == ""


@pytest.mark.parametrize(
    ("value", "headline"),
    [
        (refitted(12.0), ""),
        (refitted(13.2), "servo.stiffness is 3.2 sigma from its declared value"),
        # An unseen candidate moves it by 1.645 of its standard deviations at its limit.
        (
            refitted(11.6, unseen=1.0),
            "servo.stiffness was refitted from 10 to 11.6 +- 1.0 N*m/rad "
            "(+1.6 sigma; an undetected clamps would have the same effect)",
        ),
        (refitted(11.7, unseen=1.0), ""),
        (refitted(10.2, unseen=1.0), ""),  # within what the fit leaves open
    ],
)
def test_a_conspicuous_refit_is_in_the_headline(value: Corrected, headline: str) -> None:
    assert caveats.conspicuous_in_words([value], refit_was_needed=True) == headline
    alone = headline if "sigma from" in headline else ""
    assert caveats.conspicuous_in_words([value], refit_was_needed=False) == alone


def test_an_adequate_model_is_followed_by_what_it_cannot_see() -> None:
    assert (
        caveats.undetectable_in_words(["a", "b"], others_are_limited=False) == "these data cannot show a, b"
    )
    assert caveats.undetectable_in_words([*"abcdef"], others_are_limited=True) == (
        "these data cannot show a, b, c, d and 2 more, nor other causes below their limits"
    )
    assert (
        caveats.undetectable_in_words([], others_are_limited=True)
        == "these data cannot show causes below their limits"
    )
    assert caveats.undetectable_in_words([], others_are_limited=False) == ""


def test_the_reason_of_a_decision_is_followed_by_its_caveats_each_once() -> None:
    far = caveats.Caveats(
        conspicuous="n is 4.0 sigma from its declared value", unseen="these data cannot show b"
    )
    assert far.appended_to("why") == "why; n is 4.0 sigma from its declared value; these data cannot show b"
    refit = replace(far, refitted="n from 0 to 4 (+4.0 sigma)")
    assert refit.appended_to("why") == "why: n from 0 to 4 (+4.0 sigma); these data cannot show b"
    assert caveats.Caveats().appended_to("why") == "why"


def measured(n: float, error: float = 1.0) -> Diagnosis:
    """The diagnosis of a structure whose uncertain value is n sigma from the declared one.

    - error: of the frequencies, in stated standard deviations
    """
    rng = np.random.default_rng(7)
    along, other = 10.0 * rng.standard_normal((2, 6, 4))
    model = of_signatures({"n": along, "a": other, "nothing": 0.0 * other}, 6, 4, known={"n": {"sigma": 1.0}})
    return diagnose(model, with_changes(model, n * along + error * rng.standard_normal((6, 4))), holdout=())


def test_the_residual_of_the_declared_model_is_noise_only_where_it_is() -> None:
    right, refit = measured(0.0), measured(2.0)
    assert right.verdict == refit.verdict == "adequate"
    assert right.reason.startswith("the residual of the declared model is noise (p = ")
    assert right.headline == refit.headline == ""
    assert refit.before is not None
    assert refit.before.chi2_per_dof > 10.0
    assert refit.reason.startswith("the residual is noise once the uncertain values are refitted (p = ")
    assert ", not as declared (p < 1e-6): n from 0 to 2" in refit.reason
    assert (
        " (+2.0 sigma); these data cannot show nothing, nor other causes below their limits" in refit.reason
    )


@pytest.mark.parametrize(("error", "factor"), [(0.4, 2.5), (0.7, None)])
def test_stated_errors_two_to_three_times_too_large_are_noted(error: float, factor: float | None) -> None:
    notes = [
        note for note in measured(0.0, error).notes if note.startswith("the stated errors of the frequencies")
    ]
    assert len(notes) == (factor is not None)
    for note in notes:
        match = re.search(
            r"are ([\d.]+) times too large: the residual scatters much less \(by the root of chi2 ", note
        )
        assert match is not None
        assert float(match[1]) == pytest.approx(factor, rel=0.3)


def test_a_value_three_sigma_from_its_declaration_is_in_reason_and_headline() -> None:
    found = measured(3.4)
    assert found.verdict == "adequate"
    assert found.headline == "n is 3.4 sigma from its declared value"
    assert "(+3.4 sigma)" in found.reason


def test_the_sigma_that_may_be_relied_on_comes_first_and_the_reason_why_with_it() -> None:
    """0.01 by the fit and 0.04 by an unseen candidate: 0.041 together."""
    result, data = made_up(6, 3)
    payload = Corrected("effects.payload.mass", 0.3, 0.01, "kg", 0.0, None, False, Unseen(0.04, "belt_mass"))
    found = replace(result, corrected=(payload,))
    (value,) = found.effects[0].parameters
    assert with_saved_sigma(value, found.corrected).sigma == pytest.approx(np.hypot(0.01, 0.04))
    why = (
        "the standard deviation is 0.010 by the fit alone, and larger because it allows for an undetected "
        "belt_mass"
    )
    assert explain_saved_sigma(value, found.corrected) == why
    assert "payload.mass = 0.300 +- 0.041 kg" in str(found)
    page = read(report(found, data=data))
    summary = page.by_id("summary").text
    assert "0.300 \u00b1 0.041" in summary
    assert "0.010" not in summary  # the head has one standard deviation of it
    assert f"effects.payload.mass: {why}." in page.by_id("causes").text
    assert explain_saved_sigma(value, result.corrected) == ""
    assert "0.300 +- 0.010 kg" in str(result)
    assert found.as_json()["effects"][0]["parameters"]["mass"]["sigma"] == 0.01  # type: ignore[index]
