"""Reports: one self-contained HTML page for a diagnosis or a comparison.

`report` makes the page; `Source` names an input file by its content.  docs/report.md says what a page contains.
`pkmodes.report.page.page` makes other pages from `pkmodes.report.blocks`.
"""

from pkmodes.report.making import report
from pkmodes.report.sources import Source

__all__ = ["Source", "report"]
