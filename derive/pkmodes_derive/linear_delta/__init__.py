"""The linear delta: three carriages on rails, three linkages, belts and pulleys, in any position.

`derive` puts the parts together: coordinates and closures (`symbols`, `kinematics`), energies (`energy`),
the equilibrium (`statics`), and the list of functions that are emitted (`catalogue`).
"""

from pkmodes_derive.linear_delta.catalogue import derive

__all__ = ["derive"]
