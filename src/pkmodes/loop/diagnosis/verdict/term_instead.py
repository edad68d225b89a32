"""One thing at one place, beyond the catalogue, in place of what the catalogue would claim."""

from __future__ import annotations

from pkmodes.loop.diagnosis.verdict.evidence import Evidence
from pkmodes.loop.diagnosis.verdict.reasons import causes_in_words, names


def one_term(e: Evidence) -> str:
    """A term, beyond the catalogue, is clearly better, or survives beside several causes or a value of one axis."""
    term = e.term_instead
    if term is None:
        return ""
    description = causes_in_words(term.causes)
    if len(e.final.causes) > 1:
        return f"{names(e.final.causes)} together would explain the residual, but {description} would do so alone"
    return f"{e.explains} the residual, but so would {description}"
