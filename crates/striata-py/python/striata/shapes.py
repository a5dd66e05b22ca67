"""Meshes for trying things: arrays of points and faces that need no file."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

Arrays = tuple[NDArray[np.float32], NDArray[np.int32]]


def grid(columns: int, rows: int) -> Arrays:
    """Return a flat grid of ``columns * rows`` squares in the unit square.

    Examples
    --------
    >>> from striata import shapes
    >>> points, faces = shapes.grid(4, 3)
    >>> points.shape, faces.shape
    ((20, 3), (24, 3))
    """
    x, y = np.meshgrid(np.linspace(0.0, 1.0, columns + 1), np.linspace(0.0, 1.0, rows + 1))
    points = np.stack([x.ravel(), y.ravel(), np.zeros(x.size)], axis=1).astype(np.float32)
    corner = (np.arange(rows)[:, None] * (columns + 1) + np.arange(columns)).ravel()
    step = columns + 1
    lower = np.stack([corner, corner + 1, corner + step + 1], axis=1)
    upper = np.stack([corner, corner + step + 1, corner + step], axis=1)
    return points, np.stack([lower, upper], axis=1).reshape(-1, 3).astype(np.int32)


def terrain(size: int, seed: int = 0) -> Arrays:
    """Return hills over a grid of ``size * size`` squares.

    Examples
    --------
    >>> from striata import shapes
    >>> shapes.terrain(8)[1].shape
    (128, 3)
    """
    points, faces = grid(size, size)
    random = np.random.default_rng(seed)
    height = np.zeros(len(points))
    for octave in range(6):
        frequency, phase = random.normal(0.0, 3.0 * 1.8**octave, 2), random.uniform(0.0, 2.0 * np.pi)
        height += 0.12 * 0.55**octave * np.sin(points[:, :2] @ frequency + phase)
    points[:, 2] = height
    return points, faces


def torus(rings: int, segments: int, major: float = 1.0, minor: float = 0.4) -> Arrays:
    """Return a torus around the z axis.

    Examples
    --------
    >>> from striata import shapes
    >>> shapes.torus(16, 8)[1].shape
    (256, 3)
    """
    u, v = np.meshgrid(np.arange(rings), np.arange(segments), indexing="ij")
    a, b = 2.0 * np.pi * u / rings, 2.0 * np.pi * v / segments
    radius = major + minor * np.cos(b)
    points = np.stack([radius * np.cos(a), radius * np.sin(a), minor * np.sin(b)], axis=-1)
    corner, right = u * segments + v, (u + 1) % rings * segments + v
    up, across = u * segments + (v + 1) % segments, (u + 1) % rings * segments + (v + 1) % segments
    faces = np.stack([corner, right, across, corner, across, up], axis=-1).reshape(-1, 3)
    return points.reshape(-1, 3).astype(np.float32), faces.astype(np.int32)
