"""The JSON of a diagnosis: its keys, their types and their meaning."""

from __future__ import annotations

from typing import Annotated

from msgspec import Meta, field

from pkmodes.core.support.documents import Count, Document, Probability, Size
from pkmodes.loop.diagnosis.posterior.document import Probabilities
from pkmodes.loop.diagnosis.verdict.findings import NextMeasurement, Stability
from pkmodes.loop.diagnosis.verdict.rows import Error, Place, Row
from pkmodes.loop.diagnosis.verdict.verdicts import DampingWord, StatusWord, Word


class SizeDocument(Document, frozen=True):
    """A deviation of a parameter from its declared value: the smallest detectable one, or a limit."""

    value: Annotated[float, Meta(description="In SI units.")]
    unit: str


class ValueDocument(Document, frozen=True):
    """A fitted parameter."""

    value: float
    sigma: Annotated[float, Meta(description="Standard deviation.")]
    unit: str


class FoundDocument(ValueDocument, frozen=True):
    """A parameter of a claimed cause."""

    saved_sigma: Annotated[
        float,
        Meta(
            description="Standard deviation in the corrected robot file: it allows for candidates that these "
            "data do not show."
        ),
    ]


#: Parameters by their names.
Values = dict[str, ValueDocument]


class CauseDocument(Document, frozen=True):
    """A cause that was found."""

    name: Annotated[str, Meta(description="The best of its class.")]
    members: Annotated[
        list[str],
        Meta(
            description="All candidates that these data cannot separate from it, including itself.",
            min_length=1,
        ),
    ] = field(name="class")
    parameters: Annotated[
        dict[str, FoundDocument],
        Meta(
            description="Its parameters: of an effect by the last part of their name, others by their path."
        ),
    ]
    p_value: Annotated[
        Probability,
        Meta(description="p-value of the improvement, corrected for the number of candidates."),
    ]
    covariance: Annotated[
        list[list[float]], Meta(description="Covariance of these parameters, in their order.")
    ]
    relative: Annotated[
        Values,
        Meta(
            description="The parameters relative to their mean, where the data determine these far better than each "
            "by itself; else empty."
        ),
    ]
    plausible: Annotated[
        dict[str, bool],
        Meta(description="For each member of the class, whether its value is one that such a part can have."),
    ]
    term: Annotated[
        str | None,
        Meta(
            description="Of a cause with a value for each of several equal parts: the declared value of the one part "
            "that explains the data as well alone, such as parameter:axis.3.leg.stiffness; else null."
        ),
    ]
    term_change: Annotated[
        ValueDocument | None,
        Meta(description="Relative change of that value, if it alone is the cause; null where none is."),
    ]
    alternatives: Annotated[
        dict[str, Annotated[Values, Meta(description="Parameters of one member.")]],
        Meta(description="For each member of the class, its parameters if it were the cause."),
    ]


class RefittedDocument(Document, frozen=True):
    """An uncertain value."""

    before: Annotated[float, Meta(description="As declared, SI units.")]
    after: Annotated[float, Meta(description="Refitted value.")]
    sigma: Annotated[float, Meta(description="Standard deviation after the refit.")]
    saved_sigma: Annotated[
        float,
        Meta(
            description="Standard deviation in a corrected robot file: it allows for candidates that these "
            "data do not show."
        ),
    ]
    unit: str


class StagesDocument(Document, frozen=True):
    """The errors of all stages."""

    before: Annotated[Error, Meta(description="For the robot as declared.")]
    refit: Annotated[
        Error | None,
        Meta(description="With the uncertain values refitted; null where there are too few data."),
    ]
    after: Annotated[Error | None, Meta(description="With the causes; null unless something was added.")]


class CandidateDocument(Document, frozen=True):
    """The test of a candidate."""

    name: str
    p_value: Annotated[
        Probability,
        Meta(
            description="p-value of its score at the refit of the uncertain values, for this candidate alone: of "
            "its best plausible change."
        ),
    ]
    detectable: Annotated[
        bool,
        Meta(
            description="Whether these data show it or bound it: it is part of an explanation, its score is "
            "significant, or one of its parameters has a limit."
        ),
    ]
    visible_from: Annotated[
        dict[str, SizeDocument],
        Meta(
            description="Smallest detectable change of each parameter, beside what is claimed; empty if no plausible "
            "one is detectable."
        ),
    ]


class FactorsDocument(Document, frozen=True):
    """Root mean square factors between measured damping ratios and those of the model."""

    before: Annotated[
        float | None,
        Meta(
            description="Over the fitted ratios, with the losses as declared; null where there are none, or nothing "
            "dissipates."
        ),
    ]
    after: Annotated[float | None, Meta(description="Over the fitted ratios, with the losses as diagnosed.")]
    held_out: Annotated[
        float | None, Meta(description="Over the held-out ratios, with the losses as diagnosed.")
    ]


