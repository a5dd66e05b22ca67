"""Tiles and arrays of levels."""

import gzip
import json
import struct
import warnings

import numpy as np
import pytest
import striata


def torus():
    return striata.shapes.torus(96, 64)


def test_3d_tiles_of_arrays_and_of_a_paged_file(tmp_path):
    report = striata.tiles(torus(), tmp_path / "tiles", tile_triangles=2000, encoding="draco")
    assert report["levels"][0]["error"] == 0.0 and report["tiles"] > 4
    tileset = json.loads((tmp_path / "tiles" / "tileset.json").read_text())
    assert tileset["asset"]["version"] == "1.1"
    plan = striata.run(striata.plan("shape:terrain:60", tmp_path / "t.striata"))
    plan.remove_work()
    phases = []
    striata.tiles(tmp_path / "t.striata", tmp_path / "t.3tz", progress=lambda phase, *_: phases.append(phase))
    assert (tmp_path / "t.3tz").read_bytes().startswith(b"PK")
    assert sorted(path.name for path in tmp_path.iterdir()) == ["t.3tz", "t.striata", "tiles"]


def test_neuroglancer(tmp_path):
    report = striata.tiles(torus(), tmp_path / "meshes", format="neuroglancer", segment_id=2**64 - 1, bits=10)
    info = json.loads((tmp_path / "meshes" / "info").read_text())
    assert (info["@type"], info["vertex_quantization_bits"]) == ("neuroglancer_multilod_draco", 10)
    manifest = (tmp_path / "meshes" / f"{2**64 - 1}.index").read_bytes()
    assert struct.unpack_from("<I", manifest, 24)[0] == len(report["levels"])
    striata.tiles(torus(), tmp_path / "meshes", format="neuroglancer", sharded=True)
    assert (tmp_path / "meshes" / "0.shard").exists()


def rows(store, path, count):
    """The first rows of an array."""
    node = json.loads((store / path / "zarr.json").read_text())
    shape, chunk = node["shape"], node["codecs"][0]["configuration"]["chunk_shape"][0]
    data = store.joinpath(path, "c", *["0"] * len(shape)).read_bytes()
    index = np.frombuffer(data[-4 - 16 * -(-shape[0] // chunk) : -4], "<u8").reshape(-1, 2)
    chunks = [gzip.decompress(data[at : at + size]) for at, size in index[: -(-count // chunk)].tolist()]
    return np.frombuffer(b"".join(chunks), node["data_type"]).reshape(-1, *shape[1:])[:count]


def canonical(faces):
    """Faces that begin with their smallest corner, sorted."""
    turned = [np.roll(face, -int(np.argmin(face))) for face in np.asarray(faces)]
    return sorted(tuple(int(v) for v in face) for face in turned)


def test_levels_of_a_zarr_store_are_those_of_the_library(tmp_path):
    lod = striata.build(*torus(), guaranteed=True)
    store = tmp_path / "torus.zarr"
    report = striata.tiles(lod, store, format="zarr")
    described = json.loads((store / "zarr.json").read_text())["attributes"]["striata"]
    assert described["guaranteed_errors"] and len(described["levels"]) == len(report["levels"])
    for wanted in (4000, 500, 60):
        level = lod.level(triangles=wanted)
        n = len(level.points)
        assert np.array_equal(rows(store, "positions", n), np.asarray(level.points, np.float32))
        finer = [stored for stored in described["levels"] if stored["vertices"] >= n][-1]
        targets, corner = rows(store, "targets", finer["vertices"]), np.arange(finer["vertices"])
        while (corner >= n).any():
            corner = np.where(corner >= n, targets[corner], corner)
        faces = corner[rows(store, finer["path"] + "/triangles", finer["triangles"])]
        a, b, c = faces.T
        assert canonical(faces[(a != b) & (b != c) & (c != a)]) == canonical(level.faces)


def test_what_cannot_be_written_is_refused(tmp_path):
    for options in ({"format": "stars"}, {"bits": 12}, {"segment_id": -1}, {"tile_triangles": 3}, {"encoding": "x"}):
        with pytest.raises(ValueError, match=next(iter(options))):
            striata.tiles(torus(), tmp_path / "out", **options)
    (tmp_path / "mine").mkdir()
    (tmp_path / "mine" / "file").write_text("mine")
    with pytest.raises(ValueError, match="no tileset of striata"):
        striata.tiles(torus(), tmp_path / "mine")
    with pytest.raises(FileNotFoundError):
        striata.tiles(tmp_path / "none.ply", tmp_path / "out")
    with warnings.catch_warnings():
        warnings.simplefilter("error")
        with pytest.raises(UserWarning, match="left out: normal"):
            points, faces = torus()
            mesh = striata.Mesh(points, faces, attributes={"normal": points})
            striata.tiles(mesh, tmp_path / "meshes", format="neuroglancer")
    assert [path.name for path in sorted(tmp_path.iterdir())] == ["meshes", "mine"]
