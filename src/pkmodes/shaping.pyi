from pkmodes.machine.shaping import *
