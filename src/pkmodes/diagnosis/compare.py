"""Compare a model with measured modes: paired predictions and measurements, with residuals."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field

import numpy as np
from scipy import stats

from pkmodes.diagnosis.arguments import checked
from pkmodes.diagnosis.criteria import Criteria
from pkmodes.diagnosis.fit.fitter import Fitter
from pkmodes.diagnosis.match.predicted import Predicted
from pkmodes.diagnosis.problem import Structure
from pkmodes.diagnosis.verdict.mistakes import other_unit
from pkmodes.diagnosis.verdict.rows import MeasuredMode, drives_of
from pkmodes.diagnosis.verdict.wrong_drives import seemingly_wrong_drives
from pkmodes.measured.measurements import Measurements


@dataclass(frozen=True)
class ComparedRow(MeasuredMode):
    """One measured mode and its partner.

    Attributes
    ----------
    predicted : float or None
        Frequency of its partner [Hz]; None if it is unmatched.
    partner : int or None
        Number of the partner among the model's modes, from 1, rigid ones included.
    residual : float or None
        predicted / measured - 1.
    sigmas : float or None
        Difference of the logarithms in standard deviations of the measurement, including its position error.
    mac : float or None
        Modal assurance criterion, if a shape was measured.
    load : mapping of str to float
        Values set at its pose, by name.
    damping, sigma_damping : float or None
        Measured damping ratio and its standard deviation, where known.
    predicted_damping : float or None
        Damping ratio of its partner, beside a measured one, for structures that know it.
    """

    predicted: float | None
    partner: int | None
    residual: float | None
    sigmas: float | None
    mac: float | None
    load: Mapping[str, float] = field(default_factory=dict)
    damping: float | None = None
    sigma_damping: float | None = None
    predicted_damping: float | None = None

    @property
    def no_evidence(self) -> bool:
        """Whether its damping says nothing about its partner, whose shape is another one."""
        return self.damping is not None and self.mac is not None and self.mac < Criteria.strange_mac


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
    stage : Predicted or None
        Partners, differences and MAC of all measured modes, for figures; not part of the JSON.
    """

    rows: tuple[ComparedRow, ...]
    rms_relative: float | None
    chi2_per_dof: float | None
    p_value: float | None
    notes: tuple[str, ...] = ()
    rigid: int = 0
    stage: Predicted | None = field(default=None, compare=False, repr=False)

    @property
    def unpaired(self) -> tuple[ComparedRow, ...]:
        """Unmatched measured modes."""
        return tuple(row for row in self.rows if row.predicted is None)


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
    structure = checked(structure, data)
    fitter = Fitter(structure, data)
    pairing, *_ = fitter.unfitted(fitter.declared, np.ones(len(data.frequency), dtype=bool))
    paired = pairing.partner >= 0
    pairing, left, sigma, chi2 = fitter.unfitted(fitter.declared, paired)
    predicted, sigmas = data.frequency * np.exp(-left), -left / sigma
    residual = predicted / data.frequency - 1.0
    rows = tuple(
        ComparedRow(
            pose=data.labels[data.pose[i]],
            line=int(data.lines[i]),
            mode=data.mode[i],
            measured=float(data.frequency[i]),
            sigma=float(data.sigma[i]),
            drives=drives_of(structure, data, i),
            predicted=float(predicted[i]) if paired[i] else None,
            partner=int(pairing.partner[i]) + 1 if paired[i] else None,
            residual=float(residual[i]) if paired[i] else None,
            sigmas=float(sigmas[i]) if paired[i] else None,
            mac=None if np.isnan(pairing.mac[i]) else float(pairing.mac[i]),
            load=data.load(int(data.pose[i])),
        )
        for i in range(len(paired))
    )
    notes = tuple(text for text in (other_unit(fitter) or seemingly_wrong_drives(fitter),) if text)
    prediction = structure.predict(fitter.declared, ())
    stage, rigid = Predicted.of(fitter.pairer, data, prediction, pairing, sigma), prediction.rigid
    if not paired.any():
        return Comparison(rows, None, None, None, notes, rigid, stage)
    count = int(paired.sum())
    return Comparison(
        rows,
        rms_relative=float(np.sqrt(np.mean(residual[paired] ** 2))),
        chi2_per_dof=chi2 / count,
        p_value=float(stats.chi2.sf(chi2, count)),
        notes=notes,
        rigid=rigid,
        stage=stage,
    )
