"""Files: `open`, `save` and `convert`."""

from __future__ import annotations

import os
import warnings
from typing import Any

from . import _striata
from ._inputs import input_of
from ._lod import Level, Lod
from ._mesh import Mesh
from ._progress import Progress
from ._scene import LodScene, Scene, SceneLevel

Path = str | os.PathLike[str]

_WRAPPERS: dict[type, Any] = {
    _striata.MeshData: Mesh._of,
    _striata.SceneData: Scene._of,
    _striata.LodData: Lod._of,
    _striata.LodSceneData: LodScene._of,
}


def wrap(data: Any) -> Mesh | Scene | Lod | LodScene:
    """Return the public object for one of the extension."""
    wrapped: Mesh | Scene | Lod | LodScene = _WRAPPERS[type(data)](data)
    return wrapped


def open(path: Path) -> Any:
    """Open a file; its content decides what is returned.

    Parameters
    ----------
    path : str or path-like
        PLY, OBJ, STL, OFF, glTF, GLB, ``.striata`` or ``.stri``; all also compressed, as ``.gz`` or ``.zst``.

    Returns
    -------
    Mesh, Scene, Lod or LodScene
        A `Mesh` for mesh files, a `Scene` for glTF, a `Lod` or a `LodScene` for files with levels.

    Raises
    ------
    OSError
        If the file cannot be read.
    DecodeError
        If its content is damaged or of an unknown format; the message names line or byte.

    Examples
    --------
    >>> import striata
    >>> striata.open("missing.ply")
    Traceback (most recent call last):
    FileNotFoundError: [Errno 2] No such file or directory: 'missing.ply'
    """
    data, texts = _striata.open_file(os.fspath(path))
    for text in texts:
        warnings.warn(text, stacklevel=2)
    return wrap(data)


def save(path: Path, model: Any, *, ascii: bool = False, progress: Progress = False) -> None:
    """Write a mesh, a scene or levels to a file that appears complete or not at all.

    Parameters
    ----------
    path : str or path-like
        The extension decides the format. ``.striata`` and ``.stri`` keep all levels, and a `LodScene` also in
        ``.glb``; other formats get one mesh. ``.gz`` or ``.zst`` after the extension compresses (except for
        files with levels, which are not written so).
    model : Mesh, Scene, Lod, Level, LodScene, SceneLevel, or any mesh that `build` takes
        What to write.
    ascii : bool
        Whether PLY is written as text.

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
    file = os.fspath(path)
    kind = _striata.format_of(file)
    if isinstance(model, Level):
        model = Mesh._of(model.lod._placed(model.split_count))
    elif isinstance(model, SceneLevel):
        model = model.to_scene()
    if kind in ("striata", "stri"):
        _write_levels(file, kind, model, progress)
    elif isinstance(model, LodScene):
        if kind == "glb":
            _striata.write_bytes(file, model._data.to_bytes("glb", None))
        else:
            _striata.write_scene(file, model._data.full_scene())
    elif isinstance(model, Scene):
        _striata.write_scene(file, model._data)
    else:
        data = model._placed() if isinstance(model, Lod) else mesh_data_of(model)
        _striata.write_mesh(file, data, ascii)


def mesh_data_of(mesh: Any) -> _striata.MeshData:
    """Return the mesh for the extension, in the coordinates of the user."""
    if isinstance(mesh, Mesh):
        return mesh._data
    found = input_of(mesh)
    data = found.mesh_data()[0].stored()
    return data if found.points.offset == (0.0, 0.0, 0.0) else data.moved(found.points.offset)


def _write_levels(file: str, kind: str, model: Any, progress: Progress) -> None:
    from ._lod import build
    from ._stream import encode

    if kind == "stri":
        _striata.write_bytes(file, encode(model, progress=progress))
        return
    if isinstance(model, Scene):
        model = model.build(progress=progress)
    if isinstance(model, LodScene):
        _striata.write_bytes(file, model._data.to_bytes("striata", None))
        return
    if not isinstance(model, Lod):
        model = build(model, progress=progress)
    _striata.write_bytes(file, model._data.to_striata(model._offset()))


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


