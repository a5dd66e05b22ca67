"""Files: `open`, `save` and `convert`."""

from __future__ import annotations

import os
from typing import Any

from . import _striata
from ._any_mesh import mesh_data_of
from ._build import build
from ._level import Level
from ._lod import Lod
from ._mesh import Mesh
from ._paged import PagedLod
from ._progress import Progress
from ._read import read
from ._scene import LodScene, Scene, SceneLevel
from ._write import Path, write_lod, write_lod_scene, write_mesh, write_scene

#: Class of each object that a file can contain.
_CLASSES: dict[type, Any] = {
    _striata.MeshData: Mesh,
    _striata.SceneData: Scene,
    _striata.LodData: Lod,
    _striata.LodSceneData: LodScene,
    _striata.PagedLodData: PagedLod,
}


def open(path: Path, *, strict_input: bool = False) -> Any:
    """Open a file; its content decides what is returned.

    Parameters
    ----------
    path : str or path-like
        PLY, OBJ, STL, OFF, glTF, GLB, VTK (``.vtk``, ``.vtp``, ``.vtu``), 3MF, ``.striata`` or ``.stri``; all also compressed, as ``.gz`` or ``.zst``.
    strict_input : bool
        Whether to raise an error if something must be left out of the file or repaired, instead of a `ReadWarning`.

    Returns
    -------
    Mesh, Scene, Lod, LodScene or PagedLod
        A `Mesh` for mesh files, a `Scene` for glTF, a `Lod` or a `LodScene` for files with levels, a `PagedLod`
        for paged files and folders of pages.

    Raises
    ------
    OSError
        If the file cannot be read.
    ValueError
        With ``strict_input``, if something must be left out.
    DecodeError
        If its content is damaged or of an unknown format; the message names line or byte.

    Examples
    --------
    >>> import striata
    >>> striata.open("missing.ply")
    Traceback (most recent call last):
    FileNotFoundError: [Errno 2] No such file or directory: 'missing.ply'
    """
    data = read(path, strict_input=strict_input)
    return _CLASSES[type(data)]._of(data)


def save(
    path: Path,
    model: Any,
    *,
    ascii: bool = False,
    embed: bool = False,
    shading: bool = False,
    progress: Progress = False,
) -> None:
    """Write a mesh, a scene or levels to a file that appears complete or not at all.

    Parameters
    ----------
    path : str or path-like
        The extension decides the format. ``.striata`` and ``.stri`` keep all levels, and a `LodScene` also in
        ``.glb``; other formats get one mesh. ``.gz`` or ``.zst`` after the extension compresses meshes and
        scenes; files with levels are refused, since they are compressed already.
    model : Mesh, Scene, Lod, Level, LodScene, SceneLevel, or any mesh that `build` takes
        What to write.
    ascii : bool
        Whether PLY is written as text.
    embed : bool
        Whether a ``.gltf`` file contains its buffer and images, which takes a third more bytes, instead of having
        them as files next to it.
    shading : bool
        Whether a mesh without normals gets smooth ones in glTF, up to creases of 50 degrees, and a mesh without
        materials a matte one. Points at creases are divided.

    Raises
    ------
    OSError
        If the file cannot be written.
    ValueError
        If the format cannot store the model.

    Examples
    --------
    >>> import os, striata, tempfile
    >>> points, faces = striata.shapes.torus(16, 8)
    >>> with tempfile.TemporaryDirectory() as folder:
    ...     path = os.path.join(folder, "torus.striata")
    ...     striata.save(path, striata.build(points, faces))
    ...     striata.open(path)
    <striata.Lod: 128 points, 256 faces, ...>
    """
    if isinstance(model, (str, os.PathLike)) and not isinstance(path, (str, os.PathLike)):
        raise TypeError(f"the file comes first: striata.save({os.fspath(model)!r}, mesh)")
    is_level = isinstance(model, (Level, SceneLevel))
    if isinstance(model, SceneLevel):
        model = model.to_scene()
    elif _striata.format_of(os.fspath(path)) == "striata" and not isinstance(model, (Mesh, Lod, Level, Scene, LodScene)):
        # Points in double precision keep their digits until they are stored.
        model = build(model, progress=progress)
    if isinstance(model, Lod):
        write_lod(
            path, model._data, model._offset, ascii=ascii, embed=embed, shading=shading, progress=progress
        )
    elif isinstance(model, LodScene):
        write_lod_scene(path, model._data, embed=embed, progress=progress)
    elif isinstance(model, Scene):
        write_scene(path, model._data, embed=embed, is_level=is_level, progress=progress)
    else:
        data = model._mesh_data() if isinstance(model, Level) else mesh_data_of(model)
        write_mesh(
            path, data, ascii=ascii, embed=embed, shading=shading, is_level=is_level, progress=progress
        )


def convert(source: Path, target: Path, *, ascii: bool = False, progress: Progress = False) -> None:
    """Convert a file to another format; the extensions decide the formats.

    Parameters
    ----------
    source : str or path-like
        Any file that `open` reads.
    target : str or path-like
        Any file that `save` writes. Levels are built if the target stores them and the source does not.

    Examples
    --------
    >>> import os, striata, tempfile
    >>> mesh = striata.Mesh(*striata.shapes.torus(16, 8))
    >>> with tempfile.TemporaryDirectory() as folder:
    ...     mesh.save(os.path.join(folder, "torus.ply"))
    ...     striata.convert(os.path.join(folder, "torus.ply"), os.path.join(folder, "torus.glb"))
    ...     striata.open(os.path.join(folder, "torus.glb"))
    <striata.Scene: 1 mesh, 0 images, 256 faces>
    """
    save(target, open(source), ascii=ascii, progress=progress)


