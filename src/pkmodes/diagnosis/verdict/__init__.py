"""From fits to a verdict that a person can rely on."""
