"""Modal measurements: natural frequencies, mode shapes and poses identified on a machine."""
