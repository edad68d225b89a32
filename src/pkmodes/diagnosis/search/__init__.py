"""Which causes are tried, and which of them is enough."""
