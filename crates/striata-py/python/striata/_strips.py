"""Triangle strips."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass
from typing import Any

import numpy as np
from numpy.typing import ArrayLike, NDArray

from . import _striata
from ._any_mesh import mesh_data_of
from ._progress import Progress, reporting
from ._targets import count, number

#: Index that separates strips.
RESTART = -1


@dataclass(frozen=True)
class Strips:
    """Triangle strips in one list of indices."""

    #: Indices, with `RESTART` (-1) between strips; without, if they were stitched.
    indices: NDArray[np.int32]
    #: Number of strips.
    count: int

    def __iter__(self) -> Iterator[NDArray[np.int32]]:
        """Iterate over the strips, each an array of indices."""
        ends = np.flatnonzero(self.indices == RESTART)
        for part in np.split(self.indices, ends):
            strip = part[part != RESTART]
            if len(strip):
                yield strip

    def __len__(self) -> int:
        return self.count

    def __repr__(self) -> str:
        return f"<striata.Strips: {self.count:,} strips, {len(self.indices):,} indices>"


def strip(
    mesh: Any,
    faces: ArrayLike | None = None,
    *,
    method: str = "greedy",
    seed: int = 0,
    effort: float = 1.0,
    cache_weight: float = 0.0,
    cache_size: int = 16,
    stitched: bool = False,
    progress: Progress = False,
) -> Strips:
    """Cover each triangle by exactly one strip.

    Parameters
    ----------
    mesh : any mesh that `build` takes, or points
        The mesh.
    faces : array_like, optional
        Faces, if `mesh` is an array of points.
    method : {"greedy", "stripe", "stripe:global", "tunnel", "tunnel:N", "fewest", "cheapest"}
        "greedy" is fast, "fewest" searches for the fewest strips, "cheapest" for the fewest indices.
    seed : int
        Seed of the methods that make random choices.
    effort : float
        Duration of a search, as a factor.
    cache_weight : float
        Number of indices that one miss of the vertex cache is worth.
    cache_size : int
        Number of entries of that cache.
    stitched : bool
        Whether strips are joined by repeated indices instead of restarts.
    progress : bool or callable
        See `simplify`.

    Examples
    --------
    >>> import striata
    >>> strips = striata.strip(*striata.shapes.grid(4, 4))
    >>> sum(len(strip) - 2 for strip in strips) >= 32  # strips may repeat an index to turn
    True
    """
    data = mesh_data_of(mesh, faces)
    with reporting(progress) as callback:
        indices, strip_count = _striata.strip(
            data,
            method,
            count(seed, "seed"),
            number(effort, "effort"),
            number(cache_weight, "cache_weight"),
            count(cache_size, "cache_size"),
            stitched,
            callback,
        )
    return Strips(indices, strip_count)
