"""The version of pkmodes."""

VERSION = "0.1.0"
