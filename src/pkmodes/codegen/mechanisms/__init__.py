"""Checks that apply to one mechanism only: see `pkmodes.codegen.checking.consistency`."""
