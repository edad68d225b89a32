"""The rule for causes that only a default makes specific, because the value on which they rest was not declared."""

from __future__ import annotations

from pkmodes.loop.diagnosis.verdict.evidence import Evidence, Says


def by_a_default(e: Evidence) -> Says | None:
    """A class has a part of a whole, such as one direction of a frame, whose value a default makes specific.

    With the default open, such a cause is one mass on one spring: it explains one further mode whatever that is.  For
    changes, everything else that moves on a spring of its own is tried as a term before a claim.
    """
    if e.criteria.claim.terms_as_likely:
        return None
    members = [fit.causes[-1] for fits in e.claim.own for fit in fits]
    needed = [assumption for cause in members if cause.part_of for assumption in cause.assumes]
    assumed = [assumption for assumption in e.by_default if assumption in needed]
    if not assumed:
        return None
    words = " and ".join(assumption.words for assumption in assumed)
    declare = " and ".join(assumption.key for assumption in assumed)
    text = (
        f"{e.explains} the residual for {words}, which the robot file does not declare; with another value there, "
        "another size explains it as well, and so may anything else that moves on a spring of its own: declare "
        f"{declare}, or look for what moves"
    )
    return Says.naming(text, e.final.causes)
