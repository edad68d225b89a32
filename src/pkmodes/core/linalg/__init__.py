"""Linear algebra of small vibration problems: eigenvalues, graded systems, the modal assurance criterion."""
