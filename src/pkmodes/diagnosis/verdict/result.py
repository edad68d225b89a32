"""The result of a diagnosis: plain data for tables, JSON and reports."""

from __future__ import annotations

import math
from collections.abc import Mapping
from dataclasses import dataclass, field, replace

from pkmodes.base.documents import Document
from pkmodes.base.numbers import p_in_words, rounded
from pkmodes.diagnosis.damping.outcome import Damping
from pkmodes.diagnosis.match.predicted import Predicted
from pkmodes.diagnosis.verdict.document import (
    CandidateDocument,
    CauseDocument,
    DiagnoseDocument,
    ErrorDocument,
    FoundDocument,
    NextMeasurementDocument,
    PlaceDocument,
    RefittedDocument,
    RowDocument,
    SizeDocument,
    StabilityDocument,
    StagesDocument,
    ValueDocument,
)
from pkmodes.diagnosis.verdict.members import Member
from pkmodes.diagnosis.verdict.relative import relative_to_mean
from pkmodes.diagnosis.verdict.rows import Error, Row
from pkmodes.diagnosis.verdict.unseen import Limit, Unseen
from pkmodes.diagnosis.verdict.verdicts import VERDICTS, Word


@dataclass(frozen=True)
class Value:
    """A fitted parameter."""

    name: str
    value: float
    sigma: float
    unit: str


#: A saved standard deviation that is larger than that of the fit by this factor is explained.
NOTICEABLE = 1.05


@dataclass(frozen=True)
class Corrected(Value):
    """A parameter that the last stage of the model changed.

    Attributes
    ----------
    prior_sigma : float or None
        Standard deviation of its declared value; None if it has none.
    at_bound : bool
        Whether the value is at a physical bound other than the declared value.
    unseen : Unseen or None
        What a candidate that these data do not show could have done to the value; None where none could.
    """

    declared: float
    prior_sigma: float | None
    at_bound: bool
    unseen: Unseen | None = None

    @property
    def saved_sigma(self) -> float:
        """Standard deviation including what an unseen candidate could have done.

        What was declared still holds: it is at most the root mean square distance from the value under its prior.
        """
        if self.unseen is None:
            return self.sigma
        sigma = math.hypot(self.sigma, self.unseen.sigma)
        if self.prior_sigma is None:
            return sigma
        return max(self.sigma, min(sigma, math.hypot(self.prior_sigma, self.value - self.declared)))

    @property
    def widened(self) -> bool:
        """Whether the saved standard deviation is noticeably larger than that of the fit."""
        return self.saved_sigma > NOTICEABLE * self.sigma


@dataclass(frozen=True)
class Stages:
    """The model beside all measured modes, at each stage.

    Attributes
    ----------
    before, refit, after : Predicted or None
        As declared, with the nuisances refitted, and with the causes.
    """

    before: Predicted
    refit: Predicted | None
    after: Predicted | None


@dataclass(frozen=True)
class Refitted:
    """A nuisance parameter before and after the fit, with its standard deviation after, fitted and as saved."""

    name: str
    before: float
    after: float
    sigma: float
    saved_sigma: float
    unit: str


@dataclass(frozen=True)
class Finding:
    """One cause that was found.

    Attributes
    ----------
    name : str
        Best candidate of its class.
    members : tuple of str
        The class: all candidates that these data cannot tell apart from it, and itself.
    alternatives : dict
        For each member, its parameters if it were the cause.
    p_value : float
        p-value of the improvement, corrected for the number of candidates.
    sentence : str
        Physical meaning.
    covariances : mapping of str to tuple of tuple of float
        For each member, the covariance of its parameters, in their order.
    about : mapping of str to Member
        How its members are named, and whether their values are plausible.
    """

    name: str
    members: tuple[str, ...]
    parameters: tuple[Value, ...]
    alternatives: dict[str, tuple[Value, ...]]
    p_value: float
    sentence: str
    covariances: Mapping[str, tuple[tuple[float, ...], ...]] = field(default_factory=dict)
    about: Mapping[str, Member] = field(default_factory=dict)

    def member(self, name: str) -> Member:
        """Return how a member of the class is named, and whether its value is plausible."""
        return self.about.get(name, Member(name, self.sentence if name == self.name else ""))

    @property
    def plausible(self) -> dict[str, bool]:
        """Whether the value of each member is one that such a part can have."""
        return {name: not self.member(name).implausible for name in self.members}

    @property
    def covariance(self) -> tuple[tuple[float, ...], ...]:
        """Covariance of the parameters, in their order."""
        return self.covariances.get(self.name, ())

    def relative(self, member: str = "") -> tuple[Value, ...]:
        """Return the parameters relative to their mean, where the data determine these far better than each.

        Parameters
        ----------
        member : str
            Of the class; by default the cause itself.

        Returns
        -------
        tuple of Value
            Their mean is 0; empty where the parameters themselves say as much.
        """
        name = member or self.name
        values = self.alternatives.get(name, ())
        if len({value.unit for value in values}) != 1:
            return ()
        found = relative_to_mean([value.value for value in values], self.covariances.get(name, ()))
        if found is None:
            return ()
        return tuple(
            replace(value, value=float(d), sigma=float(sigma))
            for value, d, sigma in zip(values, *found, strict=True)
        )


