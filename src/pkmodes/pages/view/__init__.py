"""The robot in three dimensions: a scene of its moving points, and a page that shows it (docs/how-to/view.md)."""

from pkmodes.pages.view.evaluating import scene
from pkmodes.pages.view.page import assets, fragment, page
from pkmodes.pages.view.poses import poses_around, typical_pose
from pkmodes.pages.view.scene import Scene
from pkmodes.pages.view.varying import varied

__all__ = ["Scene", "assets", "fragment", "page", "poses_around", "scene", "typical_pose", "varied"]
