"""One thing at one place, beyond the catalogue, in place of what the catalogue would claim."""

from __future__ import annotations

from pkmodes.diagnosis.verdict.evidence import Evidence
from pkmodes.diagnosis.verdict.reasons import described, names


def one_term(e: Evidence) -> str:
    """A term, beyond the catalogue, explains the data better than several causes or a wrong value of one axis."""
    several = len(e.final.causes) > 1
    local = any(fit.causes[-1].local for fits in e.claim.own for fit in fits)
    term = e.term_instead if several or local else None
    if term is None:
        return ""
    what = described(term.causes)
    if several:
        return f"{names(e.final.causes)} together would explain the residual, but {what} would do so alone"
    return f"{e.explains} the residual, but {what} would do so better"
