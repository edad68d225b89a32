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
from pkmodes.loop.diagnosis.search.ranges import plausible_sizes
from pkmodes.loop.diagnosis.search.score import one_sided
from pkmodes.loop.diagnosis.search.search import Outcome, Search
from pkmodes.loop.diagnosis.verdict.classes import classes, other_pairs, survivors
from pkmodes.loop.diagnosis.verdict.findings import Finding, Value
from pkmodes.loop.diagnosis.verdict.joints import JointAlone
from pkmodes.loop.diagnosis.verdict.possible import member, possible, unusual

#: Largest number of times that a cause is replaced by a better survivor.
PREFERENCES = 4
#: For each cause, the classes of fits that have another cause in its place.
Grouped = tuple[list[list[Fit]], ...]


@dataclass(frozen=True)
class Claim:
    """The causes that would be claimed; none if the declared model passes the gate, or nothing does.

    - last: gate of the final fit
    - grouped: for each cause, the classes of fits that have another cause in its place; its own class is first
    - rivals: survivors beside a pair of causes
    - p_values: one for each cause
    - kept: whether each cause is among the survivors in its place
    - left_out: sentences about members that left a class because their values are impossible
    - plausible: largest plausible deviations of the values of all members from the declared ones, by parameter
    - implausible: names of the causes, in the place of a claimed one, whose values such a part cannot have
    """

    final: Fit
    last: Gate
    grouped: Grouped = ()
    rivals: tuple[Fit, ...] = ()
    p_values: tuple[float, ...] = ()
    kept: bool = True
    left_out: tuple[str, ...] = ()
    plausible: Mapping[int, float] = field(default_factory=dict)
    implausible: frozenset[str] = frozenset()

    @property
    def own(self) -> list[list[Fit]]:
        """The class of each cause."""
        return [groups[0] for groups in self.grouped if groups]

    def remains(self, instead: Fit | None = None) -> list[list[tuple[str, Fit]]]:
        """Return the remaining explanations with their names: classes of one cause, or else pairs of causes.

        Classes with a plausible member are first.

        - instead: the explanation that is better with other errors or priors
        """
        if instead is not None:
            return [[(_names(fit), fit)] for fit in (self.final, instead)]
        for groups in self.grouped:
            if len(groups) > 1 or len(self.final.causes) == 1:
                named = [[(name_of_last_cause(fit), fit) for fit in fits] for fits in groups]
                return sorted(named, key=lambda group: all(name in self.implausible for name, _ in group))
        return [[(_names(fit), fit)] for fit in (self.final, *self.rivals)]

    def findings(self, fitter: Fitter, single_joints: Mapping[str, JointAlone]) -> tuple[Finding, ...]:
        """Return all causes with their classes, as parts of a result.

        - single_joints: the one joint that explains the data as well, of each candidate that has one
        """
        findings = []
        for cause, p_value, groups in zip(self.final.causes, self.p_values, self.grouped, strict=True):
            fits = {name_of_last_cause(fit): fit for fit in groups[0]}
            index = {name: fitter.indices(fit.causes[-1]) for name, fit in fits.items()}
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
                    name: member(fitter, fit, self.plausible, single_joints.get(name))
                    for name, fit in fits.items()
                },
                alone=joint,
            )
            findings.append(finding)
        return tuple(findings)


