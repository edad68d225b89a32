"""The interface of a model to the diagnosis: parameters, candidate causes, and modes with their derivatives.

It is independent of robots.  A structure is measured in one or several *setups* (poses of a robot, load cases of a
test structure); each setup has its own modes, and all setups have the same parameters.
"""

from __future__ import annotations

from collections.abc import Collection, Mapping, Sequence
from dataclasses import dataclass
from functools import cached_property
from typing import NamedTuple, Protocol, runtime_checkable

import numpy as np
from numpy.typing import NDArray

Array = NDArray[np.float64]
Index = NDArray[np.intp]


@dataclass(frozen=True)
class Parameter:
    """A number that a model depends on.

    Parameters
    ----------
    name : str
        Its key in the values that the model gets, and its name in reports.
    value : float
        Declared value; for a cause that is not declared, the value at which it is absent.
    unit : str
        Unit in reports.
    sigma : float or None
        Standard deviation of the declared value: a nuisance parameter, refitted within this prior under every
        hypothesis.  None: fixed at its value, unless it belongs to a candidate.
    lower : float
        Smallest value that is physically possible.
    upper : float
        Largest value that is physically possible.
    log : bool
        Whether the prior is log-normal, for a positive scale.  The standard deviation, here or in a candidate, is
        then relative.
    usual : tuple of two floats, optional
        Range of the values that such a part can have.  A claimed value outside is marked as implausible; no fit and
        no verdict depends on it.
    correlated : tuple of tuple of str and float
        Names of other uncertain parameters with the correlation of both priors; each lists the other.  Of logarithms
        where a prior is log-normal.
    """

    name: str
    value: float
    unit: str = "1"
    sigma: float | None = None
    lower: float = -np.inf
    upper: float = np.inf
    log: bool = False
    usual: tuple[float, float] | None = None
    correlated: tuple[tuple[str, float], ...] = ()


class Assumption(NamedTuple):
    """A parameter that a cause needs at a value that nobody declared.

    - parameter: its name
    - key: where it is declared: "frame.mass"
    - words: the value in words, with what it is: "a frame.mass of 50 kg"
    """

    parameter: str
    key: str
    words: str


class Joint(NamedTuple):
    """One of several equal machine parts that each have a value in a cause: a relative change of a declared value.

    - parameter: name of its parameter in the cause
    - words: what it is called: "leg 3"
    - quantity: what changes: "stiffness"
    - term: the declared value that changes, as a term: "parameter:axis.3.leg.stiffness"; empty where there is none
    """

    parameter: str
    words: str
    quantity: str
    term: str = ""


@dataclass(frozen=True)
class Candidate:
    """A cause that may explain the residual: one parameter, or several that are tested together.

    Parameters
    ----------
    name : str
        Its name in reports.
    parameters : tuple of str
        Names of its parameters.
    sentence : str
        Physical meaning, for reports.
    remote : bool
        A special cause, tried alone if no other single cause explains the measurements.  It is never claimed: if it
        explains them, the verdict is ``unexplained``, and the reason names it.
    nameable : bool
        Whether a remote cause may be listed in the class of another one.
    sigma : tuple of float, optional
        Prior standard deviation of each parameter, applied if the cause is assumed.  It ranks this cause among
        others, and a value far outside costs evidence.
    general_of : str
        Name of a candidate that is a special case of this one: that one has one value for all joints, this one has
        a value for each.  This one is never claimed.  A claim of the special case is refused if its residual points
        significantly to this one.
    part_of : str
        Name of a candidate that moves everything this one moves, and more, with as many parameters, such as a frame
        that yields in all directions.  That one brings modes close to each other, whose shapes follow noise:
        wherever it would be claimed, this one remains too if it leaves nothing but noise.
    kind, part : str
        What it has in common with other candidates, a noun phrase such as "a compliance in series with the belt", and
        what it is among them, such as "clamps": the members of a class that share a kind are named by it.
    assumes : tuple of Assumption
        Defaults on which its values depend, such as the mass of a frame that yields.
    form : str
        Of a *term*, one form at one place, which no catalogue has: "mass", "spring", "compliance", "mount",
        "resonator" or "parameter".  Empty for a candidate of the catalogue.
    starts : tuple of tuple of float
        Values of its parameters from which it is fitted besides the linear estimate: of a resonator, whose mode may
        be anywhere, pairs of mass and frequency.
    local : bool
        A value of one axis: it concerns one place, as a term does, and is compared with terms before it is claimed.
    odds : float
        Prior odds relative to other candidates.
    joints : tuple of Joint
        Of a cause that has a relative change for each of several equal parts: these, one for each parameter.  Where
        one of them alone would do as well, it is named.
    """

    name: str
    parameters: tuple[str, ...]
    sentence: str = ""
    remote: bool = False
    nameable: bool = True
    sigma: tuple[float, ...] | None = None
    general_of: str = ""
    part_of: str = ""
    kind: str = ""
    part: str = ""
    assumes: tuple[Assumption, ...] = ()
    form: str = ""
    starts: tuple[tuple[float, ...], ...] = ()
    local: bool = False
    odds: float = 1.0
    joints: tuple[Joint, ...] = ()

    @property
    def claimable(self) -> bool:
        """Whether it may be claimed."""
        return not self.remote and not self.general_of


