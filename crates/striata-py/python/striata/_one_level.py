"""Simplification of arrays to one level, whose points are points of the input or lie anywhere."""

from __future__ import annotations

from typing import Any

import numpy as np

from . import _striata
from ._arrays import as_dtype
from ._input import Input, Result
from ._options import Placement
from ._progress import ProgressCallback
from ._targets import Request

#: Error and stop reason.
Facts = tuple[float, str]


def level_of_subset(
    found: Input,
    data: _striata.MeshData,
    request: Request,
    options: dict[str, Any],
    callback: ProgressCallback | None,
) -> tuple[Result, Facts]:
    """Simplify to a subset of the points."""
    faces, kept, origins, error, reason = _striata.simplify(
        data, request.target, request.limit, request.guaranteed, options, callback
    )
    attributes = {name: values[kept] for name, values in found.attributes.items()}
    converted = as_dtype(faces, found.faces.dtype)
    return Result(found.points.original[kept], converted, kept, origins, attributes), (error, reason)


def simplified_mesh(
    data: _striata.MeshData,
    request: Request,
    options: dict[str, Any],
    placement: Placement,
    callback: ProgressCallback | None,
) -> tuple[_striata.MeshData, float, str]:
    """Simplify a mesh with its groups and layers; returns it with error and stop reason."""
    is_free = placement == "optimal"
    return _striata.simplify_mesh(
        data, request.target, request.limit, request.guaranteed, is_free, options, callback
    )


def level_placed_freely(
    found: Input,
    data: _striata.MeshData,
    request: Request,
    options: dict[str, Any],
    callback: ProgressCallback | None,
) -> tuple[Result, Facts]:
    """Simplify with points that may lie anywhere; attributes are interpolated."""
    for name, values in found.attributes.items():
        if values.dtype.kind not in "fiub":
            raise ValueError(f"attributes[{name!r}] has the dtype {values.dtype}: use placement='subset' to carry it")
    made, error, reason = simplified_mesh(data, request, options, "optimal", callback)
    points = found.points.restored(made.points())
    layers = iter(made.layers())
    attributes = {}
    for name, values in found.attributes.items():
        rows = next(layers)[4] if values.size else np.empty((len(points), 0))
        if values.dtype.kind in "iub" and rows.dtype.kind == "f":
            rows = np.rint(rows)
        attributes[name] = rows.astype(values.dtype).reshape((len(points), *values.shape[1:]))
    return Result(points, as_dtype(made.faces(), found.faces.dtype), None, None, attributes), (error, reason)