class DampingDocument(Document, frozen=True):
    """What the damping ratios say of losses, beside the verdict on frequencies and shapes."""

    verdict: Annotated[
        DampingWord,
        Meta(
            description="The verdict on the damping, with the same meaning of words; not_measured without damping."
        ),
    ]
    reason: Annotated[str, Meta(description="One sentence for a person.")]
    effects: Annotated[
        list[CauseDocument], Meta(description="The losses found; empty unless this verdict is effect_found.")
    ]
    survivors: Annotated[
        list[Annotated[list[str], Meta(min_length=1)]],
        Meta(description="Classes of losses that remain; empty unless this verdict is ambiguous."),
    ]
    limits: Annotated[
        dict[str, SizeDocument | None],
        Meta(
            description="How far each loss that is not claimed may still be from its declared value, at 95 %; null "
            "where nothing bounds it."
        ),
    ]
    refitted: Annotated[
        dict[str, RefittedDocument],
        Meta(description="The uncertain losses, by path, each fitted within its prior."),
    ]
    undetectable: Annotated[list[str], Meta(description="Losses that are not detectable with these data.")]
    candidates: Annotated[list[CandidateDocument], Meta(description="Result for each loss.")]
    notes: Annotated[
        list[str], Meta(description="Remarks about the damping that a person should read; may be empty.")
    ]
    stability: Annotated[
        list[Stability],
        Meta(description="Results for the damping with other errors and priors."),
    ]
    fitted: Annotated[Count, Meta(description="Number of ratios that took part.")]
    scatter: Annotated[
        Size,
        Meta(
            description="Scatter of the ratios about the model beyond their stated errors that the verdict allows "
            "for: the standard deviation of their logarithm, 0 where none is needed."
        ),
    ]
    factor: FactorsDocument


class TermDocument(Document, frozen=True):
    """A member of a class beyond the catalogue: a term, or a cause of the catalogue that does as well."""

    term: Annotated[
        str, Meta(description="The term, as form:place, or the name of a cause of the catalogue.")
    ]
    sentence: Annotated[str, Meta(description="What it is, a phrase for a person.")]
    parameters: Annotated[
        Values,
        Meta(
            description="Its parameters, those of a term by their last name, declared values by their path."
        ),
    ]
    plausible: Annotated[bool, Meta(description="Whether its values are ones that such a part can have.")]
    error: Annotated[Error, Meta(description="With it, and the uncertain values refitted.")]


class TermClassDocument(Document, frozen=True):
    """Explanations beyond the catalogue that these data cannot tell apart."""

    probability: Annotated[
        Probability,
        Meta(
            description="Beside the other explanations that leave noise, by the criterion of the search; a second "
            "opinion."
        ),
    ]
    p_value: Annotated[
        Probability,
        Meta(description="p-value of the improvement by its best member, corrected for all that was tried."),
    ]
    members: Annotated[
        list[TermDocument],
        Meta(description="The best first, those with plausible values before others.", min_length=1),
    ]


class BeyondDocument(Document, frozen=True):
    """What one thing at one place would explain that the catalogue does not."""

    status: Annotated[
        StatusWord,
        Meta(
            description="found: one class of at most five explains the measurements, and nothing refuses it; "
            "several: different explanations remain; none: nothing is claimed."
        ),
    ]
    reason: Annotated[str, Meta(description="One sentence for a person.")]
    tried: Annotated[Count, Meta(description="Number of terms that were tried.")]
    classes: Annotated[
        list[TermClassDocument],
        Meta(description="The explanations that remain, the best first; empty if the status is none."),
    ]


class DiagnoseDocument(Document, frozen=True):
    """The result of a diagnosis."""

    verdict: Annotated[Word, Meta(description="The verdict, as defined in docs/reference/verdicts.md.")]
    reason: Annotated[str, Meta(description="One sentence for a person.")]
    effects: Annotated[
        list[CauseDocument], Meta(description="The causes; empty unless the verdict is effect_found.")
    ]
    survivors: Annotated[
        list[Annotated[list[str], Meta(min_length=1)]],
        Meta(description="Classes that remain; empty unless the verdict is ambiguous."),
    ]
    refitted: Annotated[
        dict[str, RefittedDocument],
        Meta(description="The uncertain values, by path, each fitted within its prior."),
    ]
    error: StagesDocument
    held_out_poses: Annotated[
        list[str], Meta(description="Labels of the poses that took no part in any choice or fit.")
    ]
    undetectable: Annotated[
        list[str],
        Meta(
            description="Candidates that are not detectable with these data: none of them has a limit or is part of "
            "an explanation."
        ),
    ]
    limits: Annotated[
        dict[str, SizeDocument | None],
        Meta(
            description="How far each parameter of each candidate that is not claimed may still deviate from its "
            "declared value, at 95 %; of an absent effect, its largest size.  By effect.parameter, or by path; null "
            "where nothing bounds it within its plausible range."
        ),
    ]
    next_measurement: Annotated[
        NextMeasurement | None,
        Meta(
            description="The pose that is expected to tell most about which explanation is true; null where none is "
            "proposed."
        ),
    ]
    next_measurement_reason: Annotated[
        str | None, Meta(description="Why no next measurement is proposed; null where one is.")
    ]
    candidates: Annotated[list[CandidateDocument], Meta(description="Result for each candidate.")]
    outliers: Annotated[list[Place], Meta(description="Rows that were set aside.")]
    unpaired: Annotated[list[Place], Meta(description="Measured modes that are unmatched in the last stage.")]
    scatter: Annotated[
        Size,
        Meta(description="Relative error common to the modes of a pose, 0 where the data show none."),
    ] = field(name="pose_scatter")
    shape_scatter: Annotated[
        Size | None,
        Meta(
            description="Estimated scatter of the shapes without a stated one, relative to the largest component; "
            "null where there are none."
        ),
    ]
    notes: Annotated[
        list[str],
        Meta(description="Remarks about the data and the result that a person should read; may be empty."),
    ]
    stability: Annotated[list[Stability], Meta(description="Results with other errors and priors.")]
    damping: DampingDocument
    probabilities: Annotated[
        Probabilities | None,
        Meta(
            description="How probable each explanation is, a second opinion on which no verdict depends; null where "
            "nothing was searched for, or another reading of the data fits far better."
        ),
    ]
    beyond: Annotated[
        BeyondDocument | None,
        Meta(
            description="One thing at one place, beyond the catalogue, on which the verdict does not depend; null "
            "where it was not tried."
        ),
    ]
    rows: Annotated[list[Row], Meta(description="One for each measured mode, in the order of the file.")]
