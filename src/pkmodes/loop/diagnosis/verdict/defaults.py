"""The rule for causes that only a default makes specific, because the value on which they rest was not declared."""

from __future__ import annotations

from pkmodes.loop.diagnosis.verdict.evidence import Answer, Evidence


def by_a_default(e: Evidence) -> Answer | None:
    """A class has a part of a whole, such as one direction of a frame, whose value a default makes specific.

    With the default open, such a cause is one mass on one spring: it explains one further mode whatever that is.  For
    changes, everything else that moves on a spring of its own is tried as a term before a claim.
    """
    if e.criteria.claim.terms_as_likely:
        return None
    members = [fit.causes[-1] for fits in e.claim.own_classes for fit in fits]
    needed_defaults = [assumption for cause in members if cause.part_of for assumption in cause.assumes]
    decisive_defaults = [assumption for assumption in e.defaults if assumption in needed_defaults]
    if not decisive_defaults:
        return None
    assumptions_in_words = " and ".join(assumption.words for assumption in decisive_defaults)
    keys_to_declare = " and ".join(assumption.key for assumption in decisive_defaults)
    text = (
        f"{e.explains} the residual for {assumptions_in_words}, which the robot file does not declare; with another "
        "value there, another size explains it as well, and so may anything else that moves on a spring of its own: "
        f"declare {keys_to_declare}, or look for what moves"
    )
    return Answer.naming(text, e.final.causes)
