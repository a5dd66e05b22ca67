"""Every level of detail of a mesh: `build`, `Lod`, `Level` and `View`."""

from __future__ import annotations

import os
from collections.abc import Mapping, Sequence as Sequence_
from dataclasses import dataclass
from functools import cached_property
from typing import Any, TypeVar

import numpy as np
from numpy.typing import ArrayLike, NDArray

from . import _striata
from ._arrays import AnyArray, indices_of
from ._inputs import Input, Result, input_of
from ._layers import Weights
from ._mesh import Mesh, counted
from ._progress import Progress, reporting
from ._targets import length, number, options_of, request_of

Frozen = TypeVar("Frozen", bound=AnyArray)


@dataclass(frozen=True)
class Sequence:
    """The collapses of a `Lod`, in the order in which they coarsen the mesh.

    Each array has an entry per removed point. Points are indices into the input of `build`; into
    `Lod.points`, if the levels were opened from a file. Points that share a position but not their attributes
    are removed together, in one step.
    """

    #: Point that is removed.
    removed: NDArray[np.int32]
    #: Point that takes its place.
    target: NDArray[np.int32]
    #: Error of the mesh after the step, in mesh units; never falling.
    error: NDArray[np.float32]
    #: Number of faces after the step.
    faces: NDArray[np.int32]
    #: Number of the step, from 0.
    step: NDArray[np.int32]

    def __len__(self) -> int:
        return len(self.removed)


