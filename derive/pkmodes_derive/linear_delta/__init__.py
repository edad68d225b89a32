"""The linear delta: three carriages on rails, three linkages, belts and pulleys, in any position.

`derive` puts the parts together: coordinates and closures (`symbols`, `kinematics`), energies (`energy`),
the equilibrium (`statics`), and the list of functions that are emitted (`catalogue`).
"""

from pkmodes_derive.linear_delta.catalogue import derive
from pkmodes_derive.linear_delta.extended import derive as derive_extended
from pkmodes_derive.linear_delta.single import derive_single

__all__ = ["derive", "derive_extended", "derive_single"]
