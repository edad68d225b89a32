"""The diagnoses of the examples, which the tests of a run make once."""

from __future__ import annotations

from pathlib import Path

from helpers.runs.shared import Shared
from pkmodes import read_robot, updating
from pkmodes.loop.diagnosis import Diagnosis

EXAMPLES = Path(__file__).parents[3] / "examples"


def example(
    shared: Shared, name: str, file: str = "measured", candidates: tuple[str, ...] | None = None
) -> Diagnosis:
    """Return what an example is diagnosed as.

    Parameters
    ----------
    name, file : str
        Its folder, and its measurements.
    candidates : tuple of str, optional
        By default all.
    """

    def found() -> Diagnosis:
        robot = read_robot(EXAMPLES / name / "robot.toml")
        data = updating.read(EXAMPLES / name / f"{file}.csv", robot=robot)
        return updating.diagnose(robot, data, candidates=candidates)

    return shared.value(f"diagnosis of {name}, {file}, {candidates}", found)
