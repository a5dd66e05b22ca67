"""Reading of files, as objects of the extension."""

from __future__ import annotations

import os

from . import _striata
from ._warn import warn

#: What a file contains.
Data = _striata.MeshData | _striata.SceneData | _striata.LodData | _striata.LodSceneData


def read(path: str | os.PathLike[str]) -> Data:
    """Open a file of any kind; what was missing becomes warnings."""
    data: Data
    data, texts = _striata.open_file(os.fspath(path))
    for text in texts:
        warn(text)
    return data
