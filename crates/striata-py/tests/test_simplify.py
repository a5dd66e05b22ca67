"""`simplify`: targets, conventions of arrays, attributes, options."""

import numpy as np
import pytest
import striata
from conftest import check_mesh


@pytest.mark.parametrize(
    ("target", "most"),
    [
        ({"triangles": 300}, 300),
        ({"target_count": 300}, 300),
        ({"ratio": 0.1}, 320),
        ({"target_reduction": 0.9}, 320),
    ],
)
def test_targets_count_triangles(terrain, target, most):
    points, faces = striata.simplify(*terrain, **target)
    check_mesh(points, faces)
    assert most - 3 <= len(faces) <= most


def test_vertices_and_errors_are_targets(terrain):
    assert len(striata.simplify(*terrain, vertices=200).points) <= 200
    small = striata.simplify(*terrain, error="0.5%")
    diagonal = np.linalg.norm(terrain[0].max(0) - terrain[0].min(0))
    assert 0 < small.error <= 0.005 * diagonal and len(small.faces) < len(terrain[1])
    same = striata.simplify(*terrain, error=0.005 * diagonal)
    assert len(same.faces) == len(small.faces)


def test_guaranteed_errors_hold(terrain):
    limit = 0.01
    small = striata.simplify(*terrain, max_error=limit)
    measured = striata.distance(terrain, tuple(small), samples=20_000)
    assert small.error <= limit and measured.a_to_b.max <= limit * 1.0001
    both = striata.simplify(*terrain, triangles=2, max_error=limit)
    assert both.stop_reason == "error_limit" and len(both.faces) == len(small.faces)


def test_arguments_are_checked(terrain):
    cases = {
        "no target": {},
        "more than one target": {"ratio": 0.5, "triangles": 3},
        "ratio is 1.5": {"ratio": 1.5},
        "ratio is nan": {"ratio": float("nan")},
        "triangles is -1": {"triangles": -1},
        "triangles is 1.5": {"triangles": 1.5},
        "error is 'much'": {"error": "much"},
        "max_error is -1.0": {"max_error": -1},
        'cost is "best"': {"ratio": 0.5, "cost": "best"},
        "placement is 'x'": {"ratio": 0.5, "placement": "x"},
        "locked[1] is 9999": {"ratio": 0.5, "locked": [0, 9999]},
        "attributes['a'] has 2 rows, but there are 1681 points": {"ratio": 0.5, "attributes": {"a": [1, 2]}},
        "weights['b']": {"ratio": 0.5, "weights": {"b": 1}},
    }
    for message, arguments in cases.items():
        with pytest.raises(ValueError) as raised:
            striata.simplify(*terrain, **arguments)
        assert message in str(raised.value), raised.value
    with pytest.raises(TypeError):
        striata.simplify(*terrain, 0.5)
    with pytest.raises(TypeError):
        striata.simplify(*terrain, percent=0.5)


@pytest.mark.parametrize("points_dtype", [np.float32, np.float64, ">f8", np.float16])
@pytest.mark.parametrize("faces_dtype", [np.int32, np.int64, ">i4", np.uint32, np.uint16])
def test_dtypes_and_strides_are_converted(terrain, points_dtype, faces_dtype):
    points, faces = terrain[0].astype(points_dtype), terrain[1].astype(faces_dtype)
    expected = striata.simplify(points, faces, ratio=0.2)
    forms = [
        (np.asfortranarray(points), np.asfortranarray(faces)),
        (np.repeat(points, 2, axis=0)[::2], np.repeat(faces, 2, axis=0)[::2]),
        (np.ascontiguousarray(points[::-1])[::-1], faces),
    ]
    for p, f in forms:
        p.flags.writeable = f.flags.writeable = False
        before = p.copy(), f.copy()
        made = striata.simplify(p, f, ratio=0.2)
        assert np.array_equal(made.points, expected.points) and np.array_equal(made.faces, expected.faces)
        assert np.array_equal(p, before[0]) and np.array_equal(f, before[1])
    wanted = np.float32 if points.dtype.itemsize < 4 else points.dtype.newbyteorder("=")
    assert expected.points.dtype == wanted
    assert expected.faces.dtype == (np.int32 if faces.dtype.itemsize < 4 else faces.dtype.newbyteorder("="))
    assert expected.points.flags.writeable and expected.faces.flags.writeable


