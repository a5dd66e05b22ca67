"""The class `Lod`: every level of detail of a mesh."""

from __future__ import annotations

import os
from collections.abc import Iterable
from functools import cached_property
from typing import Any, Generic

import numpy as np
from numpy.typing import NDArray

from . import _striata
from ._arrays import AnyArray, as_dtype, frozen
from ._display import counted, notebook_html
from ._input import Input
from ._kinds import AnyMesh
from ._level import Level
from ._mesh import Mesh
from ._sequence import Sequence
from ._strip_level import StripLevel
from ._targets import Target, Targets, level_within
from ._view import View
from ._write import write_lod

#: Shares of the faces that the table of a notebook lists.
_SHOWN_SHARES = (1.0, 0.5, 0.25, 0.1, 0.01)


class Lod(Generic[AnyMesh]):
    """Every level of detail of one mesh, over a single array of points.

    Made by `build`, `open` and `decode`. Points are in refinement order, so each level uses the first
    points only. Immutable; safe to use from several threads. Pickled as the bytes of a ``.striata`` file, which do not
    know the order of the input: `vertices` of a copy counts from 0.

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
    #: What `build` got; `None` for meshes of files and streams.
    _input: Input | None

    @classmethod
    def _of(cls, data: _striata.LodData, found: Input | None = None) -> Lod[Any]:
        lod: Lod[Any] = cls.__new__(cls)
        lod._data = data
        lod._input = None if found is None or found.data is not None else found
        return lod

    @cached_property
    def points(self) -> AnyArray:
        """Points of all levels in refinement order, shape (k, 3), in the dtype of the input."""
        if self._input is None:
            return frozen(self._data.points())
        return frozen(self._input.points.original[self.vertices])

    @cached_property
    def vertices(self) -> NDArray[np.int32]:
        """Input point of each point. Counts from 0 if the levels were opened from a file."""
        vertices = self._data.vertices()
        return frozen(np.arange(len(self._data.points()), dtype=np.int32) if vertices is None else vertices)

    @cached_property
    def attributes(self) -> dict[str, AnyArray]:
        """Attributes of all points, in refinement order."""
        if self._input is None:
            return self.mesh().attributes
        return {name: frozen(values[self.vertices]) for name, values in self._input.attributes.items()}

    @cached_property
    def sequence(self) -> Sequence:
        """The collapses, for analysis and training."""
        removed, target, step, error, faces = self._data.sequence()
        removed, target = self.vertices[removed], self.vertices[target]
        return Sequence(frozen(removed), frozen(target), frozen(error), frozen(faces), frozen(step))

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
    ) -> Level[AnyMesh]:
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
        targets = Targets(
            triangles=triangles,
            vertices=vertices,
            ratio=ratio,
            detail=detail,
            error=error,
            max_error=max_error,
            target_reduction=target_reduction,
            target_count=target_count,
        )
        request = targets.request(self.face_count, self.diagonal)
        return level_within(request, self._level, self.has_guaranteed_errors)

    def _level(self, target: Target) -> Level[AnyMesh]:
        return Level(self, *self._data.resolve(target))

    def levels(self, ratios: Iterable[float]) -> list[Level[AnyMesh]]:
        """Return a level for each share of the faces.

        Examples
        --------
        >>> import striata
        >>> lod = striata.build(*striata.shapes.terrain(20))
        >>> len(lod.levels([1.0, 0.5, 0.1]))
        3
        """
        return [self.level(ratio=ratio) for ratio in ratios]

    def fine_to_coarse(self, level: Level[Any] | int) -> NDArray[np.int32]:
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

    def strip_level(self, level: Level[Any] | None = None) -> StripLevel:
        """Return triangle strips that follow a level, first the full mesh or the level that is given.

        The strips are those of the file, if the levels were opened from one that has them.
        """
        return StripLevel(self, self.level(detail=1.0) if level is None else level)

    def mesh(self) -> Mesh:
        """Return the full mesh, with its points in refinement order."""
        return Mesh._of(self._mesh_data())

    def save(self, path: str | os.PathLike[str]) -> None:
        """Write all levels to a ``.striata`` or ``.stri`` file; see `striata.save`."""
        write_lod(path, self._data, self._offset)

    @property
    def _offset(self) -> tuple[float, float, float]:
        """Offset that is added to the origin of the extension."""
        return (0.0, 0.0, 0.0) if self._input is None else self._input.points.offset

    @property
    def _origin(self) -> tuple[float, float, float]:
        """Point of the user at which the extension has its zero."""
        x, y, z = (a + b for a, b in zip(self._data.origin, self._offset, strict=True))
        return (x, y, z)

    def _mesh_data(self) -> _striata.MeshData:
        """Return the full mesh for the extension, in the coordinates of the user."""
        return self._data.mesh().moved(self._offset)

    def _like_input(self, faces: NDArray[np.int32]) -> AnyArray:
        """Return faces in the dtype of the input."""
        return faces if self._input is None else as_dtype(faces, self._input.faces.dtype)

    def __reduce__(self) -> tuple[Any, ...]:
        return (_of_bytes, (self._data.to_striata(self._offset),))

    def __repr__(self) -> str:
        counts = f"{counted(self.point_count, 'point')}, {counted(self.face_count, 'face')}"
        base = counted(self._data.level_facts(0)[0], "face")
        return f"<striata.Lod: {counts}, {counted(self.step_count + 1, 'level')} down to {base}>"

    def _repr_html_(self) -> str:
        rows: list[tuple[str, ...]] = [("level", "faces", "points", "error")]
        for share in _SHOWN_SHARES:
            level = self.level(ratio=share)
            rows.append((f"{share:.0%}", f"{level.triangle_count:,}", f"{level.vertex_count:,}", f"{level.error:.3g}"))
        return notebook_html(self._mesh_data(), rows)


def _of_bytes(content: bytes) -> Lod[Any]:
    """Return the levels in the bytes of a ``.striata`` file."""
    return Lod._of(_striata.decode(content, False, None))
