"""Conversion of points, faces and attributes to what the library takes; errors name the place."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field
from typing import Any, TypeVar

import numpy as np
from numpy.typing import ArrayLike, NDArray

from . import _striata

#: Largest number of points or faces: three corners and a link per face must fit into 32 bits.
MAX_COUNT = (2**32 - 1) // 4

#: Coordinates this many diagonals away from the origin are moved there, since single precision loses digits.
_FAR = 16.0

AnyArray = NDArray[Any]
SharedArray = TypeVar("SharedArray", bound=AnyArray)


@dataclass
class PointSet:
    """Points as they were passed, and as the library takes them."""

    #: (n, 3), float32 or float64, as passed.
    original: AnyArray
    #: (n, 3), float32, contiguous, relative to `offset`.
    values: NDArray[np.float32]
    #: Origin that was subtracted before rounding to single precision.
    offset: tuple[float, float, float] = (0.0, 0.0, 0.0)

    def placed(self, data: _striata.MeshData) -> _striata.MeshData:
        """Return a mesh of these points in the coordinates of the user, exactly."""
        moved = data.moved(self.offset)
        wide = np.ascontiguousarray(self.original, dtype=np.float64)
        is_exact = self.original.dtype == np.float32 or bool((self.values + np.array(self.offset) == wide).all())
        return moved if is_exact else moved.with_exact_points(wide)

    def restored(self, points: NDArray[np.float32]) -> AnyArray:
        """Return other points in the coordinates and the dtype of these."""
        wide = points.astype(self.original.dtype, copy=False)
        return wide if self.offset == (0.0, 0.0, 0.0) else wide + np.array(self.offset)


@dataclass
class FaceSet:
    """Faces as the library takes them, and the form in which they were passed."""

    #: (m, 3), uint32, contiguous.
    values: NDArray[np.uint32]
    dtype: np.dtype[Any] = field(default_factory=lambda: np.dtype(np.int32))
    #: Whether they were passed as `[3, a, b, c, 3, ...]`.
    is_flat: bool = False

    def like_input(self, faces: AnyArray) -> AnyArray:
        """Return faces of shape (k, 3) in the dtype and form of the input."""
        return flat(faces, self.dtype) if self.is_flat else as_dtype(faces, self.dtype)


def frozen(array: SharedArray) -> SharedArray:
    """Make an array read-only, since it is shared."""
    array.flags.writeable = False
    return array


def as_dtype(values: AnyArray, dtype: np.dtype[Any]) -> AnyArray:
    """Convert integers without copying where possible."""
    return values.astype(dtype, copy=False)


def flat(faces: AnyArray, dtype: np.dtype[Any] | None = None) -> AnyArray:
    """Return faces of shape (k, 3) as `[3, a, b, c, 3, ...]`."""
    padded = np.empty((len(faces), 4), dtype=faces.dtype if dtype is None else dtype)
    padded[:, 0] = 3
    padded[:, 1:] = faces
    return padded.ravel()


def points_of(points: ArrayLike, name: str = "points") -> PointSet:
    """Check and convert points."""
    array = np.asarray(points)
    if array.size == 0 and array.ndim < 2:
        array = array.reshape(0, 3)
    if array.ndim != 2 or array.shape[1] != 3:
        raise ValueError(f"{name} has the shape {array.shape}, but must be (n, 3)")
    if array.dtype.kind not in "fiub":
        raise ValueError(f"{name} has the dtype {array.dtype}, but must have real numbers")
    if len(array) > MAX_COUNT:
        raise ValueError(f"{name} has {len(array)} rows, but the limit is {MAX_COUNT}")
    if array.dtype.kind != "f" or array.dtype.itemsize > 8:
        array = array.astype(np.float64)
    elif array.dtype.itemsize < 4:
        array = array.astype(np.float32)
    elif not array.dtype.isnative:
        array = array.astype(array.dtype.newbyteorder("="))
    offset = _offset(array, name)
    shifted = array if offset == (0.0, 0.0, 0.0) else array - np.array(offset)
    with np.errstate(over="ignore"):
        values = np.ascontiguousarray(shifted, dtype=np.float32)
    if array.dtype != np.float32 and not np.isfinite(values).all():
        row, column = _first(~np.isfinite(values))
        raise ValueError(f"{name}[{row}, {column}] is {array[row, column]}, which single precision cannot hold")
    return PointSet(array, values, offset)


def _offset(points: AnyArray, name: str) -> tuple[float, float, float]:
    if len(points) == 0:
        return (0.0, 0.0, 0.0)
    low, high = points.min(axis=0), points.max(axis=0)
    if not (np.isfinite(low).all() and np.isfinite(high).all()):
        row, column = _first(~np.isfinite(points))
        raise ValueError(f"{name}[{row}, {column}] is {points[row, column]}")
    if points.dtype == np.float32:
        return (0.0, 0.0, 0.0)
    with np.errstate(over="ignore"):
        diagonal = float(np.linalg.norm(high - low))
        largest = float(max(np.abs(low).max(), np.abs(high).max()))
    if largest <= _FAR * diagonal or not np.isfinite(diagonal):
        return (0.0, 0.0, 0.0)
    x, y, z = (float(v) for v in low / 2 + high / 2)
    return (x, y, z)


def faces_of(faces: ArrayLike, point_count: int, name: str = "faces") -> FaceSet:
    """Check and convert faces of shape (m, 3), or flat as `[3, a, b, c, 3, ...]`."""
    array = np.asarray(faces)
    if array.size == 0 and (array.ndim < 2 or array.shape[1] not in (3,)):
        is_flat = array.ndim == 1
        dtype = _integer_dtype(array.dtype) if array.dtype.kind in "iu" else np.dtype(np.int32)
        return FaceSet(np.empty((0, 3), np.uint32), dtype, is_flat)
    if array.dtype.kind not in "iu":
        raise ValueError(f"{name} has the dtype {array.dtype}, but must have integers")
    is_flat = array.ndim == 1
    if is_flat:
        array = _unpadded(array, name)
    if array.ndim != 2 or array.shape[1] != 3:
        raise ValueError(f"{name} has the shape {array.shape}, but must be (m, 3), or flat as [3, a, b, c, ...]")
    if len(array) > MAX_COUNT:
        raise ValueError(f"{name} has {len(array)} rows, but the limit is {MAX_COUNT}")
    if len(array) and (array.min() < 0 or array.max() >= point_count):
        row, column = _first((array < 0) | (array >= point_count))
        place = f"{name}[{4 * row + column + 1}]" if is_flat else f"{name}[{row}, {column}]"
        value = int(array[row, column])
        if value < 0:
            raise ValueError(f"{place} is {value}, but indices must be 0 or more")
        raise ValueError(f"{place} is {value}, but there are {point_count} points")
    return FaceSet(np.ascontiguousarray(array, dtype=np.uint32), _integer_dtype(array.dtype), is_flat)


def _unpadded(array: AnyArray, name: str) -> AnyArray:
    if len(array) > 4 * MAX_COUNT:
        raise ValueError(f"{name} has {len(array)} values, but the limit is {4 * MAX_COUNT}")
    wrong = np.flatnonzero(array[::4] != 3)
    if len(wrong):
        index = 4 * int(wrong[0])
        hint = "every face must be a triangle, written as [3, a, b, c, ...]"
        raise ValueError(f"{name}[{index}] is {array[index]}, but {hint}")
    if len(array) % 4:
        raise ValueError(f"{name} has {len(array)} values, which is not a multiple of 4 ([3, a, b, c, ...])")
    return array.reshape(-1, 4)[:, 1:]


def _integer_dtype(dtype: np.dtype[Any]) -> np.dtype[Any]:
    """Dtype of the faces that go out: that of the input in native order, if it is int32 or wider."""
    if dtype.itemsize < 4:
        return np.dtype(np.int32)
    return dtype if dtype.isnative else dtype.newbyteorder("=")


def _first(mask: AnyArray) -> tuple[int, int]:
    row, column = divmod(int(np.argmax(mask)), mask.shape[1])
    return row, column


def indices_of(indices: ArrayLike | None, count: int, name: str) -> list[int]:
    """Check a list of point indices, or a mask with an entry per point."""
    if indices is None:
        return []
    array = np.asarray(indices)
    if array.size == 0:
        return []
    if array.dtype == np.bool_:
        if array.shape != (count,):
            raise ValueError(f"{name} has the shape {array.shape}, but a mask must have the shape ({count},)")
        return [int(i) for i in np.flatnonzero(array)]
    if array.ndim != 1 or array.dtype.kind not in "iu":
        raise ValueError(f"{name} must be a list of indices or a mask")
    wrong = np.flatnonzero((array < 0) | (array >= count))
    if len(wrong):
        place = int(wrong[0])
        raise ValueError(f"{name}[{place}] is {array[place]}, but there are {count} points")
    return [int(i) for i in array]


def attributes_of(attributes: Mapping[str, ArrayLike] | None, count: int, what: str = "points") -> dict[str, AnyArray]:
    """Check that every attribute has a row for each point (or face)."""
    checked = {}
    for name, values in (attributes or {}).items():
        array = np.asarray(values)
        if array.ndim == 0 or array.shape[0] != count:
            rows = "no rows" if array.ndim == 0 else f"{array.shape[0]} rows"
            raise ValueError(f"attributes[{name!r}] has {rows}, but there are {count} {what}")
        checked[str(name)] = array
    return checked
