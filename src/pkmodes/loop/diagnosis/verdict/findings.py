"""The parts of a result of a diagnosis: plain data.

Fitted values, causes with the members of their classes, tests of candidates and how large they may still be,
changes of the errors, and the measurement that is proposed.
"""

from __future__ import annotations

import math
from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field, replace
from typing import Annotated

import msgspec
from msgspec import Meta

from pkmodes.core.base.drives import Drives, motors_instruction
from pkmodes.core.base.numbers import Rounded, plain, round_to_sigma
from pkmodes.core.support.documents import Document
from pkmodes.loop.diagnosis.verdict.joints import JointAlone
from pkmodes.loop.diagnosis.verdict.relative import relative_to_mean
from pkmodes.loop.diagnosis.verdict.verdicts import Word


@dataclass(frozen=True)
class Limit:
    """How large a parameter of a candidate that is not claimed may still be.

    - candidate: its name
    - value: largest deviation from the declared value at 95 %, for an absent effect its largest size; None if the
      data do not bound it within its plausible range
    - change: relative change of some frequency of the model at the limit; 0 without a limit
    """

    candidate: str
    value: float | None
    unit: str
    change: float = 0.0


@dataclass(frozen=True)
class Unseen:
    """How far a candidate that is not claimed, or another value of a default, may have moved a fitted value.

    - sigma: the effect as a standard deviation of the value, at the candidate's limit; for a value with a prior also
      without a limit
    - candidate: the candidate with the largest possible effect; empty if a default has it
    - default: the default with the largest possible effect, such as "a frame.mass of 50 kg"; empty if a candidate has
      it
    - unbounded: name of a candidate without a limit that could have moved a value without a prior farther than all
      that is counted; empty if there is none
    """

    sigma: float
    candidate: str
    unbounded: str = ""
    default: str = ""

    @property
    def agent(self) -> str:
        """What may have moved the value, such as "an undetected error in pulley.radius"."""
        if self.default:
            return self.default.replace(" of ", " other than ", 1)
        return undetected_in_words(self.candidate)


@dataclass(frozen=True)
class Member:
    """A candidate of a class.

    - sentence, kind, part: as of its candidate
    - implausible: why its value is not one that such a part can have; empty if it is
    - assumed: the defaults on which its value depends, marked as assumed; empty if there are none
    """

    name: str
    sentence: str = ""
    kind: str = ""
    part: str = ""
    implausible: str = ""
    assumed: str = ""

    @property
    def words(self) -> str:
        """Its meaning, or its name if it has no sentence."""
        return self.sentence or self.name

    @property
    def with_name(self) -> str:
        """Its meaning, with its name."""
        return f"{self.sentence} ({self.name})" if self.sentence else self.name


@dataclass(frozen=True)
class Value:
    """A fitted parameter.

    - fit_sigma: standard deviation by the fit alone, where `sigma` is larger: the value has its digits
    """

    name: str
    value: float
    sigma: float
    unit: str
    fit_sigma: float | None = field(default=None, kw_only=True)

    @property
    def rounded(self) -> Rounded:
        """The value and its standard deviation, rounded for reading."""
        return round_to_sigma(self.value, self.sigma, self.fit_sigma)


#: Smallest ratio of a saved standard deviation to that of the fit that is explained to the reader.
MIN_NOTICEABLE_RATIO = 1.05


@dataclass(frozen=True)
class Corrected(Value):
    """A parameter that the last stage of the model changed.

    - prior_sigma: standard deviation of its declared value; None if it has none
    - at_bound: whether the value is at a physical bound other than the declared value
    - unseen: how far a candidate that these data do not show may have moved the value; None if none can have
    - plausible: largest plausible deviation from the declared value
    """

    declared: float
    prior_sigma: float | None
    at_bound: bool
    unseen: Unseen | None = None
    plausible: float = math.inf

    @property
    def saved_sigma(self) -> float:
        """Standard deviation that allows for an undetected candidate.

        The declared value still counts: it is at most the root mean square distance from the value under its prior.
        Without a prior it is at most the largest plausible deviation.
        """
        if self.unseen is None:
            return self.sigma
        sigma = math.hypot(self.sigma, self.unseen.sigma)
        if self.prior_sigma is None:
            return max(self.sigma, min(sigma, self.plausible))
        return max(self.sigma, min(sigma, math.hypot(self.prior_sigma, self.value - self.declared)))

    @property
    def widened(self) -> bool:
        """Whether the saved standard deviation is noticeably larger than that of the fit."""
        return self.saved_sigma > MIN_NOTICEABLE_RATIO * self.sigma


