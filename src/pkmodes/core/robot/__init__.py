"""Robot files: units, schema, reading, and the resulting `Robot`."""
