"""Kinds of meshes for type checkers: what goes into a function, and comes back from it, in the same type.

Among the overloads of a function, those for mesh objects precede those for tuples, file names and scenes: for
a type checker, `pyvista.PolyData` has a base class of unknown type and might be any of these.
"""

from __future__ import annotations

from typing import TYPE_CHECKING, Any, Protocol

from ._arrays import AnyArray

if TYPE_CHECKING:
    # Only a type checker needs the default, which `typing` has from Python 3.13 on.
    from typing_extensions import TypeVar

    #: Type of the meshes that a `Lod` makes.
    AnyMesh = TypeVar("AnyMesh", covariant=True, default=Any)
else:
    from typing import TypeVar

    AnyMesh = TypeVar("AnyMesh", covariant=True)

#: Points and faces.
Arrays = tuple[AnyArray, AnyArray]


class PointsAndFaces(Protocol):
    """`striata.Mesh` and `pyvista.PolyData`."""

    @property
    def points(self) -> Any: ...
    @property
    def faces(self) -> Any: ...


class VerticesAndFaces(Protocol):
    """`trimesh.Trimesh`."""

    @property
    def vertices(self) -> Any: ...
    @property
    def faces(self) -> Any: ...


class VerticesAndTriangles(Protocol):
    """`open3d.geometry.TriangleMesh`."""

    @property
    def vertices(self) -> Any: ...
    @property
    def triangles(self) -> Any: ...


class VertexAndTriangle(Protocol):
    """`open3d.t.geometry.TriangleMesh`."""

    @property
    def vertex(self) -> Any: ...
    @property
    def triangle(self) -> Any: ...


class PointsAndCells(Protocol):
    """`meshio.Mesh`."""

    @property
    def points(self) -> Any: ...
    @property
    def cells(self) -> Any: ...


#: A mesh object of any package.
MeshObject = PointsAndFaces | VerticesAndFaces | VerticesAndTriangles | VertexAndTriangle | PointsAndCells
