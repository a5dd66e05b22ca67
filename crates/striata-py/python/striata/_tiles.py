"""Tiles for viewers, and arrays of all levels: the function `tiles`."""

from __future__ import annotations

import json
import os
import tempfile
from typing import Any, Literal

from . import _striata
from ._any_mesh import mesh_data_of
from ._build import build
from ._lod import Lod
from ._plan import plan
from ._progress import Progress, reporting
from ._run import run
from ._warn import warn
from ._write import Path, write_lod, write_mesh

#: Formats of folders that `tiles` writes.
TilesFormat = Literal["3dtiles"] | Literal["neuroglancer"] | Literal["zarr"]
#: How 3D Tiles store numbers.
Encoding = Literal["float"] | Literal["quantized"] | Literal["meshopt"] | Literal["draco"]


def tiles(
    mesh: Any,
    folder: Path,
    *,
    format: TilesFormat = "3dtiles",
    tile_triangles: int = 16_384,
    encoding: Encoding = "float",
    bits: Literal[10, 16] = 16,
    segment_id: int = 1,
    sharded: bool = False,
    progress: Progress = False,
) -> dict[str, Any]:
    """Write a mesh as 3D Tiles, as a mesh for Neuroglancer, or as arrays in refinement order.

    The folder appears complete or not at all; one that an earlier call has written is replaced.

    Parameters
    ----------
    mesh : mesh or path
        Anything that `build` takes as one argument, or a `Lod` (for ``"zarr"``, its levels are written). The path of a
        paged file is read in place for tiles, and may be larger than memory.
    folder : path
        Folder to write; 3D Tiles become one file if it ends in ``.3tz``.
    format : str
        ``"3dtiles"`` (3D Tiles 1.1), ``"neuroglancer"`` (``neuroglancer_multilod_draco``), or ``"zarr"`` (a Zarr v3
        group, whose layout is in the guide about tiles).
    tile_triangles : int
        Triangles per tile or fragment, about.
    encoding : str
        How 3D Tiles store numbers: ``"float"``, ``"quantized"``, ``"meshopt"`` or ``"draco"``.
    bits : int
        Bits per coordinate of a vertex in its fragment, for Neuroglancer: 10 or 16.
    segment_id : int
        Number of the segment, for Neuroglancer.
    sharded : bool
        Whether Neuroglancer gets a shard instead of two files.
    progress : bool or callable
        Show a bar, or call with phase, work done and all work.

    Returns
    -------
    dict
        Numbers of what was written, as ``striata tiles --json`` prints them. Data that are left out are named in a warning.

    Raises
    ------
    OSError
        If a file cannot be read or written.
    ValueError
        If the mesh has no faces, an option is out of range, or the folder has something else in it.

    Examples
    --------
    >>> import os, striata, tempfile
    >>> points, faces = striata.shapes.torus(64, 32)
    >>> with tempfile.TemporaryDirectory() as folder:
    ...     report = striata.tiles((points, faces), os.path.join(folder, "torus.zarr"), format="zarr")
    ...     sorted(os.listdir(os.path.join(folder, "torus.zarr")))[:3]
    ['errors', 'levels', 'positions']
    >>> report["vertices"]
    2048
    """
    if format not in ("3dtiles", "neuroglancer", "zarr"):
        raise ValueError(f"format is {format!r}, but must be '3dtiles', 'neuroglancer' or 'zarr'")
    if encoding not in ("float", "quantized", "meshopt", "draco"):
        raise ValueError(f"encoding is {encoding!r}, but must be 'float', 'quantized', 'meshopt' or 'draco'")
    if bits not in (10, 16):
        raise ValueError(f"bits is {bits}, but must be 10 or 16")
    if not 0 <= segment_id < 1 << 64:
        raise ValueError(f"segment_id is {segment_id}, but must be from 0 to 2**64 - 1")
    if not 100 <= tile_triangles <= 1_000_000:
        raise ValueError(f"tile_triangles is {tile_triangles}, but must be from 100 to 1,000,000")
    options = {
        "format": format,
        "tile_triangles": tile_triangles,
        "encoding": encoding,
        "bits": bits,
        "segment_id": segment_id,
        "sharded": sharded,
    }
    output = os.path.abspath(os.fspath(folder))
    with tempfile.TemporaryDirectory(prefix=".striata-", dir=os.path.dirname(output)) as work:
        source = _levels_of(mesh, work, progress) if format == "zarr" else _pages_of(mesh, work, progress)
        with reporting(progress) as callback:
            report: dict[str, Any] = json.loads(_striata.write_tiles(source, output, options, callback))
    for remark in report["left_out"]:
        warn(remark)
    return report


def _is_paged(mesh: Any) -> bool:
    if not isinstance(mesh, (str, os.PathLike)):
        return False
    path = os.fspath(mesh)
    return path.endswith(".striata") and isinstance(_striata.open_file(path)[0], _striata.PagedLodData)


def _levels_of(mesh: Any, work: str, progress: Progress) -> str:
    """Return a ``.striata`` file with all levels."""
    if _is_paged(mesh):
        raise ValueError(f"{os.fspath(mesh)} is a paged file, but arrays are made of levels in memory")
    lod = mesh if isinstance(mesh, Lod) else build(mesh, progress=progress)
    if not isinstance(lod, Lod):
        raise ValueError("a scene has several meshes, but arrays are those of one")
    path = os.path.join(work, "levels.striata")
    write_lod(path, lod._data, lod._offset)
    return path


def _pages_of(mesh: Any, work: str, progress: Progress) -> str:
    """Return a paged file."""
    if _is_paged(mesh):
        return str(os.fspath(mesh))
    path = os.path.join(work, "mesh.glb")
    if isinstance(mesh, Lod):
        write_lod(path, mesh._data, mesh._offset)
    else:
        write_mesh(path, mesh_data_of(*mesh) if isinstance(mesh, tuple) else mesh_data_of(mesh))
    pages = os.path.join(work, "pages.striata")
    made = run(plan(path, pages, progress=progress), progress=progress)
    made.remove_work()
    return pages
