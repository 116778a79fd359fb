"""Messages to ``logging.getLogger("mixity")``: for each fit data, models, statuses and seconds at INFO, options at DEBUG; the
notes of a data set at WARNING. The package adds no handler."""

from __future__ import annotations

import sys
from typing import TYPE_CHECKING

if TYPE_CHECKING:
    import logging

# The levels of logging, which is not imported here because that takes longer than importing the engine.
DEBUG, INFO, WARNING = 10, 20, 30

_logger: logging.Logger | None = None


def listening(level: int) -> logging.Logger | None:
    """The logger, if it is enabled for this level; else None."""
    global _logger
    if _logger is None:
        module = sys.modules.get("logging")
        if module is None:
            return None
        _logger = module.getLogger("mixity")
        _logger.addHandler(module.NullHandler())
    return _logger if _logger.isEnabledFor(level) else None
