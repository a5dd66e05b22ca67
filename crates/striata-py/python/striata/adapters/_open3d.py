"""Open3D's triangle meshes, legacy and tensor: all attributes of vertices and triangles survive.

Open3D stores texture coordinates per corner. They become attributes of wedges (points with one coordinate
each), so that seams of the texture stay where they are, and go back to the corners afterward.
"""

from __future__ import annotations

from importlib import import_module
from typing import Any

import numpy as np

from .._arrays import AnyArray
from .._input import Input, Result, arrays_input

#: Attributes that only this module uses.
_UV, _POINT = "uv", "striata:point"


def take_apart(mesh: Any) -> Input:
    """Take a mesh apart."""
    if type(mesh).__name__ != "TriangleMesh":
        raise ValueError(f"open3d {type(mesh).__name__} is not a TriangleMesh")
    return _tensor(mesh) if hasattr(mesh, "vertex") else _legacy(mesh)


def _legacy(mesh: Any) -> Input:
    attributes = {}
    if mesh.has_vertex_normals():
        attributes["normals"] = np.asarray(mesh.vertex_normals)
    if mesh.has_vertex_colors():
        attributes["colors"] = np.asarray(mesh.vertex_colors)
    corners = np.asarray(mesh.triangle_uvs) if mesh.has_triangle_uvs() else None

    def rebuild(result: Result) -> Any:
        return _rebuilt_legacy(mesh, result)

    return _wedged(np.asarray(mesh.vertices), np.asarray(mesh.triangles), attributes, corners, rebuild)


def _rebuilt_legacy(mesh: Any, result: Result) -> Any:
    utility = import_module("open3d").utility
    points, faces, attributes, corners = _unwedged(result)
    made = type(mesh)()
    made.vertices = utility.Vector3dVector(points)
    made.triangles = utility.Vector3iVector(faces.astype(np.int32))
    if "normals" in attributes:
        made.vertex_normals = utility.Vector3dVector(attributes["normals"])
    if "colors" in attributes:
        made.vertex_colors = utility.Vector3dVector(attributes["colors"])
    if corners is not None:
        made.triangle_uvs = utility.Vector2dVector(corners.reshape(-1, 2))
    if mesh.textures:
        made.textures = mesh.textures
    if result.origins is not None:
        if mesh.has_triangle_material_ids():
            ids = np.asarray(mesh.triangle_material_ids)[result.origins]
            made.triangle_material_ids = utility.IntVector(ids.astype(np.int32))
    if mesh.has_triangle_normals():
        made.compute_triangle_normals()
    return made


def _tensor(mesh: Any) -> Input:
    vertices = {name: mesh.vertex[name].cpu().numpy() for name in _names(mesh.vertex)}
    triangles = {name: mesh.triangle[name].cpu().numpy() for name in _names(mesh.triangle)}
    points = vertices.pop("positions")
    faces = triangles.pop("indices", np.empty((0, 3), dtype=np.int64))
    corners = triangles.pop("texture_uvs", None)
    triangles.pop("normals", None)

    def rebuild(result: Result) -> Any:
        return _rebuilt_tensor(mesh, triangles, result)

    flat_corners = None if corners is None else corners.reshape(-1, 2)
    return _wedged(points, faces, vertices, flat_corners, rebuild)


def _names(attributes: Any) -> list[str]:
    # A TensorMap iterates over its names.
    return [str(name) for name in attributes]


def _rebuilt_tensor(mesh: Any, triangles: dict[str, AnyArray], result: Result) -> Any:
    tensor = import_module("open3d").core.Tensor
    points, faces, attributes, corners = _unwedged(result)
    made = type(mesh)(mesh.device)
    device = mesh.device

    def put(values: AnyArray) -> Any:
        return tensor(np.ascontiguousarray(values), device=device)

    made.vertex.positions = put(points)
    made.triangle.indices = put(faces)
    for name, values in attributes.items():
        made.vertex[name] = put(values)
    if corners is not None:
        made.triangle["texture_uvs"] = put(corners)
    if result.origins is not None:
        for name, values in triangles.items():
            made.triangle[name] = put(values[result.origins])
    if mesh.has_valid_material():
        made.material = mesh.material
    if "normals" in _names(mesh.triangle):
        made.compute_triangle_normals()
    return made


def _wedged(
    points: AnyArray, faces: AnyArray, attributes: dict[str, AnyArray], corners: AnyArray | None, rebuild: Any
) -> Input:
    """Input whose points are wedges, if corners have texture coordinates."""
    if corners is None or len(corners) != 3 * len(faces) or len(faces) == 0:
        return arrays_input(points, faces, attributes, rebuild)
    if faces.min() < 0 or faces.max() >= len(points):
        return arrays_input(points, faces, attributes, rebuild)  # which reports the place
    keys = np.empty(faces.size, dtype=[("point", np.int64), ("u", np.float64), ("v", np.float64)])
    keys["point"], keys["u"], keys["v"] = faces.ravel(), corners[:, 0], corners[:, 1]
    unique, inverse = np.unique(keys, return_inverse=True)
    point = unique["point"]
    wedges = {name: values[point] for name, values in attributes.items()}
    wedges[_UV if _UV not in wedges else "texcoord"] = np.stack([unique["u"], unique["v"]], axis=1).astype(
        corners.dtype
    )
    wedged_faces = inverse.reshape(-1, 3).astype(faces.dtype)

    def rebuild_points(result: Result) -> Any:
        if result.vertices is None:
            result.attributes[_POINT] = _joined(result.points)
        else:
            result.attributes[_POINT] = point[result.vertices]
        return rebuild(result)

    return arrays_input(points[point], wedged_faces, wedges, rebuild_points)


def _joined(points: AnyArray) -> AnyArray:
    """Number of each distinct point."""
    _, inverse = np.unique(points, axis=0, return_inverse=True)
    return np.asarray(inverse).ravel()


def _unwedged(result: Result) -> tuple[AnyArray, AnyArray, dict[str, AnyArray], AnyArray | None]:
    """Points, faces and attributes without wedges, and texture coordinates of the corners."""
    attributes = dict(result.attributes)
    if _POINT not in attributes:
        return result.points, result.faces, attributes, None
    uv = attributes.pop(_UV if _UV in attributes else "texcoord")
    _, first, inverse = np.unique(attributes.pop(_POINT), return_index=True, return_inverse=True)
    faces = np.asarray(inverse).ravel()[result.faces].astype(result.faces.dtype).reshape(-1, 3)
    kept = {name: values[first] for name, values in attributes.items()}
    return result.points[first], faces, kept, uv[result.faces].reshape(-1, 3, 2)
