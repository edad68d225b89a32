"""Sentences that say why a verdict was given."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np
from numpy.typing import NDArray
from scipy import stats

from pkmodes.diagnosis.fit.fitter import Fitter
from pkmodes.diagnosis.fit.hypothesis import Fit
from pkmodes.diagnosis.problem import Candidate
from pkmodes.diagnosis.search.gate import Gate
from pkmodes.diagnosis.verdict.findings import Finding
from pkmodes.diagnosis.verdict.naming import explained
from pkmodes.support.numbers import p_in_words, p_text, plain, rounded


def noise(fit: Fit, lines: NDArray[np.int_]) -> str:
    """Return what a fit attributes to measurement errors."""
    parts, excluded = [], [str(lines[row]) for row in sorted(fit.hypothesis.excluded)]
    if len(excluded) == 1:
        parts.append(f"line {excluded[0]} set aside as an outlier")
    elif excluded:
        parts.append(f"lines {', '.join(excluded)} set aside as outliers")
    if fit.hypothesis.scatter:
        parts.append(f"an error of {100 * fit.scatter:.2g} % that the modes of a pose share")
    return " and ".join(parts)


def adequate(gate: Gate, setting_aside: str, declared: float) -> str:
    """Return the reason if nothing is missing.

    Parameters
    ----------
    declared : float
        p-value of the residual of the model as declared, before any refit.
    """
    aside = f", with {setting_aside}" if setting_aside else ""
    p = f"({p_in_words(gate.p_value)}, and {p_text(gate.p_candidates)} for the best candidate)"
    if declared > gate.level:
        return f"the residual of the declared model is noise {p}{aside}"
    refit = "the residual is noise once the uncertain values are refitted"
    return f"{refit} {p}, not as declared ({p_in_words(declared)}){aside}"


def effect_found(findings: Sequence[Finding], gate: Gate, setting_aside: str) -> str:
    """Return the reason if causes are found."""
    smallest = min(gate.p_value, gate.p_candidates)
    aside = f"; {setting_aside}" if setting_aside else ""
    return f"the residual of the declared model is not noise ({p_in_words(smallest)}); {explained(findings)}{aside}"


def ambiguous(classes: Sequence[Sequence[str]]) -> str:
    """Return the reason if several explanations remain."""
    remaining = "; ".join(" or ".join(names) for names in classes)
    if len(classes) == 1:
        return f"these data cannot tell {len(classes[0])} explanations apart: {remaining}"
    return f"{len(classes)} different explanations remain: {remaining}"


def unstable(causes: Sequence[Candidate], change: str, instead: Sequence[Candidate]) -> str:
    """Return the reason if the best cause depends on the stated errors."""
    return f"{_names(causes)} would explain the residual, but with {change}, {_names(instead)} would do so better"


def held_by_priors(causes: Sequence[Candidate]) -> str:
    """Return the reason if the value of a cause depends on the priors."""
    value = "its value changes" if len(causes) == 1 else "their values change"
    return (
        f"{_names(causes)} would explain the residual, but {value} with priors twice as wide: some uncertain "
        "parameter is far from its declared value and compensates for something else"
    )


def remote(cause: Candidate) -> str:
    """Return the reason if a remote cause, which is never claimed, explains the residual."""
    also = ", or add it to the candidates" if cause.nameable else ""
    return f"no candidate explains the residual alone, but {cause.name} would: look there{also}"


def in_one_joint(causes: Sequence[Candidate], single: Sequence[Candidate]) -> str:
    """Return the reason if a cause in one joint explains as much as one in all joints."""
    return f"{_names(causes)} would explain the residual, and so would {_names(single)}: look there, and measure more"


def unlike(cause: Candidate, general: Candidate) -> str:
    """Return the reason if the more general form of a cause is better."""
    return f"{cause.name} would explain the residual, but {general.name} would do so significantly better: look there"


def errors(causes: Sequence[Candidate], what: str) -> str:
    """Return the reason if measurement errors explain the residual nearly as well."""
    return f"{_names(causes)} would explain the residual, but measurement errors would do so nearly as well: {what}"


def shapes(causes: Sequence[Candidate]) -> str:
    """Return the reason if the frequencies agree and the shapes do not."""
    who = f"{_names(causes)} would explain" if causes else "the declared model explains"
    return f"{who} the frequencies, but not the shapes of some of these modes (MAC)"


def shapes_prefer(causes: Sequence[Candidate], others: Sequence[Candidate]) -> str:
    """Return the reason if another explanation fits the shapes better."""
    other = _names(others) if others else "the declared model"
    verb = "fit" if len(others) > 1 else "fits"
    return (
        f"{_names(causes)} would explain the frequencies, but {other} {verb} the shapes significantly better"
    )


def unspecific(causes: Sequence[Candidate], others: Sequence[str], p_value: float) -> str:
    """Return the reason if there are too few data to exclude a cause outside the candidates."""
    also = f" (and so would {', '.join(others)})" if others else ""
    return (
        f"{_names(causes)} would explain the residual{also}, but the data are too few to rule out a cause outside "
        f"the candidates: {100 * p_value:.2g} % of such causes would look like a candidate; measure more"
    )


def two_of_few(causes: Sequence[Candidate], rows: int, needed: int) -> str:
    """Return the reason if there are too few data for two causes."""
    return (
        f"{_names(causes)} together would explain the residual, but two causes are not claimed from {rows} measured "
        f"modes: measure {needed} or more"
    )


def at_bound(cause: Candidate, value: float, sigma: float, bound: float) -> str:
    """Return the reason if the value of a cause is at a bound."""
    return (
        f"{cause.name} would explain the residual, but its value, {rounded(value, sigma)}, is at its bound "
        f"{plain(bound, 4)}: something else may be the cause"
    )


def near_absence(cause: Candidate) -> str:
    """Return the reason if the value of a cause is not significant."""
    return (
        f"{cause.name} would explain the residual, but its value is not significantly different from the declared "
        "one: something else must be the cause"
    )


def rests_on(cause: Candidate, line: int, label: str, frequency: float, value: float | None) -> str:
    """Return the reason if a cause or its value depends on a single row."""
    without = "it would not be detected" if value is None else f"its value would be {plain(value, 4)}"
    return (
        f"{cause.name} would explain the residual, but depends on line {line} ({label}, {frequency:g} Hz) alone: "
        f"without that row, {without}; check the row"
    )


def extra(lines: Sequence[int]) -> str:
    """Return the reason if rows could only be set aside that are modes which the model lacks."""
    which = (
        f"line {lines[0]} is a mode" if len(lines) == 1 else f"lines {', '.join(map(str, lines))} are modes"
    )
    return (
        f"the declared model explains all other rows, but {which} that it does not have: all its modes near there "
        "were measured as well"
    )


def shared(error: float, drift: str) -> str:
    """Return the reason if only an unstated error that the modes of a pose share makes the model adequate."""
    also = f"; {drift}" if drift else ""
    return (
        f"the declared model explains the residual only with an error of {100 * error:.2g} % that the modes of a "
        f"pose share and the file does not state{also}: something changed between the poses, or an effect is missing"
    )


def held_out(causes: Sequence[Candidate], p_value: float, instead: Sequence[Candidate]) -> str:
    """Return the reason if the held-out poses contradict a result."""
    who = f"{_names(causes)} would explain" if causes else "the declared model explains"
    other = f"; {_names(instead)} would explain all poses: look there" if instead else ""
    return f"{who} the fitted poses, but not the held-out ones ({p_in_words(p_value)}){other}"


def together(causes: Sequence[Candidate], instead: Sequence[Candidate]) -> str:
    """Return the reason if another cause explains all poses better."""
    return f"{_names(causes)} would explain all poses, but {_names(instead)} explains them better: look there"


def not_everywhere(causes: Sequence[Candidate]) -> str:
    """Return the reason if the held-out poses cannot be evaluated with a result."""
    who = f"{_names(causes)} would explain" if causes else "the declared model explains"
    return f"{who} the fitted poses, but with these values the held-out ones cannot be evaluated"


def larger(ratio: float) -> str:
    """Return how large errors are relative to the stated ones: "2.3 times as large as", "12 % larger than"."""
    percent = round(100.0 * (ratio - 1.0))
    if percent == 0:
        return "as large as"
    if abs(percent) < 50:
        return f"{abs(percent)} % {'larger' if percent > 0 else 'smaller'} than"
    return f"{ratio:.2g} times as large as"


def weak(causes: Sequence[Candidate], p_value: float, what: str) -> str:
    """Return the reason if the improvement may be chance."""
    perhaps = f"; measurement errors would explain it too: {what}" if what else ""
    return (
        f"the residual points to {_names(causes)}, but not clearly enough for a claim "
        f"({p_in_words(p_value)} among all candidates): measure more{perhaps}"
    )


def _names(causes: Sequence[Candidate]) -> str:
    return " and ".join(cause.name for cause in causes)


def added_modes(causes: Sequence[Candidate]) -> str:
    """Return the reason if causes add modes that should have been measured."""
    verb = "add" if len(causes) > 1 else "adds"
    return f"{_names(causes)} would explain the measured modes, but {verb} modes between them that were not measured"


def unpaired(count: int) -> str:
    """Return the reason if measured modes remain unmatched."""
    which = "1 measured mode is" if count == 1 else f"{count} measured modes are"
    return f"{which} unmatched: the model has no mode there, and no candidate adds one"


def declared_value(name: str, away: float) -> str:
    """Return the reason if the data agree but an uncertain value is far from the declared one."""
    return (
        f"the data agree with the model, but only with {name} {away:.1f} sigma from its declared value: that value "
        "or its sigma is wrong, or something outside the candidates has the same effect"
    )


def shapes_left(ratio: float, line: int) -> str:
    """Return the reason if the model fits the frequencies but nothing explains the shapes."""
    return (
        f"the frequencies agree with the model, but the shapes do not (chi2 per degree of freedom {ratio:.3g}, worst "
        f"in line {line}), and no candidate or pair of candidates explains both"
    )


def beyond_prior(name: str, value: float, away: float) -> str:
    """Return the reason if only a candidate far beyond its prior explains the data."""
    return (
        f"{name} = {plain(value, 4)} would explain the data, but this is {away:.1f} sigma outside the range declared "
        "plausible for it, and nothing else explains them"
    )


def scattered(ratio: float, pattern: str, *, few: bool, explained: bool) -> str:
    """Return the reason if no candidate stands out from a residual of that size.

    Parameters
    ----------
    explained : bool
        Whether some explanation reduces it clearly if the stated errors are right.
    """
    perhaps = "something outside the candidates, or stated errors that are too small"
    what = pattern or (perhaps if few else "perhaps the stated sigma is too small")
    nowhere = "" if explained else " and points to no candidate"
    return f"the residual is {larger(ratio**0.5)} the stated errors{nowhere}: {what}"


def small(name: str, p_candidates: float) -> str:
    """Return the reason if the residual is hardly more than noise."""
    return (
        f"the residual is small but points to a candidate, {name} ({p_in_words(p_candidates)}), and no candidate "
        "explains it well enough for a claim: measure more"
    )


def best_of_all(causes: Sequence[Candidate], why: str) -> str:
    """Return the clause on the best explanation, which is not claimed, and why it is not."""
    sentences = " and ".join(
        f"{cause.sentence} ({cause.name})" if cause.sentence else cause.name for cause in causes
    )
    that = "that " if causes[0].sentence else ""
    return f"the best explanation, {that}{sentences}, is not claimed: {why}"


def leaves(ratio: float, p_value: float) -> str:
    """Return why an explanation is not claimed that leaves more than the stated errors."""
    return f"it leaves a residual {larger(ratio**0.5)} the stated errors ({p_in_words(p_value)})"


def leaves_unmatched(count: int) -> str:
    """Return why an explanation is not claimed that leaves measured modes without a partner."""
    return f"it leaves {count} measured mode{'' if count == 1 else 's'} unmatched"


def adds_modes() -> str:
    """Return why an explanation is not claimed that adds modes which should have been measured."""
    return "it adds modes between the measured ones that were not measured"


def leaves_direction(name: str, p_value: float) -> str:
    """Return why an explanation is not claimed whose residual still points somewhere."""
    return f"what it leaves still points to a candidate, {name} ({p_in_words(p_value)})"


def nearly(causes: Sequence[Candidate], before: float, after: float, p_value: float) -> str:
    """Return the reason if causes explain most of the residual, but not down to the stated errors."""
    verb = "explain" if len(causes) > 1 else "explains"
    return (
        f"{_names(causes)} {verb} nearly all of the residual (chi2 per degree of freedom from {before:.3g} to "
        f"{after:.3g}), but the rest exceeds the stated errors ({p_in_words(p_value)}): it is {larger(after**0.5)} "
        "these, or something else is missing as well"
    )


def real(ratio: float, pattern: str) -> str:
    """Return the reason if nothing explains the residual."""
    seen = f"; {pattern}" if pattern else ""
    return (
        f"the residual is real, {larger(ratio**0.5)} the stated errors, and no candidate or pair of candidates "
        f"reduces it to noise{seen}"
    )


def uneven(fitter: Fitter, fit: Fit) -> str:
    """Return how the frequency residual varies with the setup; empty if it does not."""
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
        f"the residual varies with the pose, from {100 * means[high]:+.2g} % at {labels[high]} to "
        f"{100 * means[low]:+.2g} % at {labels[low]}"
    )


def insufficient_data(
    rows: int,
    shapes: int,
    uncertain: Sequence[str],
    p_value: float | None,
    hints: Sequence[str],
    contradicts: bool,
) -> str:
    """Return the reason if there are too few data, and whether they nevertheless contradict the model."""
    modes = "1 measured mode" if rows == 1 else f"{rows} measured modes"
    modes += f" with {shapes} shape values" if shapes else ""
    modes += " is" if rows == 1 else " are"
    names = f"the uncertain {', '.join(uncertain)} and " if uncertain else ""
    text = f"{modes} too few to fit {names}a cause, with one value left to test it"
    if p_value is None:
        return text
    one = rows == 1
    if not contradicts:
        them = "it" if one else "them"
        p = p_in_words(p_value)
        return f"{text}; the declared model with its uncertain values does not contradict {them} ({p})"
    they, verb = ("it", "contradicts") if one else ("they", "contradict")
    would = f"; {they} would not with {' or '.join(hints)}" if hints else ""
    return f"{text}; yet {they} {verb} the declared model and its uncertain values ({p_in_words(p_value)}){would}"
