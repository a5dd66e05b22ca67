"""Targets and options: keyword arguments of every function that simplifies."""

from __future__ import annotations

import math
from collections.abc import Mapping
from dataclasses import dataclass
from typing import Any

_NAMES = (
    "triangles",
    "vertices",
    "ratio",
    "error",
    "max_error",
    "detail",
    "target_reduction",
    "target_count",
)


@dataclass(frozen=True)
class Request:
    """What a level must satisfy, as the extension takes it."""

    target: tuple[str, float]
    #: Limit of the error in mesh units, whatever the target.
    limit: float | None
    #: Whether errors must be guaranteed bounds.
    guaranteed: bool


def request_of(arguments: Mapping[str, Any], triangle_count: int, diagonal: float) -> Request:
    """Turn the keyword arguments of a call into one request."""
    given = {name: arguments[name] for name in _NAMES if arguments.get(name) is not None}
    limit = length(given.pop("max_error"), diagonal, "max_error") if "max_error" in given else None
    if len(given) > 1:
        raise ValueError(f"more than one target: {' and '.join(given)}; pass one of them (and max_error, if wanted)")
    if not given:
        if limit is None:
            names = "triangles, vertices, ratio, error, max_error, detail, target_reduction or target_count"
            raise ValueError(f"no target: pass one of {names}")
        return Request(("error", limit), limit, True)
    ((name, value),) = given.items()
    return Request(_target(name, value, triangle_count, diagonal), limit, limit is not None)


def _target(name: str, value: Any, triangle_count: int, diagonal: float) -> tuple[str, float]:
    if name in ("triangles", "target_count"):
        return ("triangles", float(count(value, name)))
    if name == "vertices":
        return ("vertices", float(count(value, name)))
    if name == "error":
        return ("error", length(value, diagonal, name))
    value = number(value, name)
    if not 0.0 <= value <= 1.0:
        share = {"ratio": "triangles kept", "detail": "vertex splits applied"}.get(name, "triangles removed")
        raise ValueError(f"{name} is {value}, but must be the share of {share}, from 0 to 1")
    if name == "detail":
        return ("detail", value)
    kept = value if name == "ratio" else 1.0 - value
    # The small term keeps products such as 0.29 * 100 from rounding down to one less.
    return ("triangles", float(math.floor(kept * triangle_count + 1e-9 * triangle_count)))


def number(value: Any, name: str) -> float:
    """Convert a finite number, or raise an error with the name of the argument."""
    try:
        converted = float(value)
    except (TypeError, ValueError):
        raise ValueError(f"{name} is {value!r}, but must be a number") from None
    if not math.isfinite(converted):
        raise ValueError(f"{name} is {converted}, but must be finite")
    return converted


def count(value: Any, name: str) -> int:
    """Convert a count of at least 0."""
    converted = number(value, name)
    if converted < 0 or converted != int(converted):
        raise ValueError(f"{name} is {value!r}, but must be a whole number of at least 0")
    return min(int(converted), 2**53)


def length(value: Any, diagonal: float, name: str) -> float:
    """Convert a length in mesh units, or text such as ``"0.1%"`` of the diagonal."""
    factor = 1.0
    if isinstance(value, str):
        text = value.strip()
        if not text.endswith("%"):
            raise ValueError(f"{name} is {value!r}, but must be a number, or a share of the diagonal such as '0.1%'")
        value, factor = text[:-1], diagonal / 100.0
    converted = number(value, name) * factor
    if converted < 0:
        raise ValueError(f"{name} is {converted}, but must be at least 0")
    return converted


def options_of(
    *,
    cost: str,
    boundary: str,
    seams: str,
    topology: str,
    max_error: float | None = None,
    pair_distance: float | None = None,
    coarsest: int = 0,
    locked: list[int] | None = None,
    weights: tuple[float, float, float] | None = None,
) -> dict[str, Any]:
    """Gather options of simplification for the extension, which checks the values."""
    return {
        "cost": cost,
        "boundary": boundary,
        "seams": seams,
        "topology": topology,
        "max_error": max_error,
        "pair_distance": pair_distance,
        "coarsest": count(coarsest, "coarsest"),
        "locked": locked or [],
        "weights": weights,
    }
