"""The accessors of fast-simplification's extension: faces of the last result."""

import numpy as np

faces = np.empty((0, 3), np.int32)


def return_faces_int32_no_padding():
    """Return indices of the last result, three per face."""
    return faces.ravel()


def return_faces_int32():
    """Return faces of the last result as `[3, a, b, c, ...]`."""
    return np.column_stack([np.full(len(faces), 3, np.int32), faces]).ravel()


def return_faces_int64():
    """Return faces of the last result as `[3, a, b, c, ...]`, in 64 bits."""
    return return_faces_int32().astype(np.int64)
