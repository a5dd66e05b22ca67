"""Meshes of any kind as one: arrays, files, and the meshes of other packages.

An adapter takes a mesh apart and knows how to build one of the same type again. Adapters are found by the
module of the type, so that no package is imported unless one of its meshes was passed in.
"""

from __future__ import annotations

import os
from collections.abc import Mapping
from importlib import import_module
from typing import Any

import numpy as np
from numpy.typing import ArrayLike

from . import _striata
from ._arrays import FaceSet, PointSet, attributes_of
from ._input import Input, arrays_input
from ._mesh import Mesh
from ._read import read

#: Adapter for each package whose meshes are accepted.
_ADAPTERS = {"trimesh": "_trimesh", "pyvista": "_pyvista", "open3d": "_open3d", "meshio": "_meshio"}


def input_of(
    mesh: Any,
    faces: ArrayLike | None = None,
    attributes: Mapping[str, ArrayLike] | None = None,
) -> Input:
    """Convert whatever a user passed as a mesh."""
    if faces is not None:
        return arrays_input(mesh, faces, attributes)
    if isinstance(mesh, tuple) and len(mesh) == 2:
        return arrays_input(mesh[0], mesh[1], attributes)
    found = _from_object(mesh)
    if attributes is not None:
        if found.data is not None:
            raise ValueError("attributes can be added to arrays and to meshes of other packages, not to a file's mesh")
        found.attributes.update(attributes_of(attributes, len(found.points.original)))
    return found


def mesh_data_of(mesh: Any, faces: ArrayLike | None = None) -> _striata.MeshData:
    """Return whatever a user passed as a mesh, as files store it, in the coordinates of the user."""
    return input_of(mesh, faces).stored_data()


def _from_object(mesh: Any) -> Input:
    if isinstance(mesh, Mesh):
        return _from_data(mesh._data)
    if isinstance(mesh, (str, os.PathLike)):
        return _from_data(_data_in_file(mesh))
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


def _from_data(data: _striata.MeshData) -> Input:
    points = data.points()
    return Input(PointSet(points, points), FaceSet(data.faces().view(np.uint32)), {}, None, data)


def _data_in_file(path: str | os.PathLike[str]) -> _striata.MeshData:
    """Return the one mesh of a file: the full mesh of files with levels, everything shown of scenes."""
    data = read(path)
    if isinstance(data, _striata.LodSceneData):
        data = data.full_scene()
    if isinstance(data, _striata.SceneData):
        return data.flattened()
    return data.mesh() if isinstance(data, _striata.LodData) else data
