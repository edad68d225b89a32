"""JSON Schemas of the output of ``--json``: ``python -m pkmodes.cli.schemas docs/schemas`` writes them."""

from __future__ import annotations

import json
import sys
from pathlib import Path

from pkmodes.cli.check import CheckDocument
from pkmodes.cli.examples import ExamplesDocument
from pkmodes.cli.figures import FiguresDocument
from pkmodes.cli.generate import GenerateDocument
from pkmodes.cli.modes import modes_document
from pkmodes.cli.response import ResponseDocument
from pkmodes.cli.sensitivities import SensitivitiesDocument
from pkmodes.cli.shaper_documents import MeasuredShaperDocument, ShaperDocument
from pkmodes.cli.show import ShowDocument
from pkmodes.core.support.documents import Document, schema_of
from pkmodes.core.support.writing import write_files
from pkmodes.loop.diagnosis.compare import CompareDocument
from pkmodes.loop.diagnosis.states.document import ChangedDocument
from pkmodes.loop.diagnosis.verdict.document import DiagnoseDocument
from pkmodes.loop.measured.comparison import MeasurementsCompared
from pkmodes.machine.maps.robots_compared import RobotsCompared
from pkmodes.machine.maps.summary import MapSummary
from pkmodes.modaltest.campaign.results import IdentifyDocument

#: The documents of each command; `compare` writes the second for two robots, the third for two measurement files, and
#: `shaper` the second for measured modes.
DOCUMENTS: dict[str, type[Document]] = {
    "examples": ExamplesDocument,
    "generate": GenerateDocument,
    "check": CheckDocument,
    "modes": modes_document(),
    "map": MapSummary,
    "figures": FiguresDocument,
    "show": ShowDocument,
    "sensitivities": SensitivitiesDocument,
    "response": ResponseDocument,
    "shaper": ShaperDocument,
    "shaper-measured": MeasuredShaperDocument,
    "identify": IdentifyDocument,
    "compare": CompareDocument,
    "compare-robots": RobotsCompared,
    "compare-measurements": MeasurementsCompared,
    "diagnose": DiagnoseDocument,
    "changed": ChangedDocument,
}


def schema_files() -> dict[str, str]:
    """Return the schema of each command by the name of its file."""
    return {
        f"{command}.schema.json": json.dumps(
            schema_of(document, f"pkmodes {command.partition('-')[0]} --json"), indent=1
        )
        + "\n"
        for command, document in DOCUMENTS.items()
    }


if __name__ == "__main__":
    write_files(Path(sys.argv[1]), schema_files())
