"""Exact derivatives of matrices and modes by the quantities of a robot file and by the effects."""
