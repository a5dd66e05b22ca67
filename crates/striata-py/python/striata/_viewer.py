"""The interactive viewer, full size in a browser."""

from __future__ import annotations

import tempfile
import webbrowser
from pathlib import Path
from typing import Any

from . import _striata
from ._stream import encode


def page(mesh: Any, *, name: str = "model") -> str:
    """Return a self-contained HTML page that shows a mesh, with all levels of detail.

    Parameters
    ----------
    mesh : any mesh that `build` takes, Lod, Level, Scene, LodScene, or bytes of a stream
        What to show.
    name : str
        Title of the model.

    Examples
    --------
    >>> import striata
    >>> text = striata.page(striata.shapes.torus(16, 8))
    >>> text.lstrip()[:15].lower()
    '<!doctype html>'
    """
    stream = bytes(mesh) if isinstance(mesh, (bytes, bytearray, memoryview)) else encode(mesh)
    return _striata.viewer_page(f"{name}.stri", stream)


def view(mesh: Any, *, path: str | None = None, open_browser: bool = True) -> Path:
    """Show a mesh in the browser, full size.

    Parameters
    ----------
    mesh : any mesh that `build` takes, Lod, Level, Scene, LodScene, or bytes of a stream
        What to show.
    path : str, optional
        Where to write the page; by default a temporary file.
    open_browser : bool
        Whether to open the page.

    Returns
    -------
    pathlib.Path
        The page, which needs neither a server nor a network.
    """
    text = page(mesh)
    target = Path(tempfile.mkdtemp(prefix="striata-")) / "model.html" if path is None else Path(path)
    target.write_text(text, encoding="utf-8")
    if open_browser:
        webbrowser.open(target.resolve().as_uri())
    return target
