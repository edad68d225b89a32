"""Sentences that say why a verdict was given."""

from __future__ import annotations

from collections.abc import Sequence

from numpy.typing import NDArray

from pkmodes.diagnosis.fitting import Fit, Hypothesis
from pkmodes.diagnosis.gate import ALPHA, Gate
from pkmodes.diagnosis.problem import Candidate
from pkmodes.diagnosis.result import Finding


def noise(hypothesis: Hypothesis, scatter: float, lines: NDArray) -> str:  # type: ignore[type-arg]
    """What was laid to the measurements themselves."""
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
    alike = f", or {more} that look{'s' if more == 1 else ''} alike" if more else ""
    return f"{finding.sentence} ({finding.name}{alike})" if finding.sentence else f"{finding.name}{alike}"


def ambiguous(classes: Sequence[Sequence[str]]) -> str:
    """Several."""
    return (
        f"{len(classes)} different explanations remain: {'; '.join(' or '.join(names) for names in classes)}"
    )


def remote(cause: Candidate) -> str:
    """A cause that is not claimed."""
    also = ", or put it among the candidates" if cause.nameable else ""
    return f"no candidate explains the residual alone, but {cause.name} would: look there{also}"


def errors(causes: Sequence[Candidate]) -> str:
    """Errors of the measurement explain it as well."""
    return (
        f"{_names(causes)} would explain the residual, but errors of the measurement nearly as well: "
        "perhaps the stated sigma is too small, or a row or a pose is off"
    )


def shapes(causes: Sequence[Candidate]) -> str:
    """Frequencies agree, shapes do not."""
    return f"{_names(causes)} would explain the frequencies, but not the shapes of some of these modes (MAC)"


def weak(causes: Sequence[Candidate], p_value: float, errors: bool) -> str:
    """It may be chance."""
    perhaps = "; perhaps the stated sigma is too small" if errors else ""
    return (
        f"what is left points at {_names(causes)}, but not clearly enough to be claimed "
        f"({_p(p_value)} among all candidates): measure more{perhaps}"
    )


def _names(causes: Sequence[Candidate]) -> str:
    return " and ".join(cause.name for cause in causes)


def unexplained(fit: Fit, final: Fit, degrees: int, first: Gate, last: Gate, dispersed: bool) -> str:
    """None."""
    ratio = fit.chi2 / max(degrees, 1)
    if last.p_missing <= last.level < min(last.p_value, last.p_candidates):
        return (
            f"{_names(final.causes)} would explain the measured modes, but adds others among them that were not "
            "measured"
        )
    if last.unpaired:
        which = "a measured mode" if last.unpaired == 1 else f"{last.unpaired} measured modes"
        return f"the model has no mode for {which}, and no candidate gives it one"
    if dispersed:
        return (
            f"the residual is {ratio**0.5:.2g} times the stated errors and points at no candidate: "
            "perhaps the stated sigma is too small"
        )
    if first.p_value > ALPHA:
        return (
            f"what is left is small but points at a candidate ({_p(first.p_candidates)}), and none explains it "
            "well enough to be claimed: measure more"
        )
    return (
        f"the residual is real (chi2 per degree of freedom {ratio:.3g}) and no candidate or pair of them "
        "brings it to the noise"
    )


def insufficient(rows: int, uncertain: Sequence[str]) -> str:
    """Too few."""
    modes = "1 measured mode is" if rows == 1 else f"{rows} measured modes are"
    names = f"the uncertain {', '.join(uncertain)}, " if uncertain else ""
    return f"{modes} too few for {names}a cause, and one more to test it with"
