"""Random calls: every one succeeds or raises `ValueError`, whatever is passed.

The number of calls is `STRIATA_RANDOM_CALLS`, 2,000 by default.
"""

import numpy as np
import striata
from conftest import check_mesh
from hypothesis import given
from hypothesis import strategies as st

FLOATS = [np.float16, np.float32, np.float64, ">f4", ">f8"]
INTEGERS = [np.int8, np.uint8, np.int16, np.int32, np.int64, np.uint32, np.uint64, ">i4", "<i8"]


@st.composite
def points_and_faces(draw):
    """Mostly valid arrays: a few points, random faces, and sometimes one thing that is wrong."""
    count = draw(st.integers(0, 30))
    random = np.random.default_rng(draw(st.integers(0, 2**16)))
    kind = draw(st.sampled_from(["random", "integers", "flat", "same", "far", "tiny", "huge", "shape"]))
    points = random.normal(size=(count, 3))
    if kind == "integers":
        points = random.integers(0, 3, (count, 3)).astype(float)
    elif kind == "flat":
        points[:, 2] = 0
    elif kind == "same":
        points[:] = 1
    elif kind == "far":
        points += 1e7
    elif kind == "tiny":
        points *= 1e-30
    elif kind == "huge":
        points *= 1e30
    faces = random.integers(0, max(count, 1), (draw(st.integers(0, 40)) if count else 0, 3))
    if kind == "shape":
        points, faces = striata.shapes.terrain(draw(st.integers(1, 12)))
    with np.errstate(over="ignore"):
        points = points.astype(draw(st.sampled_from(FLOATS)))
    if len(points) < 100:
        faces = faces.astype(draw(st.sampled_from(INTEGERS)))
    damage = draw(st.sampled_from(["none"] * 6 + ["nan", "inf", "index", "negative", "shape", "flat", "broadcast"]))
    if damage in ("nan", "inf") and len(points):
        points[draw(st.integers(0, len(points) - 1)), draw(st.integers(0, 2))] = float(damage)
    elif damage == "index" and len(faces):
        faces[draw(st.integers(0, len(faces) - 1)), 0] = min(len(points) + draw(st.integers(0, 90)), 127)
    elif damage == "negative" and len(faces) and faces.dtype.kind == "i":
        faces[draw(st.integers(0, len(faces) - 1)), 1] = -draw(st.integers(1, 100))
    elif damage == "shape":
        points, faces = points.reshape(-1), faces[:, :2]
    elif damage == "flat":
        faces = np.column_stack([np.full(len(faces), draw(st.sampled_from([3, 3, 4]))), faces]).ravel()
    elif damage == "broadcast":
        faces = np.broadcast_to(faces[:1], (2**31, 3)) if len(faces) else faces
    layout = draw(st.sampled_from(["c", "f", "strided", "reversed", "list", "readonly"]))
    if layout == "f":
        points, faces = np.asfortranarray(points), faces.copy(order="F") if faces.nbytes < 10**6 else faces
    elif layout == "strided" and points.ndim == 2:
        points = np.repeat(points, 2, axis=1)[:, ::2]
    elif layout == "reversed":
        points = points[::-1].copy()[::-1]
    elif layout == "list":
        points = points.tolist()
        faces = faces.tolist() if len(faces) < 1000 else faces
    elif layout == "readonly":
        points.flags.writeable = False
    return points, faces


TARGETS = st.one_of(
    st.fixed_dictionaries({"ratio": st.floats(-0.5, 1.5)}),
    st.fixed_dictionaries({"triangles": st.integers(-2, 60)}),
    st.fixed_dictionaries({"vertices": st.integers(0, 60)}),
    st.fixed_dictionaries({"target_reduction": st.floats(0, 1)}),
    st.fixed_dictionaries({"error": st.one_of(st.floats(allow_nan=True), st.sampled_from(["1%", "x", "-1%"]))}),
    st.fixed_dictionaries({"max_error": st.floats(0, 2)}),
    st.fixed_dictionaries({"triangles": st.integers(0, 60), "max_error": st.floats(0, 2)}),
    st.just({}),
)

OPTIONS = st.fixed_dictionaries(
    {},
    optional={
        "cost": st.sampled_from(["memoryless", "accumulated", "tracked", "?"]),
        "boundary": st.sampled_from(["keep", "lock"]),
        "seams": st.sampled_from(["cross", "keep"]),
        "topology": st.sampled_from(["change", "keep_parts", "keep"]),
        "height_field": st.sampled_from([None, True, False]),
        "pair_distance": st.floats(-1, 1),
        "locked": st.lists(st.integers(-1, 20), max_size=4),
    },
)

ATTRIBUTE_DTYPES = [np.float32, np.float64, np.uint8, np.int64, np.bool_, "U4", ">f8", np.complex64]


@given(points_and_faces(), TARGETS, OPTIONS, st.data())
def test_random_calls(arrays, target, options, data):
    points, faces = arrays
    arguments = {**target, **options}
    if data.draw(st.booleans()):
        rows = len(points) + data.draw(st.sampled_from([0, 0, 0, 1]))
        columns = data.draw(st.integers(0, 4))
        values = np.random.default_rng(rows).integers(0, 3, (rows, columns))
        name = data.draw(st.sampled_from(["label", "uv", "normals", "colors"]))
        arguments["attributes"] = {name: values.astype(data.draw(st.sampled_from(ATTRIBUTE_DTYPES)))}
        if data.draw(st.booleans()):
            arguments["weights"] = {name: data.draw(st.floats(-1, 10))}
    verb = data.draw(st.sampled_from(["simplify", "simplify", "optimal", "build", "encode", "strip", "distance"]))
    try:
        call(verb, points, faces, arguments)
    except (ValueError, OverflowError) as error:
        assert str(error)


def call(verb, points, faces, arguments):
    """Make one call and check what comes back."""
    if verb in ("simplify", "optimal"):
        placement = "optimal" if verb == "optimal" else "subset"
        made = striata.simplify(points, faces, placement=placement, **arguments)
        check_mesh(made.points, np.reshape(made.faces, (-1, 4))[:, 1:] if made.faces.ndim == 1 else made.faces)
        given_dtype = np.asarray(points).dtype
        assert given_dtype.itemsize < 4 or made.points.dtype == given_dtype.newbyteorder("=")
        for values in made.attributes.values():
            assert len(values) == len(made.points)
    elif verb == "build":
        targets = ("ratio", "triangles", "vertices", "target_reduction", "error", "max_error")
        target = {name: arguments.pop(name) for name in targets if name in arguments}
        lod = striata.build(points, faces, guaranteed="max_error" in target, **arguments)
        level = lod.level(**target)
        check_mesh(level.points, level.faces)
        assert len(lod.fine_to_coarse(level)) == len(points)
        view = lod.view()
        view.update(eye=(3, 2, 1), target=(0, 0, 0))
        assert len(view.faces) == view.triangle_count
    elif verb == "encode":
        assert striata.decode(striata.encode(points, faces, bits=8)).face_count >= 0
    elif verb == "strip":
        assert len(striata.strip(points, faces)) >= 0
    else:
        assert striata.distance((points, faces), (points, faces), samples=10).max >= 0


@given(st.binary(max_size=200), st.integers(0, 4))
def test_random_bytes_are_errors_or_meshes(data, kind):
    starts = [b"", b"STRIATA\0", b"\x89STR\x03", b"\x89SCN\x01", b"ply\n"]
    try:
        striata.decode(starts[kind] + data)
    except striata.DecodeError as error:
        assert str(error)
