"""Exact derivatives of matrices and modes with respect to robot-file quantities and effects."""
