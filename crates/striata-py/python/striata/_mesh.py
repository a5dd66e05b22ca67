"""The class `Mesh`: what mesh files hold."""

from __future__ import annotations

import json
import os
from collections.abc import Mapping
from dataclasses import dataclass
from typing import Any

import numpy as np
from numpy.typing import ArrayLike, NDArray

from . import _striata
from ._arrays import AnyArray, attributes_of
from ._display import counted
from ._input import arrays_input
from ._layers import Layer, check_storable, layers_of
from ._write import write_mesh


@dataclass(frozen=True)
class Group:
    """A run of consecutive faces that share a material."""

    #: Name of the group; may be empty.
    name: str
    #: Index of the material, or `None`.
    material: int | None
    #: Its faces.
    faces: slice


@dataclass(frozen=True)
class Material:
    """A material, as its file describes it."""

    #: Name of the material; may be empty.
    name: str
    #: The material as a glTF object; empty if only the name is known.
    gltf: dict[str, Any]


@dataclass(frozen=True)
class Image:
    """An image of a material."""

    #: Name of the image; may be empty.
    name: str
    #: Location relative to its file; empty for embedded images.
    uri: str
    #: MIME type such as ``image/png``.
    mime_type: str
    #: Contents of the image file; empty if it was not found.
    data: bytes


class Mesh:
    """Indexed triangles with attributes, groups and materials.

    Parameters
    ----------
    points : array_like, shape (n, 3)
        Coordinates.
    faces : array_like, shape (m, 3)
        Indices of points, counterclockwise when seen from outside.
    attributes : dict of array_like, optional
        Arrays with a row for each point, of numbers that fit into 32 bits.
    face_attributes : dict of array_like, optional
        Arrays with a row for each face, such as labels and colors. They follow their face through levels.

    Examples
    --------
    >>> import striata
    >>> mesh = striata.Mesh([[0, 0, 0], [1, 0, 0], [0, 1, 0]], [[0, 1, 2]])
    >>> mesh
    <striata.Mesh: 3 points, 1 face>
    """

    __slots__ = ("_data",)

    def __init__(
        self,
        points: ArrayLike,
        faces: ArrayLike,
        attributes: Mapping[str, ArrayLike] | None = None,
        face_attributes: Mapping[str, ArrayLike] | None = None,
    ) -> None:
        found = arrays_input(points, faces, attributes)
        layers, _ = layers_of(found.attributes)
        check_storable(layers)
        data = _striata.MeshData(found.points.values, found.faces.values, layers)
        if face_attributes:
            of_faces, _ = layers_of(attributes_of(face_attributes, found.face_count, "faces"))
            check_storable(of_faces)
            data = data.with_face_layers(of_faces)
        self._data = found.points.placed(data)

    @classmethod
    def _of(cls, data: _striata.MeshData) -> Mesh:
        mesh = cls.__new__(cls)
        mesh._data = data
        return mesh

    @property
    def points(self) -> AnyArray:
        """Coordinates of the points, shape (n, 3), a copy."""
        return self._data.points()

    @property
    def faces(self) -> NDArray[np.int32]:
        """Indices of the points of each face, shape (m, 3), a copy."""
        return self._data.faces()

    @property
    def point_count(self) -> int:
        """Number of points."""
        return self._data.point_count

    @property
    def face_count(self) -> int:
        """Number of faces."""
        return self._data.face_count

    @property
    def georeference(self) -> dict[str, Any] | None:
        """Place of a terrain on the Earth (``origin``, ``epsg``, ...), whose up is z; None if unknown."""
        text = self._data.georeference
        return json.loads(text) if text else None

    @property
    def attributes(self) -> dict[str, AnyArray]:
        """Arrays with a row for each point, by name: ``normal``, ``texcoord_0``, ``color_0`` and others."""
        return _named(self._data.layers())

    @property
    def face_attributes(self) -> dict[str, AnyArray]:
        """Arrays with a row for each face, by name: ``color_0`` and others."""
        return _named(self._data.face_layers())

    @property
    def groups(self) -> list[Group]:
        """Runs of faces with one material; empty if the mesh is one unnamed group."""
        return [Group(name, material, slice(first, first + n)) for name, material, first, n in self._data.groups()]

    @property
    def materials(self) -> list[Material]:
        """Materials that groups refer to."""
        return [Material(name, json.loads(gltf) if gltf else {}) for name, gltf in self._data.materials()]

    @property
    def images(self) -> list[Image]:
        """Images that materials refer to."""
        return [Image(*image) for image in self._data.images()]

    def save(self, path: str | os.PathLike[str], *, ascii: bool = False) -> None:
        """Write the mesh in the format of the extension; see `striata.save`."""
        write_mesh(path, self._data, ascii=ascii)

    def __repr__(self) -> str:
        return f"<striata.Mesh: {counted(self.point_count, 'point')}, {counted(self.face_count, 'face')}>"


def _named(layers: list[Layer]) -> dict[str, AnyArray]:
    named = {}
    for kind, number, name, _, values in layers:
        key = name if kind == "generic" else _layer_name(kind, number)
        named[key] = values[:, 0] if kind == "generic" and values.shape[1] == 1 else values
    return named


def _layer_name(kind: str, number: int) -> str:
    if kind in ("normal", "tangent"):
        return kind
    if kind.startswith("morph_"):
        return f"morph_{number}_{kind[len('morph_') :]}"
    return f"{kind}_{number}"
