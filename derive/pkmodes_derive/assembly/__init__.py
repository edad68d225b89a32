"""From a declared machine to everything that is derived of it: it knows parts and closures, and no mechanism.

`kinematics` closes the loops, `energy` writes the energies of the parts, `statics` solves the equilibrium, `matrices`
gives M and K, `chapters` lists the functions of a model, `extended` those of a model with effects, `single` those of one
robot, and `sensitivity` differentiates with respect to parameters.
"""
