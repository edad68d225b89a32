from . import diagnosis as diagnosis
from . import updating as updating
