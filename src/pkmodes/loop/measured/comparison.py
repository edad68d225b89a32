"""The result of a comparison of two measurement files, as `compare` writes it."""

from __future__ import annotations

from typing import Annotated, Literal

from msgspec import Meta

from pkmodes.core.support.documents import Count, Document, Number, Probability, Size
from pkmodes.loop.measured.shape_changes import ShapeChange
from pkmodes.loop.measured.significance import CommonChange
from pkmodes.loop.measured.strain_energy import StrainEnergyChange

#: Why the shapes of a pair do not show where something changed, or may show it wrongly.
Caution = Literal["few_channels", "no_sigma_shape", "close_modes", "low_mac", "same_shape"]
#: What the frequencies show: `ModePair.own_change` of single modes, `CommonChange.differs`, both, only all changes
#: taken together, nothing, or that no mode has a partner.
Changed = Literal["single", "common", "common_and_single", "together", "nothing", "no_pairs"]


class ModePair(Document, frozen=True):
    """A mode in both measurements."""

    pose: Annotated[str, Meta(description="Label of its pose in the first file.")]
    second_pose: Annotated[str, Meta(description="Label in the second file.")]
    first_line: Annotated[Number, Meta(description="Its line in the first file.")]
    second_line: Annotated[Number, Meta(description="Its line in the second file.")]
    first: Annotated[Size, Meta(description="Frequency [Hz].")]
    second: Annotated[Size, Meta(description="Frequency [Hz].")]
    first_sigma: Annotated[Size, Meta(description="Its standard deviation [Hz].")]
    second_sigma: Annotated[Size, Meta(description="Its standard deviation [Hz].")]
    relative: Annotated[float, Meta(description="second / first - 1.")]
    sigmas: Annotated[float, Meta(description="second - first, in standard deviations of the difference.")]
    mac: Annotated[float | None, Meta(description="Modal assurance criterion; null without shapes in both.")]
    differs: Annotated[
        bool,
        Meta(description="Whether it differs at the level of 1 % of all pairs together (Holm's procedure)."),
    ]
    mode: Annotated[str, Meta(description="Its number in the first file; empty if that gives none.")]
    noticeable: Annotated[
        Size,
        Meta(
            description="Smallest measured relative change that would have counted, if no other mode changed: 2.6 "
            "standard deviations of the difference for one pair, 3.3 for ten."
        ),
    ]
    beyond_common: Annotated[
        float | None, Meta(description="Relative change beyond that of `common`; null without one.")
    ]
    beyond_common_sigmas: Annotated[float | None, Meta(description="The same in standard deviations.")]
    own_change: Annotated[
        bool,
        Meta(
            description="Whether it changed by itself: beyond a common change at the level of 1 % of all pairs "
            "together, or, without one, as `differs`."
        ),
    ]
    shape: Annotated[
        ShapeChange | None,
        Meta(description="Change of its shape; null where not three or more channels are in both files."),
    ]
    cautions: Annotated[
        list[Caution],
        Meta(
            description="Why its shape does not say where something changed: few_channels, fewer than three in both "
            "files; no_sigma_shape; close_modes, another within 3 %; low_mac, below 0.9; same_shape, only the "
            "frequency changed."
        ),
    ]


class MeasurementsCompared(Document, frozen=True):
    """Two measurement files, compared."""

    first: Annotated[str, Meta(description="The first file.")]
    second: Annotated[str, Meta(description="The second file.")]
    pairs: Annotated[list[ModePair], Meta(description="In the order of the first file.")]
    first_unpaired: Annotated[list[Number], Meta(description="Lines of the first file without a partner.")]
    second_unpaired: Annotated[list[Number], Meta(description="Lines of the second file without a partner.")]
    median_relative: Annotated[
        float | None, Meta(description="Median of second / first - 1; null without pairs.")
    ]
    rms_relative: Annotated[Size | None, Meta(description="Root mean square of second / first - 1.")]
    chi2: Annotated[Size, Meta(description="Sum of the squares of sigmas.")]
    p_value: Annotated[
        Probability | None,
        Meta(description="Of chi2 if nothing differs and the stated errors are independent."),
    ]
    poses: Annotated[Count, Meta(description="Poses of the first file with a partner.")]
    changed: Annotated[
        Changed,
        Meta(
            description="What the frequencies say: single, modes changed by themselves; common, all by one factor; "
            "common_and_single; together, only all taken together are more than the errors; nothing; no_pairs."
        ),
    ]
    common: Annotated[
        CommonChange | None, Meta(description="What all modes share; null of fewer than two pairs.")
    ]
    strain_energy: Annotated[
        list[StrainEnergyChange],
        Meta(description="Between neighbours of channels numbered in a series; empty without such."),
    ]
    notes: Annotated[list[str], Meta(description="When the result may not be trusted.")]
