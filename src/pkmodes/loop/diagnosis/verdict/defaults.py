"""The rule for causes that only a default makes specific, because the value on which they rest was not declared."""

from __future__ import annotations

from pkmodes.loop.diagnosis.verdict.evidence import Answer, Evidence


def rests_on_undeclared_default(e: Evidence) -> Answer | None:
    """A member of a class is part of a more general cause, and stands out only because of a default value.

    An example is one direction of a frame.  With that value free, the cause is one mass on one spring and can explain
    any one extra mode.  When changes are diagnosed, every other part on its own spring has already been tried as a
    term.
    """
    if e.criteria.claim.terms_as_likely:
        return None
    class_candidates = [fit.causes[-1] for fits in e.claim.class_of_each_cause for fit in fits]
    needed_defaults = [
        assumption for cause in class_candidates if cause.part_of for assumption in cause.assumes
    ]
    decisive_defaults = [assumption for assumption in e.defaults if assumption in needed_defaults]
    if not decisive_defaults:
        return None
    assumptions_in_words = " and ".join(assumption.words for assumption in decisive_defaults)
    keys_to_declare = " and ".join(assumption.key for assumption in decisive_defaults)
    default = "default" if len(decisive_defaults) == 1 else "defaults"
    text = (
        f"{e.explains} the residual with the {default}, {assumptions_in_words}, which the robot file does not "
        "declare; with another value there, another size would explain it equally well, and so might anything else "
        f"on a spring of its own: declare {keys_to_declare}, or find out what moves"
    )
    return Answer.naming(text, e.final.causes)
