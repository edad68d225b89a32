"""What one file gives: its modes, what to say of it, and the fit behind them."""

from __future__ import annotations

from dataclasses import dataclass

from pkmodes.campaign.found import Found
from pkmodes.identification.estimates import Estimate


@dataclass(frozen=True, eq=False)
class Fit:
    """The identification of a file, for a look at it.

    Attributes
    ----------
    file : str
    names : tuple of str
        Of the responses of the estimate.
    """

    file: str
    estimate: Estimate
    names: tuple[str, ...]


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
    fit : Fit or None
        None for modes that another program has identified.
    """

    modes: tuple[Found, ...]
    messages: tuple[str, ...]
    seen: frozenset[str]
    fit: Fit | None = None
