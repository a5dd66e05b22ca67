"""Levels of GLB files with the extension STRIATA_order (docs/STRIATA_order.md), with NumPy alone."""

import json
import sys
from pathlib import Path

import numpy as np


def open_glb(path):
    """Return the document of a GLB file, and a function that returns the array of an accessor of integers."""
    data = Path(path).read_bytes()
    end = 20 + int.from_bytes(data[12:16], "little")
    document = json.loads(data[20:end])

    def integers(index):
        accessor = document["accessors"][index]
        view = document["bufferViews"][accessor["bufferView"]]
        start = end + 8 + view.get("byteOffset", 0) + accessor.get("byteOffset", 0)
        kind = {5123: "<u2", 5125: "<u4"}[accessor["componentType"]]
        return np.frombuffer(data, kind, accessor["count"], start)

    return document, integers


def level(indices, targets, n):
    """Return the triangles of the level with n vertices of a primitive, as an array of shape (m, 3)."""
    vertices = np.arange(len(targets))
    while (vertices >= n).any():  # each round follows one target: a dozen rounds at most on most meshes
        vertices = np.where(vertices < n, vertices, targets[vertices])
    a, b, c = triangles = vertices[indices].reshape(-1, 3).T
    return triangles.T[(a != b) & (b != c) & (c != a)]


if __name__ == "__main__":
    document, integers = open_glb(sys.argv[1])
    for mesh in document["meshes"]:
        for primitive in mesh["primitives"]:
            order = primitive.get("extensions", {}).get("STRIATA_order")
            for n, count, error in order["levels"] if order else []:
                triangles = level(integers(primitive["indices"]), integers(order["targets"]), n)
                print(f"{n} vertices, {len(triangles)} of {count} triangles, error {error}")
