"""Checks of generated code: `consistency` with finite differences, and in `products` whether it is up to date."""
