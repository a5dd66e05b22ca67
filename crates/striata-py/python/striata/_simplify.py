"""The function `simplify`: one coarser mesh.

Each overload lists all options, because stubtest does not understand them as one `Unpack` of a `TypedDict`.
"""

from __future__ import annotations

import functools
import os
from collections.abc import Callable, Mapping
from typing import Any, TypeVar, overload

from numpy.typing import ArrayLike

from ._any_mesh import input_of
from ._arrays import indices_of
from ._kinds import MeshObject
from ._layers import Weights
from ._mesh import Mesh
from ._one_level import level_of_subset, level_placed_freely, simplified_mesh
from ._options import Boundary, Cost, Placement, Seams, Topology, check_scene_arguments, options_of
from ._progress import Progress, reporting
from ._scene import Scene
from ._simplified import Simplified
from ._targets import Targets

#: Type of a mesh that comes back as the same type.
SomeMesh = TypeVar("SomeMesh", bound=MeshObject | Scene)


def _advice(target: Any) -> str:
    """Say how a target is written that was passed by position, as other packages take it."""
    problem = "the target of simplify has a name"
    if isinstance(target, float) and 0.0 < target < 1.0:
        return (
            f"{problem}: target_reduction={target} removes that share of the faces, as the third argument of "
            f"fast_simplification.simplify does (the same as ratio={1.0 - target:.6g}); ratio={target} keeps it"
        )
    triangles = target if isinstance(target, int) else 5000
    return f"{problem}: triangles={triangles}, ratio=0.1, error='0.1%', ..."


def _with_advice(function: Callable[..., Any]) -> Callable[..., Any]:
    """Explain targets that are passed by position, which Python would only count."""

    @functools.wraps(function)
    def checked(*arguments: Any, **options: Any) -> Any:
        if len(arguments) > 2:
            raise TypeError(_advice(arguments[2]))
        return function(*arguments, **options)

    return checked