def reached_bounds(p: Parameter, value: float, size: float = 0.0) -> list[float]:
    """Return the physical bounds that a value has reached, up to a thousandth of the largest number of this kind."""
    tolerance = 1e-3 * max(abs(p.value), abs(value), size)
    return [bound for bound in (p.lower, p.upper) if np.isfinite(bound) and abs(value - bound) <= tolerance]


@dataclass(frozen=True)
class Prediction:
    """Modes of all S setups for given parameter values.

    Attributes
    ----------
    eigenvalues : ndarray, shape (S, m)
        Ascending [1/s^2]; NaN for a setup that cannot be evaluated with these values.  A setup with fewer modes than
        others is padded with rigid modes at 0, or with modes far above the measurable range.
    rates : ndarray, shape (S, m, T)
        Derivatives of the eigenvalues with respect to the requested parameters.
    shapes : ndarray, shape (S, m, C)
        Mode shapes in the model's channels, mass-normalised.
    rigid : int
        Number of leading modes that are rigid-body motions, which are not measured.
    shape_rates : ndarray, shape (S, m, C, T), optional
        Derivatives of the shapes, if requested.  For close modes, the component within their own
        subspace may have any finite value: no comparison depends on it.
    """

    eigenvalues: Array
    rates: Array
    shapes: Array
    rigid: int = 0
    shape_rates: Array | None = None

    @cached_property
    def log_frequencies(self) -> Array:
        """Natural logarithm of the frequencies in Hz, (S, m)."""
        with np.errstate(divide="ignore", invalid="ignore"):
            logs: Array = 0.5 * np.log(np.abs(self.eigenvalues)) - np.log(2.0 * np.pi)
        return logs

    @property
    def log_rates(self) -> Array:
        """Derivatives of the logarithms of the frequencies, (S, m, T)."""
        with np.errstate(divide="ignore", invalid="ignore"):
            rates: Array = self.rates / (2.0 * self.eigenvalues[..., None])
        return rates


class Batch(NamedTuple):
    """Modes for several sets of parameter values, evaluated together.

    - sets: indices of the sets, (B,)
    - prediction: for B times S setups, those of the first set first; missing derivatives of a set are padded with
      zeros
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
        Their units: components with the same unit have the same measurement error.
    """

    @property
    def parameters(self) -> tuple[Parameter, ...]:
        """All parameters that can vary."""

    @property
    def candidates(self) -> tuple[Candidate, ...]:
        """Candidate causes."""

    @property
    def channels(self) -> tuple[str, ...]:
        """Names of the shape components."""

    @property
    def channel_units(self) -> tuple[str, ...]:
        """Units of the shape components."""

    def predict(self, values: Array, by: Sequence[int], *, shape_rates: bool = False) -> Prediction:
        """Return the modes for values of all parameters, with derivatives with respect to some of them (indices)."""

    def predict_many(
        self, values: Array, by: Sequence[Sequence[int]], *, shape_rates: bool = False
    ) -> Sequence[Batch]:
        """Return the same for several sets of values, (B, parameters), each with its own derivatives.

        Sets that can be evaluated together form one batch, which saves time if a single evaluation is cheap.
        """

    def subset(self, setups: Sequence[int]) -> Structure:
        """Return the same structure at some of its setups."""

    def position_rates(self, values: Array, *, shape_rates: bool = False) -> Prediction | None:
        """Return the modes with derivatives with respect to each component of the setups' positions, if any."""

    def elsewhere(self, count: int) -> tuple[Array, Structure] | None:
        """Return points (count, d) where the structure could also be measured, and the structure at these setups."""


