"""The class `StripLevel`: strips that follow a level."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

import numpy as np
from numpy.typing import NDArray

from ._arrays import frozen
from ._display import counted
from ._level import Level

if TYPE_CHECKING:
    from ._lod import Lod


class StripLevel:
    """A level of a `Lod` as triangle strips that are edited in place when the level changes.

    Made by `Lod.strip_level`. The strips stay good strips at every level [RCRG06]_.

    Examples
    --------
    >>> import striata
    >>> lod = striata.build(*striata.shapes.terrain(40))
    >>> strips = lod.strip_level(lod.level(triangles=500))
    >>> strips.move_to(lod.level(triangles=400))
    >>> changed = strips.take_changed_ranges()  # what to copy to the index buffer of the graphics card
    >>> strips.index_count < 1.5 * strips.level.triangle_count
    True

    References
    ----------
    .. [RCRG06] F. Ramos, M. Chover, O. Ripolles and C. Granell, "Efficient implementation of LodStrips", 2006.
    """

    def __init__(self, lod: Lod[Any], level: Level[Any]) -> None:
        self.lod = lod
        self._data = lod._data.strip_level()
        self.move_to(level)

    def move_to(self, level: Level[Any]) -> None:
        """Show another level of the same `Lod`."""
        if level.lod is not self.lod:
            raise ValueError("the level belongs to another Lod")
        self._data.move_to(level.split_count)
        #: The level that is shown.
        self.level = level

    @property
    def indices(self) -> NDArray[np.int32]:
        """Index buffer into `Lod.points`, always of the same length, with -1 between strips.

        Draw the ranges of `groups`; what lies outside of them is room to grow.
        """
        return frozen(self._data.indices())

    @property
    def groups(self) -> list[tuple[int, int]]:
        """First index and end of each group (material) in `indices`."""
        return self._data.groups()

    def take_changed_ranges(self) -> list[tuple[int, int]]:
        """Return first index and end of the parts of `indices` that changed since the last call, ascending."""
        return self._data.take_changed_ranges()

    @property
    def strip_count(self) -> int:
        """Number of strips."""
        return self._data.counts()[0]

    @property
    def index_count(self) -> int:
        """Number of indices that the strips need, with one between two strips."""
        return self._data.counts()[1]

    def __repr__(self) -> str:
        shown = f"{counted(self.strip_count, 'strip')}, {counted(self.level.triangle_count, 'face')}"
        return f"<striata.StripLevel: {shown}>"
