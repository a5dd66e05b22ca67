"""A mesh as arrays, whatever it came as, and the arrays of a level made from it."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import dataclass, field
from typing import Any

from numpy.typing import ArrayLike

from . import _striata
from ._arrays import AnyArray, FaceSet, PointSet, attributes_of, faces_of, points_of
from ._layers import Weights, file_weights, layers_of


@dataclass
class Result:
    """Arrays of a level, from which an adapter builds a mesh of its type."""

    #: (k, 3), in the dtype of the input.
    points: AnyArray
    #: (l, 3), in the dtype of the input.
    faces: AnyArray
    #: Input point of each point; `None` if points were placed freely.
    vertices: AnyArray | None
    #: Input face of each face; `None` if points were placed freely.
    origins: AnyArray | None
    #: Values of each attribute, with a row per point.
    attributes: dict[str, AnyArray]


@dataclass
class Input:
    """A mesh as arrays."""

    points: PointSet
    faces: FaceSet
    attributes: dict[str, AnyArray] = field(default_factory=dict)
    #: Builds a mesh of the type that was passed in; `None` for arrays and for meshes of files.
    rebuild: Callable[[Result], Any] | None = None
    #: The mesh with its groups and materials, if it comes from a file.
    data: _striata.MeshData | None = None

    def mesh_data(self, weights: Weights = None) -> tuple[_striata.MeshData, tuple[float, float, float] | None]:
        """Return the mesh for simplification, and weights if they are not the default ones."""
        if self.data is not None:
            return self.data, file_weights(weights)
        layers, ordered = layers_of(self.attributes, weights)
        return _striata.MeshData(self.points.values, self.faces.values, layers), ordered

    def stored_data(self) -> _striata.MeshData:
        """Return the mesh as files store it, in the coordinates of the user."""
        return self.points.placed(self.mesh_data()[0].stored())

    @property
    def face_count(self) -> int:
        return len(self.faces.values)


def arrays_input(
    points: ArrayLike,
    faces: ArrayLike,
    attributes: Mapping[str, ArrayLike] | None,
    rebuild: Callable[[Result], Any] | None = None,
) -> Input:
    """Check arrays of a user or an adapter."""
    checked = points_of(points)
    count = len(checked.original)
    return Input(checked, faces_of(faces, count), attributes_of(attributes, count), rebuild)
