"""Diagnose a structure that is not a robot: a chain of four masses and springs, measured frequencies and shapes.

    python examples/lumped_structure.py

The model lacks the braces of the second storey.  The engine gets a callable for M and K, a list of candidates, and
the measurements.  A second model has no candidates: with ``terms=True`` the engine tries masses at the floors and
springs between them, and finds the brace as a spring between the two floors that it joins.
"""

import numpy as np
from scipy.linalg import eigh

from pkmodes.diagnosis import Candidate, MatrixStructure, Measurements, Parameter, diagnose

STOREYS = 4


def matrices(values, setup):
    """Return mass and stiffness of a shear frame; setup "loaded" has 5 kg on its roof."""
    M = values["mass"] * np.eye(STOREYS)
    M[-1, -1] += 5.0 if setup == "loaded" else 0.0
    M[0, 0] += values["mass on the first floor"]
    k = values["storey"] + np.array([values[f"brace {i}"] for i in range(1, STOREYS + 1)])
    K = np.diag(k + np.append(k[1:], 0.0)) - np.diag(k[1:], 1) - np.diag(k[1:], -1)
    return M, K


parameters = [
    Parameter("mass", 20.0, "kg", sigma=0.1),
    Parameter("storey", 4.0e5, "N/m", sigma=1.2e4),
    Parameter("mass on the first floor", 0.0, "kg", lower=0.0),
    *(Parameter(f"brace {i}", 0.0, "N/m", lower=0.0) for i in range(1, STOREYS + 1)),
]
candidates = [Candidate(p.name, (p.name,)) for p in parameters if p.sigma is None]
channels = [f"floor {i}" for i in range(1, STOREYS + 1)]
setups = ["empty", "loaded"]
structure = MatrixStructure(parameters, candidates, matrices, channels=channels, setups=setups)


def bare_matrices(values, setup):
    """Return mass and stiffness of the same frame, without a parameter for braces."""
    absent = {p.name: p.value for p in parameters}
    return matrices(absent | values, setup)


bare = MatrixStructure(parameters[:2], [], bare_matrices, channels=channels, setups=setups)


def measure(rng):
    """Simulate a test of the real structure, with noise and undeclared values."""
    truth = {p.name: p.value for p in parameters} | {"mass": 20.1, "storey": 4.08e5, "brace 2": 6.0e4}
    pose, frequency, shapes = [], [], []
    for setup in setups:
        M, K = matrices(truth, setup)
        eigenvalues, modes = eigh(K, M)
        pose += [setup] * STOREYS
        frequency += list(np.sqrt(eigenvalues) / (2 * np.pi) * (1 + 0.002 * rng.standard_normal(STOREYS)))
        shapes += list(modes.T * (1 + 0.02 * rng.standard_normal((STOREYS, STOREYS))))
    columns = dict(zip(channels, np.array(shapes).T, strict=True))
    return Measurements.from_rows(pose, frequency, 0.002 * np.array(frequency), shapes=columns)


def main() -> None:
    """Diagnose both models and print the results."""
    data = measure(np.random.default_rng(1))
    result = diagnose(structure, data)
    print(f"{result.verdict}: {result.reason}")
    for found in result.effects:
        for value in found.parameters:
            print(
                f"  {value.name} = {value.value:.3g} +- {value.sigma:.2g} {value.unit}; class: {found.members}"
            )
    for stage, (_, error) in result.errors.items():
        print(f"  {stage:6} rms {100 * error.rms_relative:.2f} %, chi2 per dof {error.chi2_per_dof:.3g}")

    print("\nWithout candidates:")
    result = diagnose(bare, data, terms=True)
    print(f"{result.verdict}: {result.reason}")
    print(f"  {result.beyond.status} among {result.beyond.tried} terms: {result.beyond.reason}")


if __name__ == "__main__":
    main()
