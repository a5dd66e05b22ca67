"""The class `Simplified`: what `simplify` returns for arrays."""

from __future__ import annotations

from typing import Any

from ._arrays import AnyArray
from ._input import Result


class Simplified(tuple[Any, ...]):
    """Result of `simplify` for arrays: unpacks to points and faces, and to attributes if some were passed.

    Attributes
    ----------
    points : ndarray, shape (k, 3)
        Points that remain, in the dtype of the input.
    faces : ndarray, shape (l, 3)
        Faces that remain, in the dtype of the input.
    attributes : dict of ndarray
        Attributes of the points that remain.
    vertices : ndarray of int32 or None
        Index of the input point that each point is; `None` with ``placement="optimal"``.
    face_origins : ndarray of int32 or None
        Index of the input face that each face comes from; `None` with ``placement="optimal"``.
    error : float
        Largest distance from the input, in mesh units: a bound with ``max_error``, otherwise an estimate.
    stop_reason : str
        ``"target_reached"``, ``"base_reached"`` (nothing is left to remove), ``"error_limit"`` or
        ``"full_mesh"``.
    """

    points: AnyArray
    faces: AnyArray
    attributes: dict[str, AnyArray]
    vertices: AnyArray | None
    face_origins: AnyArray | None
    error: float
    stop_reason: str

    @classmethod
    def _of(cls, result: Result, faces: AnyArray, facts: tuple[float, str], with_attributes: bool) -> Simplified:
        parts: tuple[Any, ...] = (result.points, faces)
        made = cls((*parts, result.attributes) if with_attributes else parts)
        made.points, made.faces, made.attributes = result.points, faces, result.attributes
        made.vertices, made.face_origins = result.vertices, result.origins
        made.error, made.stop_reason = facts
        return made
