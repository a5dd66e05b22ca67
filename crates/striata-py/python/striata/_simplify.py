"""The function `simplify`: one coarser mesh."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any

import numpy as np
from numpy.typing import ArrayLike

from . import _striata
from ._arrays import AnyArray, indices_of
from ._inputs import Input, Result, input_of
from ._layers import Weights
from ._mesh import Mesh
from ._progress import Progress, reporting
from ._targets import Request, options_of, request_of


class Simplified(tuple[Any, ...]):
    """Result of `simplify` for arrays: unpacks to points and faces, and to attributes if some were passed.

    Attributes
    ----------
    points : ndarray, shape (k, 3)
        Points that remain, in the dtype of the input.
    faces : ndarray, shape (l, 3)
        Faces that remain, in the dtype of the input.
    attributes : dict of ndarray
        Attributes of the points that remain.
    vertices : ndarray of int32 or None
        Index of the input point that each point is; `None` with ``placement="optimal"``.
    face_origins : ndarray of int32 or None
        Index of the input face that each face comes from; `None` with ``placement="optimal"``.
    error : float
        Largest distance from the input, in mesh units: a bound with ``max_error``, otherwise an estimate.
    stop_reason : str
        ``"target_reached"``, ``"base_reached"`` (nothing is left to remove), ``"error_limit"`` or
        ``"full_mesh"``.
    """

    points: AnyArray
    faces: AnyArray
    attributes: dict[str, AnyArray]
    vertices: AnyArray | None
    face_origins: AnyArray | None
    error: float
    stop_reason: str

    @classmethod
    def _of(cls, result: Result, faces: AnyArray, facts: tuple[float, str], with_attributes: bool) -> Simplified:
        parts: tuple[Any, ...] = (result.points, faces)
        made = cls((*parts, result.attributes) if with_attributes else parts)
        made.points, made.faces, made.attributes = result.points, faces, result.attributes
        made.vertices, made.face_origins = result.vertices, result.origins
        made.error, made.stop_reason = facts
        return made


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
    placement: str = "subset",
    cost: str = "memoryless",
    boundary: str = "keep",
    seams: str = "cross",
    topology: str = "change",
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
        Guaranteed limit of the error: no point of the input is farther from the result. Takes longer.
    attributes : dict of array_like, optional
        Arrays of any dtype with a row per point. They follow the points that remain.
    weights : dict of float, or 0, optional
        How much a difference of 1 in an attribute costs, as a share of the diagonal. By default, normals,
        texture coordinates and colors count a little, other attributes not at all; 0 ignores all.
    placement : {"subset", "optimal"}
        Whether the points are a subset of the input's, or may lie anywhere (closer to the surface;
        attributes are interpolated).
    cost : {"memoryless", "accumulated", "tracked"}
        What orders the removals. "tracked" is slower, and the best for few triangles.
    boundary : {"keep", "lock"}
        Whether points on boundaries move along them, or stay.
    seams : {"cross", "keep"}
        Whether attributes that jump at a point may be smeared, at a cost, or block.
    topology : {"change", "keep_parts", "keep"}
        What may happen once no removal is left that keeps the topology.
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
    from ._scene import Scene

    targets = {
        "triangles": triangles,
        "vertices": vertices,
        "ratio": ratio,
        "error": error,
        "max_error": max_error,
        "target_reduction": target_reduction,
        "target_count": target_count,
    }
    options: dict[str, Any] = {"cost": cost, "boundary": boundary, "seams": seams, "topology": topology}
    options["pair_distance"] = pair_distance
    if placement not in ("subset", "optimal"):
        raise ValueError(f"placement is {placement!r}, but must be 'subset' or 'optimal'")
    if isinstance(mesh, Scene):
        return _simplify_scene(mesh, targets, options, progress)
    found = input_of(mesh, faces, attributes)
    data, found_weights = found.mesh_data(weights)
    request = request_of(targets, found.face_count, data.diagonal)
    options["weights"] = found_weights
    options["locked"] = indices_of(locked, len(found.points.original), "locked")
    with reporting(progress) as callback:
        if found.data is not None:
            made, _, _ = _freely(data, request, options_of(**options), placement == "optimal", callback)
            return Mesh._of(made)
        if placement == "optimal":
            result, facts = _placed(found, data, request, options_of(**options), callback)
        else:
            result, facts = _chosen(found, data, request, options_of(**options), callback)
    if found.rebuild is not None:
        return found.rebuild(result)
    return Simplified._of(result, found.faces.like_input(result.faces), facts, attributes is not None)


def _simplify_scene(scene: Any, targets: dict[str, Any], options: dict[str, Any], progress: Progress) -> Any:
    lods = scene.build(guaranteed=targets["max_error"] is not None, progress=progress, **options)
    return lods.level(**targets).to_scene()


def _chosen(
    found: Input, data: _striata.MeshData, request: Request, options: dict[str, Any], callback: Any
) -> tuple[Result, tuple[float, str]]:
    """Simplify to a subset of the points."""
    faces, kept, origins, error, reason = _striata.simplify(
        data, request.target, request.limit, request.guaranteed, options, callback
    )
    attributes = {name: values[kept] for name, values in found.attributes.items()}
    converted = faces.astype(found.faces.dtype, copy=False)
    return Result(found.points.original[kept], converted, kept, origins, attributes), (error, reason)


def _freely(
    data: _striata.MeshData, request: Request, options: dict[str, Any], optimal: bool, callback: Any
) -> tuple[_striata.MeshData, float, str]:
    return _striata.simplify_mesh(data, request.target, request.limit, optimal, options, callback)


def _placed(
    found: Input, data: _striata.MeshData, request: Request, options: dict[str, Any], callback: Any
) -> tuple[Result, tuple[float, str]]:
    """Simplify with points that may lie anywhere; attributes are interpolated."""
    for name, values in found.attributes.items():
        if values.dtype.kind not in "fiub":
            raise ValueError(f"attributes[{name!r}] has the dtype {values.dtype}: use placement='subset' to carry it")
    made, error, reason = _freely(data, request, options, True, callback)
    points = made.points().astype(found.points.original.dtype, copy=False)
    if found.points.offset != (0.0, 0.0, 0.0):
        points = points + np.array(found.points.offset)
    layers = iter(made.layers())
    attributes = {}
    for name, values in found.attributes.items():
        columns = values.size
        rows = next(layers)[4] if columns else np.empty((len(points), 0))
        if values.dtype.kind in "iub" and rows.dtype.kind == "f":
            rows = np.rint(rows)
        attributes[name] = rows.astype(values.dtype).reshape((len(points), *values.shape[1:]))
    faces = made.faces().astype(found.faces.dtype, copy=False)
    return Result(points, faces, None, None, attributes), (error, reason)