def wider_than_declared_in_words(value: Corrected) -> str:
    """Return why the saved standard deviation is larger than that of the declared value; empty if it is not.

    The unseen candidate may be what moved the value.  Then the declared value holds, with its standard deviation, and
    the error of the fitted value is that and the move: in quadrature, the largest saved standard deviation.
    """
    if value.prior_sigma is None or not value.widened:
        return ""
    if value.saved_sigma <= MIN_NOTICEABLE_RATIO * value.prior_sigma or value.unseen is None:
        return ""
    unit = "" if value.unit == "1" else f" {value.unit}"
    move = plain(abs(value.value - value.declared), 2)
    return (
        f"that is more than the declared sigma, {plain(value.prior_sigma, 2)}{unit}, because it may be all that "
        f"moved the value, by {move}{unit}"
    )


def saved_as(value: Value, corrected: Sequence[Corrected]) -> Corrected | None:
    """Return a cause's value as in the corrected robot file; None for another member of a class."""
    return next(
        (saved for saved in corrected if (saved.name, saved.value) == (value.name, value.value)), None
    )


def with_saved_sigma(value: Value, corrected: Sequence[Corrected]) -> Value:
    """Return a value with the standard deviation that may be relied on: the saved one, where there is one."""
    saved = saved_as(value, corrected)
    return value if saved is None else replace(value, sigma=saved.saved_sigma, fit_sigma=saved.sigma)


def explain_saved_sigma(value: Value, corrected: Sequence[Corrected]) -> str:
    """Return what the standard deviation of a value includes beyond that of the fit, and what it omits."""
    saved = saved_as(value, corrected)
    if saved is None or saved.unseen is None:
        return ""
    unseen, parts = saved.unseen, []
    if saved.widened:
        fit_sigma = round_to_sigma(value.value, value.sigma).columns[1]
        parts.append(
            f"the standard deviation is {fit_sigma} by the fit alone, and larger because it allows for "
            f"{unseen.agent}"
        )
        parts += [clause] if (clause := wider_than_declared_in_words(saved)) else []
    if unseen.unbounded:
        parts.append(omission_in_words(unseen))
    return "; ".join(parts)


def omission_in_words(unseen: Unseen) -> str:
    """Return what a standard deviation omits: the effect of a candidate without a limit."""
    return f"it does not allow for {undetected_in_words(unseen.unbounded)}, which these data do not bound"


def undetected_in_words(candidate: str) -> str:
    """Return a candidate that these data do not show, with its article."""
    path = candidate.removeprefix("parameter:")
    return f"an undetected {candidate}" if path == candidate else f"an undetected error in {path}"


@dataclass(frozen=True)
class Refitted:
    """A nuisance parameter before and after the fit, with its standard deviation after, fitted and as saved."""

    name: str
    before: float
    after: float
    sigma: float
    saved_sigma: float
    unit: str

    @classmethod
    def of(cls, v: Corrected) -> Refitted:
        """Return a nuisance parameter among the values of the last model."""
        return cls(v.name, v.declared, v.value, v.sigma, v.saved_sigma, v.unit)


