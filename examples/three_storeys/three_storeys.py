"""Close the loop on a real structure: what its model lacks, and what changed from state to state.

    python examples/three_storeys/three_storeys.py

An aluminium structure of Los Alamos National Laboratory: four plates, a base and three floors, joined by four columns
a storey, which slides on rails.  Three modes were measured in each of 17 states; measured.csv names the report.
In states 2 to 9 something is known to have been changed; in states 10 to 14 a bumper between the two upper floors
closes, which no linear model has.
"""

from pathlib import Path

import numpy as np

from pkmodes.diagnosis import Candidate, MatrixStructure, Parameter, diagnose, read_measurements

PLATES = ("base", "floor 1", "floor 2", "floor 3")
#: Masses of the plates [kg], stiffness of a storey of four columns [N/m], and a mass that was added [kg].
MASSES, STOREY, ADDED = (6.422, 6.565, 6.565, 6.675), 4 * 68.167e3, 1.2
#: Part of the stiffness that a storey loses by one column, and by two, of half the thickness.
ONE, TWO = 0.875 / 4, 0.875 / 2
#: What was changed: a plate that is heavier, or the storey that lost some of its stiffness.
CHANGED = {
    "state 2": ("base", ADDED),
    "state 3": ("floor 1", ADDED),
    "state 4": (1, ONE),
    "state 5": (1, TWO),
    "state 6": (2, ONE),
    "state 7": (2, TWO),
    "state 8": (3, ONE),
    "state 9": (3, TWO),
}
LINEAR = ["state 1", *CHANGED]
#: Springs that the chain does not have: of each plate to ground, and between plates that are no neighbours.
SPRINGS = [(i, None) for i in range(4)] + [(0, 2), (1, 3)]


def name_of(spring):
    """Return the name of a spring."""
    i, k = spring
    return f"spring of {PLATES[i]} to {'ground' if k is None else PLATES[k]}"


#: Single changes of a plate, a storey or a spring: the value of each, its unit and its range.
CAUSES = {
    **{f"storey {i} softer": ("1", 0.0, 0.95) for i in (1, 2, 3)},
    **{f"mass on {plate}": ("kg", 0.0, 20.0) for plate in PLATES},
    **{name_of(spring): ("N/m", 0.0, 1e7) for spring in SPRINGS},
}


def with_spring(K, i, k, stiffness):
    """Add a spring between two plates, or of one to ground, to a stiffness matrix."""
    K[i, i] += stiffness
    if k is not None:
        K[k, k] += stiffness
        K[i, k] -= stiffness
        K[k, i] -= stiffness


def structure_of(setups, known):
    """Return the chain at some states, with the changes of those that are known."""

    def matrices(values, setup):
        m = np.array([values[f"mass of {plate}"] for plate in PLATES])
        m += [values[f"mass on {plate}"] for plate in PLATES]
        k = np.array([values[f"storey {i}"] * (1.0 - values[f"storey {i} softer"]) for i in (1, 2, 3)])
        where, size = CHANGED[setup] if setup in known else ("", 0.0)
        if where in PLATES:
            m[PLATES.index(where)] += size
        elif where:
            k[where - 1] *= 1.0 - size
        K = np.zeros((4, 4))
        for i in range(3):
            with_spring(K, i, i + 1, k[i])
        for spring in SPRINGS:
            with_spring(K, *spring, values[name_of(spring)])
        return np.diag(m), K

    masses = [
        Parameter(f"mass of {plate}", m, "kg", sigma=0.005, log=True)
        for plate, m in zip(PLATES, MASSES, strict=True)
    ]
    # Columns clamped at both ends are stiffer on paper than in a frame.
    storeys = [Parameter(f"storey {i}", STOREY, "N/m", sigma=0.3, log=True) for i in (1, 2, 3)]
    causes = [
        Parameter(name, 0.0, unit, lower=least, upper=most) for name, (unit, least, most) in CAUSES.items()
    ]
    candidates = [Candidate(name, (name,), name) for name in CAUSES]
    return MatrixStructure(
        [*masses, *storeys, *causes], candidates, matrices, channels=PLATES, setups=setups, rigid=1
    )


def measured(setups):
    """Return the measured modes of some states."""
    every = read_measurements(Path(__file__).with_name("measured.csv"), PLATES)
    return every.at([every.labels.index(setup) for setup in setups])


def what_the_chain_lacks():
    """Diagnose the chain with all changes known: what is missing in every state."""
    return diagnose(structure_of(LINEAR, CHANGED), measured(LINEAR))


def what_changed_in(state):
    """Ask what changed in one state, as if nobody knew: the other linear states are trusted."""
    trusted = [one for one in LINEAR if one != state]
    setups = [*trusted, state]
    structure = structure_of(setups, set(trusted) & CHANGED.keys())
    states = dict.fromkeys(trusted, "trusted") | {state: state}
    return diagnose(structure, measured(setups), states=states)


if __name__ == "__main__":
    print("What the chain lacks in all states\n")
    print(what_the_chain_lacks())
    for number in range(2, 15):
        print(f"\nstate {number}\n{what_changed_in(f'state {number}')}")
