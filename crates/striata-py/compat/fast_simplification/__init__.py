"""The functions of the package fast-simplification, on top of striata.

A thin adapter for code that is written for fast-simplification, and for running that package's own tests.
`agg` has no meaning here: the cheapest collapse always comes first. It is accepted; 0 keeps the mesh.
"""

from __future__ import annotations

import numpy as np
import striata

from . import _simplify

__all__ = ["_map_isolated_points", "replay_simplification", "simplify", "simplify_mesh"]


def _count(target_reduction, target_count, face_count):
    if target_reduction and target_count:
        raise ValueError("You may specify ``target_reduction`` or ``target_count``, but not both")
    if target_reduction is None and target_count is None:
        raise ValueError("You must specify ``target_reduction`` or ``target_count``")
    if target_reduction is not None:
        if not 0 <= target_reduction <= 1:
            raise ValueError("``target_reduction`` must be between 0 and 1")
        target_count = (1 - target_reduction) * face_count
    if target_count < 0:
        raise ValueError("``target_count`` must be greater than 0")
    if target_count > face_count:
        raise ValueError(f"``target_count`` must be less than the number of faces {face_count}")
    return int(target_count)


def _checked(points, triangles):
    points, triangles = np.asarray(points, dtype=np.float64), np.asarray(triangles)
    for name, array in (("points", points), ("triangles", triangles)):
        if array.ndim != 2:
            raise ValueError(f"``{name}`` array must be 2 dimensional")
        if array.shape[1] != 3:
            raise ValueError(f"Expected ``{name}`` array to be (n, 3), not {array.shape}")
    return points, triangles.astype(np.int32)


def simplify(
    points,
    triangles,
    target_reduction=None,
    target_count=None,
    agg=7.0,
    verbose=False,
    return_collapses=False,
    lossless=False,
    preserve_border=False,
):
    """Simplify a mesh like `fast_simplification.simplify`."""
    points, triangles = _checked(points, triangles)
    boundary = "lock" if preserve_border else "keep"
    lod = striata.build(points, triangles, boundary=boundary, progress=verbose)
    if lossless:
        level = lod.level(error=0.0)
    else:
        level = lod.level(triangles=_count(target_reduction, target_count, len(triangles)))
    if agg == 0:
        level = lod.level(detail=1.0)
    sequence = lod.sequence
    done = sequence.step < lod.step_count - level.split_count
    collapses = np.stack([sequence.target[done], sequence.removed[done]], axis=1).astype(np.int32)
    points_out, faces, _ = replay_simplification(points, triangles, collapses)
    _simplify.faces = faces
    return (points_out, faces, collapses) if return_collapses else (points_out, faces)


def replay_simplification(points, triangles, collapses):
    """Apply collapses; return points, faces, and the point that each input point became."""
    points, triangles = _checked(points, triangles)
    mapping = np.arange(len(points))
    # Targets are removed later than their sources, so one pass from the last collapse suffices.
    for target, removed in collapses[::-1]:
        mapping[removed] = mapping[target]
    kept = np.ones(len(points), bool)
    kept[collapses[:, 1]] = False
    index = np.cumsum(kept) - 1
    mapping = index[mapping]
    a, b, c = mapping[triangles].T
    is_face = (a != b) & (b != c) & (c != a)
    faces = np.stack([a, b, c], axis=1)[is_face].astype(np.int32)
    # A slice of a larger array has a base, like the arrays of the original package.
    return np.append(points[kept], [[0.0] * 3], axis=0)[:-1], faces[:], mapping


def simplify_mesh(
    mesh, target_reduction=None, target_count=None, agg=7.0, verbose=False, preserve_border=False
):
    """Simplify a PolyData like `fast_simplification.simplify_mesh`."""
    if not mesh.is_all_triangles:
        raise ValueError("Input mesh must consist of only triangles")
    arguments = (target_reduction, target_count, agg, verbose, True, False, preserve_border)
    points, faces, collapses = simplify(mesh.points, mesh.regular_faces, *arguments)
    made = type(mesh).from_regular_faces(points, faces)
    made.field_data["fast_simplification_collapses"] = collapses
    return made


def _map_isolated_points(points, edges, triangles, return_outliers=False):
    """Merge points without triangles into points with triangles, along edges."""
    mapping = np.arange(len(points))
    is_done = np.zeros(len(points), bool)
    is_done[np.unique(triangles).astype(int)] = True
    edges = np.concatenate([edges, edges[:, ::-1]])
    while True:
        front = is_done[edges[:, 0]] & ~is_done[edges[:, 1]]
        if not front.any():
            break
        mapping[edges[front, 1]] = mapping[edges[front, 0]]
        is_done[edges[front, 1]] = True
    merged = np.flatnonzero(mapping != np.arange(len(mapping)))
    if return_outliers:
        return mapping, merged, np.setdiff1d(np.unique(edges), np.flatnonzero(is_done))
    return mapping, merged
