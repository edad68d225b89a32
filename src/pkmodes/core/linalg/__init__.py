"""Linear algebra of small vibration problems: eigenvalues, graded systems, damping, statics."""
