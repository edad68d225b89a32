"""The table of the suite of campaigns: what was asked before the work, what was measured, and whether that is met."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator, Sequence

import numpy as np

from studies.campaign_cases import CampaignOutcome
from studies.campaign_judging import Row
from studies.campaign_machines import KINDS_OF_RECORD

#: Asked, before the work; see `campaigns`.
FOUND, NO_MODE = 0.95, 0.02
FREQUENCY = {"frf": 0.0003, "impact": 0.001, "ambient": 0.003}
COVERED = (0.90, 0.99)
RATIO = (0.6, 1.5)
DAMPED = 0.005
DAMPING = {"forced": 0.03, "ambient": 0.15}
MAC_MEDIAN, MAC_TENTH = 0.99, 0.95
SIGNAL, NAMED, FEWEST = 8.0, 0.90, 40
WRONG = 1 / 60


def table(outcomes: Sequence[CampaignOutcome]) -> Iterator[tuple[str, str, str, bool]]:
    """Yield what was measured, what was asked, what came out, and whether that is met."""
    counted, found = counts(outcomes)
    yield "modes found", f">= {FOUND:.0%}", share(found, counted), found >= FOUND * counted
    rows = [row for outcome in outcomes for row in rows_of(outcome)]
    false = sum(row.mode < 0 for row in rows)
    yield "rows that are no mode", f"<= {NO_MODE:.0%}", share(false, len(rows)), false <= NO_MODE * len(rows)
    for kind, most in FREQUENCY.items():
        some = list(rows_that_count(of_kinds(outcomes, kind)))
        error = rms(row.frequency / row.true - 1.0 for row in some)
        what = f"frequency against the record's own truth, rms: {kind}"
        yield what, f"<= {100 * most:g} %", f"{100 * error:.3f} %", error <= most
    yield from _coverage(outcomes)
    yield from _ratios(outcomes)
    for name, kinds in (("forced", ("frf", "impact")), ("ambient", ("ambient",))):
        errors = damping_errors(of_kinds(outcomes, *kinds))
        median = float(np.median(errors)) if errors else np.nan
        what = f"damping above {100 * DAMPED:g} %, median error: {name}"
        yield what, f"<= {100 * DAMPING[name]:g} %", f"{100 * median:.1f} %", median <= DAMPING[name]
    macs = [row.mac for row in rows_that_count(outcomes) if np.isfinite(row.mac)]
    median, tenth = (float(np.quantile(macs, q)) if macs else np.nan for q in (0.5, 0.1))
    yield "MAC, median", f">= {MAC_MEDIAN:g}", f"{median:.4f}", median >= MAC_MEDIAN
    yield "MAC, worst tenth above", f">= {MAC_TENTH:g}", f"{tenth:.3f}", tenth >= MAC_TENTH
    clear = [outcome for outcome in outcomes if outcome.case.names and outcome.signal > SIGNAL]
    named = sum(outcome.state == "named" for outcome in clear)
    enough = len(clear) >= FEWEST
    what = f"cause named, signal > {SIGNAL:g} sigma, at least {FEWEST} machines"
    yield what, f">= {NAMED:.0%}", share(named, len(clear)), enough and named >= NAMED * len(clear)
    wrong = sum(outcome.state == "wrong" for outcome in outcomes)
    yield "confident and wrong", "<= 1 of 60", f"{wrong} of {len(outcomes)}", wrong <= WRONG * len(outcomes)


def _coverage(outcomes: Sequence[CampaignOutcome]) -> Iterator[tuple[str, str, str, bool]]:
    asked = f"{COVERED[0]:.0%} to {COVERED[1]:.0%}"
    for name, inside in COVERAGES.items():
        values = [value for outcome in outcomes for row in rows_of(outcome) for value in inside(outcome, row)]
        good = sum(values)
        met = bool(values) and COVERED[0] <= good / len(values) <= COVERED[1]
        yield f"within 2 sigma: {name}", asked, share(good, len(values)), met


def _ratios(outcomes: Sequence[CampaignOutcome]) -> Iterator[tuple[str, str, str, bool]]:
    every = [(outcome, row) for outcome in outcomes for row in rows_of(outcome) if row.mode >= 0]
    own = [row for _, row in every if row.of_fit > row.repeatability]
    smooth = [row for outcome, row in every if not rubbed(outcome) and np.isfinite(row.sigma_damping)]
    shapes = [row for _, row in every if row.shape_errors and np.isfinite(row.sigma_shape)]
    ratios = {
        "frequency, where sigma is mostly the identification's": (
            rms((row.frequency - row.true) / row.true for row in own),
            rms(row.of_fit / row.true for row in own),
            len(own),
        ),
        "damping": (
            rms(row.damping / row.true_damping - 1.0 for row in smooth),
            rms(row.sigma_damping / row.true_damping for row in smooth),
            len(smooth),
        ),
        "shape component": (
            rms(error for row in shapes for error in row.shape_errors),
            rms(row.sigma_shape for row in shapes for _ in row.shape_errors),
            len(shapes),
        ),
    }
    for name, (error, sigma, count) in ratios.items():
        value = error / sigma if sigma else np.nan
        what = f"rms error / rms sigma: {name}"
        yield (
            what,
            f"{RATIO[0]:g} to {RATIO[1]:g}",
            f"{value:.2f} ({count} rows)",
            RATIO[0] <= value <= RATIO[1],
        )


def _frequency_inside(_: CampaignOutcome, row: Row) -> list[bool]:
    return [] if row.mode < 0 else [abs(row.frequency - row.nominal) <= 2.0 * row.sigma]


def _damping_inside(outcome: CampaignOutcome, row: Row) -> list[bool]:
    if row.mode < 0 or rubbed(outcome) or not np.isfinite(row.sigma_damping):
        return []
    return [abs(row.damping - row.true_damping) <= 2.0 * row.sigma_damping]


def _shape_inside(_: CampaignOutcome, row: Row) -> list[bool]:
    return [abs(error) <= 2.0 * row.sigma_shape for error in row.shape_errors]


#: Whether values of a row are within two standard deviations, by what they are.
COVERAGES: dict[str, Callable[[CampaignOutcome, Row], list[bool]]] = {
    "frequency": _frequency_inside,
    "damping": _damping_inside,
    "shape component": _shape_inside,
}


def details(outcomes: Sequence[CampaignOutcome]) -> Iterator[tuple[str, ...]]:
    """Yield a line of figures for each kind of record."""
    for kind in KINDS_OF_RECORD:
        some = of_kinds(outcomes, kind)
        counted, found = counts(some)
        rows = [row for outcome in some for row in rows_of(outcome)]
        counting = list(rows_that_count(some))
        inside = {
            name: [value for outcome in some for row in rows_of(outcome) for value in within(outcome, row)]
            for name, within in COVERAGES.items()
        }
        errors = damping_errors(some)
        macs = [row.mac for row in counting if np.isfinite(row.mac)]
        yield (
            kind,
            str(len(some)),
            str(sum(outcome.files for outcome in some)),
            f"{found} of {counted}",
            f"{sum(row.mode < 0 for row in rows)} of {len(rows)}",
            f"{100 * rms(row.frequency / row.true - 1.0 for row in counting):.3f}",
            *(f"{100 * np.mean(values):.0f}" if values else "" for values in inside.values()),
            f"{100 * np.median(errors):.1f}" if errors else "",
            f"{np.median(macs):.4f}" if macs else "",
            f"{np.quantile(macs, 0.1):.3f}" if macs else "",
        )


DETAILS = (
    *("kind", "machines", "files", "modes found", "rows that are no mode", "frequency, rms [%]"),
    *("frequency in 2 sigma [%]", "damping [%]", "shape [%]", "damping, median error [%]"),
    *("MAC, median", "worst tenth"),
)


def rows_of(outcome: CampaignOutcome) -> tuple[Row, ...]:
    """Return all rows of a machine."""
    return outcome.judged.rows if outcome.judged else ()


def rows_that_count(outcomes: Iterable[CampaignOutcome]) -> Iterator[Row]:
    """Yield the rows that are modes which count."""
    for outcome in outcomes:
        counted = set(outcome.judged.counted) if outcome.judged else set()
        yield from (row for row in rows_of(outcome) if (row.record, row.mode) in counted)


def counts(outcomes: Iterable[CampaignOutcome]) -> tuple[int, int]:
    """Return how many modes count, and how many of them were found."""
    judged = [outcome.judged for outcome in outcomes if outcome.judged]
    counted = sum(len(outcome.counted) for outcome in judged)
    return counted, counted - sum(len(outcome.missed) for outcome in judged)


def of_kinds(outcomes: Iterable[CampaignOutcome], *kinds: str) -> list[CampaignOutcome]:
    """Return the outcomes with records of some kinds."""
    return [outcome for outcome in outcomes if outcome.case.kind in kinds]


def rubbed(outcome: CampaignOutcome) -> bool:
    """Return whether a machine has Coulomb friction: its damping is no constant."""
    return "Coulomb friction" in outcome.unkind


def damping_errors(outcomes: Iterable[CampaignOutcome]) -> list[float]:
    """Return relative errors of damping ratios above `DAMPED`, of modes that count, without Coulomb friction."""
    return [
        abs(row.damping / row.true_damping - 1.0)
        for outcome in outcomes
        if not rubbed(outcome)
        for row in rows_that_count([outcome])
        if row.true_damping > DAMPED and np.isfinite(row.damping)
    ]


def rms(values: Iterable[float]) -> float:
    """Return the root of the mean square; NaN of nothing."""
    found = np.array(list(values))
    return float(np.sqrt(np.mean(found**2))) if found.size else float("nan")


def share(count: int, of: int) -> str:
    """Return a share in words."""
    return f"{count} of {of}: {100 * count / of:.1f} %" if of else "no cases"
