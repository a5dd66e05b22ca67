"""Paged files: levels, views and boxes that read some of the pages."""

import numpy as np
import pytest
import striata

SIDE = 260


@pytest.fixture(scope="module")
def folder(tmp_path_factory):
    folder = tmp_path_factory.mktemp("paged")
    for name in ("terrain.striata", "pages"):
        striata.run(striata.plan(f"shape:terrain:{SIDE}", folder / name, cell=4000))
    return folder


@pytest.fixture
def paged(folder):
    return striata.open(folder / "terrain.striata")


def test_a_file_is_described_without_its_pages(paged):
    assert isinstance(paged, striata.PagedLod)
    assert (paged.face_count, paged.point_count) == (2 * (SIDE - 1) ** 2, SIDE**2)
    assert paged.page_count > 20 and paged.metadata["triangle_count"] == paged.face_count
    least, most = paged.bounds
    assert most[0] - least[0] == SIDE - 1 and paged.diagonal > SIDE
    assert paged.statistics["pages"] == 0 and paged.statistics["bytes"] > 0
    assert "pages" in repr(paged)
    with pytest.raises(TypeError):
        striata.PagedLod()


def test_levels_read_what_they_need(paged):
    level = paged.level(triangles=1000)
    assert 990 <= level.face_count <= 1000
    assert 0 < paged.statistics["pages"] < paged.page_count / 2
    assert paged.level(ratio=0.01).face_count <= 0.01 * paged.face_count
    coarse = paged.level(error="1%")
    assert 0 < coarse.face_count < paged.face_count / 4
    assert striata.distance(coarse, paged.level(ratio=1.0)).max < 0.03 * paged.diagonal
    with pytest.raises(ValueError, match="no target"):
        paged.level()


def test_all_levels_up_to_a_count_are_a_lod(paged):
    lod = paged.lod(triangles=3000)
    assert lod.face_count >= 3000 and lod.level(triangles=500).triangle_count <= 500
    # The levels are those of the file.
    ours, theirs = lod.level(triangles=800).to_mesh(), paged.level(triangles=800)
    assert ours.face_count == theirs.face_count
    np.testing.assert_array_equal(np.sort(ours.points, axis=0), np.sort(theirs.points, axis=0))


def test_views_are_fine_where_the_camera_is(paged):
    camera = {"eye": (20, 20, 60), "target": (30, 30, 0), "screen": (640, 480)}
    view = paged.view(**camera, pixels=2.0)
    assert 0 < view.face_count < paged.face_count
    level = paged.level(triangles=view.face_count)
    seen, everywhere = ((np.linalg.norm(mesh.points[:, :2] - 25, axis=1) < 40).mean() for mesh in (view, level))
    assert seen > 2 * everywhere
    limited = paged.view(**camera, pixels=2.0, budget=view.face_count // 2)
    assert view.face_count // 3 < limited.face_count <= view.face_count // 2
    with pytest.raises(ValueError, match="pixels"):
        paged.view(**camera, pixels=-1)
    with pytest.raises(ValueError, match="eye"):
        paged.view(eye=(0, 0), target=(1, 1, 1))


def test_a_box_has_full_detail(paged):
    box = paged.box((0, 0, -1000), (20, 20, 1000))
    inside = (box.points[box.faces][:, :, :2] <= 20).all(axis=(1, 2))
    assert inside.sum() == 2 * 20 * 20
    assert box.face_count < paged.face_count / 4
    assert paged.box((0, 0, -1000), (20, 20, 1000), error="0.01%").face_count > box.face_count


def test_a_folder_is_the_same(paged, folder):
    pages = striata.open(folder / "pages")
    np.testing.assert_array_equal(pages.level(triangles=700).points, paged.level(triangles=700).points)


def test_damaged_files_are_refused(folder, tmp_path):
    data = bytearray((folder / "terrain.striata").read_bytes())
    (tmp_path / "short.striata").write_bytes(data[:40])
    with pytest.raises(striata.DecodeError, match="cut off"):
        striata.open(tmp_path / "short.striata")
    data[-10] ^= 1
    (tmp_path / "damaged.striata").write_bytes(data)
    damaged = striata.open(tmp_path / "damaged.striata")
    with pytest.raises(striata.DecodeError, match="checksum"):
        damaged.level(ratio=1.0)