def test_double_precision_is_kept_far_from_the_origin(terrain):
    offset = np.array([5.4e6, 6.1e5, 1e3])
    points = terrain[0].astype(np.float64) + offset
    near = striata.simplify(terrain[0].astype(np.float64), terrain[1], ratio=0.2)
    far = striata.simplify(points, terrain[1], ratio=0.2)
    assert abs(len(far.faces) - len(near.faces)) <= 2
    assert np.array_equal(far.points, points[far.vertices])
    assert striata.distance((points, terrain[1]), tuple(far), samples=10_000).rms < 0.01


def test_flat_faces_come_back_flat(terrain):
    points, faces = terrain
    flat = np.column_stack([np.full(len(faces), 3), faces]).ravel()
    made = striata.simplify(points, flat, ratio=0.2)
    expected = striata.simplify(points, faces, ratio=0.2)
    assert made.faces.ndim == 1 and np.array_equal(made.faces.reshape(-1, 4)[:, 1:], expected.faces)


def test_places_are_named(terrain):
    points, faces = terrain
    bad = points.copy()
    bad[3, 1] = np.nan
    wrong = faces.copy()
    wrong[17, 2] = 4000
    negative = faces.copy()
    negative[0, 1] = -1
    flat = np.column_stack([np.full(len(faces), 3), faces]).ravel()
    flat[8] = 4
    huge = np.lib.stride_tricks.as_strided(faces, (2**31, 3), (0, 0))
    cases = {
        "points[3, 1] is nan": (bad, faces),
        "points[0, 0] is 1e+300": (np.full((3, 3), [1e300, 0, 0]) * [[1], [0], [0]], [[0, 1, 2]]),
        "faces[17, 2] is 4000, but there are 1681 points": (points, wrong),
        "faces[0, 1] is -1": (points, negative),
        "faces[8] is 4": (points, flat),
        "faces has 5 values": (points, [3, 0, 1, 2, 3]),
        "faces has 2147483648 rows": (points, huge),
        "points has the shape (1681, 2)": (points[:, :2], faces),
        "points has the shape (3,)": (points[0], faces),
        "faces has the shape (3200, 2)": (points, faces[:, :2]),
        "faces has the dtype float64": (points, faces.astype(float)),
        "points has the dtype complex64": (points.astype(np.complex64), faces),
        "points has the dtype object": (points.astype(object), faces),
    }
    for message, (p, f) in cases.items():
        with pytest.raises(ValueError) as raised:
            striata.simplify(p, f, ratio=0.5)
        assert message in str(raised.value), raised.value


def test_empty_and_degenerate_meshes_are_meshes():
    none = striata.simplify(np.empty((0, 3)), np.empty((0, 3), int), ratio=0.5)
    assert none.points.shape == (0, 3) and none.faces.shape == (0, 3) and none.faces.dtype == int
    assert len(striata.simplify([], [], ratio=0.5).faces) == 0
    line = striata.simplify([[0, 0, 0], [1, 0, 0]], [[0, 1, 1]], ratio=0.5)
    assert len(line.faces) == 0 and line.points.dtype == np.float64


def test_attributes_of_any_type_follow(terrain):
    points, faces = terrain
    n = len(points)
    attributes = {
        "label": np.arange(n) - 5,
        "big": np.arange(n, dtype=np.int64) * 10**12,
        "mask": np.arange(n) % 2 == 0,
        "name": np.array([f"p{i}" for i in range(n)]),
        "when": np.datetime64("2020-01-01") + np.arange(n),
        "tensor": np.random.default_rng(0).normal(size=(n, 3, 3)),
        "complex": np.arange(n) * 1j,
        "objects": np.array([{i} for i in range(n)], dtype=object),
        "nan": np.full(n, np.nan),
        "wide": np.zeros((n, 300), np.uint8),
        "none": np.empty((n, 0)),
    }
    made = striata.simplify(points, faces, ratio=0.3, attributes=attributes)
    assert len(made) == 3 and made[2] is made.attributes
    for name, values in attributes.items():
        carried = made.attributes[name]
        assert carried.dtype == values.dtype and carried.shape[1:] == values.shape[1:]
        equal = carried == values[made.vertices]
        assert np.isnan(carried).all() if name == "nan" else np.all(equal)
    assert np.array_equal(points[made.vertices], made.points)
    centers = points[faces].mean(1)[made.face_origins]
    assert np.abs(made.points[made.faces].mean(1) - centers).max() < 0.5


