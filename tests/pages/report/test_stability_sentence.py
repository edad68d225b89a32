"""What the page and the terminal say about other stated errors and priors."""

from __future__ import annotations

from dataclasses import replace

import pytest

from helpers.pages.report_examples import made_up
from pkmodes.loop.diagnosis.verdict.findings import Stability
from pkmodes.loop.diagnosis.verdict.result import Damping
from pkmodes.pages.report.damping import stability_clause
from pkmodes.pages.report.stability import stability_sentence

CHANGES = ("sigma x 0.5", "sigma x 2", "priors x 2")
SAME = ("effect_found", "payload")
NOTHING, ENOUGH = ("unexplained", ""), ("adequate", "")


def said(verdict: str, *entries: tuple[str, str]) -> str:
    result, _ = made_up(3, 2)
    return stability_sentence(
        replace(
            result,
            verdict=verdict,
            effects=result.effects if verdict == "effect_found" else (),
            stability=tuple(
                Stability(change, word, tuple(names.split()))
                for change, (word, names) in zip(CHANGES, entries, strict=False)
            ),
        )
    )


@pytest.mark.parametrize(
    ("verdict", "entries", "expected"),
    [
        (
            "effect_found",
            (SAME, SAME, SAME),
            "stable: the same cause with sigma halved, sigma doubled and priors twice as wide",
        ),
        (
            "effect_found",
            (NOTHING, SAME, SAME),
            "stability: the same cause with sigma doubled and priors twice as wide; nothing explains the residual "
            "with sigma halved (usual where the stated sigma is right)",
        ),
        (
            "effect_found",
            (NOTHING, ENOUGH, SAME),
            "stability: the same cause with priors twice as wide; nothing explains the residual with sigma halved "
            "(usual where the stated sigma is right); no cause is needed with sigma doubled (errors twice as large "
            "would explain the residual)",
        ),
        (
            "effect_found",
            (SAME, ("effect_found", "belt_mass"), ("ambiguous", "payload")),
            "stability: the same cause with sigma halved; belt_mass instead with sigma doubled; the same cause, but "
            "not alone, with priors twice as wide (the uncertain values would then make up for the differences)",
        ),
        (
            "adequate",
            (ENOUGH, ENOUGH, ENOUGH),
            "stable: adequate also with sigma halved, sigma doubled and priors twice as wide",
        ),
        (
            "adequate",
            (("effect_found", "payload belt_mass"), ENOUGH, ENOUGH),
            "stability: adequate with sigma doubled and priors twice as wide; the best explanation, which is not "
            "claimed, is payload and belt_mass with sigma halved (smaller errors make noise look significant)",
        ),
        (
            "unexplained",
            (NOTHING, NOTHING, NOTHING),
            "stable: unexplained also with sigma halved, sigma doubled and priors twice as wide",
        ),
        (
            "unexplained",
            (NOTHING, ENOUGH, ENOUGH),
            "stability: unexplained with sigma halved; adequate with sigma doubled (errors twice as large would "
            "explain the residual); adequate with priors twice as wide (the uncertain values would then make up for "
            "the residual)",
        ),
        (
            "unexplained",
            (NOTHING, ("ambiguous", "payload belt_mass"), NOTHING),
            "stability: unexplained with sigma halved and priors twice as wide; the best explanation, which is not "
            "claimed, is payload and belt_mass, but not alone, with sigma doubled (errors twice as large would "
            "explain what it leaves)",
        ),
        # The claim rests on the priors.
        (
            "effect_found",
            (SAME, SAME, ENOUGH),
            "stability: the same cause with sigma halved and sigma doubled; no cause is needed with priors twice as "
            "wide (the uncertain values would then make up for the residual)",
        ),
        ("insufficient_data", (("insufficient_data", ""),) * 3, ""),
        ("effect_found", (), ""),
    ],
)
def test_the_sentence(verdict: str, entries: tuple[tuple[str, str], ...], expected: str) -> None:
    assert said(verdict, *entries) == expected


@pytest.mark.parametrize(
    ("entries", "expected"),
    [
        ((ENOUGH, ENOUGH, ENOUGH), ""),
        (
            (
                ("effect_found", "belt_loss rail_friction"),
                ("effect_found", "belt_loss"),
                ("effect_found", "belt_loss"),
            ),
            "with sigma halved, belt_loss and rail_friction would be claimed; with sigma doubled or priors twice as "
            "wide, belt_loss would be claimed",
        ),
        ((ENOUGH, NOTHING, ENOUGH), "with sigma doubled, the verdict is unexplained"),
    ],
)
def test_losses_that_other_errors_would_claim(entries: tuple[tuple[str, str], ...], expected: str) -> None:
    stability = tuple(
        Stability(change, word, tuple(names.split()))
        for change, (word, names) in zip(CHANGES, entries, strict=True)
    )
    assert stability_clause(Damping(verdict="adequate", stability=stability)) == expected
