"""What changed between states of one machine, of which one is trusted."""
