"""The result of a diagnosis: plain data for tables, JSON and reports."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field

from pkmodes.core.base.attached import Attached
from pkmodes.core.base.numbers import p_in_words, plain
from pkmodes.core.support.documents import Document
from pkmodes.loop.diagnosis.match.predicted import PartnerPredictions
from pkmodes.loop.diagnosis.posterior.document import Probabilities
from pkmodes.loop.diagnosis.problem import Array
from pkmodes.loop.diagnosis.verdict.document import (
    CandidateDocument,
    CauseDocument,
    DampingDocument,
    DiagnoseDocument,
    FactorsDocument,
    FoundDocument,
    RefittedDocument,
    SizeDocument,
    StagesDocument,
    ValueDocument,
)
from pkmodes.loop.diagnosis.verdict.findings import (
    Corrected,
    Examined,
    Finding,
    Limit,
    NextMeasurement,
    Refitted,
    Stability,
    Value,
    with_saved_sigma,
)
from pkmodes.loop.diagnosis.verdict.joints import JointAlone
from pkmodes.loop.diagnosis.verdict.rows import Error, Place, Row
from pkmodes.loop.diagnosis.verdict.terms import Beyond
from pkmodes.loop.diagnosis.verdict.verdicts import NOT_MEASURED, VERDICTS, DampingWord, Word


@dataclass(frozen=True)
class Stages:
    """The model compared with all measured modes, at each stage.

    - before, refit, after: as declared, with the nuisances refitted, and with the causes
    - without: spectrum of the last model without its causes, at its values, (S, m); None where it has none
    - beyond: with what was found beyond the catalogue, where the catalogue claims no cause
    """

    before: PartnerPredictions
    refit: PartnerPredictions | None
    after: PartnerPredictions | None
    without: Array | None = None
    beyond: PartnerPredictions | None = None

    @property
    def with_causes(self) -> PartnerPredictions | None:
        """The model with its causes, of the catalogue or beyond it; None where none is claimed."""
        return self.after or self.beyond


@dataclass(frozen=True)
class Damping:
    """The diagnosis of losses from damping ratios, beside the verdict on frequencies and shapes.

    - verdict: ``not_measured`` without damping
    - reason: one sentence
    - effects: the losses found
    - survivors, limits, refitted, undetectable, candidates, notes, stability, corrected, correlation: as for a
      diagnosis, of losses and ratios
    - fitted: number of ratios that took part
    - scatter: how far they scatter about the model beyond their stated errors, where the verdict allows for that: the
      standard deviation of their logarithm
    - before, after, held_out: root mean square factor between measured ratios and those of the model, over the fitted
      rows as declared and as diagnosed, and over the held-out ones as diagnosed; None where there are none, or
      nothing dissipates
    """

    verdict: DampingWord = NOT_MEASURED
    reason: str = "no damping was measured"
    effects: tuple[Finding, ...] = ()
    survivors: tuple[tuple[str, ...], ...] = ()
    limits: Mapping[str, Limit] = field(default_factory=dict)
    refitted: tuple[Refitted, ...] = ()
    undetectable: tuple[str, ...] = ()
    candidates: tuple[Examined, ...] = ()
    notes: tuple[str, ...] = ()
    stability: tuple[Stability, ...] = ()
    fitted: int = 0
    scatter: float = 0.0
    before: float | None = None
    after: float | None = None
    held_out: float | None = None
    corrected: tuple[Corrected, ...] = ()
    correlation: tuple[tuple[float, ...], ...] = field(default=(), repr=False)

    @property
    def measured(self) -> bool:
        """Whether damping was measured."""
        return self.verdict != NOT_MEASURED

    @property
    def sentences(self) -> dict[str, str]:
        """Meaning of each candidate."""
        return {candidate.name: candidate.sentence for candidate in self.candidates}

    def document(self) -> DampingDocument:
        """Return it in the form described in docs/reference/json.md."""
        return DampingDocument.of(
            self,
            effects=[_cause(cause, self.corrected) for cause in self.effects],
            limits=_limits(self.limits),
            refitted={value.name: RefittedDocument.of(value) for value in self.refitted},
            candidates=_candidates(self.candidates),
            factor=FactorsDocument.of(self),
        )


@dataclass(frozen=True)
class Diagnosis:
    """The result of a diagnosis.

    All of it is about frequencies and shapes, except `damping`.

    Attributes
    ----------
    verdict : str
        See docs/reference/verdicts.md.
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
    not_separated : str
        Why none is proposed although several explanations remain; empty otherwise.
    candidates : tuple of Examined
    rows : tuple of Row
    scatter : float
        Relative error that the modes of a pose share; 0 if the data show none.
    corrected : tuple of Corrected
        Values of all parameters that the last stage changed, with their standard deviations.
    correlation : tuple of tuple of float
        Correlation of these values in the fit, in their order.
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
    damping : Damping
        The diagnosis of losses; the damping ratios are among the rows.
    headline : str
        Part of a headline about refitted values, beside the verdict; empty if there is none.
    rule : str
        The rule that decided, with its table (`rules`): "claims.found".  For tests and studies; not part of the JSON.
    alone : mapping of str to JointAlone
        The single joint that explains the data as well, for each claimed or remaining cause that has one; it is
        among the sentences.
    probabilities : Probabilities or None
        Of all explanations: a second opinion, on which no verdict depends.  None without a search, and where the data
        themselves are mistaken.
    beyond : Beyond or None
        What a single form at one place would explain that the catalogue does not; None where it was not tried.
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
    damping: Damping = field(default_factory=Damping)
    correlation: tuple[tuple[float, ...], ...] = field(default=(), repr=False)
    not_separated: str = ""
    headline: str = ""
    rule: str = field(default="", compare=False)
    probabilities: Probabilities | None = None
    beyond: Beyond | None = None
    alone: Mapping[str, JointAlone] = field(default_factory=dict)

    _repr_html_ = Attached("pkmodes.pages.report.notebook:diagnosis_html")

    def __str__(self) -> str:
        lines = [f"{self.verdict}: {self.reason}"]
        for effect in self.effects:
            p = p_in_words(effect.p_value)
            if len(effect.members) == 1:
                lines.append(f"cause: {effect.name} ({p}): {_values_in_words(effect, effect.name, self)}")
                continue
            lines.append(f"cause: one of these, which these data cannot tell apart ({p})")
            lines += [f"  {name}: {_values_in_words(effect, name, self)}" for name in effect.members]
        lines += [f"remains: {' or '.join(group)}" for group in self.survivors]
        if self.beyond is not None:
            lines.append(f"beyond the catalogue: {self.beyond.status}: {self.beyond.reason}")
        for stage, (_, error) in self.errors.items():
            rms = "" if error.rms_relative is None else f"rms {100 * error.rms_relative:.3f} %, "
            held_out_error = error.held_out_rms_relative
            held_out_text = "" if held_out_error is None else f"held out {100 * held_out_error:.3f} %, "
            lines.append(
                f"{stage:6} {rms}{held_out_text}chi2 per degree of freedom {plain(error.chi2_per_dof, 3)}"
            )
        lines += [f"note: {text}" for text in self.notes]
        if self.damping.measured:
            lines.append(f"damping: {self.damping.verdict}: {self.damping.reason}")
            lines += [f"note on the damping: {text}" for text in self.damping.notes]
        return "\n".join(lines)

    @property
    def settled(self) -> bool:
        """Whether the last model leaves only noise, so that its values correct the robot file."""
        return VERDICTS[self.verdict].settled

    @property
    def sentences(self) -> dict[str, str]:
        """Meaning of each candidate; that of a single joint where one explains as much."""
        sentences = {candidate.name: candidate.sentence for candidate in self.candidates}
        return sentences | {name: joint.sentence for name, joint in self.alone.items()}

    @property
    def every_cause(self) -> tuple[Finding, ...]:
        """The causes that a corrected robot has: those of frequencies and shapes, and the losses found."""
        return self.effects + self.damping.effects

    @property
    def errors(self) -> dict[str, tuple[str, Error]]:
        """For each stage that was reached, by its key in the JSON: its title and its errors."""
        after = f"after: with the cause{'s' if len(self.effects) > 1 else ''}"
        stages = {
            "before": ("before: as declared", self.before),
            "refit": ("refit of the uncertain values only", self.refit),
            "after": (after, self.after),
        }
        return {
            parameter_key: (title, error)
            for parameter_key, (title, error) in stages.items()
            if error is not None
        }

    @property
    def next_measurement_reason(self) -> str:
        """Why no next measurement is proposed; empty where one is."""
        if self.next_measurement is not None:
            return ""
        return self.not_separated or VERDICTS[self.verdict].nothing_next

    @property
    def outliers(self) -> tuple[Row, ...]:
        """Rows set aside as outliers."""
        return tuple(row for row in self.rows if row.outlier)

    @property
    def unpaired(self) -> tuple[Row, ...]:
        """Unmatched measured modes at the last stage."""

        def last_prediction(row: Row) -> float | None:
            return row.before if self.refit is None else row.refit if self.after is None else row.after

        return tuple(row for row in self.rows if last_prediction(row) is None and not row.outlier)

    def as_json(self) -> dict[str, object]:
        """Return the result in the form described in docs/reference/json.md, without NaN.

        Returns
        -------
        dict of str to object
            What ``pkmodes diagnose --json`` writes.
        """
        document = DiagnoseDocument.of(
            self,
            effects=[_cause(cause, self.corrected) for cause in self.effects],
            refitted={value.name: RefittedDocument.of(value) for value in self.refitted},
            error=StagesDocument.of(self),
            next_measurement_reason=self.next_measurement_reason or None,
            candidates=_candidates(self.candidates),
            outliers=list(map(Place.of, self.outliers)),
            unpaired=list(map(Place.of, self.unpaired)),
            limits=_limits(self.limits),
            damping=self.damping.document(),
            beyond=None if self.beyond is None else self.beyond.document(),
        )
        return document.as_json()


