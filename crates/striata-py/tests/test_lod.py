"""`build`, levels, views, the sequence, and distances."""

import pickle

import numpy as np
import pytest
import striata
from conftest import check_mesh


@pytest.fixture(scope="module")
def lod(terrain):
    return striata.build(*terrain, attributes={"id": np.arange(len(terrain[0]))})


def test_levels_use_prefixes_of_one_array(terrain, lod):
    for ratio in (1.0, 0.5, 0.1, 0.0):
        level = lod.level(ratio=ratio)
        check_mesh(level.points, level.faces)
        assert level.points.base is not None and np.shares_memory(level.points, lod.points)
        assert level.faces.dtype == terrain[1].dtype and level.triangle_count == len(level.faces)
        points, faces = level.to_mesh()
        check_mesh(points, faces)
        assert np.array_equal(np.sort(points[faces].ravel()), np.sort(level.points[level.faces].ravel()))
        assert np.array_equal(level.attributes()["id"], level.vertices)
    assert np.array_equal(lod.points, terrain[0][lod.vertices])
    assert np.array_equal(lod.attributes["id"], lod.vertices)
    with pytest.raises(ValueError):
        lod.points[0, 0] = 1


def test_one_level_equals_simplify(terrain, lod):
    level, made = lod.level(triangles=300), striata.simplify(*terrain, triangles=300)
    points, faces = level.to_mesh()
    assert np.array_equal(points, made.points) and np.array_equal(faces, made.faces)
    assert level.error == pytest.approx(made.error)


def test_errors_never_fall_with_fewer_triangles(lod):
    errors = [lod.level(detail=d).error for d in np.linspace(0, 1, 20)]
    assert errors == sorted(errors, reverse=True) and errors[-1] == 0


def test_fine_to_coarse_maps_every_point(terrain, lod):
    points, faces = terrain
    level = lod.level(ratio=0.1)
    coarse = lod.fine_to_coarse(level)
    assert set(coarse) >= set(level.vertices)
    mapped = coarse[faces]
    a, b, c = mapped.T
    kept = mapped[(a != b) & (b != c) & (c != a)]
    points_of, faces_of = level.to_mesh()
    assert np.array_equal(points[kept], points_of[faces_of])
    assert np.array_equal(lod.fine_to_coarse(lod.step_count), np.arange(len(points)))
    extra = striata.build(np.vstack([points, [[9, 9, 9]]]), faces)
    assert extra.fine_to_coarse(0)[-1] == -1


def test_the_sequence_replays_to_every_level(terrain, lod):
    sequence = lod.sequence
    assert len(sequence) == lod.step_count == len(sequence.target)
    assert (np.diff(sequence.error) >= 0).all() and (np.diff(sequence.faces) <= 0).all()
    representative = np.arange(len(terrain[0]))
    for removed, target in zip(sequence.removed[:400], sequence.target[:400]):
        representative[representative == removed] = target
    assert np.array_equal(representative, lod.fine_to_coarse(lod.step_count - 400))
    assert sequence.faces[399] == lod.level(detail=1 - 400 / lod.step_count).triangle_count


def test_strips_cover_a_level(lod):
    level = lod.level(ratio=0.2)
    covered = set()
    for part in np.split(level.strips, np.flatnonzero(level.strips == -1)):
        strip = part[part >= 0]
        for t in zip(strip, strip[1:], strip[2:]):
            if len(set(t)) == 3:
                covered.add(frozenset(t))
    assert covered == {frozenset(t) for t in level.faces.tolist()}


def test_views_refine_what_is_near(lod):
    view = lod.view()
    base = view.triangle_count
    view.update(eye=(0.5, -0.2, 0.4), target=(0.5, 0.5, 0), pixels=1.0, screen=(640, 480))
    check_mesh(lod.points, view.faces)
    fine = view.triangle_count
    assert base < fine <= lod.face_count
    view.update(eye=(0.5, -0.2, 0.4), target=(0.5, 0.5, 0), pixels=1.0, screen=(640, 480), budget=200)
    assert view.triangle_count <= 200
    view.update(eye=(0, 0, 90), target=(0, 0, 0), pixels=50)  # looks along `up`
    assert view.triangle_count < fine
    for wrong in ({"eye": (0, 0)}, {"fov": 180}, {"pixels": -1}, {"screen": (0, 1)}, {"eye": (0, 0, 0)}):
        arguments = {"eye": (1, 1, 1), "target": (0, 0, 0), **wrong}
        with pytest.raises(ValueError):
            view.update(**arguments)


