"""The interactive viewer: full size in a browser, or small in a notebook."""

from __future__ import annotations

import html
import tempfile
import webbrowser
from pathlib import Path
from typing import Any

from . import _striata
from ._lod import Level, Lod
from ._stream import encode

#: Largest page that a notebook embeds, in bytes; larger models get a table.
NOTEBOOK_LIMIT = 4_000_000

#: A stream rarely takes more bytes for a face; larger models are not even encoded for a notebook.
_BYTES_PER_FACE = 4


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


def html_of_lod(lod: Lod) -> str:
    """Return what a notebook shows for all levels."""
    rows: list[tuple[str, ...]] = [("level", "faces", "points", "error")]
    for share in (1.0, 0.5, 0.25, 0.1, 0.01):
        level = lod.level(ratio=share)
        rows.append((f"{share:.0%}", f"{level.triangle_count:,}", f"{level.vertex_count:,}", f"{level.error:.3g}"))
    return _frame(lod, lod.face_count) + _table(rows)


def html_of_level(level: Level) -> str:
    """Return what a notebook shows for one level."""
    facts = (f"{level.triangle_count:,}", f"{level.vertex_count:,}", f"{level.error:.3g}")
    return _frame(level, level.triangle_count) + _table([("faces", "points", "error"), facts])


def _frame(model: Lod | Level, face_count: int) -> str:
    """Return the viewer as a frame; nothing for a model that is empty or too large."""
    if face_count == 0 or face_count * _BYTES_PER_FACE > NOTEBOOK_LIMIT:
        return ""
    text = page(model)
    if len(text) > NOTEBOOK_LIMIT:
        return ""
    style = "width:100%;max-width:640px;height:400px;border:0"
    return f'<iframe sandbox="allow-scripts" style="{style}" srcdoc="{html.escape(text)}"></iframe>'


def _table(rows: list[tuple[str, ...]]) -> str:
    lines = []
    for index, row in enumerate(rows):
        tag = "th" if index == 0 else "td"
        lines.append("<tr>" + "".join(f"<{tag}>{html.escape(cell)}</{tag}>" for cell in row) + "</tr>")
    return "<table>" + "".join(lines) + "</table>"