def claim_of(search: Search, outcome: Outcome) -> Claim:
    """Return what the outcome of a search would claim."""
    final, last = outcome.final, outcome.last
    if not last.passed or not final.causes:
        return Claim(final, last)
    final, places = _preferred(search, final)
    grouped = tuple(classes(search.store, fits) for fits in places)
    if final.hypothesis.remote and grouped[0]:
        # A cause of the same class that is not remote and passes the gate names the class.
        plain = (fit for fit in grouped[0][0] if not fit.causes[-1].remote and search.gate(fit).passed)
        final = next(plain, final)
        if not final.causes[-1].remote:  # remote causes that are not nameable are not listed in a class
            named = [fit for fit in grouped[0][0] if fit.causes[-1].nameable]
            grouped = ([named, *grouped[0][1:]], *grouped[1:])
    alike = grouped
    members = dict.fromkeys(fit.causes[-1] for groups in grouped if groups for fit in groups[0])
    plausible = plausible_sizes(search.store.fitter, outcome.nuisances, list(members))
    final, grouped, left_out = _possible(search, final, grouped, plausible)
    final, grouped = _plausible_first(search, final, grouped)
    return Claim(
        final,
        search.gate(final),
        grouped,
        tuple(other_pairs(search, final, alike)),
        tuple(_p_value(search, final, place) for place in range(len(final.causes))),
        all(
            any(fit.causes[-1] == cause for fit in fits)
            for cause, fits in zip(final.causes, places, strict=True)
        ),
        left_out,
        plausible,
        frozenset(
            name_of_last_cause(fit)
            for groups in grouped
            for fits in groups
            for fit in fits
            if unusual(search.store.fitter, fit)
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


def _possible(
    search: Search, final: Fit, grouped: Grouped, plausible: Mapping[int, float]
) -> tuple[Fit, Grouped, tuple[str, ...]]:
    """Return the claim and its classes without members whose values are impossible, and sentences about these.

    If the cause that names the class of a single cause is one of them, the best of the others names it.
    """
    classes, left_out = [], list[str]()
    for cause, groups in zip(final.causes, grouped, strict=True):
        kept, removed = possible(search.store.fitter, groups[0] if groups else [], plausible)
        if removed and all(fit.causes[-1] != cause for fit in kept):
            if len(final.causes) > 1 or not search.gate(kept[0]).passed:
                kept, removed = groups[0], []
            else:
                final = kept[0]
        classes.append([kept, *groups[1:]] if groups else groups)
        left_out += removed
    return final, tuple(classes), tuple(left_out)


def _plausible_first(search: Search, final: Fit, grouped: Grouped) -> tuple[Fit, Grouped]:
    """Return the claim and its classes, the members with plausible values first in each.

    A single cause with an implausible value is replaced by the best member with a plausible one, if that leaves
    nothing but noise.
    """
    fitter = search.store.fitter
    ordered = tuple(
        [sorted(fits, key=lambda fit: bool(unusual(fitter, fit))) for fits in groups] for groups in grouped
    )
    if len(final.causes) == 1 and ordered[0] and unusual(fitter, final):
        usual = (fit for fit in ordered[0][0] if not unusual(fitter, fit) and search.gate(fit).passed)
        final = next(usual, final)
    return final, ordered


def _preferred(search: Search, final: Fit) -> tuple[Fit, list[list[Fit]]]:
    """Return the best survivor, and for each of its causes the survivors with another cause in its place."""
    for _ in range(PREFERENCES):
        rivals = [search.rivals(final, place) for place in range(len(final.causes))]
        places = [survivors(search, fits) for fits in rivals]
        pairs = zip(final.causes, places, strict=True)
        better = next((fits[0] for cause, fits in pairs if fits and fits[0].causes[-1] != cause), None)
        if better is None:
            return final, places
        final = better
    return final, [[] for _ in final.causes]  # the preferences do not converge: nothing is claimed


def _p_value(search: Search, final: Fit, place: int) -> float:
    """Return the p-value of a likelihood-ratio test of one cause, corrected for the number of candidates."""
    cause = final.causes[place]
    less = search.store.fit_without(final, place)
    gain = max(less.deviance - final.deviance, 0.0) if less is not None else 0.0
    p = float(stats.chi2.sf(gain, len(cause.parameters)))
    if one_sided(search.store.fitter, cause):
        p *= 0.5
    # The two causes of a pair were chosen together, from all pairs.
    return min(1.0, p * comb(len(search.candidates), len(final.causes)))
