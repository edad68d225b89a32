"""From a declared machine to everything that is derived of it: it knows parts and closures, and no mechanism.

`kinematics` closes the loops, `energy` writes the energies of the parts, `statics` solves the equilibrium, `derived`
collects them with M and K, `condensed` eliminates what has no inertia, `sensitivity` differentiates with respect to
parameters, and `chapters` and `models` list the functions that are emitted.
"""
