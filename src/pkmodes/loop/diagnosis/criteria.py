"""The thresholds of the diagnosis, each with its reason, by the part of the diagnosis that uses them.

Numbers of notes, of computing time and of numerical accuracy are constants where they are used.

Differences of frequencies are differences of their logarithms.
"""

from __future__ import annotations

from dataclasses import dataclass, fields, replace
from typing import ClassVar

import numpy as np

from pkmodes.core.base.errors import PkmodesError
from pkmodes.loop.measured.same_modes import CLOSE, MAX_MIXED, MIXED_SIGMAS


@dataclass(frozen=True)
class PairingCriteria:
    """Pairing measured modes with modes of the model."""

    #: Largest difference at which a measured mode is paired with a mode of the model: a factor of 1.8.
    reach: float = 0.6
    #: A MAC of 0 counts like this difference of the frequencies.
    shape_weight: float = 0.25
    #: The part of 1 - MAC that the errors of a shape explain, up to this many standard deviations and down to
    #: `good_mac`, does not count: within its errors a shape does not show to which of two modes it belongs.
    shape_sigmas: float = 3.0
    #: Modes of the model closer than this are one group: the smallest error rotates their shapes into each other, so
    #: their measured partners are assigned by the order of the frequencies alone.
    close: float = CLOSE
    #: Measured modes closer than this are compared as one subspace with their partners: a frequency error of about
    #: 0.2 % already rotates their shapes by several per cent.  The measured frequencies decide, not those of the
    #: model: a hypothesis must not be judged less strictly because it brings two modes together.
    mixed: float = 0.03
    #: The same applies to modes closer than this many standard deviations of their difference, up to a limit: their
    #: order and how they mix are then unknown.
    mixed_sigmas: float = MIXED_SIGMAS
    most_mixed: float = MAX_MIXED


@dataclass(frozen=True)
class ShapeCriteria:
    """Shapes, their errors, and shapes that belong to another mode.

    Raises
    ------
    PkmodesError
        If `sharper` is not below 1: the search would not end.
    """

    #: Smallest error of a component of a shape.  A smaller stated error covers only the identification: sensors are
    #: calibrated to half a per cent and mounted to half a degree, and the shapes of close modes rotate when a machine
    #: settles again.
    least_sigma: float = 0.01
    #: Initial scatter of shapes without a stated error; it is then estimated from the best explanation.
    scatter: float = 0.05
    #: Range of the scatter relative to the largest component: measurements are not better than the lower limit, and
    #: beyond the upper one the shapes do not agree.
    least_scatter: float = 0.005
    most_scatter: float = 0.2
    #: The search is repeated if the best explanation has a scatter smaller than the assumed one by this factor.
    sharper: float = 0.8
    #: Below this MAC a shape does not belong to its mode, whatever its stated error.
    strange_mac: float = 0.7
    #: Above this MAC it does, even if all other shapes fit far better.  In the pairing, errors explain no lower MAC.
    good_mac: float = 0.9
    #: One shape in this many may disagree: a sensor at a node, a misidentified mode.
    strange_allowed: int = 20

    def __post_init__(self) -> None:
        if not self.sharper < 1.0:
            problem = f"expected a factor below 1, found {self.sharper:g}: the search would not end"
            remedy = f"choose a smaller one; the default is {ShapeCriteria.sharper:g}"
            raise PkmodesError(problem, "ShapeCriteria.sharper", remedy)


@dataclass(frozen=True)
class FitCriteria:
    """Fits of hypotheses."""

    #: Steps of a fit; well-determined parameters need four or five.  A rough fit shows whether more are worthwhile.
    steps: int = 18
    rough_steps: int = 6
    #: Rounds of pairing and fitting; the pairing is stable after two or three.
    rounds: int = 3
    #: Largest error that the modes of a setup may share: a larger one is not a measurement error.
    most_shared: float = 0.05


