"""`pyvista.PolyData`: point data, cell data and field data survive, with the active scalars."""

from __future__ import annotations

from typing import Any

import numpy as np

from .._inputs import Input, Result, arrays_input


def take_apart(mesh: Any) -> Input:
    """Take a mesh apart; polygons become triangles first."""
    if not any(base.__name__ == "PolyData" for base in type(mesh).__mro__):
        hint = "extract its surface first, with extract_surface()"
        raise ValueError(f"pyvista.{type(mesh).__name__} is not a PolyData: {hint}")
    if mesh.n_points and not mesh.is_all_triangles:
        mesh = mesh.triangulate()
    if mesh.n_lines or mesh.n_verts:
        # A mesh of points only has a vertex cell per point; which of the others remain is unknown.
        raise ValueError(f"the PolyData has {mesh.n_lines} lines and {mesh.n_verts} vertices besides its faces")
    faces = mesh.regular_faces if mesh.n_cells else np.empty((0, 3), dtype=np.int64)
    attributes = {name: np.asarray(mesh.point_data[name]) for name in mesh.point_data.keys()}

    def rebuild(result: Result) -> Any:
        return _rebuilt(mesh, result)

    return arrays_input(np.asarray(mesh.points), np.asarray(faces), attributes, rebuild)


def _rebuilt(mesh: Any, result: Result) -> Any:
    made = type(mesh)()
    made.points = result.points
    padded = np.full((len(result.faces), 4), 3, dtype=result.faces.dtype)
    padded[:, 1:] = result.faces
    made.faces = padded.ravel()
    for name, values in result.attributes.items():
        made.point_data[name] = values
    if result.origins is not None:
        for name in mesh.cell_data.keys():
            made.cell_data[name] = np.asarray(mesh.cell_data[name])[result.origins]
    for name in mesh.field_data.keys():
        made.field_data[name] = mesh.field_data[name]
    for source, target in ((mesh.point_data, made.point_data), (mesh.cell_data, made.cell_data)):
        for kind in ("active_scalars_name", "active_vectors_name", "active_normals_name"):
            active = getattr(source, kind, None)
            if active is not None and active in target:
                setattr(target, kind, active)
        coordinates = getattr(source, "active_texture_coordinates_name", None)
        if coordinates is not None and coordinates in target:
            target.active_texture_coordinates_name = coordinates
    association = getattr(mesh.active_scalars_info, "association", None)
    active = mesh.active_scalars_name
    if active is not None and association is not None:
        data = made.point_data if association.name == "POINT" else made.cell_data
        if active in data:
            made.set_active_scalars(active, preference=association.name.lower())
    return made