class Lod:
    """Every level of detail of one mesh, over a single array of points.

    Made by `build`, `open` and `decode`. Points are in refinement order, so each level uses the first
    points only. Immutable; safe to use from several threads.

    Examples
    --------
    >>> import striata
    >>> points, faces = striata.shapes.torus(64, 32)
    >>> lod = striata.build(points, faces)
    >>> lod
    <striata.Lod: 2,048 points, 4,096 faces, ...>
    >>> level = lod.level(triangles=500)
    >>> 490 < len(level.faces) <= 500
    True
    >>> bool(level.faces.max() < level.vertex_count)
    True
    """

    def __init__(self, *arguments: Any) -> None:
        raise TypeError("a Lod is made by striata.build, striata.open or striata.decode")

    _data: _striata.LodData
    _input: Input | None

    @classmethod
    def _of(cls, data: _striata.LodData, found: Input | None = None) -> Lod:
        lod = cls.__new__(cls)
        lod._data, lod._input = data, found
        return lod

    @cached_property
    def points(self) -> AnyArray:
        """Points of all levels in refinement order, shape (k, 3), in the dtype of the input."""
        if self._input is None or self._input.data is not None:
            return _frozen(self._data.points())
        return _frozen(self._input.points.original[self.vertices])

    @cached_property
    def vertices(self) -> NDArray[np.int32]:
        """Input point of each point. Counts from 0 if the levels were opened from a file."""
        vertices = self._data.vertices()
        return _frozen(np.arange(len(self._data.points()), dtype=np.int32) if vertices is None else vertices)

    @cached_property
    def attributes(self) -> dict[str, AnyArray]:
        """Attributes of all points, in refinement order."""
        if self._input is None or self._input.data is not None:
            return self.mesh().attributes
        return {name: _frozen(values[self.vertices]) for name, values in self._input.attributes.items()}

    @cached_property
    def sequence(self) -> Sequence:
        """The collapses, for analysis and training."""
        removed, target, step, error, faces = self._data.sequence()
        removed, target = self.vertices[removed], self.vertices[target]
        return Sequence(_frozen(removed), _frozen(target), _frozen(error), _frozen(faces), _frozen(step))

    @property
    def step_count(self) -> int:
        """Number of vertex splits from the coarsest level to the full mesh."""
        return self._data.step_count

    @property
    def face_count(self) -> int:
        """Number of faces of the full mesh."""
        return self._data.level_facts(self.step_count)[0]

    @property
    def point_count(self) -> int:
        """Number of points of the full mesh."""
        return self._data.level_facts(self.step_count)[1]

    @property
    def has_guaranteed_errors(self) -> bool:
        """Whether errors are bounds that hold at every point of the surface, rather than estimates."""
        return self._data.has_guaranteed_errors

    @cached_property
    def diagonal(self) -> float:
        """Length of the diagonal of the bounding box, in mesh units."""
        return self._data.mesh().diagonal

    def level(
        self,
        *,
        triangles: int | None = None,
        vertices: int | None = None,
        ratio: float | None = None,
        detail: float | None = None,
        error: float | str | None = None,
        max_error: float | str | None = None,
        target_reduction: float | None = None,
        target_count: int | None = None,
    ) -> Level:
        """Return the most detailed level that does not exceed a target.

        Parameters
        ----------
        triangles, target_count : int, optional
            Largest number of faces.
        vertices : int, optional
            Largest number of points.
        ratio, target_reduction : float, optional
            Share of the faces to keep, or to remove.
        detail : float, optional
            Share of the vertex splits that are applied: 0 is the coarsest level, 1 the full mesh.
        error : float or str, optional
            Largest error, in mesh units or as text such as ``"0.1%"`` of the diagonal: the coarsest level
            within it.
        max_error : float or str, optional
            Like `error`, and a guarantee; only for levels built with ``guaranteed=True``.

        Returns
        -------
        Level
            The level; out of range, the coarsest level or the full mesh.
        """
        arguments = {
            "triangles": triangles,
            "vertices": vertices,
            "ratio": ratio,
            "detail": detail,
            "error": error,
            "max_error": max_error,
            "target_reduction": target_reduction,
            "target_count": target_count,
        }
        request = request_of(arguments, self.face_count, self.diagonal)
        if request.guaranteed and not self.has_guaranteed_errors:
            raise ValueError("max_error needs levels with guaranteed errors: build them with guaranteed=True")
        split_count, reason = self._data.resolve(request.target)
        if request.limit is not None:
            nearest, _ = self._data.resolve(("error", request.limit))
            if nearest > split_count:
                split_count, reason = nearest, "error_limit"
        return Level(self, split_count, reason)

    def levels(self, ratios: Sequence_[float]) -> list[Level]:
        """Return a level for each share of the faces.

        Examples
        --------
        >>> import striata
        >>> lod = striata.build(*striata.shapes.terrain(20))
        >>> len(lod.levels([1.0, 0.5, 0.1]))
        3
        """
        return [self.level(ratio=ratio) for ratio in ratios]

    def fine_to_coarse(self, level: Level | int) -> NDArray[np.int32]:
        """Return the point that represents each input point at a level.

        Parameters
        ----------
        level : Level or int
            A level of this `Lod`, or its number of vertex splits.

        Returns
        -------
        ndarray of int32
            For each input point, an index into the input; -1 for points whose position no face uses.
            Any array that belongs to the points of a level, such as a prediction of a network, goes back to
            the full mesh by this index.
        """
        split_count = level.split_count if isinstance(level, Level) else int(level)
        representative = self._data.representative(split_count)
        vertex_of_input = self._data.vertex_of_input()
        if vertex_of_input is None:
            return representative
        coarse = np.full(len(vertex_of_input), -1, dtype=np.int32)
        used = vertex_of_input >= 0
        coarse[used] = self.vertices[representative[vertex_of_input[used]]]
        return coarse

    def view(self) -> View:
        """Return an instance that follows a camera."""
        return View(self)

    def mesh(self) -> Mesh:
        """Return the full mesh, with its points in refinement order."""
        return Mesh._of(self._placed())

    def save(self, path: str | os.PathLike[str]) -> None:
        """Write all levels to a ``.striata`` or ``.stri`` file; see `striata.save`."""
        from ._files import save

        save(path, self)

    def _placed(self, split_count: int | None = None) -> _striata.MeshData:
        """Return a level (or the full mesh) for the extension, in the coordinates of the user."""
        data = self._data.mesh() if split_count is None else self._data.level_mesh(split_count)
        offset = self._offset()
        return data if offset == (0.0, 0.0, 0.0) else data.moved(offset)

    def _offset(self) -> tuple[float, float, float]:
        return (0.0, 0.0, 0.0) if self._input is None else self._input.points.offset

    def __repr__(self) -> str:
        counts = f"{counted(self.point_count, 'point')}, {counted(self.face_count, 'face')}"
        base = counted(self._data.level_facts(0)[0], "face")
        return f"<striata.Lod: {counts}, {counted(self.step_count + 1, 'level')} down to {base}>"

    def _repr_html_(self) -> str:
        from ._viewer import html_of_lod

        return html_of_lod(self)


