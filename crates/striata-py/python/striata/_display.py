"""How objects present themselves: counts in a `repr`, and a viewer with a table in a notebook."""

from __future__ import annotations

import html

from . import _striata

#: Largest page that a notebook embeds, in bytes; larger models get a table only.
NOTEBOOK_LIMIT = 4_000_000

#: A stream rarely takes more bytes for a face; larger models are not even encoded for a notebook.
_BYTES_PER_FACE = 4

#: Bits of a coordinate in a notebook: finer than a pixel of the frame.
_BITS = 14


def counted(count: int, noun: str) -> str:
    """Return text such as ``1 face`` or ``1,234 faces``."""
    plural = f"{noun}es" if noun.endswith("sh") else f"{noun}s"
    return f"{count:,} {noun if count == 1 else plural}"


def notebook_html(data: _striata.MeshData, rows: list[tuple[str, ...]]) -> str:
    """Return what a notebook shows for a model: a small viewer, if the model is small enough, and a table."""
    return _frame(data) + _table(rows)


def _frame(data: _striata.MeshData) -> str:
    """Return the viewer as a frame; nothing for a model that is empty or too large."""
    if data.face_count == 0 or data.face_count * _BYTES_PER_FACE > NOTEBOOK_LIMIT:
        return ""
    stream = _striata.encode_mesh(data, (_BITS, None, "fast"), None)
    text = _striata.viewer_page("model.stri", stream)
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
