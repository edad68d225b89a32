"""What a report needs besides the result: the robot, its measurements and files, and their names in words."""

from __future__ import annotations

from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass
from functools import cached_property

from pkmodes.core.robot.report_fields import head_of
from pkmodes.core.robot.robot import Robot
from pkmodes.core.support.motors import motors_in_words
from pkmodes.core.support.words import meaning_of
from pkmodes.loop.measured.measurements import Measurements
from pkmodes.loop.updating.load_cases import settable_paths
from pkmodes.pages.plots.evidence import PlottedEvidence
from pkmodes.pages.report.blocks import Cell, Section
from pkmodes.pages.report.formatting import clean, plural, quantity_cell, shorten
from pkmodes.pages.report.sections import origin_section
from pkmodes.pages.report.sources import Source


@dataclass(frozen=True)
class ReportContext:
    """The robot, the measurements and the files of a result.

    - subject: what was measured: the name of the robot or structure
    - view: HTML of the view in three dimensions
    """

    subject: str
    robot: Robot | None
    data: Measurements | None
    sources: tuple[Source, ...]
    view: str | None

    def title(self, drives: Iterable[str | None]) -> str:
        """Return the subject, with what the motors of a robot did."""
        return (
            shorten(self.subject)
            if self.robot is None
            else f"{shorten(self.subject)}, {motors_in_words(self.robot, drives)}"
        )

    @property
    def head(self) -> list[tuple[str, str]]:
        """Lines of the head of the report: what the robot file states about the machine."""
        return [] if self.robot is None else head_of(self.robot.report)

    @cached_property
    def _units(self) -> dict[str, str]:
        return {} if self.robot is None else settable_paths(self.robot.mechanism)

    def meaning(self, path: str) -> str:
        """Return what the path of a value means; empty where the robot does not describe it."""
        return "" if self.robot is None else clean(meaning_of(self.robot.mechanism, path))

    def load_cell(self, load: Mapping[str, float]) -> Cell:
        """Return the values set at a pose as a cell."""
        cells = {path: quantity_cell(value, self._units.get(path, "1")) for path, value in load.items()}
        return Cell(
            ", ".join(f"{clean(path)} = {cell.text}" for path, cell in cells.items()),
            plain_text=", ".join(f"{path} = {cell.plain_text}" for path, cell in cells.items()),
        )

    def origin(
        self, evidence: PlottedEvidence, further_facts: Sequence[tuple[str, Sequence[Cell]]] = ()
    ) -> Section:
        """Return the section of data and versions."""
        poses_text = plural(len(evidence.labels), evidence.setup_noun)
        facts = [
            ("measurements", [Cell(f"{plural(len(evidence.measured), 'measured mode')} at {poses_text}")])
        ]
        if self.data is not None and self.data.band is not None:
            low, high = self.data.band
            facts.append(("band", [Cell(f"{low:g} Hz to {high:g} Hz")]))
        statements = {} if self.data is None else {"prior": self.data.priors, "usable": self.data.usable}
        for kind, values in statements.items():
            if values:
                facts.append(
                    (kind, [Cell(clean(f"{name} = {statement.text}")) for name, statement in values.items()])
                )
        mechanism = None if self.robot is None else self.robot.mechanism
        return origin_section(self.sources, mechanism, [*facts, *further_facts])

    def components(self, count: int) -> Sequence[tuple[str, str]]:
        """Return the names and units of the components of a pose with `count` components."""
        if self.robot is not None:
            names_and_units = [(component.name, component.unit) for component in self.robot.mechanism.pose]
        elif self.data is not None:
            names_and_units = list(zip(self.data.components, self.data.component_units, strict=True))
        else:
            names_and_units = []
        return names_and_units if len(names_and_units) == count else [(str(i + 1), "1") for i in range(count)]
