"""Targets: which level a caller asks for, in the words of any package."""

from __future__ import annotations

import math
from collections.abc import Callable
from dataclasses import dataclass, fields
from typing import Any, Protocol, TypeVar

#: Kind and value, as the extension takes them.
Target = tuple[str, float]


@dataclass(frozen=True)
class Request:
    """Conditions of a level, in the form of the extension."""

    target: Target
    #: Limit of the error in mesh units, whatever the target.
    limit: float | None
    #: Whether errors must be guaranteed bounds.
    guaranteed: bool


@dataclass(frozen=True, kw_only=True)
class Targets:
    """The targets among the arguments of a call; all but one, besides `max_error`, must be `None`."""

    triangles: int | None = None
    vertices: int | None = None
    ratio: float | None = None
    error: float | str | None = None
    max_error: float | str | None = None
    detail: float | None = None
    target_reduction: float | None = None
    target_count: int | None = None

    def request(self, triangle_count: int, diagonal: float) -> Request:
        """Return the one request for a model with this number of triangles and this diagonal."""
        named = {field.name: getattr(self, field.name) for field in fields(self)}
        given = {name: value for name, value in named.items() if value is not None}
        limit = length(given.pop("max_error"), diagonal, "max_error") if "max_error" in given else None
        if len(given) > 1:
            raise ValueError(f"more than one target: {' and '.join(given)}; pass one of them (and max_error, if wanted)")
        if not given:
            if limit is None:
                # Not every function takes `detail`.
                names = [name for name in named if name != "detail"]
                raise ValueError(f"no target: pass one of {', '.join(names[:-1])} or {names[-1]}")
            return Request(("error", limit), limit, True)
        ((name, value),) = given.items()
        return Request(_target(name, value, triangle_count, diagonal), limit, limit is not None)


def _target(name: str, value: Any, triangle_count: int, diagonal: float) -> Target:
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


class HasError(Protocol):
    """A level, as far as requests know it."""

    error: float
    stop_reason: str


AnyLevel = TypeVar("AnyLevel", bound=HasError)


def level_within(request: Request, level_of: Callable[[Target], AnyLevel], has_guaranteed_errors: bool) -> AnyLevel:
    """Return the level that satisfies a request, by a function that finds the level of one target."""
    if request.guaranteed and not has_guaranteed_errors:
        raise ValueError("max_error needs levels with guaranteed errors: build them with guaranteed=True")
    level = level_of(request.target)
    if request.limit is not None and level.error > request.limit:
        level = level_of(("error", request.limit))
        level.stop_reason = "error_limit"
    return level


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
