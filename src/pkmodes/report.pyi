from pkmodes.pages.report import *
