"""Terms: one form (mass, spring, mount, resonator) at one place, as effects that no catalogue lists.

`places` finds the bodies of a machine, `forms` are effects at them, and `enumeration` lists all terms of a machine
for the search of a diagnosis.  A file that ``pkmodes diagnose --save-effect`` writes uses `forms`.
"""

from pkmodes_derive.terms.forms import compliance, mass, mount, resonator, spring

__all__ = ["compliance", "mass", "mount", "resonator", "spring"]
