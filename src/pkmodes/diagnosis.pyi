from pkmodes.loop.diagnosis import *
