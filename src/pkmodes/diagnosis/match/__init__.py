"""Which measured mode is which mode of the model, and what speaks against the measurements."""
