"""Measured modes beside their predictions, and the errors of one stage over all of them."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field

from pkmodes.diagnosis.problem import Driven, Structure
from pkmodes.measured.measurements import Measurements


@dataclass(frozen=True)
class Error:
    """Errors of one stage.

    Attributes
    ----------
    rms_relative, held_out_rms_relative : float or None
        Root mean square of f_model / f_measured - 1 over the fitted and the held-out rows; None if there are none.
    chi2_per_dof : float
        Chi-square per degree of freedom of the fitted rows and the priors.
    """

    rms_relative: float | None
    held_out_rms_relative: float | None
    chi2_per_dof: float


@dataclass(frozen=True)
class MeasuredMode:
    """One measured mode.

    Attributes
    ----------
    pose, line, mode : str, int, str
        Pose, line in the file, and label.
    measured, sigma : float
        Frequency and its standard deviation [Hz].
    drives : str or None
        What the motors did, "free" or "held"; None for a structure without motors.
    """

    pose: str
    line: int
    mode: str
    measured: float
    sigma: float
    drives: str | None


@dataclass(frozen=True)
class Row(MeasuredMode):
    """One measured mode and its predictions; None if the model has no partner for it.

    Attributes
    ----------
    before, refit, after : float or None
        Predicted frequency of the model as declared, with nuisances refitted, and with the causes [Hz].
    mac : float or None
        MAC at the last stage, if a shape was measured.
    load : mapping of str to float
        Values set at its pose, by name.
    damping, sigma_damping : float or None
        Measured damping ratio and its standard deviation; None if damping was not measured, or not diagnosed.
    damping_before, damping_after : float or None
        Ratio of its partner, at the final values of the frequencies: with the losses as declared, and as diagnosed.
    damping_used : bool or None
        Whether the ratio took part in the fit: not held out, of a shape like that of its partner, and not set aside.
    sigma_damping_used : float or None
        Standard deviation of the ratio with which it is compared: with the errors that no file states.
    damping_remark : str or None
        Why the ratio took no part; None if it did.
    """

    before: float | None
    refit: float | None
    after: float | None
    mac: float | None
    held_out: bool
    outlier: bool
    load: Mapping[str, float] = field(default_factory=dict)
    damping: float | None = None
    sigma_damping: float | None = None
    damping_before: float | None = None
    damping_after: float | None = None
    damping_used: bool | None = None
    sigma_damping_used: float | None = None
    damping_remark: str | None = None


def drives_of(structure: Structure, data: Measurements, row: int) -> str | None:
    """Return what the motors did in a row; None for a structure without motors."""
    return data.drives[data.pose[row]] if isinstance(structure, Driven) else None
