"""Clusters of all levels, for renderers that draw meshlets: the function `clusters`."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any

import numpy as np
from numpy.typing import ArrayLike, NDArray

from . import _striata
from ._any_mesh import mesh_data_of
from ._options import Boundary, Cost, Seams, Topology, options_of
from ._progress import Progress, reporting
from ._targets import count


@dataclass(frozen=True)
class Clusters:
    """Small groups of faces from which levels of detail are put together.

    A cluster is drawn if the simplified form of its group is not good enough, and that of the group that it refines is:
    see `cut`.
    """

    #: Faces of each cluster in turn, as indices of the points of the mesh, shape (n, 3).
    faces: NDArray[np.int32]
    #: First face and number of faces of each cluster, shape (c, 2).
    ranges: NDArray[np.int64]
    #: Group of each cluster.
    group: NDArray[np.int64]
    #: Group whose simplified form each cluster is part of; -1 at full detail.
    refines: NDArray[np.int64]
    #: Group of the mesh, with one material, that each cluster belongs to.
    mesh_group: NDArray[np.int64]
    #: Center and radius of a sphere around the points of each cluster, shape (c, 4).
    spheres: NDArray[np.float32]
    #: Number of times that the finest clusters of each group have been simplified.
    depth: NDArray[np.int64]
    #: Center and radius of the sphere of each group, shape (g, 4). It contains those of the groups that it is made of.
    group_spheres: NDArray[np.float32]
    #: Largest distance of the mesh from the simplified form of each group, an estimate; infinite for the last group,
    #: which has none.
    error: NDArray[np.float32]

    def __len__(self) -> int:
        return len(self.group)

    def __repr__(self) -> str:
        return f"<striata.Clusters: {len(self):,} clusters, {len(self.error):,} groups, {len(self.faces):,} faces>"

    def cut(self, good: ArrayLike | float) -> NDArray[np.int64]:
        """Return the clusters to draw.

        Parameters
        ----------
        good : float or array_like of bool
            Largest error, in units of the points; or whether the simplified form of each group is good enough. If it is,
            so must be those of the groups that it is made of, as when projected errors are compared with a limit.

        Examples
        --------
        >>> import striata
        >>> clusters = striata.clusters(*striata.shapes.torus(64, 32))
        >>> coarse = clusters.cut(0.05)
        >>> len(clusters.faces_of(coarse)) < 64 * 32
        True
        """
        is_good = np.asarray(good)
        if is_good.ndim == 0:
            is_good = self.error <= float(is_good)
        if is_good.shape != self.error.shape:
            raise ValueError(f"good has the shape {is_good.shape}, but there are {len(self.error)} groups")
        is_good = is_good.astype(bool) & np.isfinite(self.error)
        is_refined = (self.refines < 0) | is_good[self.refines]
        return np.flatnonzero(~is_good[self.group] & is_refined)

    def faces_of(self, clusters: ArrayLike) -> NDArray[np.int32]:
        """Return the faces of some clusters, in their order."""
        ranges = self.ranges[np.asarray(clusters, dtype=np.int64)]
        parts = [self.faces[first : first + number] for first, number in ranges.tolist()]
        return np.concatenate(parts) if parts else self.faces[:0]


def clusters(
    mesh: Any,
    faces: ArrayLike | None = None,
    *,
    max_triangles: int = 128,
    max_vertices: int = 255,
    group_size: int = 24,
    cost: Cost = "memoryless",
    boundary: Boundary = "keep",
    seams: Seams = "cross",
    topology: Topology = "change",
    height_field: bool | None = None,
    progress: Progress = False,
) -> Clusters:
    """Divide a mesh into clusters of all levels of detail, for renderers that draw meshlets.

    Neighboring clusters form groups, and each group is simplified to half of its faces, which are divided into clusters
    again. Borders of groups stay, so that any cut has no cracks. All clusters use the points of the mesh.

    Parameters
    ----------
    mesh : any mesh that `build` takes, or points
        The mesh.
    faces : array_like, optional
        Faces, if `mesh` is an array of points.
    max_triangles, max_vertices : int
        Largest numbers of faces (at least 2) and points (at least 6) of a cluster.
    group_size : int
        Number of clusters of a group, about; at least 2.
    cost, boundary, seams, topology, height_field
        See `simplify`.
    progress : bool or callable
        See `simplify`.

    Raises
    ------
    ValueError
        If the mesh is inconsistent or an option is out of range.

    Examples
    --------
    >>> import striata
    >>> clusters = striata.clusters(*striata.shapes.torus(64, 32))
    >>> len(clusters.faces_of(clusters.cut(0))) == 2 * 64 * 32
    True
    """
    data = mesh_data_of(mesh, faces)
    sizes = (
        count(max_triangles, "max_triangles"),
        count(max_vertices, "max_vertices"),
        count(group_size, "group_size"),
    )
    options = options_of(
        cost=cost, boundary=boundary, seams=seams, topology=topology, height_field=height_field
    )
    with reporting(progress) as callback:
        triangles, rows, spheres, depth, group_spheres, error = _striata.build_clusters(
            data, sizes, options, callback
        )
    return Clusters(
        faces=triangles,
        ranges=rows[:, :2],
        group=rows[:, 2],
        refines=rows[:, 3],
        mesh_group=rows[:, 4],
        spheres=spheres,
        depth=depth,
        group_spheres=group_spheres,
        error=error,
    )
