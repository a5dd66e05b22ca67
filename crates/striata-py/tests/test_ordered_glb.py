"""The example that reads ordered GLB files with NumPy makes the levels that a file also has as index ranges."""

import importlib.util
from pathlib import Path

import numpy as np

TESTS = Path(__file__).resolve().parent


def example():
    path = TESTS.parents[2] / "examples/ordered-glb/order.py"
    spec = importlib.util.spec_from_file_location("order", path)
    module = importlib.util.module_from_spec(spec)
    spec.loader.exec_module(module)
    return module


def sorted_triangles(triangles):
    first = triangles.argmin(axis=1)
    rolled = [np.roll(triangle, -k) for triangle, k in zip(triangles, first, strict=True)]
    return sorted(tuple(map(int, triangle)) for triangle in rolled)


def test_levels_by_the_rule_are_the_ranges_of_the_file():
    order = example()
    # A test of the command checks that it still writes this file.
    document, integers = order.open_glb(TESTS / "ordered.glb")
    (primitive,) = document["meshes"][0]["primitives"]
    extension = primitive["extensions"]["STRIATA_order"]
    full, targets = integers(primitive["indices"]), integers(extension["targets"])
    indices = integers(extension["indices"])
    assert len(extension["ranges"]) == 4
    for (first, count, n, _), (_, triangle_count, _) in zip(
        extension["ranges"], extension["levels"], strict=False
    ):
        level = order.level(full, targets, n)
        assert len(level) == triangle_count
        assert sorted_triangles(level) == sorted_triangles(indices[first : first + count].reshape(-1, 3))
