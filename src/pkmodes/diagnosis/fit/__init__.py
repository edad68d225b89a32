"""Hypotheses fitted to frequencies and shapes, and what each fit says."""