@dataclass(frozen=True)
class GateCriteria:
    """Tests of whether a residual is noise, and of modes that were not measured."""

    #: Level of each test.
    level: float = 0.01
    #: Their level if one cause was found: it is refused, and a second one sought, only if its residual is clearly
    #: more than noise.  Rivals below this level are excluded.
    surely: float = 1e-3
    #: If the residual of one cause is noise with a p-value above this, remote causes are not considered beside it.
    plainly: float = 0.2
    #: A mode lies between the measured ones of its setup if it is this far above the lowest and below the highest.
    margin: float = 0.01
    #: The sensors are at nodes of a mode if it moves them by less than this part of the median over all modes.
    visible: float = 0.3


@dataclass(frozen=True)
class SearchCriteria:
    """The search for additions, their prices, and rows set aside."""

    #: A rival survives up to this difference of the criterion: three standard deviations.
    survives: float = 9.0
    #: An addition that is not needed to pass the gate is removed unless it lowers the criterion by more than this.
    worth: float = 6.0
    #: Largest number of causes, and of kinds of additions: causes, outliers, a shared error.
    most_causes: int = 2
    most_additions: int = 2
    #: Number of pairs that are refitted; all of a moderate number if there are no more than `few_rows` measured
    #: frequencies, because the linear model is then a poor guide.
    pairs: int = 16
    few_rows: int = 24
    #: A second cause is sought if the first leaves less than this part of chi2, or less per degree of freedom.
    much: float = 0.6
    little: float = 25.0
    #: Candidates are refitted if the linear model promises this fraction of the best gain, and at least the best few.
    promising: float = 0.15
    at_least: int = 10
    #: Rough fits are completed for the best few, and for those that differ from the best by less than this.
    best_few: int = 4
    nearly: float = 60.0
    #: Largest part of the rows that, wrongly paired, may hold a fit in a local minimum.
    misled: float = 0.25
    #: An outlier costs as much as three parameters, because it was chosen among all rows.
    price_of_row: float = 3.0
    #: Measurement errors are not tried if outliers and a shared error would leave more chi2 per degree of freedom.
    hopeless: float = 10.0
    #: Outliers are set aside only if there are this many rows, one in this many, and only if the others predict them:
    #: their leverage is below the last number.
    rows_to_set_aside: int = 12
    rows_per_outlier: int = 30
    redundant: float = 0.5
    #: A row farther than this many standard deviations from any mode may be no mode at all.
    strange: float = 15.0


