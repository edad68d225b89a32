"""Every threshold of the diagnosis in one place, each with its reason."""

from __future__ import annotations

from dataclasses import dataclass


@dataclass(frozen=True)
class Criteria:
    """Thresholds of pairing, fits, search and verdict.

    The defaults are those with which docs/diagnosis-measured.md was measured.  Differences of frequencies are
    differences of their logarithms.
    """

    # Pairing ---------------------------------------------------------------------------------------------------

    #: Beyond this difference a measured mode is not paired with a mode of the model: a factor of 1.8.
    reach: float = 0.6
    #: A shape that does not agree at all counts like this difference of the frequencies.
    shape_weight: float = 0.25
    #: Modes of the model closer than this are one group: their shapes turn into each other with the least error, so
    #: that their measured partners are told apart by the order of the frequencies alone.
    close: float = 0.01
    #: Measured modes closer than this are compared as one space, that of their partners: an error of some 0.2 % of
    #: their frequencies already turns their shapes by several per cent.  The measured frequencies decide, not the
    #: model's: a hypothesis must not be judged more mildly because it brings two modes together.
    mixed: float = 0.03
    #: So are those closer than so many of the standard deviations of their difference, if they are stated to be less
    #: certain, up to a limit: which of two modes is which cannot be told then, nor how they mix.
    mixed_sigmas: float = 3.0
    most_mixed: float = 0.1

    # Shapes ----------------------------------------------------------------------------------------------------

    #: Scatter of shapes without a stated one, to begin with; the best explanation then gives its own.
    shape_scatter: float = 0.05
    #: What it may be, as a part of the largest component: better is not measured, and what is worse is a shape that
    #: does not agree.
    least_shape_scatter: float = 0.005
    most_shape_scatter: float = 0.2
    #: The search is made again if the best explanation has a scatter smaller than the assumed one by this factor.
    sharper: float = 0.8
    #: Below this MAC a shape is not that of its mode, whatever its stated error.
    strange_mac: float = 0.7
    #: Above this MAC it is, even if all others fit far better.
    good_mac: float = 0.9
    #: One shape in so many may be strange: a sensor at a node, a mode that was misread.
    strange_allowed: int = 20

    # Fits ------------------------------------------------------------------------------------------------------

    #: Steps of a fit; four or five are enough where the data tell.  A rough fit shows whether more are worth it.
    steps: int = 18
    rough_steps: int = 6
    #: Of more than twice so many setups, so many show where a fit should begin.
    setups_to_scout: int = 12
    #: Rounds of pairing and fitting; the pairing is stable after two or three.
    rounds: int = 3
    #: An error that the modes of a setup share is at most this large: a larger one is not an error of measuring.
    most_shared: float = 0.05

    # The gate --------------------------------------------------------------------------------------------------

    #: Level of each of its tests.
    gate: float = 0.01
    #: Their level where one cause was found: what it leaves must surely be more than noise to refuse it and to seek
    #: a second one, and a rival below this level is excluded.
    surely: float = 1e-3
    #: A cause is claimed if chance would bring one as clear, among all candidates, with less than this probability.
    claimed: float = 1e-3
    #: Nor is it claimed if some candidate would fit an arbitrary residual of that size as well with more than this
    #: probability: there are too few data to tell it from something that nobody has thought of.
    specific: float = 0.01
    #: What such a residual may leave beside a candidate: as much as the claim does, and so many standard deviations
    #: of the noise in that.  Many small changes at once are among them with so many candidates for each cause.
    spread: float = 2.0
    many: int = 6
    #: A held-out error that is larger by this factor after a claim than before it speaks against the claim.
    worse: float = 2.0
    #: A value is at a bound within so many of its standard deviations, significant if Wald's test gives less than
    #: this probability, and rests on a row if leaving that out moves it by so many standard deviations.
    bounded: float = 1.0
    absent: float = 0.003
    moved: float = 5.0
    #: Two causes are not claimed from fewer measured frequencies than this: what nobody has thought of looks like
    #: some pair of causes at the same place.
    rows_for_two: int = 10
    #: Where what one cause leaves is noise with more than this probability, no remote cause is looked for beside it.
    plainly: float = 0.2

    # The search ------------------------------------------------------------------------------------------------

    #: A rival survives up to this difference of the criterion: three standard deviations.
    survives: float = 9.0
    #: What is not needed to pass the gate is taken away unless it lowers the criterion by more than this.
    worth: float = 6.0
    #: Causes that are added at most, and kinds of additions: causes, rows set aside, a shared error.
    most_causes: int = 2
    most_additions: int = 2
    #: How many pairs are refitted; all of them where there are no more than `few_pairs` and no more than `few_rows`
    #: measured frequencies, because a linear model promises little there.
    pairs: int = 16
    few_pairs: int = 120
    few_rows: int = 24
    #: A second cause is sought if the first leaves less than this part of chi2, or less per degree of freedom.
    much: float = 0.6
    little: float = 25.0
    #: Candidates are refitted if a linear model promises this fraction of the best gain, and the best few anyhow.
    promising: float = 0.15
    at_least: int = 10
    #: Of rough fits, the best few are finished, and those that differ from the best by less than this.
    best_few: int = 4
    nearly: float = 60.0
    #: Part of the rows, at most, that may have been paired so wrongly that they keep a fit from where it belongs.
    misled: float = 0.25
    #: A row that is set aside costs as much as three parameters: it was chosen among all.
    price_of_row: float = 3.0
    #: Where setting rows aside and an error of each setup would leave more than this per degree of freedom, errors of
    #: the measurement are not tried.
    hopeless: float = 10.0
    #: Rows are set aside only where there are so many, one in so many, and each is predicted by the others: its
    #: leverage is below the last number.
    rows_to_set_aside: int = 12
    rows_per_outlier: int = 30
    redundant: float = 0.5

    # Unmeasured modes --------------------------------------------------------------------------------------------

    #: A mode is among the measured ones of its setup if it is farther than this from the outer ones.
    margin: float = 0.01
    #: A mode that moves the sensors less than this part of what the median of the modes does is at their nodes.
    visible: float = 0.3

    # The verdict -------------------------------------------------------------------------------------------------

    #: Measured values beyond the uncertain parameters: one for a cause, and one to test it with.
    redundancy: int = 2
    #: Explanations whose predictions differ by less than this sum of squares are not told apart by these data: had
    #: one been true, the other would have survived too often.
    told_apart: float = 25.0
    #: A cause is a special case of another one if no larger part of what it does lies beyond the other: derivatives
    #: by differences are that exact, and of directions in two dimensions more than are spanned one in a million is so
    #: close by chance.
    nested: float = 1e-3
    #: A class of more members is not a finding, and neither is a pair that is one of more pairs that look alike.
    most_members: int = 5
    most_pairs: int = 4
    #: A setup with more leverage than this determines something alone: no other predicts it.
    alone: float = 0.7
    #: A change of this many standard deviations would probably have been seen among so many candidates.
    seen: float = 5.0
    #: A cause is not detectable if even a change of some frequency by this fraction would not have been seen.
    noticeable: float = 0.1

    #: Explanations that are fitted again with other errors and priors, and how far from the best they may be: others
    #: do not become the best.
    contenders: int = 4
    near: float = 60.0
    #: Standard deviations by which two explanations have to differ at a pose for it to be worth measuring.
    worth_measuring: float = 2.0
    #: A load is put on for it where it separates them by so many times as much as any pose without one: it is more
    #: work, and its mass and place have errors of their own.
    worth_loading: float = 1.5

    # Notes -------------------------------------------------------------------------------------------------------

    #: Nuisances farther than this from their declared values are reported, in standard deviations.
    far: float = 3.0
    #: Stated errors that are wrong by more than this factor are reported.
    misstated: float = 3.0
    #: Stated errors are too large if chance would make the residual so small less often.
    too_small: float = 1e-4
    #: A cause explains nearly all if it leaves at most this part of chi2 per degree of freedom, and at most so much:
    #: errors twice as large as stated.
    nearly_all: tuple[float, float] = (0.1, 4.0)
    #: Stated errors may be wrong if chi2 per degree of freedom lies between these; a larger residual is the model's.
    dispersed: tuple[float, float] = (1.5, 100.0)
    #: Gain of a candidate, per parameter and scaled by the residual's own size, that has no direction.
    no_direction: float = 9.0
    #: A residual goes with the pose if chance would share it out so unevenly less often.
    uneven: float = 1e-3
    #: Shapes whose MAC with each other is above this are one shape.
    same_shape: float = 0.98
    #: Channels are wired in another way if that reduces the squares of the shapes by the first factor; by the second
    #: with the pairs as they are, for others to be tried.
    rewired: float = 3.0
    rewired_perhaps: float = 1.5
    #: A channel that is 0 in every row is dead if the model moves it by more than the first part of the largest of
    #: its unit, in more than the second part of the rows.
    dead: tuple[float, float] = (0.3, 0.25)
    #: Frequencies at one position differ clearly beyond so many standard deviations and by more than this part, for
    #: half of the modes or more.
    same_place: tuple[float, float] = (6.0, 0.01)
    #: Another unit is reported if it reduces the median difference of the frequencies by this factor, to less than
    #: this difference.
    unit_gain: float = 4.0
    unit_difference: float = 0.15
