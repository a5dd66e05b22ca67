"""Meshes of other packages: the same type comes back, with everything attached to it."""

import subprocess
import sys

import numpy as np
import pytest
import striata


def package(name):
    """Import a package, or skip: some need system libraries that the machine lacks."""
    return pytest.importorskip(name, exc_type=ImportError)


def test_nothing_is_imported_unless_it_was_passed_in():
    code = (
        "import sys, striata; striata.simplify(*striata.shapes.grid(5, 5), ratio=0.5);"
        "names = {m.split('.')[0] for m in sys.modules};"
        "assert not names & {'trimesh', 'pyvista', 'vtk', 'open3d', 'meshio', 'matplotlib', 'tqdm', 'scipy'}, names"
    )
    subprocess.run([sys.executable, "-c", code], check=True)


def both_ways(mesh, **arguments):
    """The mesh by `simplify` and by a level."""
    return [striata.simplify(mesh, ratio=0.2, **arguments), striata.build(mesh, **arguments).level(ratio=0.2).to_mesh()]


def test_trimesh(terrain):
    trimesh = package("trimesh")
    points, faces = terrain
    for visual in ("vertex", "face", "texture", "none"):
        mesh = trimesh.Trimesh(points, faces, process=False, metadata={"made": "by hand"})
        mesh.vertex_attributes["label"] = np.arange(len(points))
        mesh.face_attributes["zone"] = np.arange(len(faces))
        colors = np.random.default_rng(2).integers(0, 255, (len(faces), 4)).astype(np.uint8)
        if visual == "vertex":
            mesh.visual.vertex_colors = colors[: len(points)]
        elif visual == "face":
            mesh.visual.face_colors = colors
        elif visual == "texture":
            mesh.visual = trimesh.visual.TextureVisuals(uv=points[:, :2].copy())
        for made in both_ways(mesh):
            assert type(made) is trimesh.Trimesh and made.metadata["made"] == "by hand"
            label, zone = made.vertex_attributes["label"], made.face_attributes["zone"]
            assert np.array_equal(mesh.vertices[label], made.vertices) and len(zone) == len(made.faces)
            assert 0.19 * len(faces) < len(made.faces) <= 0.2 * len(faces)
            if visual == "vertex":
                assert np.array_equal(made.visual.vertex_colors, colors[label])
            elif visual == "face":
                assert np.array_equal(made.visual.face_colors, colors[zone])
            elif visual == "texture":
                assert np.allclose(made.visual.uv, made.vertices[:, :2])
    with pytest.raises(ValueError, match="Scene is not a Trimesh"):
        striata.simplify(trimesh.Scene(), ratio=0.5)


def test_pyvista(terrain):
    pv = package("pyvista")
    points, faces = terrain
    mesh = pv.PolyData.from_regular_faces(points, faces)
    mesh.point_data["label"] = np.arange(len(points))
    mesh.cell_data["zone"] = np.arange(len(faces))
    mesh.field_data["note"] = ["hills"]
    mesh.point_data["Normals"] = np.tile(np.float32([0, 0, 1]), (len(points), 1))
    mesh.point_data.active_normals_name = "Normals"
    mesh.set_active_scalars("label")
    for made in both_ways(mesh):
        assert type(made) is pv.PolyData and made.points.dtype == mesh.points.dtype
        label = made.point_data["label"]
        assert np.array_equal(mesh.points[label], made.points)
        assert made.active_scalars_name == "label" and made.point_data.active_normals_name == "Normals"
        assert made.cell_data["zone"].shape == (made.n_cells,) and made.field_data["note"][0] == "hills"
    assert mesh.n_cells == len(faces)


def test_pyvista_examples():
    pv = package("pyvista")
    quads = pv.Plane(i_resolution=20, j_resolution=20)
    assert striata.simplify(quads, ratio=0.5).n_cells <= 400
    sphere = pv.Sphere(phi_resolution=60, theta_resolution=60)
    made = striata.simplify(sphere, target_reduction=0.75)
    theirs = sphere.decimate(0.75)
    assert abs(made.n_cells - theirs.n_cells) <= 2 and made.is_manifold == sphere.is_manifold
    assert type(made) is type(theirs) and made.points.dtype == theirs.points.dtype
    double = pv.Sphere()
    double.points = double.points.astype(np.float64)
    assert striata.simplify(double, ratio=0.5).points.dtype == np.float64
    assert striata.simplify(pv.PolyData(), ratio=0.5).n_points == 0
    for refused in (pv.Line(), pv.ImageData(dimensions=(3, 3, 3))):
        with pytest.raises(ValueError):
            striata.simplify(refused, ratio=0.5)


def test_pyvista_keeps_the_faces_of_mixed_cells():
    pv = package("pyvista")
    plane = pv.Plane(i_resolution=8, j_resolution=8).triangulate()
    mixed = pv.PolyData(
        plane.points,
        faces=plane.faces,
        lines=[2, 0, 1, 3, 2, 3, 4],
        verts=[1, 0, 1, 5, 2, 7, 8],
    )
    mixed.cell_data["zone"] = np.arange(mixed.n_cells)
    mixed.point_data["label"] = np.arange(mixed.n_points)
    mixed.field_data["note"] = ["mixed"]
    with pytest.warns(UserWarning, match="2 lines and 3 vertex cells") as caught:
        made = striata.simplify(mixed, ratio=1.0)
    assert caught[0].filename == __file__
    assert made.n_cells == plane.n_cells and made.n_lines == made.n_verts == 0
    assert np.array_equal(made.cell_data["zone"], np.arange(5, mixed.n_cells))
    assert made.field_data["note"][0] == "mixed"
    assert np.array_equal(mixed.points[made.point_data["label"]], made.points)
    assert mixed.n_lines == 2 and mixed.n_verts == 3
    for without_faces in (pv.Line(), pv.PolyData(plane.points)):
        with pytest.raises(ValueError, match="no faces"):
            striata.simplify(without_faces, ratio=0.5)


