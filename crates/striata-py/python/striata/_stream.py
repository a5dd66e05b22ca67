"""Progressive streams: `encode`, `decode` and `StreamDecoder`."""

from __future__ import annotations

from typing import Any, Literal

import numpy as np
from numpy.typing import ArrayLike, NDArray

from . import _striata
from ._any_mesh import mesh_data_of
from ._arrays import AnyArray
from ._level import Level
from ._lod import Lod
from ._mesh import Mesh
from ._progress import Progress, reporting
from ._scene import LodScene, Scene
from ._targets import count, length

#: Trade-off between speed of decoding and size.
Effort = Literal["fast"] | Literal["compact"]


def encode(
    mesh: Any,
    faces: ArrayLike | None = None,
    *,
    bits: int = 14,
    tolerance: float | None = None,
    lossless: bool = False,
    effort: Effort = "fast",
    preview_side: int = 128,
    progress: Progress = False,
) -> bytes:
    """Compress a mesh or a scene to a stream, of which every prefix is a mesh.

    Parameters
    ----------
    mesh : any mesh that `build` takes, Lod, Level, Scene or LodScene
        What to encode. Levels are built anew, in the order that compresses best.
    faces : array_like, optional
        Faces, if `mesh` is an array of points.
    bits : int
        Bits of a coordinate along the longest side of the bounding box, 1 to 24.
    tolerance : float, optional
        Instead of `bits`: how far a point may move, in mesh units.
    lossless : bool
        Instead of `bits`: whether to keep every bit of points and attributes.
    effort : {"fast", "compact"}
        ``"fast"`` decodes three times as quickly, ``"compact"`` is 6 to 26 % smaller: for slow lines and
        storage.
    preview_side : int
        Scenes only: longest side of the previews of textures, in pixels.

    Returns
    -------
    bytes
        The stream, which `decode`, `StreamDecoder` and the viewer read.

    Examples
    --------
    >>> import striata
    >>> points, faces = striata.shapes.torus(64, 32)
    >>> stream = striata.encode(points, faces)
    >>> len(stream) < (points.nbytes + faces.nbytes) / 8
    True
    >>> striata.decode(stream)
    <striata.Lod: 2,048 points, 4,096 faces, ...>
    """
    if lossless and tolerance is not None:
        raise ValueError("tolerance and lossless exclude each other")
    step = None if tolerance is None else length(tolerance, 0.0, "tolerance")
    quality = (None if lossless or tolerance is not None else _bits(bits), step, effort)
    side = count(preview_side, "preview_side")
    if isinstance(mesh, LodScene):
        mesh = mesh.full_scene()
    with reporting(progress) as callback:
        if isinstance(mesh, Scene):
            return _striata.encode_scene(mesh._data, quality, side, callback)
        data = mesh._mesh_data() if isinstance(mesh, (Lod, Level)) else mesh_data_of(mesh, faces)
        return _striata.encode_mesh(data, quality, callback)


def _bits(bits: int) -> int:
    if int(bits) != bits or not 1 <= bits <= 24:
        raise ValueError(f"bits is {bits}, but must be from 1 to 24")
    return int(bits)


def decode(
    data: bytes | bytearray | memoryview, *, allow_truncated: bool = False, progress: Progress = False
) -> Lod[Mesh] | LodScene:
    """Decode a stream or the content of a ``.striata`` file.

    Parameters
    ----------
    data : bytes-like
        The bytes.
    allow_truncated : bool
        Whether a stream may end early; what is there is decoded.
    progress : bool or callable
        See `simplify`.

    Returns
    -------
    Lod or LodScene
        All levels of the mesh or of the scene.

    Raises
    ------
    DecodeError
        If the bytes are damaged or of another kind.

    Examples
    --------
    >>> import striata
    >>> striata.decode(b"hello")
    Traceback (most recent call last):
    striata.DecodeError: ...
    """
    with reporting(progress) as callback:
        found = _striata.decode(bytes(data), allow_truncated, callback)
    return LodScene._of(found) if isinstance(found, _striata.LodSceneData) else Lod._of(found)


class StreamDecoder:
    """Decodes the stream of a mesh while its bytes arrive.

    Examples
    --------
    >>> import striata
    >>> stream = striata.encode(*striata.shapes.torus(64, 32))
    >>> decoder = striata.StreamDecoder()
    >>> counts = []
    >>> for start in range(0, len(stream), 1000):
    ...     decoder.push(stream[start : start + 1000])
    ...     counts.append(len(decoder.faces))
    >>> counts == sorted(counts), counts[-1], decoder.is_complete
    (True, 4096, True)
    """

    def __init__(self) -> None:
        self._data = _striata.DecoderData()

    def push(self, data: bytes | bytearray | memoryview) -> None:
        """Accept the next bytes, and decode all chunks that are complete.

        If the call is interrupted, the next call decodes the rest of these bytes first.

        Raises
        ------
        DecodeError
            If the bytes are damaged. Data that was decoded before remains available.
        """
        self._data.push(bytes(data))

    def finish(self) -> None:
        """Decode what it can of a stream that will not go on; no more bytes are accepted."""
        self._data.finish()

    @property
    def points(self) -> AnyArray:
        """Points decoded so far, shape (n, 3)."""
        return self._data.points()

    @property
    def faces(self) -> NDArray[np.int32]:
        """Faces of the finest level decoded so far, shape (m, 3)."""
        return self._data.faces()

    @property
    def is_complete(self) -> bool:
        """Whether the whole stream has been decoded."""
        return self._data.facts()[0]

    @property
    def split_count(self) -> int:
        """Number of vertex splits decoded so far."""
        return self._data.facts()[1]

    @property
    def step_count(self) -> int | None:
        """Number of vertex splits of the whole stream; `None` until the header has arrived."""
        return self._data.facts()[2]

    @property
    def error(self) -> float | None:
        """Distance of what has been decoded from the full mesh, in mesh units; `None` until known."""
        return self._data.facts()[3]

    @property
    def byte_count(self) -> int | None:
        """Length of the whole stream; `None` until the header has arrived."""
        return self._data.facts()[4]

    def lod(self) -> Lod[Mesh] | None:
        """Return all levels decoded so far; `None` before the coarsest one has arrived."""
        data = self._data.lod()
        return None if data is None else Lod._of(data)
