"""Warnings that point to the line of the user."""

from __future__ import annotations

import sys
import warnings
from types import FrameType


class ReadWarning(UserWarning):
    """Something was left out of a file that was read, or repaired: once for each kind, with count and first place."""


def warn(text: str, category: type[Warning] = UserWarning) -> None:
    """Issue a warning at the line that called this package."""
    level = 1
    frame: FrameType | None = sys._getframe()
    while frame is not None and str(frame.f_globals.get("__name__")).split(".")[0] == "striata":
        frame, level = frame.f_back, level + 1
    warnings.warn(text, category, stacklevel=level)
