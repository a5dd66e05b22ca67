"""Attributes as layers of the library, so that seams survive and attributes can count in the cost.

Values that go out are always taken from the arrays that came in, by index. The layers only say which points
with equal coordinates differ, what a collapse costs, and what a file stores.
"""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any

import numpy as np

from ._arrays import AnyArray

Layer = tuple[str, int, str, bool, AnyArray]

#: Names that packages and files use for the meanings that the library knows.
_MEANINGS = {
    "normal": {"normal", "normals", "vertex_normals", "point_normals", "n"},
    "texcoord": {"uv", "uvs", "uv0", "texcoord", "texcoords", "texture_uvs", "texture coordinates", "tcoords", "st"},
    "color": {"color", "colors", "colour", "colours", "rgb", "rgba", "vertex_colors", "color_0"},
}

#: Weights of the library, as shares of the diagonal.
DEFAULT_WEIGHTS = {"normal": 0.007, "texcoord": 0.02, "color": 0.003}

#: Color sets from this number on exist only for the cost; files do not store them.
_FIRST_COST_SET = 200
_LAST_SET = 255
#: Prefix of layers that only tell points apart; files do not store them.
_ID_PREFIX = "striata:id:"

Weights = Mapping[str, float] | float | None


def layers_of(
    attributes: Mapping[str, AnyArray], weights: Weights = None
) -> tuple[list[Layer], tuple[float, float, float] | None]:
    """Return the layers for attributes, and the weights of normals, texture coordinates and colors."""
    wanted = _checked_weights(attributes, weights)
    is_plain = weights is None
    kinds = {} if is_plain or isinstance(weights, Mapping) else dict.fromkeys(DEFAULT_WEIGHTS, 0.0)
    layers: list[Layer] = []
    costs: list[tuple[str, AnyArray]] = []
    taken: set[str] = set()
    for name, values in attributes.items():
        meaning = _meaning(name, values)
        if meaning is None or meaning in taken:
            layers.append(_plain(name, values))
            if wanted.get(name, 0.0) > 0.0:
                costs.append((name, values))
            continue
        taken.add(meaning)
        if name in wanted:
            _check_finite(name, values)
            kinds[meaning] = wanted[name]
        is_finite = values.dtype.kind != "f" or bool(np.isfinite(values).all())
        layers.append(_known(meaning, name, values) if is_finite else _plain(name, values))
    all_weights = {**DEFAULT_WEIGHTS, **kinds}
    if costs and all_weights["color"] == 0.0:
        # Costs use the weight of colors, so the colors themselves must not be colors.
        layers = [("generic", 0, *layer[2:]) if layer[0] == "color" else layer for layer in layers]
        all_weights["color"] = 1.0
    for number, (name, values) in enumerate(costs):
        if _FIRST_COST_SET + number > _LAST_SET:
            raise ValueError(f"weights[{name!r}]: at most {_LAST_SET - _FIRST_COST_SET + 1} attributes can count")
        columns = _cost_columns(name, values, wanted[name] / all_weights["color"])
        layers.append(("color", _FIRST_COST_SET + number, "", False, columns))
    ordered = (all_weights["normal"], all_weights["texcoord"], all_weights["color"])
    is_default = is_plain or all_weights == DEFAULT_WEIGHTS
    return [layer for layer in layers if layer[4].shape[1]], None if is_default else ordered


def check_storable(layers: list[Layer]) -> None:
    """Refuse attributes that only tell points apart, since no file stores them."""
    for _, _, name, _, _ in layers:
        if name.startswith(_ID_PREFIX):
            shown = name.removeprefix(_ID_PREFIX)
            raise ValueError(f"attributes[{shown!r}] cannot be stored: its values are not numbers of 32 bits")


def file_weights(weights: Weights) -> tuple[float, float, float] | None:
    """Return the weights for a mesh of a file, whose layers are named normal, texcoord and color."""
    if weights is None:
        return None
    if not isinstance(weights, Mapping):
        _check_number(weights)
        return (0.0, 0.0, 0.0)
    named = dict(DEFAULT_WEIGHTS)
    for name, weight in weights.items():
        if name not in named:
            raise ValueError(f"weights[{name!r}]: meshes and scenes of files have weights for {sorted(named)}")
        named[name] = _checked_weight(name, weight)
    return (named["normal"], named["texcoord"], named["color"])


