"""Checks of generated code: `consistency` by finite differences, `products` for currency."""
