"""What is checked of one mechanism alone: see `pkmodes.checking.consistency`."""
