"""From fits to a verdict."""
