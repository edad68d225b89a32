"""Checks that apply to one mechanism only: see `pkmodes.checking.consistency`."""
