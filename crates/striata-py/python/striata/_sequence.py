"""The class `Sequence`: the collapses that lead from a mesh to its coarsest level."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray


@dataclass(frozen=True)
class Sequence:
    """The collapses of a `Lod`, in the order in which they coarsen the mesh.

    Each array has an entry per removed point. Points are indices into the input of `build`; into
    `Lod.points`, if the levels were opened from a file. Points that share a position but not their attributes
    are removed together, in one step.
    """

    #: Point that is removed.
    removed: NDArray[np.int32]
    #: Point that takes its place.
    target: NDArray[np.int32]
    #: Error of the mesh after the step, in mesh units; never falling.
    error: NDArray[np.float32]
    #: Number of faces after the step.
    faces: NDArray[np.int32]
    #: Number of the step, from 0.
    step: NDArray[np.int32]

    def __len__(self) -> int:
        return len(self.removed)
