"""Modal measurements: natural frequencies, shapes and poses that were identified on a machine."""
