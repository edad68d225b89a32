"""Compare a model with measured modes: paired predictions and measurements, with residuals."""

from __future__ import annotations

from dataclasses import dataclass, field
from typing import Annotated

import msgspec
import numpy as np
from msgspec import Meta
from scipy import stats

from pkmodes.core.base.attached import Attached
from pkmodes.core.base.numbers import number_or_none
from pkmodes.core.support.documents import Count, Document, Number, Probability, Settings, Size
from pkmodes.loop.diagnosis.arguments import checked_structure
from pkmodes.loop.diagnosis.criteria import Criteria
from pkmodes.loop.diagnosis.fit.fitter import Fitter
from pkmodes.loop.diagnosis.match.predicted import PartnerPredictions
from pkmodes.loop.diagnosis.problem import Structure
from pkmodes.loop.diagnosis.readings.amplitude import notes_on_amplitude
from pkmodes.loop.diagnosis.readings.table import answer_for_declared_model
from pkmodes.loop.diagnosis.verdict.rows import (
    Level,
    ModeName,
    MotorsDid,
    Nearest,
    NearestMac,
    Place,
    drives_of,
)
from pkmodes.loop.measured.measurements import Measurements


class ComparedRow(Place, frozen=True, omit_defaults=True):
    """A measured mode and its partner in the model."""

    mode: ModeName
    measured: Annotated[float, Meta(description="Frequency [Hz].")]
    sigma: Annotated[float, Meta(description="Its standard deviation [Hz].")]
    drives: MotorsDid
    predicted: Annotated[
        float | None,
        Meta(
            description="Frequency of the paired mode [Hz]; null for an unmatched row, like the next three."
        ),
    ]
    partner: Annotated[
        Number | None,
        Meta(description="Number of the paired mode in the model, from 1, counting the rigid ones."),
    ]
    residual: Annotated[float | None, Meta(description="predicted / measured - 1.")]
    sigmas: Annotated[
        float | None,
        Meta(
            description="Difference of the logarithms in standard deviations, including the uncertainty of the "
            "position."
        ),
    ]
    mac: Annotated[
        Size | None,
        Meta(
            description="Modal assurance criterion; null where no shape was measured, or the row is unmatched."
        ),
    ]
    load: Settings = msgspec.field(name="set", default_factory=dict)
    level: Level = None
    damping: Annotated[
        float | None,
        Meta(description="Measured damping ratio; present only where it was measured, like the next two."),
    ] = None
    sigma_damping: Annotated[float | None, Meta(description="Its standard deviation.")] = None
    predicted_damping: Annotated[float | None, Meta(description="Damping ratio of the paired mode.")] = None
    nearest: Nearest = None
    nearest_mac: NearestMac = None

    @property
    def shape_differs(self) -> bool:
        """Whether its damping cannot be compared with its partner's, because their shapes differ."""
        return self.damping is not None and self.mac is not None and self.mac < Criteria.shapes.strange_mac


class CompareDocument(Document, frozen=True):
    """The residuals of a robot."""

    robot: Annotated[str, Meta(description="Name of the robot.")]
    rms_relative: Annotated[
        Size | None,
        Meta(description="Root mean square of the residuals of the paired rows; null where none is paired."),
    ]
    chi2_per_dof: Annotated[
        Size | None,
        Meta(
            description="Of the paired rows alone, with their stated errors, nothing fitted; null where none is "
            "paired."
        ),
    ]
    p_value: Annotated[
        Probability | None,
        Meta(
            description="Probability of a larger chi-square if the model is right; null where none is paired."
        ),
    ]
    unpaired: Annotated[Count, Meta(description="Number of unmatched measured modes.")]
    rows: Annotated[
        tuple[ComparedRow, ...], Meta(description="One for each measured mode, in the order of the file.")
    ]


