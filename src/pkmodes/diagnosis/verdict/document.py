"""The JSON of a diagnosis: its keys, their types and their meaning."""

from __future__ import annotations

from typing import Annotated

from msgspec import Meta, field

from pkmodes.core.base.drives import Drives
from pkmodes.diagnosis.verdict.verdicts import DampingWord, Word
from pkmodes.support.documents import Count, Document, Number, Probability, Settings, Size


class SizeDocument(Document):
    """A deviation of a parameter from its declared value: the smallest detectable one, or a limit."""

    value: Annotated[float, Meta(description="In SI units.")]
    unit: str


class ValueDocument(Document):
    """A fitted parameter."""

    value: float
    sigma: Annotated[float, Meta(description="Standard deviation.")]
    unit: str


class FoundDocument(ValueDocument):
    """A parameter of a claimed cause."""

    saved_sigma: Annotated[
        float,
        Meta(
            description="Standard deviation in the corrected robot file: it includes what a candidate that these "
            "data do not show could have done to the value."
        ),
    ]


#: Parameters by their names.
Values = dict[str, ValueDocument]


class CauseDocument(Document):
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
    alternatives: Annotated[
        dict[str, Annotated[Values, Meta(description="Parameters of one member.")]],
        Meta(description="For each member of the class, its parameters if it were the cause."),
    ]


class RefittedDocument(Document):
    """An uncertain value."""

    before: Annotated[float, Meta(description="As declared, SI units.")]
    after: Annotated[float, Meta(description="Refitted value.")]
    sigma: Annotated[float, Meta(description="Standard deviation after the refit.")]
    saved_sigma: Annotated[
        float,
        Meta(
            description="Standard deviation in a corrected robot file: it includes what a candidate that these data "
            "do not show could have done to the value."
        ),
    ]
    unit: str


class ErrorDocument(Document):
    """The errors of one stage."""

    rms_relative: Annotated[
        Size | None,
        Meta(
            description="Root mean square of f_model / f_measured - 1 over the fitted rows; null if there are none."
        ),
    ]
    held_out_rms_relative: Annotated[
        Size | None, Meta(description="The same over the held-out rows; null if there are none.")
    ]
    chi2_per_dof: Annotated[
        Size, Meta(description="Chi-square per degree of freedom of the fitted rows and the priors.")
    ]


class StagesDocument(Document):
    """The errors of all stages."""

    before: Annotated[ErrorDocument, Meta(description="For the robot as declared.")]
    refit: Annotated[
        ErrorDocument | None,
        Meta(description="With the uncertain values refitted; null where there are too few data."),
    ]
    after: Annotated[
        ErrorDocument | None, Meta(description="With the causes; null unless something was added.")
    ]


class NextMeasurementDocument(Document, omit_defaults=True):
    """A pose to be measured."""

    pose: Annotated[list[float], Meta(description="Platform centre [m].")]
    separates: Annotated[list[str], Meta(description="The two explanations.", min_length=2, max_length=2)]
    sigmas: Annotated[float, Meta(description="By how many standard deviations they differ there.")]
    drives: Annotated[
        Drives | None, Meta(description="What the motors are to do; null for a structure without motors.")
    ]
    hidden_by: Annotated[
        str,
        Meta(
            description="The uncertain value that could make up most of that difference within its standard "
            "deviation, so that several such poses, or a more exact value, are needed; present only where one could."
        ),
    ] = ""
    load: Annotated[
        dict[str, float],
        Meta(
            description="Values to be set for it, by path, in SI units; present only where a payload is proposed."
        ),
    ] = field(name="set", default_factory=dict)


class CandidateDocument(Document):
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


class StabilityDocument(Document):
    """The result with other errors or priors."""

    change: Annotated[str, Meta(description="The change, such as sigma x 0.5.")]
    verdict: Annotated[Word, Meta(description="The resulting verdict.")]
    effects: Annotated[list[str], Meta(description="The resulting names of the causes.")]


class PlaceDocument(Document):
    """A measured mode by its place in the file."""

    pose: Annotated[str, Meta(description="Label of the pose.")]
    line: Annotated[Number, Meta(description="Line of the measurement file.")]


class RowDocument(PlaceDocument, omit_defaults=True):
    """A measured mode and its predictions."""

    mode: Annotated[str, Meta(description="The experimenter's mode number; may be empty.")]
    measured: Annotated[float, Meta(description="Measured value.")] = field(name="frequency_hz")
    sigma: Annotated[float, Meta(description="Its standard deviation.")] = field(name="sigma_hz")
    drives: Annotated[
        Drives | None, Meta(description="What the motors did; null for a structure without motors.")
    ]
    before: Annotated[
        float | None, Meta(description="Predicted as declared; null where the row is unmatched.")
    ] = field(name="before_hz")
    refit: Annotated[
        float | None,
        Meta(
            description="With the uncertain values refitted; null where the row is unmatched, or without that "
            "stage."
        ),
    ] = field(name="refit_hz")
    after: Annotated[
        float | None,
        Meta(description="With the causes; null where the row is unmatched, or without that stage."),
    ] = field(name="after_hz")
    mac: Annotated[Size | None, Meta(description="MAC in the last stage; null where no shape was measured.")]
    held_out: Annotated[bool, Meta(description="Whether its pose took no part in any fit.")]
    outlier: Annotated[bool, Meta(description="Whether it was set aside.")]
    load: Settings = field(name="set", default_factory=dict)
    damping: Annotated[
        float | None,
        Meta(
            description="Measured damping ratio; present only where damping was diagnosed, like the next five."
        ),
    ] = None
    sigma_damping: Annotated[float | None, Meta(description="Its standard deviation.")] = None
    damping_before: Annotated[
        float | None, Meta(description="Damping ratio of the paired mode with the losses as declared.")
    ] = None
    damping_after: Annotated[
        float | None, Meta(description="Damping ratio of the paired mode with the losses as diagnosed.")
    ] = None
    damping_used: Annotated[
        bool | None,
        Meta(
            description="Whether the ratio took part in the fit: not held out, of a shape like that of its mode, "
            "not set aside."
        ),
    ] = None
    sigma_damping_used: Annotated[
        float | None,
        Meta(
            description="Standard deviation of the ratio with which it is compared: with the errors that no file "
            "states."
        ),
    ] = None
    damping_remark: Annotated[
        str | None, Meta(description="Why the ratio took no part; present only where it did not.")
    ] = None


class FactorsDocument(Document):
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


class DampingDocument(Document):
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
        list[StabilityDocument],
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


class DiagnoseDocument(Document):
    """The result of a diagnosis."""

    verdict: Annotated[Word, Meta(description="The verdict, as defined in docs/diagnosis.md.")]
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
        NextMeasurementDocument | None,
        Meta(
            description="The pose that best separates the remaining explanations; null where none is proposed."
        ),
    ]
    next_measurement_reason: Annotated[
        str | None, Meta(description="Why no next measurement is proposed; null where one is.")
    ]
    candidates: Annotated[list[CandidateDocument], Meta(description="Result for each candidate.")]
    outliers: Annotated[list[PlaceDocument], Meta(description="Rows that were set aside.")]
    unpaired: Annotated[
        list[PlaceDocument], Meta(description="Measured modes that are unmatched in the last stage.")
    ]
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
    stability: Annotated[list[StabilityDocument], Meta(description="Results with other errors and priors.")]
    damping: DampingDocument
    rows: Annotated[
        list[RowDocument], Meta(description="One for each measured mode, in the order of the file.")
    ]
