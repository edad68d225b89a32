"""Fits of hypotheses to frequencies and shapes, and their goodness of fit."""