@dataclass(frozen=True)
class ClaimCriteria:
    """Claims: what they need, their classes, their stability, and the next measurement.

    The class constants are not to be chosen: they depend on what is claimed, a cause or a change (`ClaimOfChanges`).
    """

    #: Whether a cause may rest on one row where each mode was measured once, at one setup, and the cause by nature
    #: hardly changes other modes.  For a single state it may not: a mistaken row is as likely.
    one_row_suffices: ClassVar[bool] = False
    #: Whether a term is as likely as a cause of the catalogue: a part at one place that changed.
    terms_as_likely: ClassVar[bool] = False
    #: Whether several causes at once are claimed: one change is more likely than two, and the errors of a wrong model
    #: can look like two.
    claims_several: ClassVar[bool] = True
    #: Whether a law rivals a term whenever it survives beside it.  A part that changed is more likely than a
    #: change that varies with the position, so for changes a law is a rival only where it is clearly better.
    laws_survive: ClassVar[bool] = True
    #: Largest factor by which stated errors may be too small, as an explanation that competes with a cause.
    wrong_errors: ClassVar[float] = np.inf
    #: The limit of `specific` for a term, since so many of these are tried.
    specific_term: ClassVar[float] = 0.01
    #: Largest p-value, among all candidates, of a cause that is claimed.
    claimed: float = 1e-3
    #: A cause is not claimed if some candidate would fit an arbitrary residual of that size as well with more than
    #: this probability: the data are too few to tell it from something outside the candidates.  Of 63 refusals by a
    #: limit of 0.01, 19 become right claims with this one, and one a wrong one.
    specific: float = 0.05
    #: Such a residual is as large as what the claim explains and leaves, plus this many standard deviations of noise.
    #: Combinations of candidates are drawn too if at least this many, for each cause, are different.
    spread: float = 2.0
    many: int = 6
    #: A value is at a bound if within this many standard deviations of it, significant if the p-value of a Wald test
    #: is below this, and determined by a row if leaving that out moves it by this many standard deviations.
    bounded: float = 1.0
    absent: float = 0.003
    moved: float = 5.0
    #: Two causes are not claimed from fewer measured frequencies than this: something outside the candidates looks
    #: like some pair of causes at the same place.
    rows_for_two: int = 10
    #: Measured values required in addition to the uncertain parameters: one for a cause, and one to test it.
    redundancy: int = 2
    #: Explanations whose predictions differ by less than this sum of squares are one class: if one were true, the
    #: other would survive too often.
    told_apart: float = 25.0
    #: A larger class is not a finding, and neither is a pair in a larger class of pairs.  Members that are the same
    #: to any measurement count too: where they did not, one cause outside the catalogue in ten was claimed (CoreXY).
    most_members: int = 5
    most_pairs: int = 4
    #: A setup with more leverage than this determines some parameter by itself: the others do not predict it.
    alone: float = 0.7
    #: A change of this many standard deviations is probably detected, even among many candidates.
    seen: float = 5.0
    #: Number of explanations refitted with other errors and priors, and their largest difference from the best one:
    #: explanations farther away do not become the best.
    contenders: int = 4
    near: float = 60.0
    #: Standard deviations by which two explanations must differ at a pose for it to be worth measuring.
    worth_measuring: float = 2.0
    #: A load, or motors in another state than in most measurements, is proposed if it is expected to yield this many
    #: times the information of any pose without it: it is more work, and a load has errors of mass and position.
    worth_loading: float = 1.5


@dataclass(frozen=True)
class DampingCriteria:
    """The diagnosis of damping."""

    #: Smallest relative error of a damping ratio: halves of one modal test differ by 10 to 50 % in damping, whatever
    #: sigma a file states.  It also covers what the approximation of light damping neglects.
    floor: float = 0.1
    #: Smallest error of a damping ratio: no test of a machine resolves it better.
    resolution: float = 1e-4
    #: A ratio is resolved if it exceeds this many standard deviations: below, its logarithm has no normal error.
    resolved: float = 3.0
    #: A prediction of no damping counts as this part of the measured ratio: its logarithm is a clear contradiction.
    least: float = 0.01
    #: Ratios whose median is above this are not light damping, and more likely given in per cent.
    most: float = 0.3
    #: Largest scatter beyond the stated errors, as in repeated tests, that does not contradict the model: of ratios
    #: about those of the model, or about any one value if it declares no damping.  Neither does a common ratio that
    #: differs by this much from the declared one.  It is a factor of 1.5, since tests differ by up to 50 %: of 54
    #: complete machines whose ratios scatter by 20 to 40 % from mode to mode, 7 were unexplained with 1.3, and one
    #: with 1.5.
    scatter: float = 0.4
    #: A claim needs data that reject laws outside the candidates, in which ratios differ from mode to mode by a
    #: factor of two (standard deviation of the logarithm): no larger part of these may look like a candidate, or like
    #: a pair.
    spread: float = 0.7
    specific: tuple[float, float] = (0.05, 0.01)
    #: One row may be set aside if it is farther than this many standard deviations from the prediction of the others.
    outlier: float = 4.0


@dataclass(frozen=True)
class ReasonCriteria:
    """Reasons of a verdict, and notes."""

    #: Nuisances farther than this from their declared values are reported, in standard deviations.
    far: float = 3.0
    #: A cause explains nearly all if it leaves at most this part of chi2 per degree of freedom, and at most this
    #: much: errors twice as large as stated.
    nearly_all: tuple[float, float] = (0.1, 4.0)
    #: Stated errors may be wrong if chi2 per degree of freedom is in this range; a larger residual is a model error.
    dispersed: tuple[float, float] = (1.5, 100.0)
    #: A residual has no direction if each candidate gains less than this, per parameter and in units of the mean
    #: residual.
    no_direction: float = 9.0