@dataclass(frozen=True)
class Finding:
    """One cause that was found.

    - name: best candidate of its class
    - members: the class: all candidates that these data cannot tell apart from it, and itself
    - alternatives: for each member, its parameters if it were the cause
    - p_value: p-value of the improvement, corrected for the number of candidates
    - sentence: physical meaning
    - covariances: for each member, the covariance of its parameters, in their order
    - about: names of its members in words, and whether their values are plausible
    - alone: the single joint in which it explains the data as well
    """

    name: str
    members: tuple[str, ...]
    parameters: tuple[Value, ...]
    alternatives: dict[str, tuple[Value, ...]]
    p_value: float
    sentence: str
    covariances: Mapping[str, tuple[tuple[float, ...], ...]] = field(default_factory=dict)
    about: Mapping[str, Member] = field(default_factory=dict)
    alone: JointAlone | None = None
    state: str = ""

    def member(self, name: str) -> Member:
        """Return how a member of the class is named, and whether its value is plausible."""
        return self.about.get(name, Member(name, self.sentence if name == self.name else ""))

    @property
    def assumed(self) -> str:
        """The defaults on which the values of some members depend, as the end of a clause; empty for none."""
        assumed = dict.fromkeys(self.member(name).assumed for name in self.members)
        return "".join(f", for {text}" for text in assumed if text)

    @property
    def plausible(self) -> dict[str, bool]:
        """Whether the value of each member is one that such a part can have."""
        return {name: not self.member(name).implausible for name in self.members}

    @property
    def covariance(self) -> tuple[tuple[float, ...], ...]:
        """Covariance of the parameters, in their order."""
        return self.covariances.get(self.name, ())

    def relative(self, member: str = "") -> tuple[Value, ...]:
        """Return the parameters relative to their mean, where the data determine these far better than each.

        - member: name of a member of the class; by default the cause itself

        Their mean is 0; empty where the parameters themselves are as well determined.
        """
        name = member or self.name
        values = self.alternatives.get(name, ())
        if len({value.unit for value in values}) != 1:
            return ()
        relative_values = relative_to_mean([value.value for value in values], self.covariances.get(name, ()))
        if relative_values is None:
            return ()
        return tuple(
            replace(value, value=float(d), sigma=float(sigma))
            for value, d, sigma in zip(values, *relative_values, strict=True)
        )


@dataclass(frozen=True)
class Examined:
    """The test of one candidate.

    - p_value: p-value of its score at the refit of the nuisances, for this candidate alone: of its best plausible
      change
    - visible_from: smallest change of each parameter that these data would probably show, with its standard
      deviation, beside what is claimed; none if it would not be plausible
    - detectable: whether these data show it or bound it
    - sentence: physical meaning
    """

    name: str
    p_value: float
    visible_from: tuple[Value, ...]
    detectable: bool
    sentence: str = ""


class Stability(Document, frozen=True):
    """The result with other errors or priors."""

    change: Annotated[str, Meta(description="The change, such as sigma x 0.5.")]
    verdict: Annotated[Word, Meta(description="The resulting verdict.")]
    effects: Annotated[tuple[str, ...], Meta(description="The resulting names of the causes.")]


class NextMeasurement(Document, frozen=True, omit_defaults=True):
    """The pose that is expected to tell most about which explanation is true, and how to measure there."""

    pose: Annotated[tuple[float, ...], Meta(description="Platform centre [m].")]
    separates: Annotated[
        tuple[str, ...],
        Meta(description="The two explanations that it tells apart best.", min_length=2, max_length=2),
    ]
    sigmas: Annotated[
        float, Meta(description="By how many standard deviations of a measured frequency they differ there.")
    ]
    drives: Annotated[
        Drives | None,
        Meta(
            description="What the motors are to do: turn freely, or be held by clamps on their shafts; null for a "
            "structure without motors."
        ),
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
    ] = msgspec.field(name="set", default_factory=dict)

    @property
    def motors(self) -> str:
        """What is to be done to the motors, as words; empty for a structure without motors."""
        return "" if self.drives is None else motors_instruction([self.drives])

    @property
    def caveat(self) -> str:
        """What to do about a value that could hide the difference; empty if there is none."""
        if not self.hidden_by:
            return ""
        return (
            f"{self.hidden_by} could make up for most of that within its sigma: measure several poses in this "
            "way, or state it more exactly"
        )
