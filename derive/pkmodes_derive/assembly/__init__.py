"""Derivation of a declared machine from its parts and closures, independent of the particular mechanism.

`kinematics` closes the loops, `energy` writes the energies of the parts, `statics` solves the equilibrium, `derived`
collects them with M and K, `condensed` eliminates coordinates without inertia, `sensitivity` differentiates with
respect to parameters, and `chapters` and `models` list the functions that are emitted.
"""