def test_seams_of_any_attribute_survive():
    points, faces = striata.shapes.grid(20, 20)
    points[:, 2] = np.sin(7 * points[:, 0]) * 0.1
    right = points[faces].mean(1)[:, 0] > 0.5
    # Both halves have their own points along the middle, equal in place but not in label.
    doubled = np.concatenate([points, points])
    split = np.where(right[:, None], faces + len(points), faces)
    label = np.repeat(["left", "right"], len(points))
    made = striata.simplify(doubled, split, ratio=0.2, seams="keep", attributes={"label": label})
    sides = made.attributes["label"][made.faces]
    assert (sides == sides[:, :1]).all() and set(sides.ravel()) == {"left", "right"}


def test_weights_count_in_the_cost():
    points, faces = striata.shapes.grid(60, 60)
    field = np.tanh(40 * (points[:, 0] - 0.5) + np.sin(9 * points[:, 1]))
    plain = striata.simplify(points, faces, ratio=0.05, attributes={"field": field})
    weighted = striata.simplify(points, faces, ratio=0.05, attributes={"field": field}, weights={"field": 0.1})

    def nearest_error(made):
        distance = ((points[:, None, :2] - made.points[None, :, :2]) ** 2).sum(-1)
        return np.abs(field - made.attributes["field"][distance.argmin(1)]).mean()

    assert nearest_error(weighted) < 0.6 * nearest_error(plain)
    colors = {"field": field, "colors": np.zeros((len(points), 3)), "normals": np.tile([0.0, 0, 1], (len(points), 1))}
    for weights in [{"field": 0.1, "colors": 0}, {"normals": 1.0}, 0, {}]:
        check_mesh(*striata.simplify(points, faces, ratio=0.1, attributes=colors, weights=weights)[:2])
    with pytest.raises(ValueError, match=r"attributes\['field'\]\[5\] is nan"):
        broken = np.where(np.arange(len(field)) == 5, np.nan, field)
        striata.simplify(points, faces, ratio=0.1, attributes={"field": broken}, weights={"field": 1})


def test_optimal_placement_interpolates(terrain):
    height = terrain[0][:, 2].astype(np.float64)
    label = np.arange(len(height)) % 7
    made = striata.simplify(
        *terrain, ratio=0.1, placement="optimal", attributes={"height": height, "label": label}
    )
    check_mesh(made.points, made.faces)
    assert made.vertices is None and made.attributes["label"].dtype == label.dtype
    assert set(made.attributes["label"]) <= set(range(7))
    assert np.abs(made.attributes["height"] - made.points[:, 2]).max() < 0.05
    chosen = striata.simplify(*terrain, ratio=0.1)
    rms = [striata.distance(terrain, tuple(m)[:2], samples=50_000).rms for m in (made, chosen)]
    assert rms[0] < rms[1]


def test_locked_points_stay(terrain):
    locked = [0, 40, 800]
    made = striata.simplify(*terrain, triangles=50, locked=locked)
    assert set(locked) <= set(made.vertices)
    mask = np.zeros(len(terrain[0]), bool)
    mask[locked] = True
    assert np.array_equal(striata.simplify(*terrain, triangles=50, locked=mask).faces, made.faces)


def test_objects_that_are_no_meshes_are_refused(terrain):
    for thing in (None, 5, object(), {"points": 1}):
        with pytest.raises(ValueError, match="is not a mesh"):
            striata.simplify(thing, ratio=0.5)
    with pytest.raises(ValueError, match="faces are missing"):
        striata.simplify(terrain[0], ratio=0.5)


def test_targets_by_position_are_explained(terrain):
    with pytest.raises(TypeError, match=r"target_reduction=0\.9 .* ratio=0\.1\)"):
        striata.simplify(*terrain, 0.9)
    with pytest.raises(TypeError, match="triangles=500,"):
        striata.simplify(*terrain, 500)
