"""Whole glTF scenes: `Scene`, `LodScene` and `SceneLevel`."""

from __future__ import annotations

import json
import os
from dataclasses import dataclass
from functools import cached_property
from typing import Any

import numpy as np
from numpy.typing import NDArray

from . import _striata
from ._display import counted
from ._layers import Weights, file_weights
from ._lod import Lod
from ._mesh import Image, Mesh
from ._options import Boundary, Cost, Seams, Topology, options_of
from ._progress import Progress, reporting
from ._targets import Target, Targets, level_within, number
from ._write import write_lod_scene, write_scene


@dataclass(frozen=True)
class Instance:
    """A mesh that a node of a scene shows."""

    #: Index of the node, or `None` if the document has no nodes.
    node: int | None
    #: Index of the mesh in `Scene.meshes`.
    mesh: int
    #: Matrix of shape (4, 4) from the mesh to the scene.
    transform: NDArray[np.float64]


class Scene:
    """A glTF document with its meshes and images apart.

    Made by `striata.open`. Materials, nodes, skins, animations and everything else is in `document`, and is
    kept when the scene is saved.
    """

    def __init__(self, mesh: Mesh) -> None:
        self._data = _striata.SceneData.of_mesh(mesh._data)

    @classmethod
    def _of(cls, data: _striata.SceneData) -> Scene:
        scene = cls.__new__(cls)
        scene._data = data
        return scene

    @cached_property
    def document(self) -> dict[str, Any]:
        """The glTF document, without the data of meshes and images."""
        document: dict[str, Any] = json.loads(self._data.document())
        return document

    @cached_property
    def meshes(self) -> list[Mesh | None]:
        """Triangles of each mesh of the document; `None` for meshes without triangles."""
        return [None if data is None else Mesh._of(data) for data in self._data.meshes()]

    @property
    def mesh_names(self) -> list[str]:
        """Name of each mesh; empty if it has none."""
        return self._data.mesh_names()

    @cached_property
    def images(self) -> list[Image]:
        """Images of the document."""
        return [Image(*image) for image in self._data.images()]

    @property
    def instances(self) -> list[Instance]:
        """Contents of the scene."""
        shown = self._data.instances()
        return [Instance(node, mesh, np.array(matrix).reshape(4, 4).T) for node, mesh, matrix in shown]

    @property
    def warnings(self) -> list[str]:
        """Files that were missing when the scene was read."""
        return self._data.warnings()

    @property
    def triangle_count(self) -> int:
        """Number of faces shown; those of a mesh count once for each instance."""
        return self._data.face_count

    @property
    def diagonal(self) -> float:
        """Length of the diagonal of the bounding box."""
        return self._data.diagonal

    def flattened(self) -> Mesh:
        """Return one mesh of everything shown, with all transforms applied."""
        return Mesh._of(self._data.flattened())

    def deduplicate(self) -> Scene:
        """Return the scene with equal images, textures, materials, vertices and meshes merged.

        Materials and meshes with different names stay apart. A scene with an unknown extension, which may refer to
        any part by its number, stays as it is.
        """
        return Scene._of(self._data.deduplicated())

    def resample(self, tolerance: float = 1e-4) -> Scene:
        """Return the scene without keyframes that their neighbors give within a tolerance.

        The tolerance is relative to the largest number of each animated property, which is 1 for rotations.

        Raises
        ------
        ValueError
            If the tolerance is negative, or the data of an animation are damaged.
        """
        converted = number(tolerance, "tolerance")
        if converted < 0:
            raise ValueError(f"tolerance is {converted}, but must be at least 0")
        return Scene._of(self._data.resampled(converted))

    def build(
        self,
        *,
        guaranteed: bool = False,
        weights: Weights = None,
        cost: Cost = "memoryless",
        boundary: Boundary = "keep",
        seams: Seams = "cross",
        topology: Topology = "change",
        height_field: bool | None = None,
        pair_distance: float | None = None,
        coarsest: int = 0,
        progress: Progress = False,
    ) -> LodScene:
        """Build all levels of all meshes; see `striata.build`. `coarsest` applies to each mesh."""
        options = options_of(
            cost=cost,
            boundary=boundary,
            seams=seams,
            topology=topology,
            height_field=height_field,
            pair_distance=pair_distance,
            coarsest=coarsest,
            weights=file_weights(weights),
        )
        with reporting(progress) as callback:
            return LodScene._of(self._data.build(guaranteed, options, callback))

    def save(self, path: str | os.PathLike[str], *, embed: bool = False) -> None:
        """Write the scene; see `striata.save`."""
        write_scene(path, self._data, embed=embed)

    def __repr__(self) -> str:
        meshes, images = counted(len(self.mesh_names), "mesh"), counted(len(self.images), "image")
        return f"<striata.Scene: {meshes}, {images}, {counted(self.triangle_count, 'face')}>"


