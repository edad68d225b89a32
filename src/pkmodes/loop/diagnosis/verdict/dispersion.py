"""A law outside the candidates: a declared stiffness that changes with the frequency, as that of rubber belts does.

Its effect on the frequencies is that of a changed stiffness times a function of the frequency: its logarithm, for a
power law, or its square.  A score test, at the fit without the causes, shows how much each of these would explain.
"""

from __future__ import annotations

from dataclasses import replace
from typing import NamedTuple

import numpy as np

from pkmodes.loop.diagnosis.fit.hypothesis import Fit
from pkmodes.loop.diagnosis.fit.store import FitStore
from pkmodes.loop.diagnosis.verdict.evidence import Evidence

#: Units of stiffnesses; one that is declared as 0 is an absent spring.
STIFFNESSES = ("N/m", "N*m/rad")


class Dispersion(NamedTuple):
    """A declared stiffness that changes with the frequency.

    - name: name of the parameter
    - criterion: criterion of the model with it in place of the causes; smaller is better
    - rises: whether it is larger for modes of high frequency
    """

    name: str
    criterion: float
    rises: bool


def frequency_dependent_stiffness(e: Evidence) -> str:
    """A declared stiffness that changes with the frequency explains the data better, or as well as two causes.

    It has one parameter: as good as a pair of causes, it is the better explanation.  A single cause must be clearly
    worse to be refused: heavier motors of a rotary delta and reducers that soften with the frequency look the same.
    """
    law, is_pair = dispersion(e.store, e.final), len(e.final.causes) > 1
    max_advantage = 0.0 if is_pair else e.criteria.search.survives
    if law is None or law.criterion > e.store.criterion(e.final) - max_advantage:
        return ""
    return (
        f"{e.explains} the residual, but a {law.name} that {'rises' if law.rises else 'falls'} with the "
        f"frequency, which is not a candidate, would do so "
        f"{'with one value' if is_pair else 'significantly better'}: look there"
    )


def dispersion(store: FitStore, final: Fit) -> Dispersion | None:
    """Return the stiffness that explains the data best by a change with the frequency; None if none is declared.

    - final: the final fit, whose causes the stiffness replaces
    """
    fitter, hypothesis = store.fitter, replace(final.hypothesis, causes=())
    fit_without_causes = store.fit(hypothesis, store.values_without(final, hypothesis))
    declared = [
        (i, p.name) for i, p in enumerate(fitter.parameters) if p.unit in STIFFNESSES and p.value > 0.0
    ]
    if fit_without_causes is None or not declared:
        return None
    rows, log_frequencies = fitter.observations.frequency_slice, fitter.observations.log_frequencies
    laws = (log_frequencies - log_frequencies.mean(), np.exp(2.0 * (log_frequencies - log_frequencies.max())))
    _, signatures = fitter.signatures(fit_without_causes, [i for i, _ in declared])
    trials = []
    for column, (_, name) in zip(signatures.T, declared, strict=True):
        for law in laws:
            signature = np.zeros(len(column))
            signature[rows] = column[rows] * law
            remainder = signature - fit_without_causes.basis @ (fit_without_causes.basis.T @ signature)
            norm = float(np.linalg.norm(remainder))
            score = float(remainder @ fit_without_causes.white) / max(norm, 1e-300)
            trials.append(
                Dispersion(
                    name, store.criterion(fit_without_causes) - score**2 + store.parameter_price, score > 0.0
                )
            )
    return min(trials, key=lambda trial: trial.criterion)
