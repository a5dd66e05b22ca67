"""Typed code that uses the package; `test_types.py` runs mypy over it, in strict mode.

A mesh goes in and comes back as the same type. Calls that end in `type: ignore` are mistakes that a type
checker must find.
"""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path
from typing import Any

import numpy as np
import striata
from numpy.typing import NDArray
from typing_extensions import assert_type

Array = NDArray[Any]


class PolyData:
    """A mesh with the attributes of `pyvista.PolyData`; subclasses come back as subclasses."""

    points: NDArray[np.float64]
    faces: NDArray[np.int64]


class Trimesh:
    """A mesh with the attributes of `trimesh.Trimesh`, which are properties."""

    @property
    def vertices(self) -> NDArray[np.float64]: ...  # type: ignore[empty-body]
    @property
    def faces(self) -> NDArray[np.int64]: ...  # type: ignore[empty-body]


class TriangleMesh:
    """A mesh with the attributes of `open3d.geometry.TriangleMesh`."""

    vertices: Any
    triangles: Any


class TensorMesh:
    """A mesh with the attributes of `open3d.t.geometry.TriangleMesh`."""

    vertex: Any
    triangle: Any


class MeshioMesh:
    """A mesh with the attributes of `meshio.Mesh`."""

    points: Any
    cells: list[Any]


def arrays(points: NDArray[np.float32], faces: NDArray[np.int32]) -> None:
    small = striata.simplify(points, faces, ratio=0.1)
    assert_type(small, striata.Simplified)
    assert_type(small.points, Array)
    assert_type(small.attributes, dict[str, Array])
    assert_type(striata.simplify((points, faces), triangles=100), striata.Simplified)
    assert_type(striata.simplify([[0, 0, 0], [1, 0, 0], [0, 1, 0]], [[0, 1, 2]], ratio=1.0), striata.Simplified)
    lod = striata.build(points, faces, guaranteed=True, cost="tracked", locked=[1, 2])
    assert_type(lod, striata.Lod[tuple[Array, Array]])
    level = lod.level(max_error="0.1%")
    assert_type(level, striata.Level[tuple[Array, Array]])
    assert_type(level.to_mesh(), tuple[Array, Array])
    assert_type(level.error, float)
    assert_type(lod.levels([1.0, 0.5]), list[striata.Level[tuple[Array, Array]]])
    assert_type(lod.fine_to_coarse(level), NDArray[np.int32])
    view = lod.view()
    view.update(eye=(0, 0, 1), target=np.zeros(3), pixels=2.0)
    assert_type(view.faces, Array)


def other_packages(
    poly_data: PolyData, mesh: Trimesh, legacy: TriangleMesh, tensor: TensorMesh, mixed: MeshioMesh
) -> None:
    assert_type(striata.simplify(poly_data, target_reduction=0.9), PolyData)
    assert_type(striata.simplify(mesh, ratio=0.1), Trimesh)
    assert_type(striata.simplify(legacy, ratio=0.1), TriangleMesh)
    assert_type(striata.simplify(tensor, ratio=0.1), TensorMesh)
    assert_type(striata.simplify(mixed, ratio=0.1), MeshioMesh)
    assert_type(striata.build(mesh), striata.Lod[Trimesh])
    assert_type(striata.build(poly_data).level(ratio=0.5).to_mesh(), PolyData)
    assert_type(striata.build(legacy).level(ratio=0.5).to_mesh(), TriangleMesh)


def files(path: Path, text: str, data: bytes) -> None:
    assert_type(striata.simplify(text, ratio=0.1), striata.Mesh)
    assert_type(striata.simplify(path, ratio=0.1), striata.Mesh)
    assert_type(striata.build(path), striata.Lod[striata.Mesh])
    assert_type(striata.decode(data), striata.Lod[striata.Mesh] | striata.LodScene)
    striata.simplify(path, ratio=0.1).save("small.ply")


def scenes(scene: striata.Scene, mesh: striata.Mesh) -> None:
    assert_type(striata.simplify(scene, ratio=0.1), striata.Scene)
    assert_type(striata.simplify(mesh, ratio=0.1), striata.Mesh)
    assert_type(striata.build(scene), striata.LodScene)
    assert_type(striata.build(mesh).level(ratio=0.1).to_mesh(), striata.Mesh)
    assert_type(striata.build(scene).level(ratio=0.1).to_scene(), striata.Scene)


def options(points: Array, faces: Array, bar: Callable[[str, int, int], None]) -> None:
    striata.simplify(points, faces, ratio=0.1, attributes={"uv": points}, weights={"uv": 0.1}, progress=bar)
    assert_type(striata.distance((points, faces), (points, faces)).rms, float)
    for strip in striata.strip(points, faces, method="cheapest"):
        assert_type(strip, NDArray[np.int32])
    lods: list[striata.Lod] = [striata.build(points, faces)]
    assert_type(lods[0].level(ratio=0.1).to_mesh(), Any)


def mistakes(points: Array, faces: Array, lod: striata.Lod[Any]) -> None:
    striata.simplify(points, ratio=0.1)  # type: ignore[call-overload]
    striata.simplify(points, faces, percent=10)  # type: ignore[call-overload]
    striata.simplify(points, faces, ratio=0.1, cost="best")  # type: ignore[call-overload]
    striata.build(points, faces, ratio=0.1)  # type: ignore[call-overload]
    striata.build(3)  # type: ignore[call-overload]
    lod.level(10)  # type: ignore[call-arg]
