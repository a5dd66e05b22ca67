"""Meshes shared by the tests."""

import os

import numpy as np
import pytest
import striata
from hypothesis import HealthCheck, settings

settings.register_profile(
    "striata",
    deadline=None,
    derandomize=True,
    suppress_health_check=list(HealthCheck),
    max_examples=int(os.environ.get("STRIATA_RANDOM_CALLS", "2000")),
)
settings.load_profile("striata")


@pytest.fixture(scope="session")
def terrain():
    """Points and faces of hills."""
    return striata.shapes.terrain(40)


@pytest.fixture(scope="session")
def torus():
    """Points and faces of a torus."""
    return striata.shapes.torus(48, 24)


def check_mesh(points, faces):
    """Assert that faces are triangles of the points."""
    assert points.ndim == faces.ndim == 2 and points.shape[1] == faces.shape[1] == 3
    assert len(faces) == 0 or (faces.min() >= 0 and faces.max() < len(points))
    a, b, c = faces.T
    assert not ((a == b) | (b == c) | (c == a)).any()
    assert np.isfinite(points).all()
