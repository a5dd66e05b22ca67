"""`trimesh.Trimesh`: vertex and face attributes, colors, texture coordinates and metadata survive."""

from __future__ import annotations

import copy
from typing import Any

import numpy as np

from .._input import Input, Result, arrays_input

#: Names under which parts of `Trimesh.visual` travel, which no user attribute has.
_COLORS, _UV = "striata:vertex_colors", "uv"


def take_apart(mesh: Any) -> Input:
    """Take a mesh apart."""
    if not (hasattr(mesh, "vertices") and hasattr(mesh, "faces")):
        hint = "pass its geometries one by one, or scene.to_geometry()"
        raise ValueError(f"trimesh.{type(mesh).__name__} is not a Trimesh: {hint}")
    attributes = {name: np.asarray(values) for name, values in mesh.vertex_attributes.items()}
    own = set(attributes)
    visual = mesh.visual
    uv = getattr(visual, "uv", None)
    if visual.kind == "texture" and uv is not None and len(uv) == len(mesh.vertices):
        attributes[_UV if _UV not in own else "striata:uv"] = np.asarray(uv)
    elif visual.kind == "vertex":
        attributes[_COLORS] = np.asarray(visual.vertex_colors)

    def rebuild(result: Result) -> Any:
        return _rebuilt(mesh, own, result)

    return arrays_input(np.asarray(mesh.vertices), np.asarray(mesh.faces), attributes, rebuild)


def _rebuilt(mesh: Any, own: set[str], result: Result) -> Any:
    made = type(mesh)(vertices=result.points, faces=result.faces, process=False)
    made.metadata.update(copy.deepcopy(mesh.metadata))
    for name in own:
        made.vertex_attributes[name] = result.attributes[name]
    if result.origins is not None:
        for name, values in mesh.face_attributes.items():
            made.face_attributes[name] = np.asarray(values)[result.origins]
    visual = mesh.visual
    uv = result.attributes.get(_UV if _UV not in own else "striata:uv")
    if visual.kind == "texture" and uv is not None:
        made.visual = type(visual)(uv=uv, material=visual.material)
    elif visual.kind == "vertex":
        made.visual.vertex_colors = result.attributes[_COLORS]
    elif visual.kind == "face" and result.origins is not None:
        made.visual.face_colors = np.asarray(visual.face_colors)[result.origins]
    return made
