"""``python -m pkmodes`` is the command line."""

from pkmodes.cli import main

main()
