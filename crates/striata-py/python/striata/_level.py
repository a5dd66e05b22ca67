"""The class `Level`: one uniform level of detail."""

from __future__ import annotations

import os
from functools import cached_property
from typing import TYPE_CHECKING, Any, Generic

import numpy as np
from numpy.typing import NDArray

from . import _striata
from ._arrays import AnyArray, frozen
from ._display import counted, notebook_html
from ._input import Input, Result
from ._kinds import AnyMesh
from ._mesh import Mesh
from ._write import write_mesh

if TYPE_CHECKING:
    from ._lod import Lod


class Level(Generic[AnyMesh]):
    """One uniform level of a `Lod`; made by `Lod.level`."""

    def __init__(self, lod: Lod[AnyMesh], split_count: int, stop_reason: str) -> None:
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
        return frozen(self.lod._like_input(faces)), frozen(origins)

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
        return frozen(self.lod._data.level_strips(self.split_count))

    @cached_property
    def vertices(self) -> NDArray[np.int32]:
        """Input points that the faces use, ascending: the points of `to_mesh`."""
        return frozen(np.unique(self.lod.vertices[self.faces]).astype(np.int32))

    def to_mesh(self) -> AnyMesh:
        """Return the level as a mesh of the type that `build` got, with only the points that it uses.

        Arrays give a tuple of points and faces, files and streams a `Mesh`.
        """
        found = self.lod._input
        mesh: Any
        if found is None:
            mesh = self._mesh()
        elif found.rebuild is None:
            result = self._result(found)
            mesh = (result.points, found.faces.like_input(result.faces))
        else:
            mesh = found.rebuild(self._result(found))
        made: AnyMesh = mesh
        return made

    def attributes(self) -> dict[str, AnyArray]:
        """Return the attributes of the points of `to_mesh`."""
        found = self.lod._input
        return self._mesh().attributes if found is None else self._result(found).attributes

    def save(self, path: str | os.PathLike[str]) -> None:
        """Write the level as a mesh, with its faces in an order for vertex caches; see `striata.save`."""
        write_mesh(path, self._mesh_data(), is_level=True)

    def _mesh(self) -> Mesh:
        return Mesh._of(self._mesh_data())

    def _mesh_data(self) -> _striata.MeshData:
        """Return the level for the extension, in the coordinates of the user."""
        return self.lod._data.level_mesh(self.split_count).moved(self.lod._offset)

    def _result(self, found: Input) -> Result:
        kept = self.vertices
        index = np.empty(len(found.points.original), dtype=found.faces.dtype)
        index[kept] = np.arange(len(kept), dtype=found.faces.dtype)
        faces = index[self.lod.vertices[self.faces]].reshape(-1, 3)
        attributes = {name: values[kept] for name, values in found.attributes.items()}
        return Result(found.points.original[kept], faces, kept, self.face_origins, attributes)

    def __repr__(self) -> str:
        counts = f"{counted(self.triangle_count, 'face')}, {counted(self.vertex_count, 'point')}"
        return f"<striata.Level: {counts}, error {self.error:.3g}>"

    def _repr_html_(self) -> str:
        facts = (f"{self.triangle_count:,}", f"{self.vertex_count:,}", f"{self.error:.3g}")
        return notebook_html(self._mesh_data(), [("faces", "points", "error"), facts])
