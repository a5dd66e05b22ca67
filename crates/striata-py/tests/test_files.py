"""Files, streams and scenes."""

import json

import numpy as np
import pytest
import striata


@pytest.mark.parametrize("name", ["m.ply", "m.obj", "m.stl", "m.off", "m.glb", "m.gltf", "m.ply.gz", "m.obj.zst"])
def test_every_format_keeps_the_shape(tmp_path, torus, name):
    path = tmp_path / name
    striata.save(path, torus)
    opened = striata.open(path)
    mesh = opened.flattened() if isinstance(opened, striata.Scene) else opened
    assert mesh.face_count == len(torus[1])
    assert striata.distance(torus, mesh, samples=2000).max < 1e-5


def canonical(faces):
    """Set of faces, each beginning with its smallest index."""
    return {tuple(np.roll(t, -t.argmin())) for t in faces}


@pytest.mark.parametrize("name", ["l.striata", "l.stri"])
def test_files_with_levels(tmp_path, torus, name):
    lod = striata.build(*torus, attributes={"label": np.arange(len(torus[0]), dtype=np.uint16)})
    path = tmp_path / name
    lod.save(path)
    opened = striata.open(path)
    assert opened.face_count == lod.face_count
    assert np.array_equal(np.sort(opened.attributes["label"]), np.arange(len(torus[0])))
    if name.endswith("striata"):
        target = {"triangles": 500}
        assert canonical(opened.level(**target).faces) == canonical(lod.level(**target).faces)
        assert np.array_equal(opened.points, lod.points)


def test_only_what_users_passed_is_stored(tmp_path, torus):
    names = np.array([f"p{i % 3}" for i in range(len(torus[0]))])
    height = torus[0][:, 2]
    lod = striata.build(*torus, attributes={"name": names, "height": height}, weights={"height": 0.5})
    lod.save(tmp_path / "a.striata")
    assert set(striata.open(tmp_path / "a.striata").attributes) == {"height"}
    assert set(lod.mesh().attributes) == {"height"} and set(lod.attributes) == {"name", "height"}


def test_files_far_from_the_origin_keep_their_place(tmp_path, torus):
    points = torus[0].astype(np.float64) + [5e5 + 0.1, 5e6, 0]
    for name in ("f.striata", "f.ply", "f.obj", "f.stri"):
        striata.save(tmp_path / name, striata.build(points, torus[1]) if "stri" in name else (points, torus[1]))
        opened = striata.open(tmp_path / name)
        assert opened.points.dtype == np.float64
        if name in ("f.ply", "f.obj"):
            assert np.array_equal(opened.points, points)
            small = striata.simplify(opened, ratio=0.5)
            rows = {tuple(point) for point in points}
            assert all(tuple(point) in rows for point in small.points)
        else:
            assert striata.distance((points, torus[1]), opened, samples=2000).max < (1e-6 if name == "f.striata" else 1e-3)
    view = striata.open(tmp_path / "f.striata").view()
    view.update(eye=points.mean(0) + [0, 0, 5], target=points.mean(0), pixels=1.0)
    assert len(view.faces) > 100


def test_data_of_faces_follow_their_faces(tmp_path, torus):
    points, faces = torus
    label = np.arange(len(faces), dtype=np.int32) * 1000 - 7
    color = np.tile(np.uint8([[10, 20, 30]]), (len(faces), 1))
    mesh = striata.Mesh(points, faces, face_attributes={"label": label, "color": color})
    assert mesh.face_attributes["label"].dtype == np.int32
    assert np.array_equal(mesh.face_attributes["label"], label)
    for name in ("a.ply", "a.striata", "a.stri"):
        striata.save(tmp_path / name, striata.build(mesh) if "stri" in name else mesh)
        opened = striata.open(tmp_path / name)
        full = opened if name == "a.ply" else opened.mesh()
        assert sorted(full.face_attributes["label"]) == sorted(label)
        assert np.array_equal(full.face_attributes["color_0"], color)
    level = striata.build(mesh).level(ratio=0.3)
    assert np.array_equal(level.to_mesh().face_attributes["label"], label[level.face_origins])
    with pytest.raises(ValueError, match="faces"):
        striata.Mesh(points, faces, face_attributes={"label": label[1:]})


