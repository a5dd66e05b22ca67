"""The class `PagedLod`: levels of a mesh of any size, read page by page."""

from __future__ import annotations

import json
from functools import cached_property
from typing import Any

from numpy.typing import ArrayLike

from . import _striata
from ._display import counted
from ._lod import Lod
from ._mesh import Mesh
from ._targets import Targets, count, length
from ._view import vector, camera_arguments


class PagedLod:
    """Every level of detail of a mesh of any size; made by `open` for files that `run` has built.

    Only the pages that a level needs are read, and kept for the next one as long as they take about 600 MB.
    Safe to use from several threads, which wait for each other.

    Examples
    --------
    >>> import striata, tempfile
    >>> folder = tempfile.mkdtemp()
    >>> plan = striata.run(striata.plan("shape:terrain:200", f"{folder}/terrain.striata", cell=4000))
    >>> paged = striata.open(plan.output)
    >>> paged
    <striata.PagedLod: 40,000 points, 79,202 faces, ... pages>
    >>> paged.level(triangles=1000).face_count
    999
    """

    def __init__(self, *arguments: Any) -> None:
        raise TypeError("a PagedLod is made by striata.open")

    _data: _striata.PagedLodData

    @classmethod
    def _of(cls, data: _striata.PagedLodData) -> PagedLod:
        paged = cls.__new__(cls)
        paged._data = data
        return paged

    @property
    def face_count(self) -> int:
        """Number of faces of the full mesh."""
        return self._data.face_count

    @property
    def point_count(self) -> int:
        """Number of points of the full mesh."""
        return self._data.point_count

    @property
    def page_count(self) -> int:
        """Number of pages."""
        return self._data.page_count

    @property
    def diagonal(self) -> float:
        """Length of the diagonal of the bounding box, in mesh units."""
        return self._data.diagonal

    @property
    def bounds(self) -> tuple[tuple[float, ...], tuple[float, ...]]:
        """Smallest and largest coordinates."""
        least, most = self._data.bounds
        return tuple(least), tuple(most)

    @cached_property
    def metadata(self) -> dict[str, Any]:
        """Metadata of the mesh: source, layers, groups, grid, georeference, options."""
        found: dict[str, Any] = json.loads(self._data.metadata())
        return found

    @property
    def statistics(self) -> dict[str, int]:
        """Number of ``requests``, ``bytes`` and ``pages`` read so far."""
        return dict(zip(("requests", "bytes", "pages"), self._data.statistics, strict=True))

    def level(
        self,
        *,
        triangles: int | None = None,
        vertices: int | None = None,
        ratio: float | None = None,
        error: float | str | None = None,
        target_reduction: float | None = None,
        target_count: int | None = None,
    ) -> Mesh:
        """Return the most detailed level that does not exceed a target, as `Lod.level` does."""
        targets = Targets(
            triangles=triangles,
            vertices=vertices,
            ratio=ratio,
            error=error,
            target_reduction=target_reduction,
            target_count=target_count,
        )
        return Mesh._of(self._data.level(targets.request(self.face_count, self.diagonal).target))

    def lod(self, *, triangles: int) -> Lod[Any]:
        """Return all levels of up to `triangles` faces, in memory."""
        return Lod._of(self._data.lod(count(triangles, "triangles")))

    def view(
        self,
        *,
        eye: ArrayLike,
        target: ArrayLike,
        up: ArrayLike = (0.0, 0.0, 1.0),
        fov: float = 60.0,
        screen: tuple[int, int] = (1920, 1080),
        pixels: float = 1.0,
        budget: int | None = None,
    ) -> Mesh:
        """Return the level that a camera needs.

        Parameters
        ----------
        eye, target, up : array_like, shape (3,)
            Position of the camera, the point it looks at, and the direction that is upward on its screen.
        fov : float
            Vertical angle of view, in degrees.
        screen : tuple of int
            Width and height of the screen, in pixels.
        pixels : float
            Largest error on the screen, in pixels.
        budget : int, optional
            Largest number of faces; the error on the screen is then larger, as far as necessary.
        """
        camera = camera_arguments((eye, target, up), fov=fov, screen=screen, pixels=pixels, budget=budget)
        return Mesh._of(self._data.view(*camera))

    def box(self, least: ArrayLike, most: ArrayLike, *, error: float | str | None = None) -> Mesh:
        """Return the mesh with full detail in a box.

        Parameters
        ----------
        least, most : array_like, shape (3,)
            Smallest and largest coordinates of the box.
        error : float or str, optional
            Largest error outside, in mesh units or as text such as ``"0.1%"`` of the diagonal. Default: no
            limit, as coarse as possible.
        """
        outside = float("inf") if error is None else length(error, self.diagonal, "error")
        origin = (0.0, 0.0, 0.0)
        return Mesh._of(self._data.box_level(vector(least, "least", origin), vector(most, "most", origin), outside))

    def __repr__(self) -> str:
        counts = f"{counted(self.point_count, 'point')}, {counted(self.face_count, 'face')}"
        return f"<striata.PagedLod: {counts}, {counted(self.page_count, 'page')}>"
