"""What the package tells through ``logging.getLogger("mixity")``: INFO of each fit its data, models, statuses and seconds, DEBUG
its options, WARNING the notes of a data set. It adds no handler that would show anything."""

from __future__ import annotations

import sys
from typing import TYPE_CHECKING

if TYPE_CHECKING:
    import logging

# The levels of logging, which is imported by those who listen: it takes longer to import than the engine.
DEBUG, INFO, WARNING = 10, 20, 30

_logger: logging.Logger | None = None


def listening(level: int) -> logging.Logger | None:
    """The logger, where somebody may want to hear of this level."""
    global _logger
    if _logger is None:
        module = sys.modules.get("logging")
        if module is None:
            return None
        _logger = module.getLogger("mixity")
        _logger.addHandler(module.NullHandler())
    return _logger if _logger.isEnabledFor(level) else None