class LodScene:
    """A scene with every level of detail of each of its meshes; made by `Scene.build`, `open` and `decode`."""

    _data: _striata.LodSceneData

    def __init__(self, *arguments: Any) -> None:
        raise TypeError("a LodScene is made by Scene.build, striata.open or striata.decode")

    @classmethod
    def _of(cls, data: _striata.LodSceneData) -> LodScene:
        lods = cls.__new__(cls)
        lods._data = data
        return lods

    @cached_property
    def lods(self) -> list[Lod[Mesh] | None]:
        """Levels of each mesh of the document; `None` for meshes without triangles."""
        return [None if data is None else Lod._of(data) for data in self._data.lods()]

    @property
    def triangle_count(self) -> int:
        """Number of faces of the full scene; those of a mesh count once for each instance."""
        return self._data.face_count

    @property
    def has_guaranteed_errors(self) -> bool:
        """Whether errors are bounds rather than estimates."""
        return self._data.has_guaranteed_errors

    @cached_property
    def diagonal(self) -> float:
        """Length of the diagonal of the bounding box."""
        return self._data.diagonal

    def level(
        self,
        *,
        triangles: int | None = None,
        vertices: int | None = None,
        ratio: float | None = None,
        detail: float | None = None,
        error: float | str | None = None,
        max_error: float | str | None = None,
        target_reduction: float | None = None,
        target_count: int | None = None,
    ) -> SceneLevel:
        """Return a level of the scene, whose meshes all have the same error; see `Lod.level`."""
        targets = Targets(
            triangles=triangles,
            vertices=vertices,
            ratio=ratio,
            detail=detail,
            error=error,
            max_error=max_error,
            target_reduction=target_reduction,
            target_count=target_count,
        )
        request = targets.request(self.triangle_count, self.diagonal)
        return level_within(request, self._level, self.has_guaranteed_errors)

    def _level(self, target: Target) -> SceneLevel:
        _, triangles, vertices, error, reason = self._data.level(target)
        return SceneLevel(self, target, triangles, vertices, error, reason)

    def full_scene(self) -> Scene:
        """Return the scene with all of its triangles."""
        return Scene._of(self._data.full_scene())

    def save(self, path: str | os.PathLike[str]) -> None:
        """Write all levels to a ``.striata``, ``.stri`` or ``.glb`` file; see `striata.save`."""
        write_lod_scene(path, self._data)

    def __repr__(self) -> str:
        return f"<striata.LodScene: {counted(self.triangle_count, 'face')}>"


class SceneLevel:
    """One level of detail of a `LodScene`."""

    def __init__(
        self, lods: LodScene, target: Target, triangles: int, vertices: int, error: float, reason: str
    ) -> None:
        self._lods, self._target = lods, target
        #: Number of faces; those of a mesh count once for each instance.
        self.triangle_count = triangles
        #: Number of points; those of a mesh count once.
        self.vertex_count = vertices
        #: Largest error of all meshes, in units of the scene.
        self.error = error
        #: How well the target is met; see `Level`.
        self.stop_reason = reason

    def to_scene(self) -> Scene:
        """Return the level as a scene, with materials, images and animations."""
        return Scene._of(self._lods._data.level_scene(self._target))

    def save(self, path: str | os.PathLike[str], *, embed: bool = False) -> None:
        """Write the level as a scene, with its faces in an order for vertex caches; see `striata.save`."""
        write_scene(path, self.to_scene()._data, embed=embed, is_level=True)

    def __repr__(self) -> str:
        return f"<striata.SceneLevel: {counted(self.triangle_count, 'face')}, error {self.error:.3g}>"