class Level:
    """One uniform level of a `Lod`; made by `Lod.level`."""

    def __init__(self, lod: Lod, split_count: int, stop_reason: str) -> None:
        self.lod = lod
        #: Number of vertex splits between the coarsest level and this one.
        self.split_count = split_count
        #: How well the target is met: ``"target_reached"``, ``"base_reached"``, ``"error_limit"`` or
        #: ``"full_mesh"``.
        self.stop_reason = stop_reason
        facts = lod._data.level_facts(split_count)
        #: Number of faces.
        self.triangle_count: int = facts[0]
        #: Number of points, counted from the start of `Lod.points`.
        self.vertex_count: int = facts[1]
        #: Largest distance from the full mesh, in mesh units.
        self.error: float = facts[2]

    @property
    def points(self) -> AnyArray:
        """The first `vertex_count` points of `Lod.points`: a view, not a copy."""
        points: AnyArray = self.lod.points[: self.vertex_count]
        return points

    @cached_property
    def _faces(self) -> tuple[AnyArray, NDArray[np.int32]]:
        faces, origins = self.lod._data.level_faces(self.split_count)
        if self.lod._input is None:
            return _frozen(faces), _frozen(origins)
        return _frozen(faces.astype(self.lod._input.faces.dtype, copy=False)), _frozen(origins)

    @property
    def faces(self) -> AnyArray:
        """Faces, shape (l, 3), as indices into `points`, in the dtype of the input."""
        return self._faces[0]

    @property
    def face_origins(self) -> NDArray[np.int32]:
        """Input face that each face comes from."""
        return self._faces[1]

    @cached_property
    def strips(self) -> NDArray[np.int32]:
        """Triangle strips as one list of indices into `points`, with -1 between strips."""
        return _frozen(self.lod._data.level_strips(self.split_count))

    @cached_property
    def vertices(self) -> NDArray[np.int32]:
        """Input points that the faces use, ascending: the points of `to_mesh`."""
        return _frozen(np.unique(self.lod.vertices[self.faces]).astype(np.int32))

    def to_mesh(self) -> Any:
        """Return the level as a mesh of the type that `build` got, with only the points that it uses.

        Arrays give a tuple of points and faces, files and streams a `Mesh`.
        """
        found = self.lod._input
        if found is None or found.data is not None:
            return Mesh._of(self.lod._data.level_mesh(self.split_count))
        result = self._result(found)
        if found.rebuild is None:
            return result.points, found.faces.like_input(result.faces)
        return found.rebuild(result)

    def attributes(self) -> dict[str, AnyArray]:
        """Return the attributes of the points of `to_mesh`."""
        found = self.lod._input
        if found is None or found.data is not None:
            return Mesh._of(self.lod._data.level_mesh(self.split_count)).attributes
        return self._result(found).attributes

    def _result(self, found: Input) -> Result:
        kept = self.vertices
        index = np.empty(len(found.points.original), dtype=found.faces.dtype)
        index[kept] = np.arange(len(kept), dtype=found.faces.dtype)
        faces = index[self.lod.vertices[self.faces]].reshape(-1, 3)
        attributes = {name: values[kept] for name, values in found.attributes.items()}
        return Result(found.points.original[kept], faces, kept, self.face_origins, attributes)

    def save(self, path: str | os.PathLike[str]) -> None:
        """Write the level as a mesh; see `striata.save`."""
        from ._files import save

        save(path, Mesh._of(self.lod._placed(self.split_count)))

    def __repr__(self) -> str:
        counts = f"{counted(self.triangle_count, 'face')}, {counted(self.vertex_count, 'point')}"
        return f"<striata.Level: {counts}, error {self.error:.3g}>"

    def _repr_html_(self) -> str:
        from ._viewer import html_of_level

        return html_of_level(self)


