"""The figures of a robot: `pictures` draws them, `write_pictures` writes them (docs/figures.md).

`response_picture` draws frequency responses, and measured ones from `read_response` over them (docs/response.md).
`tornado_picture` draws which quantities the frequencies depend on most (docs/sensitivities.md).
"""

from pkmodes.figures.files import write_pictures
from pkmodes.figures.pictures import Picture, pictures
from pkmodes.figures.response_picture import response_picture
from pkmodes.figures.tornado_picture import tornado_picture
from pkmodes.figures.working_plane import working_plane
from pkmodes.response.measured import read_response

__all__ = [
    "Picture",
    "pictures",
    "read_response",
    "response_picture",
    "tornado_picture",
    "working_plane",
    "write_pictures",
]
