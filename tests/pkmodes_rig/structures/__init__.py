"""Structures with known modes, and their simulated measurements, for tests and studies of the identification."""
