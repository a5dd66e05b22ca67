"""The class `View`: an instance that follows a camera."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

import numpy as np
from numpy.typing import ArrayLike

from ._arrays import AnyArray, frozen
from ._display import counted
from ._targets import length, number

if TYPE_CHECKING:
    from ._lod import Lod


class View:
    """An instance of a `Lod` that follows a camera from frame to frame.

    Parameters
    ----------
    lod : Lod
        The levels; any number of views can share them.

    Examples
    --------
    >>> import striata
    >>> lod = striata.build(*striata.shapes.terrain(40))
    >>> view = lod.view()
    >>> view.update(eye=(0.5, -1, 1), target=(0.5, 0.5, 0), pixels=2.0)
    >>> 0 < len(view.faces) <= lod.face_count
    True
    """

    def __init__(self, lod: Lod[Any]) -> None:
        self.lod = lod
        self._data = lod._data.view()
        self._faces: AnyArray | None = None

    def update(
        self,
        *,
        eye: ArrayLike,
        target: ArrayLike,
        up: ArrayLike = (0.0, 0.0, 1.0),
        fov: float = 60.0,
        screen: tuple[int, int] = (1920, 1080),
        pixels: float = 1.0,
        budget: int | None = None,
    ) -> None:
        """Refine what the camera sees, and coarsen the rest.

        Parameters
        ----------
        eye, target, up : array_like, shape (3,)
            Position of the camera, the point it looks at, and the direction that is upward on its screen.
            If `up` is parallel to the view, another direction is chosen.
        fov : float
            Vertical angle of view, in degrees.
        screen : tuple of int
            Width and height of the screen, in pixels.
        pixels : float
            Largest error on the screen, in pixels.
        budget : int, optional
            Largest number of faces. They go where the error is most visible.
        """
        camera = camera_arguments(
            (eye, target, up), fov=fov, screen=screen, pixels=pixels, budget=budget, offset=self.lod._origin
        )
        self._data.update(*camera)
        self._faces = None

    @property
    def faces(self) -> AnyArray:
        """Faces shown, shape (l, 3), as indices into `Lod.points`, in the dtype of the input."""
        if self._faces is None:
            self._faces = frozen(self.lod._like_input(self._data.faces()))
        return self._faces

    @property
    def triangle_count(self) -> int:
        """Number of faces shown."""
        return self._data.face_count

    def __repr__(self) -> str:
        return f"<striata.View: {counted(self.triangle_count, 'face')} of {self.lod.face_count:,}>"


#: Eye, target, upward direction, tangent of half the angle, screen, pixels and budget, as the extension takes them.
Camera = tuple[
    tuple[float, float, float],
    tuple[float, float, float],
    tuple[float, float, float],
    float,
    tuple[int, int],
    float,
    int | None,
]


def camera_arguments(
    vectors: tuple[ArrayLike, ArrayLike, ArrayLike],
    *,
    fov: float,
    screen: tuple[int, int],
    pixels: float,
    budget: int | None,
    offset: tuple[float, float, float] = (0.0, 0.0, 0.0),
) -> Camera:
    """Convert the arguments of a view, or raise an error with the name of the argument."""
    eye, target, up = vectors
    from_eye = vector(eye, "eye", offset)
    to_target = vector(target, "target", offset)
    limit = number(pixels, "pixels")
    if limit < 0:
        raise ValueError(f"pixels is {limit}, but must be at least 0")
    angle = number(fov, "fov")
    if not 0 < angle < 180:
        raise ValueError(f"fov is {angle}, but must be an angle between 0 and 180 degrees")
    width, height = (int(side) for side in screen)
    if not (0 < width < 2**31 and 0 < height < 2**31):
        raise ValueError(f"screen is {screen}, but must be a width and a height in pixels")
    upward = _upward(np.subtract(to_target, from_eye), np.asarray(vector(up, "up", (0.0, 0.0, 0.0))))
    if budget is not None:
        budget = int(length(budget, 0.0, "budget"))
    tangent = float(np.tan(np.radians(angle) / 2))
    return (from_eye, to_target, upward, tangent, (width, height), limit, budget)


def vector(values: ArrayLike, name: str, offset: tuple[float, float, float]) -> tuple[float, float, float]:
    array = np.asarray(values, dtype=np.float64)
    if array.shape != (3,) or not np.isfinite(array).all():
        raise ValueError(f"{name} is {values!r}, but must be three finite numbers")
    x, y, z = (float(v) for v in array - np.array(offset))
    return (x, y, z)


def _upward(forward: AnyArray, up: AnyArray) -> tuple[float, float, float]:
    """Return `up`, or an axis if `up` is parallel to the view."""
    if np.linalg.norm(np.cross(forward, up)) <= 1e-6 * np.linalg.norm(forward) * np.linalg.norm(up):
        up = np.eye(3)[int(np.argmin(np.abs(forward)))]
    x, y, z = (float(v) for v in up)
    return (x, y, z)
