from pkmodes.pages.view import *