class View:
    """An instance of a `Lod` that follows a camera from frame to frame.

    Parameters
    ----------
    lod : Lod
        The levels; any number of views can share them.

    Examples
    --------
    >>> import striata
    >>> lod = striata.build(*striata.shapes.terrain(40))
    >>> view = lod.view()
    >>> view.update(eye=(0.5, -1, 1), target=(0.5, 0.5, 0), pixels=2.0)
    >>> 0 < len(view.faces) <= lod.face_count
    True
    """

    def __init__(self, lod: Lod) -> None:
        self.lod = lod
        self._data = lod._data.view()
        self._faces: AnyArray | None = None

    def update(
        self,
        *,
        eye: ArrayLike,
        target: ArrayLike,
        up: ArrayLike = (0.0, 0.0, 1.0),
        fov: float = 60.0,
        screen: tuple[int, int] = (1920, 1080),
        pixels: float = 1.0,
        budget: int | None = None,
    ) -> None:
        """Refine what the camera sees, and coarsen the rest.

        Parameters
        ----------
        eye, target, up : array_like, shape (3,)
            Position of the camera, the point it looks at, and the direction that is upward on its screen.
            If `up` is parallel to the view, another direction is chosen.
        fov : float
            Vertical angle of view, in degrees.
        screen : tuple of int
            Width and height of the screen, in pixels.
        pixels : float
            Largest error on the screen, in pixels.
        budget : int, optional
            Largest number of faces, spent where the error is most visible.
        """
        offset = self.lod._offset()
        from_eye = _vector(eye, "eye", offset)
        to_target = _vector(target, "target", offset)
        limit = number(pixels, "pixels")
        if limit < 0:
            raise ValueError(f"pixels is {limit}, but must be at least 0")
        angle = number(fov, "fov")
        if not 0 < angle < 180:
            raise ValueError(f"fov is {angle}, but must be an angle between 0 and 180 degrees")
        width, height = (int(side) for side in screen)
        if not (0 < width < 2**31 and 0 < height < 2**31):
            raise ValueError(f"screen is {screen}, but must be a width and a height in pixels")
        upward = _upward(np.subtract(to_target, from_eye), np.asarray(_vector(up, "up", (0.0, 0.0, 0.0))))
        if budget is not None:
            budget = int(length(budget, 0.0, "budget"))
        tangent = float(np.tan(np.radians(angle) / 2))
        self._data.update(from_eye, to_target, upward, tangent, (width, height), limit, budget)
        self._faces = None

    @property
    def faces(self) -> AnyArray:
        """Faces shown, shape (l, 3), as indices into `Lod.points`."""
        if self._faces is None:
            faces = self._data.faces()
            if self.lod._input is not None:
                faces = faces.astype(self.lod._input.faces.dtype, copy=False)
            self._faces = _frozen(faces)
        return self._faces

    @property
    def triangle_count(self) -> int:
        """Number of faces shown."""
        return self._data.face_count

    def __repr__(self) -> str:
        return f"<striata.View: {counted(self.triangle_count, 'face')} of {self.lod.face_count:,}>"


def build(
    mesh: Any,
    faces: ArrayLike | None = None,
    *,
    guaranteed: bool = False,
    attributes: Mapping[str, ArrayLike] | None = None,
    weights: Weights = None,
    cost: str = "memoryless",
    boundary: str = "keep",
    seams: str = "cross",
    topology: str = "change",
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
    attributes, weights, cost, boundary, seams, topology, locked, pair_distance, progress
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
    from ._scene import Scene

    if isinstance(mesh, Scene):
        rules: dict[str, Any] = {"cost": cost, "boundary": boundary, "seams": seams, "topology": topology}
        return mesh.build(guaranteed=guaranteed, pair_distance=pair_distance, progress=progress, **rules)
    found = input_of(mesh, faces, attributes)
    data, found_weights = found.mesh_data(weights)
    options = options_of(
        cost=cost,
        boundary=boundary,
        seams=seams,
        topology=topology,
        pair_distance=pair_distance,
        coarsest=coarsest,
        locked=indices_of(locked, len(found.points.original), "locked"),
        weights=found_weights,
    )
    with reporting(progress) as callback:
        return Lod._of(_striata.build(data, guaranteed, options, callback), found)


def _frozen(array: Frozen) -> Frozen:
    """Make an array read-only, since it is shared."""
    array.flags.writeable = False
    return array


def _vector(values: ArrayLike, name: str, offset: tuple[float, float, float]) -> tuple[float, float, float]:
    array = np.asarray(values, dtype=np.float64)
    if array.shape != (3,) or not np.isfinite(array).all():
        raise ValueError(f"{name} is {values!r}, but must be three finite numbers")
    x, y, z = (float(v) for v in array - np.array(offset))
    return (x, y, z)


def _upward(forward: AnyArray, up: AnyArray) -> tuple[float, float, float]:
    """Return `up`, or an axis if `up` is parallel to the view."""
    if np.linalg.norm(np.cross(forward, up)) <= 1e-6 * np.linalg.norm(forward) * np.linalg.norm(up):
        up = np.eye(3)[int(np.argmin(np.abs(forward)))]
    x, y, z = (float(v) for v in up)
    return (x, y, z)
