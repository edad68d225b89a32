"""The robot in three dimensions: a scene of its moving points, and a page that shows it (docs/view.md)."""

from pkmodes.view.evaluating import scene
from pkmodes.view.page import assets, fragment, page
from pkmodes.view.poses import poses_around, typical_pose
from pkmodes.view.scene import Scene
from pkmodes.view.varying import varied

__all__ = ["Scene", "assets", "fragment", "page", "poses_around", "scene", "typical_pose", "varied"]
