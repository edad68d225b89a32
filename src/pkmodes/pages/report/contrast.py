"""Which of two equal parts differs, where the data give only their ratio: "belt 1 is 29 % softer than belt 2"."""

from __future__ import annotations

from dataclasses import dataclass

from pkmodes.core.base.numbers import plain
from pkmodes.loop.diagnosis.verdict.findings import Finding, Value
from pkmodes.loop.diagnosis.verdict.joints import COMPARATIVES
from pkmodes.loop.updating.joints import CHANGE
from pkmodes.pages.report.report_context import ReportContext

#: Smallest difference that is named, in standard deviations.
MIN_DIFFERENCE_SIGMAS = 3.0


@dataclass(frozen=True)
class Contrast:
    """The part with the smaller value of two equal parts.

    - part, other_part: "belt 1", "belt 2"
    - quantity: "stiffness"
    - change: of its value relative to that of the other, negative
    - value: that of the part, relative to the mean of both
    """

    part: str
    other_part: str
    quantity: str
    change: float
    value: Value

    @property
    def comparison(self) -> str:
        """How it differs from the other: "29 % softer than belt 2"."""
        percent = plain(100.0 * abs(self.change), 2)
        if self.quantity in COMPARATIVES:
            return f"{percent} % {COMPARATIVES[self.quantity][0]} than {self.other_part}"
        return f"{percent} % below {self.other_part} in {self.quantity}"

    @property
    def sentence(self) -> str:
        """What it means: "belt 1 is 29 % softer than belt 2"."""
        return f"{self.part} is {self.comparison}"

    @property
    def term(self) -> str:
        """The part as a declared value of the machine, which a picture shows: "parameter:belt.1"."""
        return f"parameter:{'.'.join(self.part.rsplit(' ', 1))}"


def contrast_of_parts(effect: Finding, context: ReportContext | None) -> Contrast | None:
    """Return which of two parts a cause is about; None where it has other parameters, or no clear difference.

    Only a cause whose values are far better known relative to their mean than by themselves has a contrast; the
    values of any other cause show by themselves which part differs.
    """
    values = effect.relative()
    if context is None or effect.alone is not None or len(values) != 2:
        return None
    part_matches = [CHANGE.fullmatch(context.meaning(value.name)) for value in values]
    if part_matches[0] is None or part_matches[1] is None:
        return None
    low, high = sorted(range(2), key=lambda k: values[k].value)
    change = (1.0 + values[low].value) / (1.0 + values[high].value) - 1.0
    sigma = (1.0 - change) * values[low].sigma  # both deviate from their mean by the same amount
    if abs(change) < MIN_DIFFERENCE_SIGMAS * sigma:
        return None
    names = [f"{match[2]} {match[3]}" for match in part_matches if match is not None]
    return Contrast(names[low], names[high], part_matches[0][1], change, values[low])
