"""`pyvista.PolyData`: point data, cell data and field data survive, with the active scalars."""

from __future__ import annotations

from typing import Any

import numpy as np

from .._arrays import AnyArray
from .._display import counted
from .._input import Input, Result, arrays_input
from .._warn import warn


def take_apart(mesh: Any) -> Input:
    """Take a mesh apart. Polygons and strips become triangles; lines and vertex cells are left out."""
    if not any(base.__name__ == "PolyData" for base in type(mesh).__mro__):
        hint = "extract its surface first, with extract_surface()"
        raise ValueError(f"pyvista.{type(mesh).__name__} is not a PolyData: {hint}")
    surface = _triangles(mesh)
    faces = surface.regular_faces if surface.n_cells else np.empty((0, 3), dtype=np.int64)
    attributes = {name: np.asarray(mesh.point_data[name]) for name in mesh.point_data.keys()}
    cell_data = {name: np.asarray(surface.cell_data[name]) for name in surface.cell_data.keys()}

    def rebuild(result: Result) -> Any:
        return _rebuilt(mesh, cell_data, result)

    return arrays_input(np.asarray(mesh.points), np.asarray(faces), attributes, rebuild)


def _triangles(mesh: Any) -> Any:
    """Return a mesh of triangles only, over the same points."""
    if mesh.n_lines or mesh.n_verts:
        mesh = _faces_only(mesh)
    if mesh.n_cells and (mesh.n_strips or not mesh.is_all_triangles):
        return mesh.triangulate()
    return mesh


def _faces_only(mesh: Any) -> Any:
    """Return a copy without lines and vertex cells: they would have to follow points that are removed."""
    others = f"{counted(mesh.n_lines, 'line')} and {counted(mesh.n_verts, 'vertex cell')}"
    # The cells of a PolyData are its vertices, then its lines, its polygons and its strips.
    first = mesh.n_lines + mesh.n_verts
    if first == mesh.n_cells:
        raise ValueError(f"the PolyData has no faces, only {others}")
    warn(f"{others} of the PolyData are left out; its faces are kept")
    surface = type(mesh)()
    surface.points, surface.faces, surface.strips = mesh.points, mesh.faces, mesh.strips
    for name in mesh.cell_data.keys():
        surface.cell_data[name] = np.asarray(mesh.cell_data[name])[first:]
    return surface


def _rebuilt(mesh: Any, cell_data: dict[str, AnyArray], result: Result) -> Any:
    made = type(mesh)()
    made.points = result.points
    padded = np.full((len(result.faces), 4), 3, dtype=result.faces.dtype)
    padded[:, 1:] = result.faces
    made.faces = padded.ravel()
    for name, values in result.attributes.items():
        made.point_data[name] = values
    if result.origins is not None:
        for name, values in cell_data.items():
            made.cell_data[name] = values[result.origins]
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
