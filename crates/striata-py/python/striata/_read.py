"""Reading of files, as objects of the extension."""

from __future__ import annotations

import os

from . import _striata
from ._warn import ReadWarning, warn

#: Contents of a file.
Data = _striata.MeshData | _striata.SceneData | _striata.LodData | _striata.LodSceneData


def read(path: str | os.PathLike[str], *, strict_input: bool = False) -> Data:
    """Open a file of any kind; what was left out becomes warnings, or an error."""
    data: Data
    data, texts = _striata.open_file(os.fspath(path))
    if strict_input and texts:
        raise ValueError("; ".join(texts))
    for text in texts:
        warn(text, ReadWarning)
    return data
