"""Reports: one self-contained HTML page for a diagnosis, a comparison or a map.

`report` and `map_report` make the page; `view_of_result` and `view_of` the view in three dimensions inside it;
`Source` names an input file by its content.  docs/report.md says what a page contains.  `pkmodes.report.page.page`
makes other pages from `pkmodes.report.blocks`.
"""

from pkmodes.report.map import map_report
from pkmodes.report.measured_report import report
from pkmodes.report.model_view import view_of, view_of_result
from pkmodes.report.sources import Source

__all__ = ["Source", "map_report", "report", "view_of", "view_of_result"]
