"""The one sentence of a verdict, from what it rests on."""

from __future__ import annotations

from pkmodes.diagnosis.fit.hypothesis import Fit
from pkmodes.diagnosis.search.gate import Gate
from pkmodes.diagnosis.search.search import Outcome, Search
from pkmodes.diagnosis.verdict import reasons
from pkmodes.diagnosis.verdict.judgement import Judgement
from pkmodes.diagnosis.verdict.report import Report, remains


def reason_of(report: Report, search: Search, outcome: Outcome, judged: Judgement) -> str:
    """Say why a verdict was given."""
    fitter, store = search.store.fitter, search.store
    noise = reasons.noise(judged.final.hypothesis, judged.final.scatter, fitter.data.lines)
    if judged.verdict == "adequate":
        return reasons.adequate(outcome.last, noise)
    if judged.verdict == "effect_found":
        return reasons.found(report.findings(judged), outcome.first, noise)
    if judged.verdict == "ambiguous":
        return reasons.ambiguous([[name for name, _ in named] for named in remains(judged)])
    squares, degrees = store.frequency_misfit(outcome.nuisances)
    ratio = squares / max(degrees, 1.0)
    dispersed = _dispersed(outcome.first, outcome.nuisances, search)
    return reasons.unexplained(
        fitter, outcome.nuisances, judged.final, ratio, outcome.first, outcome.last, dispersed
    )


def _dispersed(gate: Gate, fit: Fit, search: Search) -> bool:
    """Whether what is left has no direction, once it is scaled to its own size: larger errors than stated."""
    squares, degrees = search.store.frequency_misfit(fit)
    scale = squares / max(degrees, 1.0)
    most = max((s.gain / scale / max(len(s.candidate.parameters), 1) for s in gate.scores.each), default=0.0)
    c = search.criteria
    return bool(c.dispersed[0] < scale < c.dispersed[1] and most < c.no_direction)