def test_errors_of_files(tmp_path, torus):
    with pytest.raises(FileNotFoundError) as raised:
        striata.open(tmp_path / "none.ply")
    assert raised.value.errno == 2 and raised.value.filename.endswith("none.ply")
    with pytest.raises(OSError):
        striata.open(tmp_path)
    with pytest.raises(FileNotFoundError):
        striata.save(tmp_path / "no" / "such.ply", torus)
    with pytest.raises(TypeError, match="the file comes first"):
        striata.save(torus, tmp_path / "a.ply")
    broken = tmp_path / "broken.off"
    broken.write_text("OFF\n3 1 0\n0 0 0\n1 0 x\n")
    with pytest.raises(striata.DecodeError, match="line 5"):
        striata.open(broken)
    (tmp_path / "what.bin").write_bytes(b"hello")
    with pytest.raises(striata.DecodeError):
        striata.open(tmp_path / "what.bin")
    with pytest.raises(ValueError):
        striata.save(tmp_path / "x.xyz", torus)
    assert issubclass(striata.DecodeError, ValueError)


def test_conversion(tmp_path, torus):
    striata.save(tmp_path / "a.ply", torus)
    for name in ("b.glb", "c.striata", "d.stri", "e.obj"):
        striata.convert(tmp_path / "a.ply", tmp_path / name)
        assert (tmp_path / name).stat().st_size > 0
    assert isinstance(striata.open(tmp_path / "c.striata"), striata.Lod)
    small = striata.simplify(tmp_path / "a.ply", ratio=0.1)
    assert isinstance(small, striata.Mesh) and small.face_count <= 0.1 * len(torus[1])
    striata.save(tmp_path / "text.ply", torus, ascii=True)
    assert b"format ascii" in (tmp_path / "text.ply").read_bytes()[:40]


def test_streams(torus):
    stream = striata.encode(*torus)
    assert isinstance(stream, bytes)
    decoder = striata.StreamDecoder()
    assert decoder.lod() is None and decoder.byte_count is None and decoder.step_count is None
    counts, errors = [], []
    for start in range(0, len(stream), 500):
        decoder.push(memoryview(stream)[start : start + 500])
        counts.append(len(decoder.faces))
        if decoder.error is not None:
            errors.append(decoder.error)
    assert decoder.is_complete and decoder.byte_count == len(stream) and errors[-1] == 0
    assert counts == sorted(counts) and errors == sorted(errors, reverse=True)
    assert len(decoder.points) == len(torus[0]) and decoder.split_count == decoder.step_count
    assert decoder.lod().level(triangles=500).triangle_count <= 500
    exact = striata.decode(striata.encode(*torus, lossless=True))
    assert {tuple(p) for p in exact.points} == {tuple(p) for p in torus[0]}
    near = striata.decode(striata.encode(*torus, tolerance=0.001))
    assert striata.distance(torus, near, samples=1000).a_to_b.max < 0.002
    for wrong in ({"bits": 0}, {"bits": 99}, {"effort": "x"}, {"tolerance": -1}, {"tolerance": 1, "lossless": True}):
        with pytest.raises(ValueError):
            striata.encode(*torus, **wrong)


