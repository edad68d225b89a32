"""Pairing of measured modes with modes of the model."""