@dataclass(frozen=True)
class Examined:
    """The test of one candidate.

    Attributes
    ----------
    p_value : float
        p-value of its score at the refit of the nuisances, for this candidate alone: of its best plausible change.
    visible_from : tuple of Value
        Smallest change of each parameter that these data would probably show, with its standard deviation, beside
        what is claimed; none if it would not be plausible.
    detectable : bool
        Whether these data show it or bound it.
    sentence : str
        Physical meaning.
    """

    name: str
    p_value: float
    visible_from: tuple[Value, ...]
    detectable: bool
    sentence: str = ""


@dataclass(frozen=True)
class NextMeasurement:
    """The pose at which two explanations differ most, and the values to set there, by name."""

    pose: tuple[float, ...]
    separates: tuple[str, str]
    sigmas: float
    load: Mapping[str, float] = field(default_factory=dict)


@dataclass(frozen=True)
class Stability:
    """The verdict with other errors or priors than stated.

    Attributes
    ----------
    change : str
        ``"sigma x 0.5"``, ``"sigma x 2"`` or ``"priors x 2"``.
    effects : tuple of str
        Names of the causes that are best with this change.
    """

    change: str
    verdict: Word
    effects: tuple[str, ...]


@dataclass(frozen=True)
class Diagnosis:
    """The result of a diagnosis.

    Attributes
    ----------
    verdict : str
        See docs/diagnosis.md.
    reason : str
        One sentence.
    effects : tuple of Finding
    survivors : tuple of tuple of str
        Remaining classes if the verdict is ambiguous.
    refitted : tuple of Refitted
    before, refit, after : Error
        Stages.  The refit includes outliers and a shared error if these explain the residual; it is None if there
        are too few data.  after is None unless a cause was found.
    held_out_poses, undetectable : tuple of str
    next_measurement : NextMeasurement or None
    candidates : tuple of Examined
    rows : tuple of Row
    scatter : float
        Relative error that the modes of a pose share; 0 if the data show none.
    corrected : tuple of Corrected
        Values of all parameters that the last stage changed, with their standard deviations.
    notes : tuple of str
        Notes on the data and the fit.
    stability : tuple of Stability
    shape_scatter : float or None
        Estimated scatter of the shapes without a stated error, relative to the largest component.
    limits : mapping of str to Limit
        How large each candidate that is not claimed may still be, by parameter: ``"<effect>.<parameter>"``, or the
        path of a declared value.
    stages : Stages or None
        Partners, differences and MAC of all measured modes, for figures; not part of the JSON.
    damping : Damping or None
        What the damping says, where it was measured and diagnosed; in the JSON, its ratios are among the rows.
    headline : str
        What of the refitted values a headline says beside the verdict; empty for nothing.
    """

    verdict: Word
    reason: str
    effects: tuple[Finding, ...]
    survivors: tuple[tuple[str, ...], ...]
    refitted: tuple[Refitted, ...]
    before: Error | None
    refit: Error | None
    after: Error | None
    held_out_poses: tuple[str, ...]
    undetectable: tuple[str, ...]
    next_measurement: NextMeasurement | None
    candidates: tuple[Examined, ...]
    rows: tuple[Row, ...]
    scatter: float
    corrected: tuple[Corrected, ...]
    notes: tuple[str, ...] = ()
    stability: tuple[Stability, ...] = ()
    shape_scatter: float | None = None
    limits: Mapping[str, Limit] = field(default_factory=dict)
    stages: Stages | None = field(default=None, compare=False, repr=False)
    damping: Damping | None = None
    headline: str = ""

    def __str__(self) -> str:
        lines = [f"{self.verdict}: {self.reason}"]
        for effect in self.effects:
            p = p_in_words(effect.p_value)
            if len(effect.members) == 1:
                lines.append(f"cause: {effect.name} ({p}): {_values(effect, effect.name, self)}")
                continue
            lines.append(f"cause: one of these, which these data cannot tell apart ({p})")
            lines += [f"  {name}: {_values(effect, name, self)}" for name in effect.members]
        lines += [f"remains: {' or '.join(group)}" for group in self.survivors]
        for stage, error in (("before", self.before), ("refit", self.refit), ("after", self.after)):
            if error is not None:
                rms = "" if error.rms_relative is None else f"rms {100 * error.rms_relative:.3f} %, "
                held = error.held_out_rms_relative
                apart = "" if held is None else f"held out {100 * held:.3f} %, "
                lines.append(f"{stage:6} {rms}{apart}chi2 per degree of freedom {error.chi2_per_dof:.3g}")
        lines += [f"note: {text}" for text in self.notes]
        return "\n".join(lines)

    def saved(self, value: Value) -> Corrected | None:
        """Return a value of a cause as the corrected robot file has it; None for another member of a class."""
        return next(
            (one for one in self.corrected if (one.name, one.value) == (value.name, value.value)), None
        )

    def believed(self, value: Value) -> Value:
        """Return a value with the standard deviation that may be relied on: the saved one, where there is one."""
        saved = self.saved(value)
        return value if saved is None else replace(value, sigma=saved.saved_sigma)

    def why_larger(self, value: Value) -> str:
        """Return why the standard deviation of a value is larger than that of the fit; empty if it is not."""
        saved = self.saved(value)
        if saved is None or saved.unseen is None or not saved.widened:
            return ""
        fit = rounded(value.value, value.sigma).columns[1]
        return (
            f"+- {fit} by the fit alone; the rest is what an unseen {saved.unseen.candidate} could have done"
        )

    @property
    def settled(self) -> bool:
        """Whether the last model leaves only noise, so that its values correct the robot file."""
        return VERDICTS[self.verdict].settled

    @property
    def outliers(self) -> tuple[Row, ...]:
        """Rows set aside as outliers."""
        return tuple(row for row in self.rows if row.outlier)

    @property
    def unpaired(self) -> tuple[Row, ...]:
        """Unmatched measured modes at the last stage."""

        def last(row: Row) -> float | None:
            return row.before if self.refit is None else row.refit if self.after is None else row.after

        return tuple(row for row in self.rows if last(row) is None and not row.outlier)

    def as_json(self) -> dict[str, object]:
        """Return the result in the form described in docs/json.md, without NaN.

        Returns
        -------
        dict of str to object
            What ``pkmodes diagnose --json`` writes.
        """
        document = DiagnoseDocument.of(
            self,
            effects=[_cause(cause, self.corrected) for cause in self.effects],
            refitted={value.name: RefittedDocument.of(value) for value in self.refitted},
            error=StagesDocument.of(
                self, before=_error(self.before), refit=_error(self.refit), after=_error(self.after)
            ),
            next_measurement=self.next_measurement and NextMeasurementDocument.of(self.next_measurement),
            candidates=[
                CandidateDocument.of(one, visible_from=_by_key(SizeDocument, one.visible_from))
                for one in self.candidates
            ],
            outliers=list(map(PlaceDocument.of, self.outliers)),
            unpaired=list(map(PlaceDocument.of, self.unpaired)),
            stability=list(map(StabilityDocument.of, self.stability)),
            limits={
                name: None if limit.value is None else SizeDocument.of(limit)
                for name, limit in self.limits.items()
            },
            rows=list(map(RowDocument.of, self.rows)),
        )
        return document.as_json()


