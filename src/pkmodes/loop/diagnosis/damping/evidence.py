"""Evidence for the rules of the verdict on damping."""

from __future__ import annotations

import math
from collections.abc import Mapping
from dataclasses import dataclass
from functools import cached_property

import numpy as np
from scipy import stats

from pkmodes.loop.diagnosis.criteria import Criteria
from pkmodes.loop.diagnosis.damping.doubts import p_coincidence, p_of_trend
from pkmodes.loop.diagnosis.damping.explanation import LossExplanation, best_explanation, p_of_one_more
from pkmodes.loop.diagnosis.damping.fit import LossFit, LossFitter
from pkmodes.loop.diagnosis.damping.observations import DampingObservations
from pkmodes.loop.diagnosis.problem import Array
from pkmodes.loop.diagnosis.verdict.evidence import Answer, Rule, first_decision
from pkmodes.loop.diagnosis.verdict.verdicts import Verdict


@dataclass(frozen=True)
class LossAnswer(Answer):
    """The answer of a rule that applies.

    - ratio_scatter: how far the ratios scatter about the model beyond their stated errors, where the verdict allows
      for that: the standard deviation of their logarithm
    - rivals: explanations that remain where several do, the best first
    """

    ratio_scatter: float = 0.0
    rivals: tuple[LossFit, ...] = ()


@dataclass(frozen=True, eq=False)
class DampingJudgement:
    """A verdict on damping, with the fits that belong to it.

    - rule: name of the rule that gave the verdict
    - base: fit with the declared losses
    - final: fit with the causes; the base where none is found or remains
    - classes, p_values: from the `LossExplanation` that is found or remains; otherwise empty
    - answer: why; empty for a claim, where several explanations remain, and where the declared losses leave noise
    """

    rule: str
    verdict: Verdict
    base: LossFit
    final: LossFit
    classes: tuple[tuple[LossFit, ...], ...]
    p_values: tuple[float, ...]
    answer: LossAnswer


class LossEvidence:
    """Damping ratios and the losses that explain them; costly results are computed when a rule first needs them.

    - fitter: fits losses to the rows that take part
    - doubts: where one of these applies, nothing is claimed
    - trials: verdicts with other errors or priors, by change
    - held_out: ratios of the held-out poses
    """

    def __init__(
        self,
        fitter: LossFitter,
        doubts: LossRules,
        trials: Mapping[str, DampingJudgement] | None = None,
        held_out: DampingObservations | None = None,
    ) -> None:
        self.fitter, self.criteria = fitter, fitter.criteria
        self.trials, self.held_out, self._doubts = trials or {}, held_out, doubts

    def answer_with(self, text: str) -> LossAnswer:
        """Return a reason as an answer."""
        return LossAnswer(text)

    @cached_property
    def base(self) -> LossFit:
        """The fit of the declared losses, within their priors."""
        return self.fitter.fit()

    @property
    def resolved_count(self) -> int:
        """Number of ratios that are significantly above 0."""
        return int(self.fitter.observations.resolved_mask.sum())

    @cached_property
    def p_one_more(self) -> float:
        """The smallest p-value of one more loss, corrected for the number of candidates."""
        fits = [self.fitter.fit((j,)) for j in self.fitter.candidates]
        return min((p_of_one_more(self.fitter, self.base, fit) for fit in fits), default=1.0)

    @cached_property
    def explanation(self) -> LossExplanation | None:
        """The best explanation by other losses than the declared ones."""
        return best_explanation(self.fitter)

    @cached_property
    def claim(self) -> LossExplanation | None:
        """The explanation, where no rule raises a doubt."""
        return None if first_decision(self._doubts, self) else self.explanation

    @cached_property
    def p_trend(self) -> float:
        """The p-value of a trend with the frequency that the explanation leaves; 1 without one."""
        return p_of_trend(self.fitter, self.explanation.best) if self.explanation else 1.0

    @cached_property
    def coincidence(self) -> float:
        """The fraction of laws outside the candidates that would look like as many of them; 0 without explanation."""
        return p_coincidence(self.fitter, self.explanation.best) if self.explanation else 0.0

    @cached_property
    def common_loss(self) -> int | None:
        """The loss that is the same ratio for all modes."""
        return next((j for j, loss in enumerate(self.fitter.losses) if not loss.effect), None)

    @property
    def declares_losses(self) -> bool:
        """Whether the model declares any loss."""
        return any(loss.declared for loss in self.fitter.losses)

    def scatter_about(self, fit: LossFit) -> float:
        """Return how far ratios are from a fit beyond their stated errors: standard deviation of the logarithm."""
        rows, resolved = self.fitter.observations, self.fitter.observations.resolved_mask
        deviation = (rows.logarithms - rows.predicted_logarithms(fit.values))[resolved]
        excess_variance = float(np.mean(deviation**2)) - float(np.mean(rows.stated_sigma[resolved] ** 2))
        return math.sqrt(max(excess_variance, 0.0))


#: A table of the verdict on damping.
LossRules = tuple[Rule[LossEvidence, LossAnswer], ...]


def contradicts_held_out(
    held_out: DampingObservations, values: Array, criteria: Criteria, ratio_scatter: float = 0.0
) -> bool:
    """Return whether the rows of held-out poses contradict losses.

    - ratio_scatter: scatter of the ratios beyond their stated errors that the verdict allows for
    """
    if not len(held_out.ratio) or not values.any():
        return False
    white = held_out.with_scatter(ratio_scatter).residual(values)
    return bool(stats.chi2.sf(float(white @ white), len(white)) <= criteria.gate.surely)
