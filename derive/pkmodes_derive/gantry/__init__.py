"""Common parts of machines that belts move in the plane of x and y: CoreXY, Cartesian gantry, bed slinger.

`belts` declares two belts with their runs, motor pulleys and motors, `plane` the coordinates, the travel and the
conditions on both, `picture` what is drawn of them.  A mechanism says which bodies move, and what each belt pulls.
"""