@dataclass(frozen=True)
class Comparison:
    """A comparison of a model with measurements, without any fit.

    Attributes
    ----------
    rows : tuple of ComparedRow
    rms_relative : float or None
        Root mean square of the residuals of the paired rows; None if there are none.
    chi2_per_dof, p_value : float or None
        Goodness of fit of the paired rows with their stated errors.
    notes : tuple of str
        Warnings, such as frequencies that seem to be in another unit.
    rigid : int
        Number of rigid-body modes, which come first among the model's modes.
    stage : PartnerPredictions or None
        Partners, differences and MAC of all measured modes, for figures; not part of the JSON.
    """

    rows: tuple[ComparedRow, ...]
    rms_relative: float | None
    chi2_per_dof: float | None
    p_value: float | None
    notes: tuple[str, ...] = ()
    rigid: int = 0
    stage: PartnerPredictions | None = field(default=None, compare=False, repr=False)

    _repr_html_ = Attached("pkmodes.pages.report.notebook:comparison_html")

    @property
    def unpaired(self) -> tuple[ComparedRow, ...]:
        """Unmatched measured modes: the model has no mode left for them, or only one of another shape."""
        return tuple(row for row in self.rows if row.predicted is None)

    def as_json(self, robot: str) -> dict[str, object]:
        """Return the result in the form described in docs/reference/json.md, without NaN.

        Parameters
        ----------
        robot : str
            Name of the robot.

        Returns
        -------
        dict of str to object
            What ``pkmodes compare --json`` writes.
        """
        document = CompareDocument.of(self, robot=robot, unpaired=len(self.unpaired))
        return document.as_json()


def compare(structure: Structure, data: Measurements) -> Comparison:
    """Pair measured modes with predicted ones.

    Parameters
    ----------
    structure : Structure
        At the setups of the measurements; evaluated with the declared values of its parameters.
    data : Measurements
        Identified modes of these setups.

    Returns
    -------
    Comparison
        One row for each measured mode, in the order of the data.

    Raises
    ------
    PkmodesError
        If the data do not belong to the structure, or it cannot be evaluated as declared.
    """
    structure = checked_structure(structure, data)
    fitter = Fitter(structure, data)
    prediction, pairer = structure.predict(fitter.declared, ()), fitter.observations.pairer
    pairing, _, sigma, _ = fitter.evaluate(fitter.declared, np.ones(len(data.frequency), dtype=bool))
    stage = PartnerPredictions.from_pairing(pairer, data, prediction, pairing, sigma)
    is_paired = stage.partner_mode > 0
    *_, chi2 = fitter.evaluate(fitter.declared, is_paired, pairing)
    residual = stage.frequency / data.frequency - 1.0
    drives = drives_of(structure, data)
    rows = tuple(
        ComparedRow(
            pose=data.labels[data.pose[i]],
            line=int(data.lines[i]),
            mode=data.mode[i],
            measured=float(data.frequency[i]),
            sigma=float(data.sigma[i]),
            drives=drives[i],
            predicted=number_or_none(stage.frequency[i]),
            partner=int(pairing.partner[i]) + 1 if is_paired[i] else None,
            residual=number_or_none(residual[i]),
            sigmas=number_or_none(stage.normalised_differences[i]),
            mac=number_or_none(stage.partner_mac[i]),
            load=data.load(int(data.pose[i])),
            level=data.level_at(int(data.pose[i])),
            nearest=number_or_none(stage.nearest_frequency[i]),
            nearest_mac=number_or_none(stage.nearest_mac[i]),
        )
        for i in range(len(is_paired))
    )
    notes = (*answer_for_declared_model(fitter), *notes_on_amplitude(fitter, fitter.declared))
    if not is_paired.any():
        return Comparison(rows, None, None, None, notes, prediction.rigid, stage)
    count = int(is_paired.sum())
    return Comparison(
        rows,
        rms_relative=float(np.sqrt(np.mean(residual[is_paired] ** 2))),
        chi2_per_dof=chi2 / count,
        p_value=float(stats.chi2.sf(chi2, count)),
        notes=notes,
        rigid=prediction.rigid,
        stage=stage,
    )
