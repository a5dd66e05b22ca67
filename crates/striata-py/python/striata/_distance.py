"""Distances between surfaces."""

from __future__ import annotations

from dataclasses import dataclass
from functools import cached_property
from typing import Any

import numpy as np
from numpy.typing import NDArray

from . import _striata
from ._any_mesh import input_of
from ._level import Level
from ._lod import Lod
from ._progress import Progress, reporting
from ._targets import count


@dataclass(frozen=True)
class OneSidedDistance:
    """Distances from points of one surface to another surface, in mesh units."""

    #: Maximum.
    max: float
    #: Root mean square over the area.
    rms: float
    #: Mean over the area.
    mean: float


@dataclass(frozen=True)
class Distance:
    """Distance between two surfaces, in mesh units."""

    #: From the first surface to the second.
    a_to_b: OneSidedDistance
    #: From the second surface to the first.
    b_to_a: OneSidedDistance
    #: Diagonal of the bounding box of the first mesh.
    diagonal: float
    #: Number of points measured.
    sample_count: int
    _meshes: tuple[_striata.MeshData, _striata.MeshData]

    @property
    def max(self) -> float:
        """Larger maximum of the two directions: the Hausdorff distance, as far as samples find it."""
        return max(self.a_to_b.max, self.b_to_a.max)

    @property
    def rms(self) -> float:
        """Larger root mean square of the two directions."""
        return max(self.a_to_b.rms, self.b_to_a.rms)

    @property
    def mean(self) -> float:
        """Larger mean of the two directions."""
        return max(self.a_to_b.mean, self.b_to_a.mean)

    @cached_property
    def of_vertices(self) -> NDArray[np.float64]:
        """Distance of each point of the first mesh to the surface of the second."""
        return _striata.vertex_distances(*self._meshes)

    def __repr__(self) -> str:
        return f"<striata.Distance: rms {self.rms:.3g}, max {self.max:.3g}, diagonal {self.diagonal:.3g}>"


def distance(a: Any, b: Any, *, samples: int = 500_000, seed: int = 0, progress: Progress = False) -> Distance:
    """Measure the distance between two surfaces by sampling, in both directions.

    Parameters
    ----------
    a, b : any mesh that `build` takes, a tuple of points and faces, Lod or Level
        The meshes.
    samples : int
        Number of points on each surface, besides all vertices.
    seed : int
        Offsets the samples.
    progress : bool or callable
        See `simplify`.

    Returns
    -------
    Distance
        With `rms`, `max`, `mean`, both directions, and `of_vertices`, the distance of each point of `a`.

    Examples
    --------
    >>> import striata
    >>> points, faces = striata.shapes.grid(4, 4)
    >>> lifted = points + [0, 0, 0.5]
    >>> d = striata.distance((points, faces), (lifted, faces), samples=1000)
    >>> d.rms, d.max
    (0.5, 0.5)
    >>> d.of_vertices[:3]
    array([0.5, 0.5, 0.5])
    """
    first, second = _pair(a, b)
    with reporting(progress) as callback:
        forward, backward, diagonal, sample_count = _striata.distance(
            first, second, count(samples, "samples"), count(seed, "seed"), callback
        )
    sides = OneSidedDistance(*forward), OneSidedDistance(*backward)
    return Distance(*sides, diagonal, sample_count, (first, second))


def _pair(a: Any, b: Any) -> tuple[_striata.MeshData, _striata.MeshData]:
    """Return both meshes relative to one origin, so that no digits are lost far away from it."""
    (first, offset), (second, other) = _placed(a), _placed(b)
    placed = first.moved(offset)
    return placed, second.moved(other).relative_to(placed)


def _placed(mesh: Any) -> tuple[_striata.MeshData, tuple[float, float, float]]:
    """Return a mesh and what must be added to its points."""
    if isinstance(mesh, Level):
        return mesh.lod._data.level_mesh(mesh.split_count), mesh.lod._offset
    if isinstance(mesh, Lod):
        return mesh._data.mesh(), mesh._offset
    found = input_of(mesh)
    return found.mesh_data()[0], found.points.offset
