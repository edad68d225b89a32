"""From measured signals to modal measurements: the campaign file, its records, and their modes."""
