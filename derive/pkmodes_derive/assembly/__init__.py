"""From a declared machine to everything derived from it, using its parts and closures and no particular mechanism.

`kinematics` closes the loops, `energy` writes the energies of the parts, `statics` solves the equilibrium, `derived`
collects them with M and K, `condensed` eliminates coordinates without inertia, `sensitivity` differentiates with
respect to parameters, and `chapters` and `models` list the functions that are emitted.
"""
