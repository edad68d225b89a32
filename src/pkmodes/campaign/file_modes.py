"""What one file gives: its modes, what to say of it, and the fit behind them."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from pkmodes.campaign.found import Found
from pkmodes.identification.estimates import Estimate


@dataclass(frozen=True, eq=False)
class Fit:
    """The fit of a file, to be looked at.

    Attributes
    ----------
    estimate : Estimate
        Its functions are S responses per R references, or S power spectra.
    responses, references : tuple of str
        Names of the S and of the R; no references for spectra.
    coherence : ndarray, shape (F, S, R), or None
        On the lines of the estimate.
    """

    estimate: Estimate
    responses: tuple[str, ...]
    references: tuple[str, ...] = ()
    coherence: NDArray[np.float64] | None = None


@dataclass(frozen=True, eq=False)
class FileModes:
    """The modes of a file.

    Attributes
    ----------
    modes : tuple of Found
    messages : tuple of str
        What the user should know.
    seen : frozenset of str
        Names of the sensors and, without their signs, of the forces in the file.
    added : tuple of Found or str
        For each frequency from which the user asked for a mode: the mode, or why there is none.
    fit : Fit or None
        None for modes that are already identified.
    """

    modes: tuple[Found, ...]
    messages: tuple[str, ...]
    seen: frozenset[str]
    added: tuple[Found | str, ...] = ()
    fit: Fit | None = None
