"""Robot files: units, schema, reading, and the `Robot` that comes out."""
