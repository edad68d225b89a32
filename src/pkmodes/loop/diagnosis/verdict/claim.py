"""The claim at the end of a search: the preferred causes, with the classes of their rivals.

Each cause is compared with all others in its place.  The best survivor takes the place; survivors that these data
cannot tell from it are its class; a member whose value is impossible leaves the class.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field
from math import comb

from scipy import stats

from pkmodes.loop.diagnosis.fit.fitter import Fitter
from pkmodes.loop.diagnosis.fit.hypothesis import Fit
from pkmodes.loop.diagnosis.search.gate import Gate
from pkmodes.loop.diagnosis.search.ranges import max_plausible_deviations
from pkmodes.loop.diagnosis.search.score import allowed_sign
from pkmodes.loop.diagnosis.search.search import Outcome, Search
from pkmodes.loop.diagnosis.verdict.classes import classes, other_pairs, survivors
from pkmodes.loop.diagnosis.verdict.findings import Finding, Value
from pkmodes.loop.diagnosis.verdict.joints import JointAlone
from pkmodes.loop.diagnosis.verdict.possible import describe_member, split_possible, violated_usual_range

#: Largest number of times that a cause is replaced by a better survivor.
MAX_REPLACEMENTS = 4
#: For each cause, the classes of fits that have another cause in its place.
ClassesByCause = tuple[list[list[Fit]], ...]


@dataclass(frozen=True)
class Claim:
    """The causes that would be claimed; none if the declared model passes the gate, or nothing does.

    - last_gate: gate of the final fit
    - classes_by_cause: for each cause, the classes of fits with another cause in its place; its own class is first
    - rivals: survivors beside a pair of causes
    - p_values: one for each cause
    - causes_survive: whether each cause is among the survivors in its place
    - left_out: sentences about members that left a class because their values are impossible
    - max_deviations: largest plausible deviations of the values of all members from the declared ones, by parameter
    - implausible_names: names of the causes, in the place of a claimed one, whose values such a part cannot have
    """

    final: Fit
    last_gate: Gate
    classes_by_cause: ClassesByCause = ()
    rivals: tuple[Fit, ...] = ()
    p_values: tuple[float, ...] = ()
    causes_survive: bool = True
    left_out: tuple[str, ...] = ()
    max_deviations: Mapping[int, float] = field(default_factory=dict)
    implausible_names: frozenset[str] = frozenset()

    @property
    def class_of_each_cause(self) -> list[list[Fit]]:
        """The class of each cause."""
        return [groups[0] for groups in self.classes_by_cause if groups]

    def remaining_explanations(self, instead: Fit | None = None) -> list[list[tuple[str, Fit]]]:
        """Return the remaining explanations with their names: classes of one cause, or else pairs of causes.

        Classes with a plausible member are first.

        - instead: the explanation that is better with other errors or priors
        """
        if instead is not None:
            return [[(_names(fit), fit)] for fit in (self.final, instead)]
        for groups in self.classes_by_cause:
            if len(groups) > 1 or len(self.final.causes) == 1:
                named_fits = [[(name_of_last_cause(fit), fit) for fit in fits] for fits in groups]
                return sorted(
                    named_fits, key=lambda group: all(name in self.implausible_names for name, _ in group)
                )
        return [[(_names(fit), fit)] for fit in (self.final, *self.rivals)]

    def findings(self, fitter: Fitter, single_joints: Mapping[str, JointAlone]) -> tuple[Finding, ...]:
        """Return all causes with their classes, as parts of a result.

        - single_joints: the one joint that explains the data as well, of each candidate that has one
        """
        findings = []
        for cause, p_value, groups in zip(
            self.final.causes, self.p_values, self.classes_by_cause, strict=True
        ):
            fits = {name_of_last_cause(fit): fit for fit in groups[0]}
            index = {name: fitter.parameter_indices(fit.causes[-1]) for name, fit in fits.items()}
            values = {name: fitted_values(fitter, fit, index[name]) for name, fit in fits.items()}
            names = [cause.name, *(name for name in fits if name != cause.name)]
            joint = single_joints.get(cause.name)
            finding = Finding(
                name=cause.name,
                members=tuple(names),
                parameters=values[cause.name],
                alternatives={name: values[name] for name in names},
                p_value=p_value,
                sentence=cause.sentence if joint is None else joint.sentence,
                covariances={
                    name: tuple(map(tuple, fits[name].covariance_of(index[name]).tolist())) for name in names
                },
                about={
                    name: describe_member(fitter, fit, self.max_deviations, single_joints.get(name))
                    for name, fit in fits.items()
                },
                alone=joint,
            )
            findings.append(finding)
        return tuple(findings)


def claim_of(search: Search, outcome: Outcome) -> Claim:
    """Return what the outcome of a search would claim."""
    final_fit, last_gate = outcome.final_fit, outcome.last_gate
    if not last_gate.passed or not final_fit.causes:
        return Claim(final_fit, last_gate)
    final_fit, survivors_by_cause = _prefer_best_survivor(search, final_fit)
    classes_by_cause = tuple(classes(search.store, fits) for fits in survivors_by_cause)
    if final_fit.hypothesis.remote and classes_by_cause[0]:
        # A cause of the same class that is not remote and passes the gate names the class.
        fits_not_remote = (
            fit for fit in classes_by_cause[0][0] if not fit.causes[-1].remote and search.gate(fit).passed
        )
        final_fit = next(fits_not_remote, final_fit)
        if not final_fit.causes[-1].remote:  # remote causes that are not nameable are not listed in a class
            nameable_fits = [fit for fit in classes_by_cause[0][0] if fit.causes[-1].nameable]
            classes_by_cause = ([nameable_fits, *classes_by_cause[0][1:]], *classes_by_cause[1:])
    all_classes = classes_by_cause
    members = dict.fromkeys(fit.causes[-1] for groups in classes_by_cause if groups for fit in groups[0])
    max_deviations = max_plausible_deviations(search.store.fitter, outcome.nuisance_fit, list(members))
    final_fit, classes_by_cause, left_out = _without_impossible(
        search, final_fit, classes_by_cause, max_deviations
    )
    final_fit, classes_by_cause = _order_by_plausibility(search, final_fit, classes_by_cause)
    return Claim(
        final_fit,
        search.gate(final_fit),
        classes_by_cause,
        tuple(other_pairs(search, final_fit, all_classes)),
        tuple(_p_value(search, final_fit, place) for place in range(len(final_fit.causes))),
        all(
            any(fit.causes[-1] == cause for fit in fits)
            for cause, fits in zip(final_fit.causes, survivors_by_cause, strict=True)
        ),
        left_out,
        max_deviations,
        frozenset(
            name_of_last_cause(fit)
            for groups in classes_by_cause
            for fits in groups
            for fit in fits
            if violated_usual_range(search.store.fitter, fit)
        ),
    )


def fitted_values(fitter: Fitter, fit: Fit, index: Sequence[int]) -> tuple[Value, ...]:
    """Return fitted parameters with their standard deviations."""
    parameters = [fitter.parameters[i] for i in index]
    return tuple(
        Value(p.name, float(fit.values[i]), fit.sigma_of(i), p.unit)
        for i, p in zip(index, parameters, strict=True)
    )


def name_of_last_cause(fit: Fit) -> str:
    """Return the name of the last cause of a fit, in whose place others were tried."""
    return fit.causes[-1].name


def _names(fit: Fit) -> str:
    return " + ".join(cause.name for cause in fit.causes)


def _without_impossible(
    search: Search, final: Fit, classes_by_cause: ClassesByCause, max_deviations: Mapping[int, float]
) -> tuple[Fit, ClassesByCause, tuple[str, ...]]:
    """Return the claim and its classes without members whose values are impossible, and sentences about these.

    If the cause that names the class of a single cause is one of them, the best of the others names it.
    """
    possible_classes, left_out = [], list[str]()
    for cause, groups in zip(final.causes, classes_by_cause, strict=True):
        possible_fits, removed_sentences = split_possible(
            search.store.fitter, groups[0] if groups else [], max_deviations
        )
        if removed_sentences and all(fit.causes[-1] != cause for fit in possible_fits):
            if len(final.causes) > 1 or not search.gate(possible_fits[0]).passed:
                possible_fits, removed_sentences = groups[0], []
            else:
                final = possible_fits[0]
        possible_classes.append([possible_fits, *groups[1:]] if groups else groups)
        left_out += removed_sentences
    return final, tuple(possible_classes), tuple(left_out)


def _order_by_plausibility(
    search: Search, final: Fit, classes_by_cause: ClassesByCause
) -> tuple[Fit, ClassesByCause]:
    """Return the claim and its classes, the members with plausible values first in each.

    A single cause with an implausible value is replaced by the best member with a plausible one, if that leaves
    nothing but noise.
    """
    fitter = search.store.fitter
    ordered = tuple(
        [sorted(fits, key=lambda fit: bool(violated_usual_range(fitter, fit))) for fits in groups]
        for groups in classes_by_cause
    )
    if len(final.causes) == 1 and ordered[0] and violated_usual_range(fitter, final):
        usual_fits = (
            fit for fit in ordered[0][0] if not violated_usual_range(fitter, fit) and search.gate(fit).passed
        )
        final = next(usual_fits, final)
    return final, ordered


def _prefer_best_survivor(search: Search, final: Fit) -> tuple[Fit, list[list[Fit]]]:
    """Return the best survivor, and for each of its causes the survivors with another cause in its place."""
    for _ in range(MAX_REPLACEMENTS):
        rivals = [search.rivals(final, place) for place in range(len(final.causes))]
        survivors_by_cause = [survivors(search, fits) for fits in rivals]
        causes_and_survivors = zip(final.causes, survivors_by_cause, strict=True)
        better_fit = next(
            (fits[0] for cause, fits in causes_and_survivors if fits and fits[0].causes[-1] != cause), None
        )
        if better_fit is None:
            return final, survivors_by_cause
        final = better_fit
    return final, [[] for _ in final.causes]  # the preferences do not converge: nothing is claimed


def _p_value(search: Search, final: Fit, position: int) -> float:
    """Return the p-value of a likelihood-ratio test of one cause, corrected for the number of candidates."""
    cause = final.causes[position]
    without_cause = search.store.fit_without(final, position)
    gain = max(without_cause.deviance - final.deviance, 0.0) if without_cause is not None else 0.0
    p = float(stats.chi2.sf(gain, len(cause.parameters)))
    if allowed_sign(search.store.fitter, cause):
        p *= 0.5
    # The two causes of a pair were chosen together, from all pairs.
    return min(1.0, p * comb(len(search.candidates), len(final.causes)))
