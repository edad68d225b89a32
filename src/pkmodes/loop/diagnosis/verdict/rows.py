"""Measured modes with their predictions, and the errors of one stage over all of them."""

from __future__ import annotations

from typing import Annotated, cast

from msgspec import Meta, field

from pkmodes.core.base.drives import Drives
from pkmodes.core.support.documents import Document, Number, Settings, Size
from pkmodes.loop.diagnosis.problem import Driven, Structure
from pkmodes.loop.measured.measurements import Measurements

#: Of a measured mode, in a comparison and in a diagnosis.
ModeName = Annotated[str, Meta(description="The experimenter's mode number; may be empty.")]
MotorsDid = Annotated[
    Drives | None, Meta(description="What the motors did; null for a structure without motors.")
]
Level = Annotated[
    float | None,
    Meta(description="Level of excitation in the unit of the file; present only where it gives one."),
]
Nearest = Annotated[
    float | None,
    Meta(
        description="Frequency of the nearest mode of the model [Hz], in the last stage; present only where that "
        "mode has another shape (a MAC below 0.5 that the errors of the shape do not explain), so that the row is "
        "unmatched."
    ),
]
NearestMac = Annotated[
    Size | None, Meta(description="MAC with the nearest mode; present like its frequency.")
]


class Error(Document, frozen=True):
    """The errors of one stage."""

    rms_relative: Annotated[
        Size | None,
        Meta(
            description="Root mean square of f_model / f_measured - 1 over the fitted rows that have a partner; null "
            "if there are none."
        ),
    ]
    held_out_rms_relative: Annotated[
        Size | None, Meta(description="The same over the held-out rows; null if there are none.")
    ]
    chi2_per_dof: Annotated[
        Size,
        Meta(
            description="Chi-square per degree of freedom of all fitted rows and the priors.  An unmatched row "
            "counts with its difference from the nearest mode, or with a factor of 1.8 where no mode is left."
        ),
    ]


class Place(Document, frozen=True):
    """A measured mode by its place in the file."""

    pose: Annotated[str, Meta(description="Label of the pose.")]
    line: Annotated[Number, Meta(description="Line of the measurement file.")]


class Row(Place, frozen=True, omit_defaults=True):
    """A measured mode and its predictions."""

    mode: ModeName
    measured: Annotated[float, Meta(description="Measured value.")] = field(name="frequency_hz")
    sigma: Annotated[float, Meta(description="Its standard deviation.")] = field(name="sigma_hz")
    drives: MotorsDid
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
    mac: Annotated[
        Size | None,
        Meta(
            description="MAC in the last stage; null where no shape was measured, or the row is unmatched there."
        ),
    ]
    held_out: Annotated[bool, Meta(description="Whether its pose took no part in any fit.")]
    outlier: Annotated[bool, Meta(description="Whether it was set aside.")]
    load: Settings = field(name="set", default_factory=dict)
    level: Level = None
    beyond: Annotated[
        float | None,
        Meta(
            description="With what was found beyond the catalogue; present only where it was, and the row has a "
            "partner there."
        ),
    ] = field(name="beyond_hz", default=None)
    nearest: Nearest = field(name="nearest_hz", default=None)
    nearest_mac: NearestMac = None
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


def drives_of(structure: Structure, data: Measurements) -> list[Drives | None]:
    """Return what the motors did in each row; None for a structure without motors."""
    driven = isinstance(structure, Driven)
    return [cast("Drives", data.drives[setup]) if driven else None for setup in data.pose.tolist()]
