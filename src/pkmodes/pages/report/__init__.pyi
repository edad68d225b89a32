from .map import map_report
from .measured_report import report
from .model_view import view_of, view_of_result
from .sources import Source

__all__ = ["Source", "map_report", "report", "view_of", "view_of_result"]
