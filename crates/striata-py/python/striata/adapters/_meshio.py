"""`meshio.Mesh`: point data, cell data and field data survive; quads become triangles."""

from __future__ import annotations

from typing import Any

import numpy as np

from .._arrays import AnyArray
from .._input import Input, Result, arrays_input
from .._warn import warn

#: Cells that a surface may have besides faces; they are left out.
_LOWER = ("vertex", "line")


def take_apart(mesh: Any) -> Input:
    """Take a mesh apart."""
    points = np.asarray(mesh.points)
    columns = points.shape[1] if points.ndim == 2 else 3
    if columns == 2:
        points = np.column_stack([points, np.zeros(len(points), dtype=points.dtype)])
    faces, origins = _faces(mesh)
    cell_data = {name: _of_faces(mesh, blocks) for name, blocks in mesh.cell_data.items()}
    attributes = {name: np.asarray(values) for name, values in mesh.point_data.items()}

    def rebuild(result: Result) -> Any:
        cells = [("triangle", result.faces)]
        data = {}
        if result.origins is not None:
            data = {name: [values[origins[result.origins]]] for name, values in cell_data.items()}
        kept_points = result.points[:, :columns]
        field_data = dict(mesh.field_data)
        return type(mesh)(kept_points, cells, result.attributes, data, field_data)

    return arrays_input(points, faces, attributes, rebuild)


def _faces(mesh: Any) -> tuple[AnyArray, AnyArray]:
    """Triangles of all blocks of faces, and the cell that each comes from, counted over those blocks."""
    triangles, cells, count = [np.empty((0, 3), dtype=np.int64)], [np.empty(0, dtype=np.int64)], 0
    dtypes = [np.asarray(block.data).dtype for block in mesh.cells if block.type in ("triangle", "quad")]
    for block in mesh.cells:
        data = np.asarray(block.data)
        if block.type == "triangle":
            triangles.append(data)
            cells.append(np.arange(count, count + len(data)))
        elif block.type == "quad":
            triangles.append(np.stack([data[:, [0, 1, 2]], data[:, [0, 2, 3]]], axis=1).reshape(-1, 3))
            cells.append(np.repeat(np.arange(count, count + len(data)), 2))
        elif block.type in _LOWER:
            warn(f"{len(data)} cells of the type {block.type} are left out")
            continue
        else:
            raise ValueError(f"meshio cells of the type {block.type!r} are not triangles or quads")
        count += len(data)
    joined = np.concatenate(triangles)
    return joined.astype(dtypes[0]) if dtypes else joined, np.concatenate(cells)


def _of_faces(mesh: Any, blocks: Any) -> AnyArray:
    kept = [np.asarray(values) for block, values in zip(mesh.cells, blocks, strict=True) if block.type not in _LOWER]
    return np.concatenate(kept) if kept else np.empty(0)
