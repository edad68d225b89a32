"""What the diagnosis asks of a model: parameters, candidate causes, and modes with their derivatives.

Nothing here knows of robots.  A structure is measured in one or several *setups* (poses of a robot, load cases
of a test structure), each with modes of its own; its parameters are the same in all of them.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from typing import NamedTuple, Protocol, runtime_checkable

import numpy as np
from numpy.typing import NDArray

Array = NDArray[np.float64]
Index = NDArray[np.intp]


@dataclass(frozen=True)
class Parameter:
    """A number that a model depends on.

    Attributes
    ----------
    name : str
    value : float
        As declared; for a cause that is not declared, the value at which it is absent.
    unit : str
        For reports.
    sigma : float or None
        Standard deviation of the declared value: a nuisance, refitted inside this prior under every
        hypothesis.  None: held at its value, unless it belongs to a candidate.
    lower, upper : float
        Physical bounds.
    log : bool
        Whether the logarithm is what is normally distributed: a log-normal prior, for a positive scale.  Its
        standard deviation, here or in a candidate, is then relative.
    """

    name: str
    value: float
    unit: str = "1"
    sigma: float | None = None
    lower: float = -np.inf
    upper: float = np.inf
    log: bool = False


@dataclass(frozen=True)
class Candidate:
    """A cause that may explain what is left: one parameter, or several that are tested together.

    Attributes
    ----------
    name : str
    parameters : tuple of str
        Names of its parameters.
    sentence : str
        What it would mean, for a person.
    remote : bool
        A special cause, tried alone where no other cause explains the measurements alone.  It is not claimed
        by itself: where it explains them, the verdict is ``unexplained``, and the reason points at it.
    nameable : bool
        Whether a remote cause may stand in the class of another one that looks like it.
    sigma : tuple of float, optional
        How far each parameter may plausibly be from its value, as a standard deviation: a prior that holds where
        the cause is assumed.  It ranks this cause among others, and a value far outside costs evidence.
    general_of : str
        Name of a candidate that is a special case of this one: one value for all joints, where this one has another
        value for each.  It is never claimed itself: where that one would be, and what it leaves points at this one
        significantly, that one is refused.
    """

    name: str
    parameters: tuple[str, ...]
    sentence: str = ""
    remote: bool = False
    nameable: bool = True
    sigma: tuple[float, ...] | None = None
    general_of: str = ""

    @property
    def claimable(self) -> bool:
        """Whether it may be claimed by itself."""
        return not self.remote and not self.general_of


class ShapeRates(Protocol):
    """Derivatives of shapes, as an array (S, m, C, T) or found for those modes that are asked for."""

    def __getitem__(self, at: tuple[Index, Index], /) -> Array:
        """Those of some modes, by setup and number: their common shape, channels, parameters."""


@dataclass(frozen=True)
class Prediction:
    """Modes of all S setups for given values of the parameters.

    Attributes
    ----------
    eigenvalues : ndarray, shape (S, m)
        Ascending [1/s^2]; NaN for a setup that cannot be evaluated with these values.  What a setup has less than
        others is a rigid mode at 0, or stands far above all that could be measured.
    rates : ndarray, shape (S, m, T)
        Their derivatives with respect to the parameters that were asked for.
    shapes : ndarray, shape (S, m, C)
        Mode shapes in the model's channels, mass-normalised.
    rigid : int
        Leading modes that are rigid-body motions and not measured.
    shape_rates : ShapeRates, optional
        Derivatives of the shapes, (S, m, C, T), where they were asked for; ``np.asarray`` gives all of them.  Of
        close modes the part within their own space may be anything finite: nothing that is compared depends on it.
    """

    eigenvalues: Array
    rates: Array
    shapes: Array
    rigid: int = 0
    shape_rates: ShapeRates | None = None

    @property
    def log_frequencies(self) -> Array:
        """Natural logarithm of the frequencies in Hz, (S, m)."""
        with np.errstate(divide="ignore", invalid="ignore"):
            logs: Array = 0.5 * np.log(np.abs(self.eigenvalues)) - np.log(2.0 * np.pi)
        return logs

    @property
    def log_rates(self) -> Array:
        """Derivatives of the logarithms of the frequencies, (S, m, T)."""
        with np.errstate(divide="ignore", invalid="ignore"):
            found: Array = self.rates / (2.0 * self.eigenvalues[..., None])
        return found


class Batch(NamedTuple):
    """Modes for several sets of values of the parameters, evaluated together.

    Attributes
    ----------
    sets : ndarray of int, shape (B,)
        Which of the sets.
    prediction : Prediction
        Of B times S setups, those of the first set first; zeros for derivatives that a set has less than others.
    """

    sets: NDArray[np.intp]
    prediction: Prediction


class Structure(Protocol):
    """A model to be diagnosed.

    Attributes
    ----------
    parameters : tuple of Parameter
    candidates : tuple of Candidate
    channels : tuple of str
        Names of the shape components that the model predicts.
    channel_units : tuple of str
        Their units: components of one unit are measured equally well.
    """

    @property
    def parameters(self) -> tuple[Parameter, ...]:
        """All that can vary."""

    @property
    def candidates(self) -> tuple[Candidate, ...]:
        """What may be missing."""

    @property
    def channels(self) -> tuple[str, ...]:
        """Names of the shape components."""

    @property
    def channel_units(self) -> tuple[str, ...]:
        """Units of the shape components."""

    def predict(self, values: Array, by: Sequence[int], *, shape_rates: bool = False) -> Prediction:
        """Modes for these values of all parameters, with derivatives with respect to some of them (indices)."""

    def predict_many(
        self, values: Array, by: Sequence[Sequence[int]], *, shape_rates: bool = False
    ) -> Sequence[Batch]:
        """The same for several sets of values, (B, parameters), each with derivatives of its own.

        Sets that can be evaluated together are one batch, which saves time where the modes themselves take little.
        """

    def subset(self, setups: Sequence[int]) -> Structure:
        """The same structure at some of its setups."""

    def position_rates(self, values: Array, *, shape_rates: bool = False) -> Prediction | None:
        """Modes with derivatives with respect to the position of each setup (T = 3), where setups have one."""

    def elsewhere(self, count: int) -> tuple[Array, Structure] | None:
        """Points (count, 3) where the structure could be measured as well, and the structure at these setups."""


@runtime_checkable
class Loadable(Protocol):
    """A structure in which something could be set to a known value, such as a payload, to measure it again."""

    def loaded(self) -> Sequence[tuple[Mapping[str, float], Structure]]:
        """Loads, by the names of what is set to which value in all setups, and the structure with each of them."""


def one_by_one(
    structure: Structure, values: Array, by: Sequence[Sequence[int]], *, shape_rates: bool = False
) -> list[Batch]:
    """What `Structure.predict_many` gives where each set of values is a batch of its own."""
    sets = zip(values, by, strict=True)
    found = [structure.predict(one, some, shape_rates=shape_rates) for one, some in sets]
    return [Batch(np.array([k]), prediction) for k, prediction in enumerate(found)]
