"""Find the physical cause that a model lacks from measured modes, for any model with M and K.

`diagnose` takes a structure, for example a `MatrixStructure` made from callables for M and K, and measured modes.
It reports whether the model is adequate, which cause explains the residual, or that the data do not decide.
`compare` only pairs predictions with measurements.  docs/explanation/diagnosis.md has the method and its limits.
"""

from pkmodes.loop.diagnosis.compare import Comparison, compare
from pkmodes.loop.diagnosis.criteria import Criteria
from pkmodes.loop.diagnosis.diagnose import diagnose
from pkmodes.loop.diagnosis.matrices import MatrixStructure
from pkmodes.loop.diagnosis.problem import Candidate, Parameter, Prediction, Structure
from pkmodes.loop.diagnosis.update import Update, update
from pkmodes.loop.diagnosis.verdict.result import Diagnosis
from pkmodes.loop.measured.measurements import Measurements
from pkmodes.loop.measured.reading import read_modes as read_measurements

__all__ = [
    "Candidate",
    "Comparison",
    "Criteria",
    "Diagnosis",
    "MatrixStructure",
    "Measurements",
    "Parameter",
    "Prediction",
    "Structure",
    "Update",
    "compare",
    "diagnose",
    "read_measurements",
    "update",
]
