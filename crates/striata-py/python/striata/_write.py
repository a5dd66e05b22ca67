"""Writing of files from objects of the extension; the name of the file decides the format.

Formats with levels are ``.striata`` and ``.stri``; what has none yet is simplified first, with the default
options.
"""

from __future__ import annotations

import os

from . import _striata
from ._options import options_of
from ._progress import Progress, reporting
from ._warn import warn

Path = str | os.PathLike[str]

#: Precision and effort of streams that are written to files, as `encode_mesh` takes them.
DEFAULT_QUALITY = (14, None, "fast")
#: Longest side of the previews of textures in such streams, in pixels.
DEFAULT_PREVIEW_SIDE = 128


def _file_and_kind(path: Path, *, with_levels: tuple[str, ...] = ("striata", "stri")) -> tuple[str, str | None]:
    """Return the name of a file and its format."""
    file = os.fspath(path)
    kind = _striata.format_of(file)
    if kind in with_levels and file.lower().endswith((".gz", ".zst")):
        raise ValueError(f"{file}: files with levels are compressed already; leave out .gz or .zst")
    return file, kind


def _warn_of(losses: list[str]) -> None:
    """Warn of what a format cannot store."""
    for loss in losses:
        warn(loss)


def write_mesh(
    path: Path,
    data: _striata.MeshData,
    *,
    ascii: bool = False,
    embed: bool = False,
    shading: bool = False,
    is_level: bool = False,
    progress: Progress = False,
) -> None:
    """Write a mesh, in the coordinates of the user; levels with their faces in an order for vertex caches."""
    file, kind = _file_and_kind(path)
    with reporting(progress) as callback:
        if kind == "striata":
            lod = _striata.build(data, False, options_of(), callback)
            _striata.write_bytes(file, lod.to_striata((0.0, 0.0, 0.0)))
        elif kind == "stri":
            _striata.write_bytes(file, _striata.encode_mesh(data, DEFAULT_QUALITY, callback))
        else:
            options = {"ascii": ascii, "embed": embed, "shading": shading, "is_level": is_level}
            _warn_of(_striata.write_mesh(file, data, options))


def write_lod(
    path: Path,
    data: _striata.LodData,
    offset: tuple[float, float, float],
    *,
    ascii: bool = False,
    embed: bool = False,
    shading: bool = False,
    progress: Progress = False,
) -> None:
    """Write all levels of a mesh, or the full mesh; `offset` is added to the points."""
    file, kind = _file_and_kind(path)
    if kind == "striata":
        _striata.write_bytes(file, data.to_striata(offset))
    else:
        mesh = data.mesh().moved(offset)
        write_mesh(path, mesh, ascii=ascii, embed=embed, shading=shading, progress=progress)


def write_scene(
    path: Path,
    data: _striata.SceneData,
    *,
    embed: bool = False,
    is_level: bool = False,
    progress: Progress = False,
) -> None:
    """Write a scene; levels with their faces in an order for vertex caches."""
    file, kind = _file_and_kind(path)
    with reporting(progress) as callback:
        if kind == "striata":
            lods = data.build(False, options_of(), callback)
            _striata.write_bytes(file, lods.to_bytes("striata", callback))
        elif kind == "stri":
            _striata.write_bytes(file, _striata.encode_scene(data, DEFAULT_QUALITY, DEFAULT_PREVIEW_SIDE, callback))
            _warn_of(data.losses(kind, file))
        else:
            options = {"ascii": False, "embed": embed, "shading": False, "is_level": is_level}
            _warn_of(_striata.write_scene(file, data, options))


def write_lod_scene(
    path: Path, data: _striata.LodSceneData, *, embed: bool = False, progress: Progress = False
) -> None:
    """Write all levels of a scene, or the full scene."""
    file, kind = _file_and_kind(path, with_levels=("striata", "stri", "glb"))
    if kind in ("striata", "glb"):
        with reporting(progress) as callback:
            _striata.write_bytes(file, data.to_bytes(kind, callback))
        if kind == "glb":
            _warn_of(data.full_scene().losses(kind, file))
    else:
        write_scene(path, data.full_scene(), embed=embed, progress=progress)
