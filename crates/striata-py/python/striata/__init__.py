"""Simplification, levels of detail and progressive streams of triangle meshes: arrays in, arrays out.

>>> import striata
>>> points, faces = striata.shapes.terrain(40)              # or any arrays, files, meshes of other packages
>>> points, faces = striata.simplify(points, faces, ratio=0.1)
>>> lod = striata.build(points, faces)                      # every level at once
>>> lod.level(triangles=100).faces.shape
(100, 3)
"""

from . import plot, shapes
from ._build import build
from ._clusters import Clusters, clusters
from ._distance import Distance, OneSidedDistance, distance
from ._files import convert, open, save
from ._level import Level
from ._lod import Lod
from ._mesh import Group, Image, Material, Mesh
from ._paged import PagedLod
from ._plan import Plan, Simulation, plan
from ._run import run
from ._scene import Instance, LodScene, Scene, SceneLevel
from ._sequence import Sequence
from ._simplified import Simplified
from ._simplify import simplify
from ._stream import StreamDecoder, decode, encode
from ._striata import DecodeError, __version__
from ._strip_level import StripLevel
from ._strips import RESTART, Strips, strip
from ._tiles import tiles
from ._view import View
from ._viewer import page, view
from ._warn import ReadWarning

__all__ = [
    "RESTART",
    "Clusters",
    "DecodeError",
    "Distance",
    "Group",
    "Image",
    "Instance",
    "Level",
    "Lod",
    "LodScene",
    "Material",
    "Mesh",
    "OneSidedDistance",
    "PagedLod",
    "Plan",
    "ReadWarning",
    "Scene",
    "SceneLevel",
    "Sequence",
    "Simplified",
    "Simulation",
    "StreamDecoder",
    "StripLevel",
    "Strips",
    "View",
    "__version__",
    "build",
    "clusters",
    "convert",
    "decode",
    "distance",
    "encode",
    "open",
    "page",
    "plan",
    "plot",
    "run",
    "save",
    "shapes",
    "simplify",
    "strip",
    "tiles",
    "view",
]