def strip_triangles(indices):
    found = []
    for strip in np.split(indices, np.flatnonzero(indices == -1)):
        strip = strip[strip >= 0]
        for i, (a, b, c) in enumerate(zip(strip, strip[1:], strip[2:], strict=False)):
            if a != b != c != a:
                found.append((a, b, c) if i % 2 == 0 else (b, a, c))
    return found


def same_triangles(a, b):
    rotated = [[min(np.roll(t, k).tolist() for k in range(3)) for t in triangles] for triangles in (a, b)]
    return sorted(rotated[0]) == sorted(rotated[1])


def test_strips_follow_levels(lod, tmp_path):
    strips = lod.strip_level()
    assert strips.level.triangle_count == lod.face_count and "strip" in repr(strips)
    uploaded = strips.indices.copy()
    strips.take_changed_ranges()
    for triangles in (400, 100, 250, 30):
        level = lod.level(triangles=triangles)
        strips.move_to(level)
        for first, end in strips.take_changed_ranges():
            uploaded[first:end] = strips.indices[first:end]
        assert np.array_equal(uploaded, strips.indices)
        shown = [t for first, end in strips.groups for t in strip_triangles(uploaded[first:end])]
        assert same_triangles(shown, level.faces)
        assert strips.index_count < 3 * level.triangle_count and 0 < strips.strip_count < level.triangle_count
    assert lod.strip_level(lod.level(triangles=30)).strip_count == strips.strip_count
    striata.save(tmp_path / "a.striata", lod)
    opened = striata.open(tmp_path / "a.striata")
    again = opened.strip_level(opened.level(triangles=100))
    strips.move_to(lod.level(triangles=100))
    assert np.array_equal(again.indices[slice(*again.groups[0])], strips.indices[slice(*strips.groups[0])])
    striata.save(tmp_path / "b.striata", striata.open(tmp_path / "a.striata"))
    assert (tmp_path / "b.striata").read_bytes() == (tmp_path / "a.striata").read_bytes()
    with pytest.raises(ValueError, match="another Lod"):
        strips.move_to(opened.level(triangles=100))


def test_views_work_far_from_the_origin(terrain):
    offset = np.array([5e6, 4e5, 0])
    far = striata.build(terrain[0].astype(np.float64) + offset, terrain[1]).view()
    near = striata.build(terrain[0].astype(np.float64), terrain[1]).view()
    for view, origin in ((far, offset), (near, 0)):
        view.update(eye=origin + np.array([0.5, -0.5, 0.5]), target=origin + np.array([0.5, 0.5, 0]))
    assert abs(far.triangle_count - near.triangle_count) < 0.05 * near.triangle_count


def test_guarantees(terrain):
    lod = striata.build(*terrain, guaranteed=True)
    level = lod.level(triangles=2, max_error=0.02)
    assert level.error <= 0.02 and level.stop_reason == "error_limit"
    measured = striata.distance(terrain, level, samples=20_000)
    assert measured.a_to_b.max <= 0.02 * 1.0001
    with pytest.raises(ValueError, match="guaranteed=True"):
        striata.build(*terrain).level(max_error=1)


def test_levels_of_seams_and_duplicates(torus):
    points, faces = torus
    soup = points[faces.ravel()]
    lod = striata.build(soup, np.arange(len(soup)).reshape(-1, 3))
    assert lod.point_count == len(points)
    assert np.array_equal(soup[lod.fine_to_coarse(lod.step_count)], soup)


def test_distances(torus):
    points, faces = torus
    d = striata.distance(torus, (points * 1.1, faces), samples=10_000)
    assert 0 < d.mean <= d.rms <= d.max and d.max == max(d.a_to_b.max, d.b_to_a.max)
    assert d.of_vertices.shape == (len(points),) and d.of_vertices.max() <= d.a_to_b.max
    with pytest.raises(ValueError, match="second mesh has no triangle"):
        striata.distance(torus, ([], []))
    with pytest.raises(ValueError, match="sample count"):
        striata.distance(torus, torus, samples=0)


def test_lods_cannot_be_made_by_hand():
    with pytest.raises(TypeError, match=r"striata\.build"):
        striata.Lod()


def test_lods_are_pickled(terrain):
    offset = np.array([5e6, 4e5, 0])
    for points in (terrain[0], terrain[0].astype(np.float64) + offset):
        lod = striata.build(points, terrain[1])
        copy = pickle.loads(pickle.dumps(lod))
        assert repr(copy) == repr(lod)
        for ratio in (1.0, 0.1):
            level, copied = lod.level(ratio=ratio), copy.level(ratio=ratio)
            assert copied.error == level.error
            assert np.allclose(copied.points, level.points, rtol=0, atol=1e-6)
            assert sorted(map(sorted, copied.faces.tolist())) == sorted(map(sorted, level.faces.tolist()))