def test_damaged_streams_are_errors(torus):
    stream = striata.encode(*torus)
    for length in range(0, len(stream), 97):
        with pytest.raises(striata.DecodeError):
            striata.decode(stream[:length])
    partial = striata.decode(stream[: len(stream) // 2], allow_truncated=True)
    assert 0 < partial.face_count < len(torus[1])
    random = np.random.default_rng(1)
    for _ in range(200):
        damaged = bytearray(stream)
        damaged[random.integers(len(stream))] ^= 1 << random.integers(8)
        try:
            assert striata.decode(bytes(damaged)).face_count >= 0
        except striata.DecodeError:
            pass
    with pytest.raises(striata.DecodeError):
        striata.StreamDecoder().push(b"x" * 100)


@pytest.fixture
def scene_path(tmp_path, torus):
    mesh = striata.Scene(striata.Mesh(*torus))
    mesh.save(tmp_path / "one.gltf")
    document = json.loads((tmp_path / "one.gltf").read_text())
    document["nodes"] = [{"mesh": 0}, {"mesh": 0, "translation": [3, 0, 0]}]
    document["scenes"], document["scene"] = [{"nodes": [0, 1]}], 0
    document["meshes"][0]["name"] = "ring"
    document["materials"] = [{"name": "red", "pbrMetallicRoughness": {"baseColorFactor": [1, 0, 0, 1]}}]
    document["meshes"][0]["primitives"][0]["material"] = 0
    path = tmp_path / "two.gltf"
    path.write_text(json.dumps(document))
    return path


def test_scenes(tmp_path, torus, scene_path):
    scene = striata.open(scene_path)
    assert isinstance(scene, striata.Scene) and scene.mesh_names == ["ring"] and scene.images == []
    assert scene.triangle_count == 2 * len(torus[1]) and scene.meshes[0].face_count == len(torus[1])
    assert [i.transform[0, 3] for i in scene.instances] == [0, 3]
    assert scene.flattened().face_count == scene.triangle_count
    lods = striata.build(scene)
    assert isinstance(lods, striata.LodScene) and lods.lods[0].face_count == len(torus[1])
    level = lods.level(ratio=0.1)
    assert level.triangle_count <= 0.1 * scene.triangle_count and level.error > 0
    assert level.to_scene().document["materials"][0]["name"] == "red"
    assert striata.simplify(scene, ratio=0.1).triangle_count == level.triangle_count
    for name in ("s.striata", "s.stri", "s.glb"):
        lods.save(tmp_path / name)
        opened = striata.open(tmp_path / name)
        assert isinstance(opened, striata.LodScene), name
        assert opened.triangle_count == scene.triangle_count
    level.save(tmp_path / "level.glb")
    assert striata.open(tmp_path / "level.glb").triangle_count == level.triangle_count
    decoded = striata.decode(striata.encode(scene))
    assert isinstance(decoded, striata.LodScene)
    with pytest.raises(ValueError, match="guaranteed"):
        lods.level(max_error=1)


def test_scenes_are_edited_and_embedded(tmp_path, torus, scene_path):
    document = json.loads(scene_path.read_text())
    document["materials"] = 2 * document["materials"]
    document["meshes"] = 2 * document["meshes"]
    document["nodes"][-1]["mesh"] = 1
    path = tmp_path / "copies.gltf"
    path.write_text(json.dumps(document))
    scene = striata.open(path)
    merged = scene.deduplicate()
    assert len(scene.meshes) == 2 and len(merged.meshes) == 1 and len(merged.document["materials"]) == 1
    assert merged.triangle_count == scene.triangle_count
    assert scene.resample().document == scene.document
    with pytest.raises(ValueError, match="tolerance"):
        scene.resample(-1)
    striata.save(tmp_path / "a.gltf", scene)
    scene.save(tmp_path / "b.gltf", embed=True)
    assert (tmp_path / "a.bin").exists() and not (tmp_path / "b.bin").exists()
    striata.save(tmp_path / "c.gltf", striata.Mesh(*torus), embed=True)
    assert not (tmp_path / "c.bin").exists()


def test_shading_gives_plain_meshes_normals(tmp_path, torus):
    striata.save(tmp_path / "plain.glb", striata.Mesh(*torus))
    striata.save(tmp_path / "shaded.glb", striata.Mesh(*torus), shading=True)
    primitive = [
        striata.open(tmp_path / f"{name}.glb").document["meshes"][0]["primitives"][0] for name in ("plain", "shaded")
    ]
    assert "NORMAL" not in primitive[0]["attributes"] and "NORMAL" in primitive[1]["attributes"]
    assert "material" not in primitive[0] and "material" in primitive[1]


def test_meshes_of_files_have_attributes_groups_and_materials(tmp_path):
    (tmp_path / "m.mtl").write_text("newmtl a\nKd 1 0 0\nnewmtl b\nKd 0 1 0\n")
    (tmp_path / "m.obj").write_text(
        "mtllib m.mtl\nv 0 0 0\nv 1 0 0\nv 0 1 0\nv 1 1 0\nvt 0 0\nvt 1 0\nvt 0 1\nvt 1 1\n"
        "usemtl a\nf 1/1 2/2 3/3\nusemtl b\nf 2/2 4/4 3/3\n"
    )
    mesh = striata.open(tmp_path / "m.obj")
    assert set(mesh.attributes) == {"texcoord_0"} and mesh.attributes["texcoord_0"].shape == (4, 2)
    assert [g.faces for g in mesh.groups] == [slice(0, 1), slice(1, 2)]
    assert [m.name for m in mesh.materials] == ["a", "b"] and mesh.images == []
    assert striata.simplify(mesh, ratio=1.0).face_count == 2
    lod = striata.build(mesh)
    assert isinstance(lod.level(ratio=1.0).to_mesh(), striata.Mesh)
    assert len(lod.level(ratio=1.0).to_mesh().materials) == 2


def test_missing_companions_are_warnings(tmp_path):
    (tmp_path / "m.obj").write_text("mtllib none.mtl\nv 0 0 0\nv 1 0 0\nv 0 1 0\nusemtl a\nf 1 2 3\n")
    with pytest.warns(UserWarning, match=r"none\.mtl"):
        striata.open(tmp_path / "m.obj")


def test_what_is_left_out_is_a_read_warning(tmp_path):
    (tmp_path / "m.obj").write_text("v 0 0 0\nv 1 0 0\nv 0 1 0\nvw 1\nvw 2\nf 1 2 3\n")
    with pytest.warns(striata.ReadWarning, match="2 lines skipped, the first is line 4"):
        assert striata.open(tmp_path / "m.obj").face_count == 1
    with pytest.raises(ValueError, match="2 lines skipped"):
        striata.open(tmp_path / "m.obj", strict_input=True)


def test_pages_and_notebooks(tmp_path, torus):
    lod = striata.build(*torus)
    text = lod._repr_html_()
    assert "<iframe" in text and "<table>" in text and len(text) < 8_000_000
    assert "<table>" in lod.level(ratio=0.1)._repr_html_()
    assert "<iframe" not in striata.build([], [])._repr_html_()
    path = striata.view(lod, path=str(tmp_path / "v.html"), open_browser=False)
    assert "striata-model" in path.read_text()


def test_plots(torus):
    matplotlib = pytest.importorskip("matplotlib")
    matplotlib.use("Agg")
    axes = striata.plot.error(striata.build(*torus))
    assert len(axes.lines) == 1 and axes.get_xlabel() == "triangles"


def test_data_that_scene_files_do_not_hold_is_a_warning(tmp_path, torus):
    points, faces = torus
    mesh = striata.Mesh(
        points,
        faces,
        attributes={"label": np.arange(len(points), dtype=np.int32) + 123456789},
        face_attributes={"id": np.arange(len(faces), dtype=np.int32)},
    )
    scene = striata.Scene(mesh)
    for model in (scene, striata.build(scene)):
        for name, lost in (("a.glb", ["label", "id"]), ("a.ply", ["label", "id"]), ("a.stri", ["id"])):
            with pytest.warns(UserWarning) as found:
                model.save(tmp_path / name)
            texts = [str(warning.message) for warning in found]
            assert len(texts) == len(lost) and all(f"`{key}`" in text for key, text in zip(lost, texts)), (name, texts)
        model.save(tmp_path / "a.striata")
        back = striata.open(tmp_path / "a.striata").level(ratio=1.0).to_scene().meshes[0]
        assert set(back.attributes["label"]) == set(mesh.attributes["label"])
        assert set(back.face_attributes["id"]) == set(mesh.face_attributes["id"])
