"""Sentences that say why a verdict was given."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np
from numpy.typing import NDArray
from scipy import stats

from pkmodes.diagnosis.fit.fitter import Fitter
from pkmodes.diagnosis.fit.hypothesis import Fit, Hypothesis
from pkmodes.diagnosis.problem import Candidate
from pkmodes.diagnosis.search.gate import Gate
from pkmodes.diagnosis.verdict.result import Finding


def noise(hypothesis: Hypothesis, scatter: float, lines: NDArray[np.int_]) -> str:
    """What was attributed to the measurements themselves."""
    parts = []
    if hypothesis.excluded:
        which = ", ".join(str(lines[row]) for row in sorted(hypothesis.excluded))
        parts.append(f"line {which} set aside as an outlier")
    if hypothesis.scatter:
        parts.append(f"an error of {100 * scatter:.2g} % that the modes of a pose share")
    return " and ".join(parts)


def adequate(gate: Gate, setting_aside: str) -> str:
    """Nothing is missing."""
    aside = f", with {setting_aside}" if setting_aside else ""
    return (
        f"what the declared model leaves is noise ({_p(gate.p_value)}, "
        f"and {gate.p_candidates:.2g} for the best candidate){aside}"
    )


def found(findings: Sequence[Finding], gate: Gate, setting_aside: str) -> str:
    """A cause."""
    causes = " and ".join(_cause(finding) for finding in findings)
    smallest = min(gate.p_value, gate.p_candidates)
    aside = f"; {setting_aside}" if setting_aside else ""
    return f"the declared model leaves more than noise ({_p(smallest)}); what explains it: {causes}{aside}"


def _p(p_value: float) -> str:
    return f"p = {p_value:.2g}" if p_value > 0.0 else "p < 1e-300"


def _cause(finding: Finding) -> str:
    more = len(finding.members) - 1
    others = "one other that looks" if more == 1 else f"{more} others that look"
    alike = f", or {others} the same" if more else ""
    return f"{finding.sentence} ({finding.name}{alike})" if finding.sentence else f"{finding.name}{alike}"


def ambiguous(classes: Sequence[Sequence[str]]) -> str:
    """Several."""
    remaining = "; ".join(" or ".join(names) for names in classes)
    if len(classes) == 1:
        return f"{len(classes[0])} explanations look alike to these data: {remaining}"
    return f"{len(classes)} different explanations remain: {remaining}"


def unstable(causes: Sequence[Candidate], change: str, instead: Sequence[Candidate]) -> str:
    """A cause that depends on the stated errors."""
    return (
        f"{_names(causes)} would explain the residual, but with {change} {_names(instead)} would do so better"
    )


def held_by_priors(causes: Sequence[Candidate]) -> str:
    """A value that depends on what was declared of others."""
    return (
        f"{_names(causes)} would explain the residual, but its value changes with priors twice as wide: some "
        "uncertain value is far from its declared one, and makes up for something else"
    )


def remote(cause: Candidate) -> str:
    """A cause that is not claimed."""
    also = ", or put it among the candidates" if cause.nameable else ""
    return f"no candidate explains the residual alone, but {cause.name} would: look there{also}"


def unlike(cause: Candidate, general: Candidate) -> str:
    """Another form of the cause is better."""
    return f"{cause.name} would explain the residual, but {general.name} would do so significantly better: look there"


def errors(causes: Sequence[Candidate], what: str) -> str:
    """Errors of the measurement explain it as well."""
    return (
        f"{_names(causes)} would explain the residual, but errors of the measurement nearly as well: {what}"
    )


def shapes(causes: Sequence[Candidate]) -> str:
    """Frequencies agree, shapes do not."""
    who = f"{_names(causes)} would explain" if causes else "the declared model explains"
    return f"{who} the frequencies, but not the shapes of some of these modes (MAC)"


def shapes_prefer(causes: Sequence[Candidate], others: Sequence[Candidate]) -> str:
    """Another explanation has the better shapes."""
    other = _names(others) if others else "the declared model"
    return f"{_names(causes)} would explain the frequencies, but {other} fits the shapes significantly better"


def unspecific(causes: Sequence[Candidate], others: Sequence[str], p_value: float) -> str:
    """Too few data to know it from anything else."""
    also = f" (and so would {', '.join(others)})" if others else ""
    return (
        f"{_names(causes)} would explain the residual{also}, but so little data cannot rule out a cause "
        f"outside the candidates: {100 * p_value:.2g} % of those would look like one of them; measure more"
    )


def two_of_few(causes: Sequence[Candidate], rows: int, needed: int) -> str:
    """Two causes from few data."""
    return (
        f"{_names(causes)} together would explain the residual, but two causes are not claimed from {rows} measured "
        f"modes: measure {needed} or more"
    )


def at_bound(cause: Candidate, value: float, sigma: float, bound: float) -> str:
    """A value that a bound holds."""
    return (
        f"{cause.name} would explain the residual, but its value, {value:.4g} +- {sigma:.2g}, is at its bound "
        f"{bound:.4g}: something else may be the cause"
    )


def near_absence(cause: Candidate) -> str:
    """A value that is not significant."""
    return (
        f"{cause.name} would explain the residual, but its value is not significantly different from the declared "
        "one: something else must be the cause"
    )


def rests_on(cause: Candidate, line: int, label: str, frequency: float, value: float | None) -> str:
    """A single row speaks for it."""
    without = "it would not be seen without it" if value is None else f"without it, its value is {value:.4g}"
    return (
        f"{cause.name} would explain the residual, but it rests on line {line} ({label}, {frequency:g} Hz) alone, "
        f"and {without}: check that row"
    )


def weak(causes: Sequence[Candidate], p_value: float, what: str) -> str:
    """It may be chance."""
    perhaps = f"; errors of the measurement would explain it too: {what}" if what else ""
    return (
        f"what is left points at {_names(causes)}, but not clearly enough to be claimed "
        f"({_p(p_value)} among all candidates): measure more{perhaps}"
    )


def _names(causes: Sequence[Candidate]) -> str:
    return " and ".join(cause.name for cause in causes)


def added_modes(causes: Sequence[Candidate]) -> str:
    """Modes that should have been measured."""
    return f"{_names(causes)} would explain the measured modes, but adds others among them that were not measured"


def unpaired(count: int) -> str:
    """Measured modes that no model has."""
    which = "1 measured mode is" if count == 1 else f"{count} measured modes are"
    return f"{which} unmatched: the model has no mode there, and no candidate adds one"


def declared_value(name: str, away: float) -> str:
    """The data agree, an uncertain value does not."""
    return (
        f"the data agree with the model, but only with {name} {away:.1f} sigma from its declared value: that value "
        "or its sigma is wrong, or something outside the candidates has the same effect"
    )


def shapes_left(ratio: float, line: int) -> str:
    """The frequencies agree, the shapes do not."""
    return (
        f"the frequencies agree with the model, but the shapes do not (chi2 per degree of freedom {ratio:.3g}, worst "
        f"in line {line}), and no candidate or pair of them explains both"
    )


def beyond_prior(name: str, value: float, away: float) -> str:
    """A candidate that its prior forbids."""
    return (
        f"{name} = {value:.4g} would explain the data, but that is {away:.1f} sigma outside what was declared "
        "plausible for it, and nothing else explains them"
    )


def scattered(ratio: float, pattern: str, few: bool) -> str:
    """What is left has no direction."""
    perhaps = "something outside the candidates, or stated errors that are too small"
    what = pattern or (perhaps if few else "perhaps the stated sigma is too small")
    return f"the residual is {ratio**0.5:.2g} times the stated errors and points at no candidate: {what}"


def small(p_candidates: float) -> str:
    """It is hardly more than noise."""
    return (
        f"what is left is small but points at a candidate ({_p(p_candidates)}), and none explains it well enough to "
        "be claimed: measure more"
    )


def nearly(causes: Sequence[Candidate], before: float, after: float, p_value: float) -> str:
    """It explains most, and leaves more than the stated errors."""
    verb = "explain" if len(causes) > 1 else "explains"
    return (
        f"{_names(causes)} {verb} nearly all of the residual (chi2 per degree of freedom from {before:.3g} to "
        f"{after:.3g}), but what is left is more than the stated errors ({_p(p_value)}): they are some "
        f"{after**0.5:.2g} times too small, or something else is missing as well"
    )


def real(ratio: float, pattern: str) -> str:
    """Nothing explains it."""
    seen = f"; {pattern}" if pattern else ""
    return (
        f"the residual is real (chi2 per degree of freedom {ratio:.3g}) and no candidate or pair of them "
        f"brings it to the noise{seen}"
    )


def uneven(fitter: Fitter, fit: Fit) -> str:
    """How the residual of the frequencies goes with the setup, where it does; else empty."""
    left = fit.residual[fitter.frequency_rows]
    rows = [r for r in fitter.noise.rows if len(r) >= 2]
    if len(rows) < 3:
        return ""
    means = np.array([left[r].mean() for r in rows])
    between = sum(
        len(r) * (m - left[np.concatenate(rows)].mean()) ** 2 for r, m in zip(rows, means, strict=True)
    )
    within = sum(float(((left[r] - m) ** 2).sum()) for r, m in zip(rows, means, strict=True))
    count = sum(map(len, rows))
    ratio = (between / (len(rows) - 1)) / max(within / (count - len(rows)), 1e-300)
    if stats.f.sf(ratio, len(rows) - 1, count - len(rows)) > fitter.criteria.uneven:
        return ""
    labels = [fitter.data.labels[fitter.data.pose[r[0]]] for r in rows]
    high, low = int(means.argmax()), int(means.argmin())
    return (
        f"the residual goes with the pose, from {100 * means[high]:+.2g} % at {labels[high]} to "
        f"{100 * means[low]:+.2g} % at {labels[low]}"
    )


def insufficient(
    rows: int,
    shapes: int,
    uncertain: Sequence[str],
    p_value: float | None,
    hints: Sequence[str],
    contradicts: bool,
) -> str:
    """Too few, and whether they contradict the model all the same."""
    modes = "1 measured mode" if rows == 1 else f"{rows} measured modes"
    modes += f" with {shapes} shape values" if shapes else ""
    modes += " is" if rows == 1 else " are"
    names = f"the uncertain {', '.join(uncertain)}, " if uncertain else ""
    text = f"{modes} too few for {names}a cause, and one more to test it with"
    if p_value is None:
        return text
    if not contradicts:
        return (
            f"{text}; the declared model with its uncertain values does not contradict them ({_p(p_value)})"
        )
    would = f"; they would not with {' or '.join(hints)}" if hints else ""
    return f"{text}; yet they contradict the declared model and its uncertain values ({_p(p_value)}){would}"