def parameter_key(v: Value) -> str:
    """Return the last name of an effect's parameter (`compliance`), as in the robot file; else the whole path."""
    return v.name.split(".")[-1] if v.name.startswith("effects.") else v.name


def _values_in_words(effect: Finding, member: str, result: Diagnosis) -> str:
    """Return the values of a cause, or of another member of its class, and whether they are implausible."""
    relative = effect.relative(member)
    fitted = relative or effect.alternatives.get(member, ())
    reported = (
        [with_saved_sigma(v, result.corrected) for v in fitted]
        if len(effect.members) == 1 and not relative
        else fitted
    )
    values = [f"{v.name} = {v.rounded} {v.unit}".removesuffix(" 1") for v in reported]
    relative_clause = " relative to their mean" if relative else ""
    implausible_reason = effect.member(member).implausible
    assumption_clause = f", for {text}" if (text := effect.member(member).assumed) else ""
    return (
        ", ".join(values)
        + relative_clause
        + assumption_clause
        + (f" (implausible: {implausible_reason})" if implausible_reason else "")
    )


def _cause(cause: Finding, corrected: tuple[Corrected, ...]) -> CauseDocument:
    alternatives = {name: _by_key(ValueDocument, values) for name, values in cause.alternatives.items()}
    saved = {value.name: value.saved_sigma for value in corrected}
    parameters = {
        parameter_key(value): FoundDocument.of(value, saved_sigma=saved.get(value.name, value.sigma))
        for value in cause.parameters
    }
    single_joint = cause.alone
    return CauseDocument.of(
        cause,
        term=(single_joint.joint.term or None) if single_joint else None,
        term_change=ValueDocument(single_joint.change, single_joint.sigma, "1") if single_joint else None,
        parameters=parameters,
        covariance=[list(row) for row in cause.covariance],
        relative=_by_key(ValueDocument, cause.relative()),
        alternatives=alternatives,
    )


def _candidates(examined: tuple[Examined, ...]) -> list[CandidateDocument]:
    return [
        CandidateDocument.of(candidate, visible_from=_by_key(SizeDocument, candidate.visible_from))
        for candidate in examined
    ]


def _limits(limits: Mapping[str, Limit]) -> dict[str, SizeDocument | None]:
    return {name: None if limit.value is None else SizeDocument.of(limit) for name, limit in limits.items()}


def _by_key(kind: type[Document], values: tuple[Value, ...]) -> dict[str, Document]:
    return {parameter_key(value): kind.of(value) for value in values}
