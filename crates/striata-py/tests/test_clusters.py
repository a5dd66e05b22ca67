"""Clusters for renderers that draw meshlets."""

import numpy as np
import pytest
import striata


def edges_of(faces):
    """Return the number of uses of each edge, in either direction."""
    edges = np.concatenate([faces[:, [0, 1]], faces[:, [1, 2]], faces[:, [2, 0]]])
    return np.unique(np.sort(edges, axis=1), axis=0, return_counts=True)[1]


def test_full_detail_is_the_mesh():
    points, faces = striata.shapes.torus(64, 32)
    clusters = striata.clusters(points, faces, max_triangles=32)
    full = clusters.faces_of(clusters.cut(0))
    assert sorted(map(sorted, full.tolist())) == sorted(map(sorted, faces.tolist()))
    assert clusters.ranges[:, 1].max() <= 32
    assert len(clusters.faces_of([])) == 0
    assert "clusters" in repr(clusters)


def test_cuts_have_no_cracks_and_their_errors_are_true():
    points, faces = striata.shapes.torus(64, 32)
    clusters = striata.clusters(points, faces, max_triangles=32, group_size=6)
    size = np.linalg.norm(np.ptp(points, axis=0))
    for error in (0.002 * size, 0.01 * size, np.inf):
        level = clusters.faces_of(clusters.cut(error))
        assert (edges_of(level) == 2).all()
        if np.isfinite(error):
            assert striata.distance((points, faces), (points, level)).max <= 1.2 * error
    # A camera: fine near the eye, coarse far from it.
    eye = points[0] + 0.1 * size
    distance = np.linalg.norm(clusters.group_spheres[:, :3] - eye, axis=1) - clusters.group_spheres[:, 3]
    level = clusters.faces_of(clusters.cut(clusters.error <= 0.02 * np.maximum(distance, 1e-3 * size)))
    assert (edges_of(level) == 2).all()
    assert 0 < len(level) < len(faces)


def test_groups_nest():
    clusters = striata.clusters(*striata.shapes.torus(64, 32), max_triangles=32, group_size=6)
    made = clusters.refines >= 0
    finer, own = clusters.refines[made], clusters.group[made]
    assert (clusters.error[finer] <= clusters.error[own]).all()
    assert (clusters.depth[finer] < clusters.depth[own]).all()
    assert np.isinf(clusters.error).sum() == 1


def test_refusals():
    torus = striata.shapes.torus(16, 8)
    for option in ("max_triangles", "max_vertices", "group_size"):
        with pytest.raises(ValueError, match=option):
            striata.clusters(*torus, **{option: 1})
    with pytest.raises(ValueError, match="groups"):
        striata.clusters(*torus).cut([True])
