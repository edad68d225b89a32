"""Results for terms beyond the catalogue: plain data, the words of a headline, and the JSON."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass

from pkmodes.loop.diagnosis.verdict import naming
from pkmodes.loop.diagnosis.verdict.document import (
    BeyondDocument,
    TermClassDocument,
    TermDocument,
    ValueDocument,
)
from pkmodes.loop.diagnosis.verdict.findings import Corrected, Finding, Value
from pkmodes.loop.diagnosis.verdict.rows import Error
from pkmodes.loop.diagnosis.verdict.verdicts import FOUND, StatusWord

#: Form whose parameters keep their names as declared values.
DECLARED = "parameter"


@dataclass(frozen=True)
class TermClass:
    """Explanations that these data cannot tell apart, the best first, plausible ones before others.

    - finding: its members with their values, and the p-value of the best member
    - probability: beside the other explanations that leave noise
    - forms: form of each member; empty for a cause of the catalogue
    - errors: errors with each member
    - corrected: values of its best member, and the uncertain values beside it
    """

    finding: Finding
    probability: float
    forms: Mapping[str, str]
    errors: Mapping[str, Error]
    corrected: tuple[Corrected, ...]

    def quantity(self, member: str, value: Value) -> str:
        """Return the name of a parameter of a member, without that of the member: "stiffness"."""
        form = self.forms.get(member, "")
        if value.name.startswith(f"{member}."):
            return value.name.removeprefix(f"{member}.")
        if form == DECLARED or not (form or value.name.startswith("effects.")):
            return value.name
        return form if form == "compliance" else value.name.split(".")[-1]

    @property
    def document(self) -> TermClassDocument:
        """The class in the form described in docs/reference/json.md."""
        members = [
            TermDocument(
                term=name,
                sentence=self.finding.member(name).words,
                parameters={
                    self.quantity(name, value): ValueDocument.of(value)
                    for value in self.finding.alternatives[name]
                },
                plausible=not self.finding.member(name).implausible,
                error=self.errors[name],
            )
            for name in self.finding.members
        ]
        return TermClassDocument(self.probability, self.finding.p_value, members)


@dataclass(frozen=True)
class Beyond:
    """What a single form at one place would explain that the catalogue does not.

    - status: "found", "several" or "none"
    - reason: one sentence
    - tried: number of terms
    - classes: what remains; empty if nothing is claimed
    - catalogue: the best explanation of the catalogue, claimed or not, and the errors with it; None if none was
      fitted
    - rule: the rule that decided: "beyond.found".  For tests and studies; not part of the JSON.
    """

    status: StatusWord
    reason: str
    tried: int
    classes: tuple[TermClass, ...] = ()
    catalogue: tuple[str, Error] | None = None
    rule: str = ""

    @property
    def found(self) -> TermClass | None:
        """The class that was found; None if none was."""
        return self.classes[0] if self.status == FOUND.word else None

    def words(self, max_length: int | None = None) -> str:
        """Return what was found with its value, as a sentence; empty if nothing was found.

        - max_length: characters of a class; what does not fit is counted
        """
        if self.found is None:
            return ""
        finding, forms = self.found.finding, self.found.forms
        if not all(forms[name] for name in finding.members):  # a cause of the catalogue is among them
            words = naming.found_in_words([finding], max_length)
            return words[0].upper() + words[1:]
        if len(finding.members) > 1:
            return f"Not in the catalogue: {naming.found_in_words([finding], max_length)}"
        sizes = [f"{value.rounded} {value.unit}".removesuffix(" 1") for value in finding.parameters]
        return f"Not in the catalogue: {', '.join([finding.member(finding.name).words, *sizes])}"

    def document(self) -> BeyondDocument:
        """Return it in the form described in docs/reference/json.md."""
        return BeyondDocument(
            self.status, self.reason, self.tried, [term_class.document for term_class in self.classes]
        )
