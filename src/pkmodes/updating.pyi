from pkmodes.loop.updating import *
