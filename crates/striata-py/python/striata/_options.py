"""Options of every function that simplifies.

The aliases are unions of single literals, since stubtest compares no other form of them with the runtime.
"""

from __future__ import annotations

from typing import Any, Literal

from ._targets import count

#: Whether the points of a level are points of the input, or may lie anywhere.
Placement = Literal["subset"] | Literal["optimal"]
#: What orders the removals.
Cost = Literal["memoryless"] | Literal["accumulated"] | Literal["tracked"]
#: Whether points on boundaries move along them.
Boundary = Literal["keep"] | Literal["lock"]
#: Whether attributes that jump at a point may be smeared.
Seams = Literal["cross"] | Literal["keep"]
#: What may happen once no removal is left that keeps the topology.
Topology = Literal["change"] | Literal["keep_parts"] | Literal["keep"]


def options_of(
    *,
    cost: str = "memoryless",
    boundary: str = "keep",
    seams: str = "cross",
    topology: str = "change",
    height_field: bool | None = None,
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
        "height_field": height_field,
        "max_error": None,
        "pair_distance": pair_distance,
        "coarsest": count(coarsest, "coarsest"),
        "locked": locked or [],
        "weights": weights,
    }


def check_scene_arguments(**arguments: object) -> None:
    """Refuse arguments that are about the points of one mesh, and so have no meaning for a scene."""
    given = [name for name, value in arguments.items() if value is not None]
    if given:
        raise ValueError(f"{' and '.join(given)}: not possible for a scene, only for a single mesh")