@runtime_checkable
class Extensible(Protocol):
    """A structure that can be extended by terms: one form at one place."""

    def with_terms(self) -> Structure:
        """Return the structure with the parameters and candidates of all its terms in addition to its own.

        The parameters of this structure come first, in their order, then those of the terms; so do the candidates,
        of which those that are the same thing as a term are left out.  Each term has a ``form`` and is ``remote``, so
        that a search of the catalogue does not offer it.
        """


@dataclass(frozen=True)
class Sensor:
    """A sensor with several axes at one place.

    - place: where it is, such as "platform"
    - channels: the channels of its two or three axes, perpendicular, in right-handed order
    - axes: names of the axes, such as "x"
    """

    place: str
    channels: tuple[str, ...]
    axes: tuple[str, ...]


@runtime_checkable
class Instrumented(Protocol):
    """A structure that knows which of its channels are axes of one sensor."""

    @property
    def sensors(self) -> Sequence[Sensor]:
        """Sensors with several axes, which may be mounted in another direction."""


@runtime_checkable
class Loadable(Protocol):
    """A structure that could be measured again with known loads, such as a payload."""

    def loaded(self) -> Sequence[tuple[Mapping[str, float], Structure]]:
        """Return loads (values by name, set in all setups), each with the structure under it."""


@runtime_checkable
class Surrounded(Protocol):
    """A structure that could be measured elsewhere under conditions of its own."""

    @property
    def surroundings(self) -> str:
        """What `Structure.elsewhere` offers, as a plural noun in a sentence."""


@runtime_checkable
class Driven(Protocol):
    """A structure with motors, which turn freely or are held in each setup."""

    @property
    def drives(self) -> str:
        """What the motors do in most of the setups: "free" or "held"."""

    def with_other_drives(self, setups: Sequence[int]) -> Structure:
        """Return the structure with the motors free instead of held, or held instead of free, in some setups."""

    def may_be_held(self, causes: Collection[str]) -> bool:
        """Return whether a measurement with held motors may be proposed, where some causes are certain.

        Motors that give way are held in a measurement only by clamps on their shafts.
        """


class MotorCandidates(Protocol):
    """Names of candidates: motors on springs, and joints between motors and what they drive."""

    @property
    def springs(self) -> tuple[str, ...]:
        """Those without influence in setups with held motors."""

    @property
    def joints(self) -> tuple[str, ...]:
        """Those that act in setups with held motors like motors that give way."""


@runtime_checkable
class WithMotorCandidates(Protocol):
    """A structure whose motors may give way."""

    @property
    def motor_effects(self) -> MotorCandidates:
        """The candidates by which they do."""


@dataclass(frozen=True)
class Loss:
    """Something that dissipates: damping ratios are linear in its parameter, and frequencies do not depend on it.

    - parameter: its value as declared, 0 if it is not.  With a sigma it is refitted within this prior.
    - candidate: its name as a candidate; empty if it is not suspected
    - sentence: physical meaning, for reports
    - declared: whether the structure declares it
    - effect: whether it is a physical effect.  A ratio common to all modes is none: it names no joint.
    - claimable: whether it may be claimed by itself if the structure declares no loss at all
    """

    parameter: Parameter
    candidate: str = ""
    sentence: str = ""
    declared: bool = False
    effect: bool = True
    claimable: bool = True


@runtime_checkable
class Damped(Protocol):
    """A structure that knows what its modes dissipate."""

    @property
    def losses(self) -> Sequence[Loss]:
        """Everything that dissipates, or is suspected to; empty if damping is not to be diagnosed."""

    def damping_rates(self, values: Array) -> Array:
        """Return the damping ratio of each elastic mode per unit of each loss, (S, m, losses), for light damping.

        The modes are those of `Structure.predict`, without the rigid ones; NaN where a setup has fewer.

        - values: of all parameters of the structure
        """


def predict_one_by_one(
    structure: Structure, values: Array, by: Sequence[Sequence[int]], *, shape_rates: bool = False
) -> list[Batch]:
    """Return the result of `Structure.predict_many` with one batch for each set of values."""
    sets = zip(values, by, strict=True)
    predictions = [structure.predict(point, indices, shape_rates=shape_rates) for point, indices in sets]
    return [Batch(np.array([k]), prediction) for k, prediction in enumerate(predictions)]
