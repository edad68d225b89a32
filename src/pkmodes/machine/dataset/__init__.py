"""Results as datasets and tables: names, dimensions, units and descriptions."""