@overload
def simplify(
    mesh: ArrayLike,
    faces: ArrayLike,
    *,
    triangles: int | None = None,
    vertices: int | None = None,
    ratio: float | None = None,
    error: float | str | None = None,
    max_error: float | str | None = None,
    target_reduction: float | None = None,
    target_count: int | None = None,
    attributes: Mapping[str, ArrayLike] | None = None,
    weights: Weights = None,
    placement: Placement = "subset",
    cost: Cost = "memoryless",
    boundary: Boundary = "keep",
    seams: Seams = "cross",
    topology: Topology = "change",
    height_field: bool | None = None,
    locked: ArrayLike | None = None,
    pair_distance: float | None = None,
    progress: Progress = False,
) -> Simplified: ...
@overload
def simplify(
    mesh: SomeMesh,
    faces: None = None,
    *,
    triangles: int | None = None,
    vertices: int | None = None,
    ratio: float | None = None,
    error: float | str | None = None,
    max_error: float | str | None = None,
    target_reduction: float | None = None,
    target_count: int | None = None,
    attributes: Mapping[str, ArrayLike] | None = None,
    weights: Weights = None,
    placement: Placement = "subset",
    cost: Cost = "memoryless",
    boundary: Boundary = "keep",
    seams: Seams = "cross",
    topology: Topology = "change",
    height_field: bool | None = None,
    locked: ArrayLike | None = None,
    pair_distance: float | None = None,
    progress: Progress = False,
) -> SomeMesh: ...
@overload
def simplify(
    mesh: tuple[ArrayLike, ArrayLike],
    faces: None = None,
    *,
    triangles: int | None = None,
    vertices: int | None = None,
    ratio: float | None = None,
    error: float | str | None = None,
    max_error: float | str | None = None,
    target_reduction: float | None = None,
    target_count: int | None = None,
    attributes: Mapping[str, ArrayLike] | None = None,
    weights: Weights = None,
    placement: Placement = "subset",
    cost: Cost = "memoryless",
    boundary: Boundary = "keep",
    seams: Seams = "cross",
    topology: Topology = "change",
    height_field: bool | None = None,
    locked: ArrayLike | None = None,
    pair_distance: float | None = None,
    progress: Progress = False,
) -> Simplified: ...
@overload
def simplify(
    mesh: str | os.PathLike[str],
    faces: None = None,
    *,
    triangles: int | None = None,
    vertices: int | None = None,
    ratio: float | None = None,
    error: float | str | None = None,
    max_error: float | str | None = None,
    target_reduction: float | None = None,
    target_count: int | None = None,
    attributes: Mapping[str, ArrayLike] | None = None,
    weights: Weights = None,
    placement: Placement = "subset",
    cost: Cost = "memoryless",
    boundary: Boundary = "keep",
    seams: Seams = "cross",
    topology: Topology = "change",
    height_field: bool | None = None,
    locked: ArrayLike | None = None,
    pair_distance: float | None = None,
    progress: Progress = False,
) -> Mesh: ...
@_with_advice
def simplify(
    mesh: Any,
    faces: ArrayLike | None = None,
    *,
    triangles: int | None = None,
    vertices: int | None = None,
    ratio: float | None = None,
    error: float | str | None = None,
    max_error: float | str | None = None,
    target_reduction: float | None = None,
    target_count: int | None = None,
    attributes: Mapping[str, ArrayLike] | None = None,
    weights: Weights = None,
    placement: Placement = "subset",
    cost: Cost = "memoryless",
    boundary: Boundary = "keep",
    seams: Seams = "cross",
    topology: Topology = "change",
    height_field: bool | None = None,
    locked: ArrayLike | None = None,
    pair_distance: float | None = None,
    progress: Progress = False,
) -> Any:
    """Simplify a mesh to one level of detail.

    Exactly one target is needed, besides `max_error`. The input is never changed.

    Parameters
    ----------
    mesh : array_like, shape (n, 3), or a mesh
        Points; or a mesh of trimesh, PyVista, Open3D, meshio or striata, or a file name. Scenes of
        `striata.open` are simplified as a whole.
    faces : array_like, shape (m, 3), optional
        Indices of points; also flat as ``[3, a, b, c, 3, ...]``. Needed if `mesh` is an array.
    triangles, target_count : int, optional
        Largest number of faces.
    vertices : int, optional
        Largest number of points.
    ratio : float, optional
        Share of the faces to keep.
    target_reduction : float, optional
        Share of the faces to remove.
    error : float or str, optional
        Largest error, estimated, in mesh units or as text such as ``"0.1%"`` of the diagonal.
    max_error : float or str, optional
        Guaranteed limit of the error: no point of the input is farther from the result. Takes longer. With
        ``placement="optimal"``, a limit of the measured error instead.
    attributes : dict of array_like, optional
        Arrays of any dtype with a row per point. They follow the points that remain.
    weights : dict of float, or 0, optional
        How much a difference of 1 in an attribute costs, as a share of the diagonal. By default, normals,
        texture coordinates and colors count a little, other attributes not at all; 0 ignores all.
    placement : {"subset", "optimal"}
        Whether the points are a subset of the input's, or are moved so that the surface is closest to the
        original; attributes are fitted too. About half the error.
    cost : {"memoryless", "accumulated", "tracked"}
        What orders the removals. "tracked" is slower, and the best for few triangles.
    boundary : {"keep", "lock"}
        Whether points on boundaries move along them, or stay.
    seams : {"cross", "keep"}
        Whether attributes that jump at a point may be smeared, at a cost, or block.
    topology : {"change", "keep_parts", "keep"}
        What may happen once no removal is left that keeps the topology.
    height_field : bool, optional
        Whether no face may turn over in plan, seen along the z axis; by default if the mesh has a georeference, as
        rasters of heights do.
    locked : array_like of int or bool, optional
        Points that must stay, as indices or as a mask.
    pair_distance : float, optional
        Also joins points without a common edge that are closer than this, in mesh units.
    progress : bool or callable
        ``True`` shows a bar (with tqdm, if installed). A callable gets phase, work done and all work.

    Returns
    -------
    Simplified or a mesh
        For arrays, a tuple of points and faces, and attributes if any were passed. Otherwise a mesh of the
        type that was passed in, with everything that was attached to its points and faces.

    Raises
    ------
    ValueError
        If an array or an argument is invalid; the message names the place.
    OSError
        If a file cannot be read.

    Examples
    --------
    >>> import numpy as np, striata
    >>> points, faces = striata.shapes.terrain(40)
    >>> small_points, small_faces = striata.simplify(points, faces, ratio=0.1)
    >>> len(small_faces) <= 0.1 * len(faces)
    True

    Point data follow, and further results are attributes of the tuple:

    >>> label = np.arange(len(points))
    >>> small = striata.simplify(points, faces, triangles=200, attributes={"label": label})
    >>> bool((small.attributes["label"] == small.vertices).all())
    True
    """
    if placement not in ("subset", "optimal"):
        raise ValueError(f"placement is {placement!r}, but must be 'subset' or 'optimal'")
    targets = Targets(
        triangles=triangles,
        vertices=vertices,
        ratio=ratio,
        error=error,
        max_error=max_error,
        target_reduction=target_reduction,
        target_count=target_count,
    )
    if isinstance(mesh, Scene):
        free = None if placement == "subset" else placement
        check_scene_arguments(faces=faces, attributes=attributes, locked=locked, placement=free)
        lods = mesh.build(
            guaranteed=max_error is not None,
            weights=weights,
            cost=cost,
            boundary=boundary,
            seams=seams,
            topology=topology,
            height_field=height_field,
            pair_distance=pair_distance,
            progress=progress,
        )
        return lods.level(**vars(targets)).to_scene()
    found = input_of(mesh, faces, attributes)
    data, found_weights = found.mesh_data(weights)
    options = options_of(
        cost=cost,
        boundary=boundary,
        seams=seams,
        topology=topology,
        height_field=height_field,
        pair_distance=pair_distance,
        locked=indices_of(locked, len(found.points.original), "locked"),
        weights=found_weights,
    )
    request = targets.request(found.face_count, data.diagonal)
    with reporting(progress) as callback:
        if found.data is not None:
            made, _, _ = simplified_mesh(data, request, options, placement, callback)
            return Mesh._of(made)
        one_level = level_of_subset if placement == "subset" else level_placed_freely
        result, facts = one_level(found, data, request, options, callback)
    if found.rebuild is not None:
        return found.rebuild(result)
    return Simplified._of(result, found.faces.like_input(result.faces), facts, attributes is not None)
