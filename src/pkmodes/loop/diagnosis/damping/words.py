"""Sentences about damping."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np

from pkmodes.core.base.numbers import p_in_words, plain, round_to_sigma
from pkmodes.loop.diagnosis.damping.evidence import DampingJudgement
from pkmodes.loop.diagnosis.damping.explanation import loss_names
from pkmodes.loop.diagnosis.damping.fit import LossFitter
from pkmodes.loop.diagnosis.verdict.findings import Finding
from pkmodes.loop.diagnosis.verdict.verdicts import ADEQUATE, AMBIGUOUS, EFFECT_FOUND, INSUFFICIENT_DATA

#: Largest number of lines listed in a note.
MAX_LISTED_LINES = 8
#: Why measured damping is not diagnosed.
NO_LOSSES_REASON = "the damping is not diagnosed: no loss is among the candidates"
UNSETTLED_REASON = (
    "the damping is not diagnosed: without an explanation of the frequencies, its modes may be the wrong ones"
)


def damping_clause(fitter: LossFitter, judgement: DampingJudgement, findings: Sequence[Finding]) -> str:
    """Return a judgement as a clause about the damping.

    The clause gives no p-value for a claimed cause, which has its own; two p-values could contradict each other.
    """
    if judgement.verdict is ADEQUATE:
        return (
            judgement.answer.text
            or f"the damping is that of the model ({p_in_words(judgement.base.p_value)})"
        )
    if judgement.verdict is EFFECT_FOUND:
        sentences = {loss.candidate: loss.sentence for loss in fitter.losses if loss.candidate}
        causes = [
            " or ".join(f"{sentences[name]} ({name})" for name in finding.members) for finding in findings
        ]
        return f"the damping is not that of the declared model; explanation: {' and '.join(causes)}"
    if judgement.verdict is AMBIGUOUS:
        remaining = "; ".join(loss_names(fitter, fit) for fit in judgement.answer.rivals)
        return f"of the damping, {len(judgement.answer.rivals)} different explanations remain: {remaining}"
    if judgement.verdict is INSUFFICIENT_DATA:
        return f"the damping is not diagnosed: {judgement.answer.text}"
    return f"the damping is not that of the model: {judgement.answer.text}"


def common_ratio_sentence(ratio: float, sigma: float, min_error: float) -> str:
    """Return the sentence for one ratio that explains the damping of a model that declares none.

    - min_error: smallest relative error that a measured ratio is taken to have, whatever its file states
    """
    percent = f"{round_to_sigma(100.0 * ratio, 100.0 * sigma)} %"
    return (
        f"the file declares no damping; every measured mode agrees with a damping ratio of {percent}, within the "
        f"{100.0 * min_error:g} % by which tests of one machine differ at least; that names no joint: to declare it, "
        f'write ratio = "{plain(100.0 * ratio, 2)} %" in a table [damping]'
    )


def scatter_sentence(ratio: float | None, scatter: float) -> str:
    """Return the sentence for damping that scatters as in repeated tests, and that no loss explains.

    - ratio: the value about which it scatters; None if this is the damping that the file declares
    - scatter: standard deviation of the logarithm, in excess of the stated errors
    """
    excess = f"by a factor of {plain(np.exp(scatter), 2)} beyond their stated errors"
    if ratio is None:
        return (
            f"the measured ratios scatter about those of the model {excess}, as repeated tests do, and name no "
            "joint"
        )
    return (
        f"the file declares no damping; the measured ratios scatter about {plain(100.0 * ratio, 2)} % {excess}, as "
        "repeated tests do, and name no joint"
    )


def nearly_declared_sentence(ratio: float, sigma: float, declared: float) -> str:
    """Return the sentence for a common ratio that differs from the declared one no more than repeated tests do."""
    percent = f"{round_to_sigma(100.0 * ratio, 100.0 * sigma)} %"
    return (
        f"the measured ratios are those of a damping ratio of {percent} instead of the "
        f"declared {plain(100.0 * declared, 3)} %, by which repeated tests may differ"
    )


def not_predicted_note(factor: float) -> str:
    """Return the note if the losses do not predict the damping of the held-out poses."""
    return f"the damping of the held-out poses is not predicted: a factor of {plain(factor, 2)} in the mean"


def per_cent_reason(ratio: float) -> str:
    """Return the reason where damping ratios seem to be in per cent."""
    return (
        f"the damping ratios, {plain(ratio, 2)} in the median, are not those of a lightly damped machine, and not "
        "diagnosed: if they are in per cent, write the column as damping [%]"
    )


def factor_hundred_note(*, above: bool) -> str:
    """Return the note if damping ratios are a hundred times, or a hundredth of, those of the model."""
    multiple = "a hundred times" if above else "a hundredth of"
    return f"the damping ratios are {multiple} those of the model: check the unit, damping or damping [%]"


def uninformative_note(lines: Sequence[int]) -> str:
    """Return the note on rows whose damping contains no information about the losses."""
    return (
        f"{_damping_of_lines(lines)} is not used: it is 0 without a standard deviation, or the measurements set the "
        "losses there"
    )


def other_shape_note(lines: Sequence[int], mac_limit: float) -> str:
    """Return the note on rows whose shapes are not those of the modes with which they are paired."""
    return (
        f"{_damping_of_lines(lines)} is not used: the shape measured there is not that of its mode (MAC below "
        f"{mac_limit:g})"
    )


def _damping_of_lines(lines: Sequence[int]) -> str:
    ellipsis = ", ..." if len(lines) > MAX_LISTED_LINES else ""
    line_list = ", ".join(map(str, lines[:MAX_LISTED_LINES])) + ellipsis
    return f"the damping of line{'' if len(lines) == 1 else 's'} {line_list}"


def outlier_note(line: int, label: str, ratio: float) -> str:
    """Return the note on a row whose damping contradicts that of all others."""
    return f"the damping of line {line} ({label}, {plain(100.0 * ratio, 3)} %) is set aside as an outlier: check it"
