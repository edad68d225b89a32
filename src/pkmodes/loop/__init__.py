"""Closing the loop: measurements, sensitivities, updating and diagnosis of models; robot files rewritten."""

from lazy_loader import attach

# SciPy, which updating and diagnosis need, is loaded where they are used.
__getattr__, __dir__, __all__ = attach(__name__, submodules=["diagnosis", "updating"])
