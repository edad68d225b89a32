from pkmodes.pages.figures import *
