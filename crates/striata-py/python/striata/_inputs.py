"""Meshes of any kind as one: arrays, files, and the meshes of other packages.

An adapter takes a mesh apart and knows how to build one of the same type again. Adapters are found by the
module of the type, so that no package is imported unless one of its meshes was passed in.
"""

from __future__ import annotations

import os
from collections.abc import Callable, Mapping
from dataclasses import dataclass, field
from importlib import import_module
from typing import Any

import numpy as np
from numpy.typing import ArrayLike

from . import _striata
from ._arrays import AnyArray, FaceSet, PointSet, attributes_of, faces_of, points_of
from ._layers import Weights, layers_of


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
    #: Builds a mesh of the type that was passed in.
    rebuild: Callable[[Result], Any] | None = None
    #: The mesh with its groups and materials, if it comes from a file.
    data: _striata.MeshData | None = None

    def mesh_data(self, weights: Weights = None) -> tuple[_striata.MeshData, tuple[float, float, float] | None]:
        """Return the mesh for the extension, and weights if they are not the default ones."""
        if self.data is not None:
            return self.data, _file_weights(weights)
        layers, ordered = layers_of(self.attributes, weights)
        return _striata.MeshData(self.points.values, self.faces.values, layers), ordered

    @property
    def face_count(self) -> int:
        return len(self.faces.values)


def _file_weights(weights: Weights) -> tuple[float, float, float] | None:
    """Weights of the layers of a file, whose names are normal, texcoord and color."""
    if weights is None:
        return None
    named = {"normal": 0.007, "texcoord": 0.02, "color": 0.003}
    if not isinstance(weights, Mapping):
        return (0.0, 0.0, 0.0)
    for name, weight in weights.items():
        if name not in named:
            raise ValueError(f"weights[{name!r}]: meshes from files have weights for {sorted(named)}")
        named[name] = float(weight)
    return (named["normal"], named["texcoord"], named["color"])


#: Adapter for each package whose meshes are accepted.
_ADAPTERS = {"trimesh": "_trimesh", "pyvista": "_pyvista", "open3d": "_open3d", "meshio": "_meshio"}


def input_of(
    mesh: Any,
    faces: ArrayLike | None = None,
    attributes: Mapping[str, ArrayLike] | None = None,
) -> Input:
    """Convert whatever a user passed as a mesh."""
    if faces is not None:
        points = points_of(mesh)
        checked = attributes_of(attributes, len(points.original))
        return Input(points, faces_of(faces, len(points.original)), checked)
    if isinstance(mesh, tuple) and len(mesh) == 2:
        return input_of(mesh[0], mesh[1], attributes)
    if isinstance(mesh, (str, os.PathLike)):
        mesh = _mesh_in_file(mesh)
    found = _from_object(mesh)
    if attributes is not None:
        if found.data is not None:
            raise ValueError("attributes can be added to arrays and to meshes of other packages, not to a file's mesh")
        found.attributes.update(attributes_of(attributes, len(found.points.original)))
    return found


def _mesh_in_file(path: str | os.PathLike[str]) -> Any:
    from ._files import open as open_file
    from ._lod import Lod
    from ._scene import LodScene, Scene

    found = open_file(path)
    if isinstance(found, LodScene):
        found = found.full_scene()
    if isinstance(found, Scene):
        return found.flattened()
    if isinstance(found, Lod):
        return found.mesh()
    return found


def _from_object(mesh: Any) -> Input:
    from ._mesh import Mesh

    if isinstance(mesh, Mesh):
        return mesh._input()
    for base in type(mesh).__mro__:
        package = base.__module__.split(".")[0]
        if package in _ADAPTERS:
            adapter = import_module(f".adapters.{_ADAPTERS[package]}", __package__)
            found: Input = adapter.take_apart(mesh)
            return found
    if isinstance(mesh, (np.ndarray, list)):
        raise ValueError("faces are missing: pass points and faces")
    kinds = "points and faces, a file name, or a mesh of striata, trimesh, pyvista, open3d or meshio"
    raise ValueError(f"{type(mesh).__module__}.{type(mesh).__qualname__} is not a mesh; pass {kinds}")


def arrays_input(
    points: ArrayLike,
    faces: ArrayLike,
    attributes: Mapping[str, AnyArray],
    rebuild: Callable[[Result], Any],
) -> Input:
    """Input of an adapter, whose arrays are checked like those of users."""
    checked = points_of(points)
    count = len(checked.original)
    return Input(checked, faces_of(faces, count), attributes_of(attributes, count), rebuild)
