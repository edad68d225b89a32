"""Diagnosis of damping at the final model of the frequencies: which joint dissipates, and how much."""