def _checked_weights(attributes: Mapping[str, AnyArray], weights: Weights) -> dict[str, float]:
    if weights is None:
        return {}
    if not isinstance(weights, Mapping):
        _check_number(weights)
        return {}
    for name in weights:
        if name not in attributes:
            raise ValueError(f"weights[{name!r}]: there is no such attribute, only {sorted(attributes)}")
    return {name: _checked_weight(name, weight) for name, weight in weights.items()}


def _check_number(weights: float) -> None:
    if weights != 0:
        raise ValueError(f"weights is {weights!r}, but must be a dict of names and weights, or 0 for geometry only")


def _checked_weight(name: str, weight: float) -> float:
    if not (np.isfinite(weight) and weight >= 0):
        raise ValueError(f"weights[{name!r}] is {weight}, but must be a finite number of at least 0")
    return float(weight)


def _meaning(name: str, values: AnyArray) -> str | None:
    for meaning, names in _MEANINGS.items():
        if name.lower() in names:
            columns = {"normal": (3,), "texcoord": (2,), "color": (3, 4)}[meaning]
            is_number = values.dtype.kind == "f" or (meaning == "color" and values.dtype == np.uint8)
            if values.ndim == 2 and values.shape[1] in columns and is_number:
                return meaning
    return None


def _known(meaning: str, name: str, values: AnyArray) -> Layer:
    is_integer = values.dtype.kind != "f"
    dtype = np.uint8 if is_integer else np.float32
    return (meaning, 0, name, is_integer, np.ascontiguousarray(values, dtype=dtype))


def _cost_columns(name: str, values: AnyArray, factor: float) -> AnyArray:
    if values.dtype.kind not in "fiub":
        raise ValueError(f"weights[{name!r}]: the attribute has the dtype {values.dtype}, not numbers")
    _check_finite(name, values)
    rows = values.reshape(len(values), -1).astype(np.float64)
    if rows.shape[1] > 255:
        raise ValueError(f"weights[{name!r}]: the attribute has {rows.shape[1]} columns, but the limit is 255")
    if len(rows):
        # Only differences count, and small ones would be lost in single precision.
        rows = rows - rows.mean(axis=0)
    with np.errstate(over="ignore"):
        columns = np.ascontiguousarray(rows * factor, dtype=np.float32)
    if not np.isfinite(columns).all():
        raise ValueError(f"weights[{name!r}]: the attribute is too large for single precision")
    return columns


def _check_finite(name: str, values: AnyArray) -> None:
    if values.dtype.kind == "f" and not np.isfinite(values).all():
        place = np.unravel_index(int(np.argmax(~np.isfinite(values))), values.shape)
        where = ", ".join(str(int(i)) for i in place)
        raise ValueError(f"attributes[{name!r}][{where}] is {values[place]}, so it cannot count in the cost")


def _plain(name: str, values: AnyArray) -> Layer:
    """Layer of an attribute without a meaning that the library knows."""
    rows = values.reshape(len(values), -1) if values.size else values.reshape(len(values), 0)
    kind = values.dtype.kind
    if rows.shape[1] > 255 or kind not in "fiub":
        return _ids(name, rows)
    dtype: np.dtype[Any] | type[np.generic] | None = None
    if kind == "f":
        dtype = np.float64 if values.dtype.itemsize > 4 else np.float32
    elif kind == "b":
        dtype = np.uint8
    elif values.dtype.itemsize <= 4:
        dtype = values.dtype.newbyteorder("=")
    elif rows.size:
        low, high = int(rows.min()), int(rows.max())
        if 0 <= low and high < 2**32:
            dtype = np.uint32
        elif -(2**31) <= low and high < 2**31:
            dtype = np.int32
    if dtype is None:
        return _ids(name, rows)
    with np.errstate(over="ignore", invalid="ignore"):
        return ("generic", 0, name, False, np.ascontiguousarray(rows, dtype=dtype))


def _ids(name: str, rows: AnyArray) -> Layer:
    """Layer that gives equal rows equal numbers."""
    try:
        _, inverse = np.unique(rows, axis=0, return_inverse=True)
        ids = np.asarray(inverse, dtype=np.uint32).reshape(-1, 1)
    except TypeError:
        # Objects without an order: nothing is merged.
        ids = np.arange(len(rows), dtype=np.uint32).reshape(-1, 1)
    return ("generic", 0, _ID_PREFIX + name, False, np.ascontiguousarray(ids))
