"""The core: robot file, parameters, M and K, modes.  README.md leads a pose through it."""
