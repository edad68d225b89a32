"""Errors, checks of arguments, formatting of numbers, states of the motors, methods that applications attach."""
