"""Which measured mode is which mode of the model."""