def test_pyvista_strips_become_triangles():
    pv = package("pyvista")
    sphere = pv.Sphere()
    strips = sphere.strip()
    assert strips.n_strips > 0
    strips.cell_data["zone"] = np.arange(strips.n_cells)
    made = striata.simplify(strips, ratio=1.0)
    assert made.n_strips == 0 and made.n_cells == sphere.n_cells
    assert set(made.cell_data["zone"]) == set(range(strips.n_cells))
    assert made.volume == pytest.approx(sphere.volume)
    # A vertex cell, a line, a quad and a strip of two triangles.
    points = np.float32([[0, 0, 0], [1, 0, 0], [1, 1, 0], [0, 1, 0], [2, 0, 0], [2, 1, 0]])
    every = pv.PolyData(points, faces=[4, 0, 1, 2, 3], lines=[2, 0, 1], verts=[1, 0], strips=[4, 1, 4, 2, 5])
    every.cell_data["zone"] = [10, 11, 12, 13]
    with pytest.warns(UserWarning, match="1 line and 1 vertex cell of"):
        made = striata.simplify(every, ratio=1.0)
    assert sorted(made.cell_data["zone"]) == [12, 12, 13, 13]
    centers = made.cell_centers().points[:, 0]
    assert ((centers > 1) == (made.cell_data["zone"] == 13)).all()


def test_open3d_legacy(terrain):
    o3d = package("open3d")
    points, faces = terrain
    vectors = o3d.utility
    mesh = o3d.geometry.TriangleMesh(
        vectors.Vector3dVector(points.astype(np.float64)), vectors.Vector3iVector(faces)
    )
    mesh.compute_vertex_normals()
    mesh.vertex_colors = vectors.Vector3dVector(np.clip(points.astype(np.float64), 0, 1))
    for has_uv in (False, True):
        if has_uv:
            uv = points[faces.ravel(), :2].astype(np.float64)
            uv[: len(uv) // 2, 0] += 2.0  # a seam through the middle
            mesh.triangle_uvs = vectors.Vector2dVector(uv)
            mesh.triangle_material_ids = vectors.IntVector(np.arange(len(faces), dtype=np.int32) % 2)
        for made in both_ways(mesh):
            assert type(made) is o3d.geometry.TriangleMesh
            vertices = np.asarray(made.vertices)
            assert np.allclose(np.asarray(made.vertex_colors), np.clip(vertices, 0, 1))
            assert made.has_vertex_normals() and 0.15 * len(faces) < len(made.triangles) <= 0.2 * len(faces)
            assert made.has_triangle_uvs() == has_uv
            if has_uv:
                corners = np.asarray(made.triangle_uvs)
                at = vertices[np.asarray(made.triangles).ravel(), :2]
                assert np.allclose(np.minimum(np.abs(corners - at), np.abs(corners - [2, 0] - at)), 0, atol=1e-6)
                assert len(np.unique(vertices, axis=0)) == len(vertices)
                assert len(made.triangle_material_ids) == len(made.triangles)


def test_open3d_tensor(terrain):
    o3d = package("open3d")
    points, faces = terrain
    mesh = o3d.t.geometry.TriangleMesh(o3d.core.Tensor(points), o3d.core.Tensor(faces.astype(np.int64)))
    mesh.vertex["label"] = o3d.core.Tensor(np.arange(len(points)))
    mesh.triangle["zone"] = o3d.core.Tensor(np.arange(len(faces)))
    for has_uv in (False, True):
        if has_uv:
            mesh.triangle["texture_uvs"] = o3d.core.Tensor(np.ascontiguousarray(points[faces][:, :, :2]))
        for made in both_ways(mesh):
            assert type(made) is o3d.t.geometry.TriangleMesh
            label = made.vertex["label"].numpy()
            vertices = made.vertex.positions.numpy()
            assert np.array_equal(points[label], vertices) and vertices.dtype == np.float32
            triangles = made.triangle.indices.numpy()
            assert triangles.dtype == np.int64 and len(made.triangle["zone"].numpy()) == len(triangles)
            if has_uv:
                assert np.allclose(made.triangle["texture_uvs"].numpy(), vertices[triangles][:, :, :2])


def test_meshio(terrain):
    meshio = package("meshio")
    points, faces = terrain
    blocks = [("triangle", faces[:1000]), ("triangle", faces[1000:])]
    zones = [np.arange(1000), np.arange(1000, len(faces))]
    mesh = meshio.Mesh(points, blocks, {"label": np.arange(len(points))}, {"zone": zones})
    for made in both_ways(mesh):
        assert type(made) is meshio.Mesh
        assert np.array_equal(points[made.point_data["label"]], made.points)
        assert len(made.cell_data["zone"][0]) == len(made.cells[0].data)
    quads = meshio.Mesh(points[:, :2], [("quad", [[0, 1, 42, 41]]), ("line", [[0, 1]])], cell_data={"z": [[7], [8]]})
    with pytest.warns(UserWarning, match="line"):
        made = striata.simplify(quads, ratio=1.0)
    assert made.points.shape[1] == 2 and list(made.cell_data["z"][0]) == [7, 7]
    with pytest.raises(ValueError, match="tetra"):
        striata.simplify(meshio.Mesh(points, [("tetra", [[0, 1, 2, 3]])]), ratio=0.5)