@dataclass(frozen=True)
class ReadingCriteria:
    """Other readings of the data: units, drives, wiring, copies."""

    #: Shapes whose mutual MAC is above this are the same.
    same_shape: float = 0.98
    #: Other wirings of the sensors are tried if shapes with stated errors have a larger chi2 per degree of freedom
    #: than the first, or if the others scatter by more than the second.
    rewired_misfit: float = 1.5
    rewired_scatter: float = 0.02
    #: Sensors are wired differently if that reduces the squares of the shapes by this factor, and the deviance of
    #: frequencies and shapes by this: a chance of 1e-9, after some 60 wirings were tried.
    rewired: float = 3.0
    rewired_certain: float = 45.0
    #: No other mistake or cause is needed for data with a smaller chi2 per value.
    rewired_noise: float = 3.0
    #: A wiring remains if its deviance differs from the best one by less than this.
    rewired_told_apart: float = 25.0
    #: A channel that is 0 in every row is dead if the model moves it by more than the first fraction of the largest
    #: component of its unit, in at least the second fraction of the rows.
    dead: tuple[float, float] = (0.3, 0.25)
    #: Frequencies at one position differ clearly if by more than this many standard deviations and this fraction, for
    #: half of the modes or more.
    same_place: tuple[float, float] = (6.0, 0.01)
    #: Another unit is reported if it reduces the median difference of the frequencies by this factor, to less than
    #: this difference, and if this part of the rows then has a mode: a robot tied to ground has modes far below those
    #: of the model, and a factor that moves these up to it moves the others far above.
    unit_gain: float = 4.0
    unit_difference: float = 0.15
    unit_paired: float = 0.75
    #: Motors free instead of held, or held instead of free, are reported if that reduces the mean difference of the
    #: frequencies by this factor, to less than this difference.
    drives_gain: float = 4.0
    drives_difference: float = 0.1
    #: Fewest rows for which another state of the motors is considered at some setups only.
    drives_rows: int = 3


@dataclass(frozen=True)
class Criteria:
    """Thresholds of pairing, fits, search and verdict.

    The error rates in docs/reference/results.md were measured with the defaults.  One threshold is changed by
    ``Criteria(claim=ClaimCriteria(told_apart=16.0))``.
    """

    pairing: PairingCriteria = PairingCriteria()
    shapes: ShapeCriteria = ShapeCriteria()
    fits: FitCriteria = FitCriteria()
    gate: GateCriteria = GateCriteria()
    search: SearchCriteria = SearchCriteria()
    claim: ClaimCriteria = ClaimCriteria()
    damping: DampingCriteria = DampingCriteria()
    reasons: ReasonCriteria = ReasonCriteria()
    readings: ReadingCriteria = ReadingCriteria()


class ClaimOfChanges(ClaimCriteria):
    """Claims that something changed between two states of one machine."""

    one_row_suffices: ClassVar[bool] = True
    terms_as_likely: ClassVar[bool] = True
    claims_several: ClassVar[bool] = False
    laws_survive: ClassVar[bool] = False
    wrong_errors: ClassVar[float] = 3.0
    specific_term: ClassVar[float] = 0.2
    #: Lower limit of `specific`: what changed is more often one part than what a model lacks is one candidate.
    least_specific: ClassVar[float] = 0.2


def of_changes(criteria: Criteria) -> Criteria:
    """Return the thresholds for changes between two states of one machine."""
    same = {threshold.name: getattr(criteria.claim, threshold.name) for threshold in fields(ClaimCriteria)}
    same["specific"] = max(same["specific"], ClaimOfChanges.least_specific)
    return replace(criteria, claim=ClaimOfChanges(**same))