def key(v: Value) -> str:
    """Return the last name of an effect's parameter (`compliance`), as in the robot file; else the whole path."""
    return v.name.split(".")[-1] if v.name.startswith("effects.") else v.name


def _values(effect: Finding, member: str, result: Diagnosis) -> str:
    """Return the values of a cause, or of another member of its class, and whether they are implausible."""
    relative = effect.relative(member)
    fitted = relative or effect.alternatives.get(member, ())
    shown = [result.believed(v) for v in fitted] if len(effect.members) == 1 and not relative else fitted
    values = [f"{v.name} = {rounded(v.value, v.sigma)} {v.unit}".removesuffix(" 1") for v in shown]
    also, why = " relative to their mean" if relative else "", effect.member(member).implausible
    return ", ".join(values) + also + (f" (implausible: {why})" if why else "")


def _cause(cause: Finding, corrected: tuple[Corrected, ...]) -> CauseDocument:
    alternatives = {name: _by_key(ValueDocument, values) for name, values in cause.alternatives.items()}
    saved = {value.name: value.saved_sigma for value in corrected}
    parameters = {
        key(value): FoundDocument.of(value, saved_sigma=saved.get(value.name, value.sigma))
        for value in cause.parameters
    }
    return CauseDocument.of(
        cause,
        parameters=parameters,
        covariance=[list(row) for row in cause.covariance],
        relative=_by_key(ValueDocument, cause.relative()),
        alternatives=alternatives,
    )


def _by_key(kind: type[Document], values: tuple[Value, ...]) -> dict[str, Document]:
    return {key(value): kind.of(value) for value in values}


def _error(error: Error | None) -> ErrorDocument | None:
    return None if error is None else ErrorDocument.of(error)
