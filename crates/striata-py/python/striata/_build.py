"""The function `build`: every level of detail at once. Its overloads are those of `simplify`."""

from __future__ import annotations

import os
from collections.abc import Mapping
from typing import Any, TypeVar, overload

from numpy.typing import ArrayLike

from . import _striata
from ._any_mesh import input_of
from ._arrays import indices_of
from ._kinds import Arrays, MeshObject
from ._layers import Weights
from ._lod import Lod
from ._mesh import Mesh
from ._options import Boundary, Cost, Seams, Topology, check_scene_arguments, options_of
from ._progress import Progress, reporting
from ._scene import LodScene, Scene

#: Type of a mesh whose levels come back as the same type.
SomeMesh = TypeVar("SomeMesh", bound=MeshObject)


@overload
def build(
    mesh: ArrayLike,
    faces: ArrayLike,
    *,
    guaranteed: bool = False,
    attributes: Mapping[str, ArrayLike] | None = None,
    weights: Weights = None,
    cost: Cost = "memoryless",
    boundary: Boundary = "keep",
    seams: Seams = "cross",
    topology: Topology = "change",
    height_field: bool | None = None,
    locked: ArrayLike | None = None,
    pair_distance: float | None = None,
    coarsest: int = 0,
    progress: Progress = False,
) -> Lod[Arrays]: ...
@overload
def build(
    mesh: SomeMesh,
    faces: None = None,
    *,
    guaranteed: bool = False,
    attributes: Mapping[str, ArrayLike] | None = None,
    weights: Weights = None,
    cost: Cost = "memoryless",
    boundary: Boundary = "keep",
    seams: Seams = "cross",
    topology: Topology = "change",
    height_field: bool | None = None,
    locked: ArrayLike | None = None,
    pair_distance: float | None = None,
    coarsest: int = 0,
    progress: Progress = False,
) -> Lod[SomeMesh]: ...
@overload
def build(
    mesh: tuple[ArrayLike, ArrayLike],
    faces: None = None,
    *,
    guaranteed: bool = False,
    attributes: Mapping[str, ArrayLike] | None = None,
    weights: Weights = None,
    cost: Cost = "memoryless",
    boundary: Boundary = "keep",
    seams: Seams = "cross",
    topology: Topology = "change",
    height_field: bool | None = None,
    locked: ArrayLike | None = None,
    pair_distance: float | None = None,
    coarsest: int = 0,
    progress: Progress = False,
) -> Lod[Arrays]: ...
@overload
def build(
    mesh: str | os.PathLike[str],
    faces: None = None,
    *,
    guaranteed: bool = False,
    attributes: Mapping[str, ArrayLike] | None = None,
    weights: Weights = None,
    cost: Cost = "memoryless",
    boundary: Boundary = "keep",
    seams: Seams = "cross",
    topology: Topology = "change",
    height_field: bool | None = None,
    locked: ArrayLike | None = None,
    pair_distance: float | None = None,
    coarsest: int = 0,
    progress: Progress = False,
) -> Lod[Mesh]: ...
@overload
def build(
    mesh: Scene,
    faces: None = None,
    *,
    guaranteed: bool = False,
    attributes: Mapping[str, ArrayLike] | None = None,
    weights: Weights = None,
    cost: Cost = "memoryless",
    boundary: Boundary = "keep",
    seams: Seams = "cross",
    topology: Topology = "change",
    height_field: bool | None = None,
    locked: ArrayLike | None = None,
    pair_distance: float | None = None,
    coarsest: int = 0,
    progress: Progress = False,
) -> LodScene: ...
def build(
    mesh: Any,
    faces: ArrayLike | None = None,
    *,
    guaranteed: bool = False,
    attributes: Mapping[str, ArrayLike] | None = None,
    weights: Weights = None,
    cost: Cost = "memoryless",
    boundary: Boundary = "keep",
    seams: Seams = "cross",
    topology: Topology = "change",
    height_field: bool | None = None,
    locked: ArrayLike | None = None,
    pair_distance: float | None = None,
    coarsest: int = 0,
    progress: Progress = False,
) -> Any:
    """Build every level of detail of a mesh.

    Takes little longer than one level by `simplify`, and returns all of them.

    Parameters
    ----------
    mesh : array_like, shape (n, 3), or a mesh
        Points; or a mesh of trimesh, PyVista, Open3D, meshio or striata, a scene of striata, or a file name.
    faces : array_like, shape (m, 3), optional
        Indices of points; also flat as ``[3, a, b, c, 3, ...]``. Needed if `mesh` is an array.
    guaranteed : bool
        Whether errors of all levels and views are bounds that hold everywhere. Takes several times longer.
    coarsest : int
        Number of faces at which to stop; by default as few as possible.
    attributes, weights, cost, boundary, seams, topology, height_field, locked, pair_distance, progress
        See `simplify`.

    Returns
    -------
    Lod
        All levels; a `LodScene` if a scene was passed.

    Examples
    --------
    >>> import striata
    >>> points, faces = striata.shapes.terrain(30)
    >>> lod = striata.build(points, faces, guaranteed=True)
    >>> level = lod.level(max_error="1%")
    >>> level.error <= 0.01 * lod.diagonal
    True
    """
    if isinstance(mesh, Scene):
        check_scene_arguments(faces=faces, attributes=attributes, locked=locked)
        return mesh.build(
            guaranteed=guaranteed,
            weights=weights,
            cost=cost,
            boundary=boundary,
            seams=seams,
            topology=topology,
            height_field=height_field,
            pair_distance=pair_distance,
            coarsest=coarsest,
            progress=progress,
        )
    found = input_of(mesh, faces, attributes)
    data, found_weights = found.mesh_data(weights)
    options = options_of(
        cost=cost,
        boundary=boundary,
        seams=seams,
        topology=topology,
        height_field=height_field,
        pair_distance=pair_distance,
        coarsest=coarsest,
        locked=indices_of(locked, len(found.points.original), "locked"),
        weights=found_weights,
    )
    with reporting(progress) as callback:
        return Lod._of(_striata.build(data, guaranteed, options, callback), found)
