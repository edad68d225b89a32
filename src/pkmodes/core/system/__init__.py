"""Matrices of one robot: M(p) and K(p), with and without effects."""
