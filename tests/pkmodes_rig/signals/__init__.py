"""Signals of the virtual test rig: what accelerometers on its machines record in a modal test.

From the top: `campaigns` writes folders that ``pkmodes identify`` reads; `visits` says in which state a machine is
when it is measured; `excitation`, `analyser`, `sensors` and `accelerometer_chip` are the laboratory's equipment; and
`small_motion` and `integration` the machine that moves.
"""
