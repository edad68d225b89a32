"""The compiled evaluator: poses in, modes out, several poses side by side in vector registers.

Each mechanism has its own library, built from its generated header (``lanes.h``) and the C sources here: when pkmodes
is installed for the mechanisms that come with it, at first use for others.  Without a compiler NumPy does the work.
"""
