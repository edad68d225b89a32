"""Symbolic derivation of parallel robots with compliant transmissions, emitted as NumPy and C99.

The physics is written once, here, as SymPy expressions; everything that can be derived from it is
derived.  `vocabulary` names the symbols, `chain` differentiates through named intermediate values,
`implicit` closes kinematic loops, `lagrangian` forms M and K, `mechanisms` declares each machine
and `emit` writes the code.  Run ``python -m pkmodes_derive --help`` to regenerate the committed code.
"""

__version__ = "0.1.0"
