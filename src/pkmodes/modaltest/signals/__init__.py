"""Measured signals: one file, of any of the known formats, as arrays with the names and units that it gives them."""
