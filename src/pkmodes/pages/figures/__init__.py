"""The figures of a robot: `pictures` draws them, `write_pictures` writes them (docs/how-to/figures.md).

`response_picture` draws frequency responses, and measured ones from `read_response` over them
(docs/how-to/response.md). `tornado_picture` draws which quantities the frequencies depend on most
(docs/how-to/sensitivities.md).
"""

from pkmodes.machine.response.measured import read_response
from pkmodes.pages.figures.files import write_pictures
from pkmodes.pages.figures.pictures import Picture, pictures
from pkmodes.pages.figures.response_picture import response_picture
from pkmodes.pages.figures.tornado_picture import tornado_picture
from pkmodes.pages.figures.working_plane import working_plane

__all__ = [
    "Picture",
    "pictures",
    "read_response",
    "response_picture",
    "tornado_picture",
    "working_plane",
    "write_pictures",
]
