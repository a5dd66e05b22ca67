//! Rasters of heights as meshes.

use std::collections::BTreeMap;
use std::fs;
use std::path::{Path, PathBuf};

use striata::mesh::IndexedMesh;
use striata_io::Scene;
use striata_io::pieces::{Piece, PieceOptions, PieceSource, Terrain, open_all, open_pieces};
use tempfile::TempDir;
use tiff::encoder::{TiffEncoder, colortype};
use tiff::tags::Tag;

/// Writes a 16-bit GeoTIFF with samples ten units apart, whose upper left sample is at `corner`.
fn write_tiff(path: &Path, width: u32, height: u32, corner: [f64; 2], heights: &[i16]) {
    let mut encoder = TiffEncoder::new(fs::File::create(path).unwrap()).unwrap();
    let mut image = encoder.new_image::<colortype::GrayI16>(width, height).unwrap();
    image.rows_per_strip(3).unwrap();
    let directory = image.encoder();
    directory.write_tag(Tag::ModelPixelScaleTag, &[10.0f64, 10.0, 0.0][..]).unwrap();
    directory
        .write_tag(Tag::ModelTiepointTag, &[0.0f64, 0.0, 0.0, corner[0] - 5.0, corner[1] + 5.0, 0.0][..])
        .unwrap();
    directory.write_tag(Tag::GdalNodata, "-9999").unwrap();
    let keys: [u16; 8] = [1, 1, 0, 1, 3072, 0, 1, 32633];
    directory.write_tag(Tag::GeoKeyDirectoryTag, &keys[..]).unwrap();
    image.write_data(heights).unwrap();
}

fn all(source: &dyn PieceSource) -> Vec<Piece> {
    (0..source.piece_count()).map(|index| source.read_piece(index).unwrap()).collect()
}

fn triangles(pieces: &[Piece]) -> usize {
    pieces.iter().map(|piece| piece.triangles.len()).sum()
}

/// Number of edges with one triangle, over all pieces.
fn borders(pieces: &[Piece]) -> usize {
    let mut edges: BTreeMap<[[u32; 3]; 2], u32> = BTreeMap::new();
    for piece in pieces {
        for t in &piece.triangles {
            let at = t.map(|v| piece.positions[v as usize].map(f32::to_bits));
            for i in 0..3 {
                let (a, b) = (at[i], at[(i + 1) % 3]);
                *edges.entry([a.min(b), a.max(b)]).or_default() += 1;
            }
        }
    }
    edges.values().filter(|&&count| count == 1).count()
}

/// All triangles face up.
fn check_winding(pieces: &[Piece]) {
    for piece in pieces {
        for t in &piece.triangles {
            let [a, b, c] = t.map(|v| piece.positions[v as usize]);
            assert!((b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0]) > 0.0);
        }
    }
}

fn message(result: Result<Box<dyn PieceSource>, striata_io::ReadError>) -> String {
    result.err().expect("an error").to_string()
}

#[test]
fn a_geotiff_has_a_vertex_per_sample() {
    let folder = TempDir::new().unwrap();
    let path = folder.path().join("a.tif");
    let heights: Vec<i16> = (0..7 * 11).map(|i| (i % 7) as i16 * 100).collect();
    write_tiff(&path, 7, 11, [500.0, 900.0], &heights);
    let source = open_pieces(&path, &PieceOptions::default().with_z_scale(2.0)).unwrap();
    let pieces = all(source.as_ref());
    assert_eq!(triangles(&pieces) as u64, source.summary().triangle_count);
    check_winding(&pieces);
    let positions = &pieces[0].positions;
    assert!(positions.contains(&[0.0, 0.0, 0.0]) && positions.contains(&[60.0, 100.0, 1200.0]));
    let georeference = source.summary().georeference.as_ref().unwrap();
    assert_eq!(
        (&georeference["epsg"], &georeference["origin"]),
        (&32633.into(), &serde_json::json!([500.0, 800.0]))
    );
}

#[test]
fn samples_without_heights_are_holes() {
    let folder = TempDir::new().unwrap();
    let path = folder.path().join("a.tif");
    let mut heights = vec![5i16; 25];
    heights[12] = -9999;
    heights[0] = -9999;
    write_tiff(&path, 5, 5, [0.0, 0.0], &heights);
    let pieces = all(open_pieces(&path, &PieceOptions::default()).unwrap().as_ref());
    // Each of the four quads around the middle, and the one at the corner, keeps one triangle.
    assert_eq!(triangles(&pieces), 32 - 5);
    check_winding(&pieces);
}

#[test]
fn several_rasters_are_one_surface_whether_or_not_they_share_samples() {
    let folder = TempDir::new().unwrap();
    for shared in [0, 1u32] {
        let (left, right) = (folder.path().join("l.tif"), folder.path().join("r.tif"));
        write_tiff(&left, 300, 20, [0.0, 0.0], &vec![1; 6000]);
        write_tiff(&right, 300, 20, [f64::from(300 - shared) * 10.0, 0.0], &vec![1; 6000]);
        let source = open_all(&[left, right], &PieceOptions::default()).unwrap();
        let pieces = all(source.as_ref());
        let width = (600 - shared) as usize;
        assert_eq!(triangles(&pieces), 2 * (width - 1) * 19);
        assert_eq!(borders(&pieces), 2 * (width - 1 + 19));
    }
}

#[test]
fn rasters_of_different_grids_are_refused() {
    let folder = TempDir::new().unwrap();
    let (a, b) = (folder.path().join("a.tif"), folder.path().join("b.tif"));
    write_tiff(&a, 4, 4, [0.0, 0.0], &[1; 16]);
    write_tiff(&b, 4, 4, [44.0, 0.0], &[1; 16]);
    let text = message(open_all(&[a, b.clone()], &PieceOptions::default()));
    assert!(text.contains("b.tif") && text.contains("between"), "{text}");
}

#[test]
fn srtm_tiles_are_placed_by_their_names() {
    let folder = TempDir::new().unwrap();
    let tile = |name: &str| {
        let path: PathBuf = folder.path().join(name);
        let bytes: Vec<u8> = (0..61 * 61).flat_map(|i: i16| (i % 61).to_be_bytes()).collect();
        fs::write(&path, bytes).unwrap();
        path
    };
    let paths = [tile("N35E138.hgt"), tile("N35E139.hgt")];
    let source = Terrain::open(&paths, &PieceOptions::default()).unwrap();
    let pieces = all(&source);
    assert_eq!(triangles(&pieces), 2 * 120 * 60);
    check_winding(&pieces);
    let east = pieces.iter().flat_map(|piece| &piece.positions).map(|p| p[0]).fold(0.0, f32::max);
    assert!((181_000.0..183_000.0).contains(&east), "two degrees at 35.5 north are {east} m");
    fs::write(&paths[0], [0; 77]).unwrap();
    let text = message(open_pieces(&paths[0], &PieceOptions::default()));
    assert!(text.contains("not a square"), "{text}");
}

#[test]
fn gray_images_are_heights() {
    let folder = TempDir::new().unwrap();
    let path = folder.path().join("a.png");
    let mut encoder = png::Encoder::new(fs::File::create(&path).unwrap(), 3, 2);
    encoder.set_color(png::ColorType::Grayscale);
    encoder.set_depth(png::BitDepth::Sixteen);
    let bytes: Vec<u8> = [1000u16, 2, 3, 4, 5, 6].iter().flat_map(|x| x.to_be_bytes()).collect();
    encoder.write_header().unwrap().write_image_data(&bytes).unwrap();
    let pieces = all(open_pieces(&path, &PieceOptions::default()).unwrap().as_ref());
    assert!(
        pieces[0].positions.contains(&[0.0, 1.0, 1000.0]) && pieces[0].positions.contains(&[2.0, 0.0, 6.0])
    );
}

#[test]
fn damaged_rasters_are_errors() {
    let folder = TempDir::new().unwrap();
    let path = folder.path().join("a.tif");
    write_tiff(&path, 40, 40, [0.0, 0.0], &vec![7; 1600]);
    let bytes = fs::read(&path).unwrap();
    for end in (0..bytes.len()).step_by(37) {
        fs::write(&path, &bytes[..end]).unwrap();
        if let Ok(source) = open_pieces(&path, &PieceOptions::default()) {
            let read = (0..source.piece_count()).try_for_each(|index| source.read_piece(index).map(drop));
            let text = read.err().map(|error| error.to_string()).unwrap_or_default();
            assert!(text.is_empty() || text.contains("a.tif"), "{text}");
        }
    }
}

/// Samples that share a byte would be taken for whole bytes.
#[test]
fn samples_of_less_than_a_byte_are_refused() {
    let folder = TempDir::new().unwrap();
    let path = folder.path().join("few.tif");
    let mut encoder = TiffEncoder::new(fs::File::create(&path).unwrap()).unwrap();
    encoder.new_image::<colortype::Gray8>(8, 8).unwrap().write_data(&[3; 64]).unwrap();
    let bytes = fs::read(&path).unwrap();
    // The entry of BitsPerSample: one 16-bit number.
    let entry = |bits: u8| [2, 1, 3, 0, 1, 0, 0, 0, bits, 0];
    let at = bytes.windows(10).position(|window| window == entry(8)).unwrap();
    assert!(open_pieces(&path, &PieceOptions::default()).is_ok());
    for bits in [1, 2, 4] {
        let mut changed = bytes.clone();
        changed[at..at + 10].copy_from_slice(&entry(bits));
        fs::write(&path, &changed).unwrap();
        let text = message(open_pieces(&path, &PieceOptions::default()));
        assert!(text.contains("few.tif") && text.contains(&format!("{bits} bits per sample")), "{text}");
    }
}

/// Writes a raster of floats with these tags.
fn write_floats(path: &Path, heights: &[f32], tags: &[(Tag, &[f64])], metadata: Option<&str>) {
    let mut encoder = TiffEncoder::new(fs::File::create(path).unwrap()).unwrap();
    let mut image = encoder.new_image::<colortype::Gray32Float>(4, 3).unwrap();
    for (tag, numbers) in tags {
        image.encoder().write_tag(*tag, *numbers).unwrap();
    }
    if let Some(xml) = metadata {
        image.encoder().write_tag(Tag::Unknown(42_112), xml).unwrap();
    }
    image.write_data(heights).unwrap();
}

/// The height at a place, from the lower left corner.
fn height_at(mesh: &striata::mesh::IndexedMesh, [x, y]: [f64; 2]) -> Option<f64> {
    let all = (0..mesh.vertex_count()).map(|vertex| mesh.file_position(vertex));
    all.filter(|p| (p[0] - x).abs() < 1e-6 && (p[1] - y).abs() < 1e-6).map(|p| p[2]).next()
}

#[test]
fn files_of_other_programs_are_read_as_meshes() {
    let folder = TempDir::new().unwrap();
    let path = folder.path().join("a.tif");
    let heights: Vec<f32> = (0..12).map(|i| i as f32).collect();
    let read = || striata_io::read(&path).unwrap();
    // The first row is the northernmost, and a pixel is an area: its sample is in the middle.
    let north_up = [10.0, 0.0, 0.0, 500.0, 0.0, -10.0, 0.0, 900.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 1.0];
    write_floats(&path, &heights, &[(Tag::ModelTransformationTag, &north_up)], None);
    let mesh = read();
    assert_eq!((mesh.vertex_count(), mesh.triangle_count()), (12, 12));
    assert_eq!([height_at(&mesh, [0.0, 20.0]), height_at(&mesh, [30.0, 0.0])], [Some(0.0), Some(11.0)]);
    let corner = || {
        let source = open_pieces(&path, &PieceOptions::default()).unwrap();
        source.summary().georeference.as_ref().unwrap()["origin"].clone()
    };
    assert_eq!(corner(), serde_json::json!([505.0, 875.0]));
    let mut south_up = north_up;
    (south_up[5], south_up[7]) = (10.0, 870.0);
    write_floats(&path, &heights, &[(Tag::ModelTransformationTag, &south_up)], None);
    let mesh = read();
    assert_eq!([height_at(&mesh, [0.0, 0.0]), height_at(&mesh, [30.0, 20.0])], [Some(0.0), Some(11.0)]);
    assert_eq!(corner(), serde_json::json!([505.0, 875.0]));
    check_winding(&all(open_pieces(&path, &PieceOptions::default()).unwrap().as_ref()));
    let mut identity = [0.0; 16];
    (0..4).for_each(|i| identity[5 * i] = 1.0);
    write_floats(&path, &heights, &[(Tag::ModelTransformationTag, &identity)], None);
    assert_eq!(height_at(&read(), [0.0, 2.0]), Some(0.0), "pixels from the lower left");
    // Samples that are scaled, and the largest negative float for samples that are none.
    let mut scaled = heights.clone();
    scaled[0] = f32::MIN;
    let xml = "<GDALMetadata>\n<Item name=\"SCALE\" sample=\"0\" role=\"scale\">0.5</Item>\n\
               <Item name=\"OFFSET\" sample=\"0\" role=\"offset\">1500</Item>\n</GDALMetadata>";
    write_floats(&path, &scaled, &[], Some(xml));
    let mesh = read();
    assert_eq!((mesh.vertex_count(), mesh.triangle_count()), (11, 11));
    assert_eq!(height_at(&mesh, [3.0, 0.0]), Some(1505.5));
    let options = PieceOptions::default().with_nodata(Some(11.0));
    let holes = Terrain::open(std::slice::from_ref(&path), &options).unwrap().mesh().unwrap();
    assert_eq!(holes.vertex_count(), 10, "the sample, not the height");
    let options = PieceOptions::default().with_z_scale(1e38);
    let message =
        Terrain::open(std::slice::from_ref(&path), &options).unwrap().mesh().unwrap_err().to_string();
    assert!(message.contains("the sample in column 1, row 0"), "{message}");
    write_floats(&path, &[f32::NAN; 12], &[], None);
    let message = striata_io::read(&path).unwrap_err().to_string();
    assert!(message.contains("no four neighboring samples have heights"), "{message}");
    let zero = "<Item role=\"scale\">0</Item>";
    write_floats(&path, &heights, &[], Some(zero));
    let message = striata_io::read(&path).unwrap_err().to_string();
    assert!(message.contains("samples times 0"), "{message}");
}

/// Decimal digits of a void need not be those of the sample; one or two huge values are voids, more are damage.
#[test]
fn voids_are_recognized_and_damage_is_named() {
    let folder = TempDir::new().unwrap();
    let path = folder.path().join("a.tif");
    let mut heights: Vec<f32> = (0..12).map(|i| i as f32).collect();
    heights[11] = -9999.9;
    write_floats(&path, &heights, &[], None);
    let holes = |nodata: Option<f64>| {
        let options = PieceOptions::default().with_nodata(nodata);
        Terrain::open(std::slice::from_ref(&path), &options).unwrap().mesh().unwrap().vertex_count()
    };
    assert_eq!([holes(None), holes(Some(-9999.9)), holes(Some(-9999.0))], [12, 11, 12]);
    (heights[0], heights[3], heights[11]) = (-3.4e38, 3.0e38, -3.4e38);
    write_floats(&path, &heights, &[], None);
    let report = striata_io::read_with_report(&path).unwrap();
    assert_eq!((report.mesh.vertex_count(), report.warnings.len()), (9, 2));
    let text = report.warnings[0].to_string();
    assert!(text.contains("samples of -3.4e38 are taken for none"), "{text}");
    let source = open_pieces(&path, &PieceOptions::default()).unwrap();
    assert_eq!((source.read_piece(0).unwrap().positions.len(), source.warnings()), (9, report.warnings));
    heights[8] = 2.0e35;
    write_floats(&path, &heights, &[], None);
    let message = striata_io::read(&path).unwrap_err().to_string();
    assert!(message.contains("row 2 is") && message.contains("no height"), "{message}");
    let source = open_pieces(&path, &PieceOptions::default()).unwrap();
    assert!(source.read_piece(0).is_err());
    assert_eq!(holes(Some(2.0e35)), 8);
}

/// Numbers that may be a height or a void are kept, with a remark.
#[test]
fn usual_voids_are_pointed_out() {
    let folder = TempDir::new().unwrap();
    let path = folder.path().join("a.tif");
    let mut heights: Vec<f32> = (0..12).map(|i| i as f32).collect();
    let remarks = |nodata: Option<f64>| {
        let options = PieceOptions::default().with_nodata(nodata);
        let terrain = Terrain::open(std::slice::from_ref(&path), &options).unwrap();
        (terrain.mesh().unwrap().vertex_count(), terrain.warnings().len())
    };
    write_floats(&path, &heights, &[], None);
    assert_eq!(remarks(None), (12, 0));
    heights[0] = -9999.0;
    write_floats(&path, &heights, &[], None);
    assert_eq!(remarks(None), (12, 1));
    assert_eq!(remarks(Some(-9999.0)), (11, 0));
}

/// Rasters at the two ends of the world are no terrain of their size squared.
#[test]
fn rasters_far_apart_are_refused() {
    let folder = TempDir::new().unwrap();
    let paths = ["a.tif", "b.tif"].map(|name| folder.path().join(name));
    write_tiff(&paths[0], 2, 2, [0.0, 0.0], &[1; 4]);
    write_tiff(&paths[1], 2, 2, [1e15, 1e15], &[1; 4]);
    let text = message(open_all(&paths, &PieceOptions::default()));
    assert!(text.contains("too far from the other rasters"), "{text}");
}

/// glTF is y up and maps are z up, so nodes turn a terrain, and readers of whole files and of pieces turn it back.
#[test]
fn terrains_are_y_up_in_gltf_and_z_up_elsewhere() {
    let folder = TempDir::new().unwrap();
    let raster = folder.path().join("dem.tif");
    write_tiff(&raster, 4, 3, [500_000.0, 5_600_000.0], &[0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 99]);
    let mesh = IndexedMesh { origin: [1000.0, 2000.0, 3.0], ..striata_io::read(&raster).unwrap() };
    let places = |mesh: &IndexedMesh| {
        let place = |p: &[f32; 3]| [0, 1, 2].map(|axis| f64::from(p[axis]) + mesh.origin[axis]);
        let mut places: Vec<_> = mesh.positions.iter().map(place).collect();
        places.sort_by(|a, b| a.partial_cmp(b).unwrap());
        places
    };
    let path = folder.path().join("dem.glb");
    for is_scene in [false, true] {
        if is_scene {
            let scene = Scene::from_mesh(mesh.clone()).unwrap();
            striata_io::write_scene(&path, &scene, &Default::default()).unwrap();
        } else {
            striata_io::write(&path, &mesh, &Default::default()).unwrap();
        }
        let scene = striata_io::read_scene(&path).unwrap();
        let georeferences = scene.meshes().iter().flatten().map(|mesh| &mesh.appearance.georeference);
        assert_eq!(georeferences.collect::<Vec<_>>(), [&mesh.appearance.georeference]);
        let shown = scene.bounds().unwrap();
        assert_eq!([shown.min[1], shown.max[1]], [3.0, 102.0]);
        assert_eq!([shown.min[2], shown.max[2]], [-2020.0, -2000.0]);
        assert_eq!(places(&striata_io::read(&path).unwrap()), places(&mesh));
        let pieces = open_pieces(&path, &PieceOptions::default()).unwrap();
        let piece = pieces.read_piece(0).unwrap();
        let origin = pieces.summary().origin;
        let read = IndexedMesh { positions: piece.positions, origin, ..IndexedMesh::default() };
        assert_eq!(places(&read), places(&mesh));
    }
}

/// The place of a raster stays with its mesh in all formats that can say it.
#[test]
fn the_georeference_stays_with_the_mesh() {
    let folder = TempDir::new().unwrap();
    let raster = folder.path().join("dem.tif");
    write_tiff(&raster, 4, 3, [500_000.0, 5_600_000.0], &[0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11]);
    let mesh = striata_io::read(&raster).unwrap();
    let place: serde_json::Value = serde_json::from_str(&mesh.appearance.georeference).unwrap();
    assert_eq!(place["epsg"], 32633);
    assert_eq!(place["origin"], serde_json::json!([500_000.0, 5_599_980.0]));
    let (ply, glb) = (folder.path().join("dem.ply"), folder.path().join("dem.glb"));
    striata_io::write(&ply, &mesh, &Default::default()).unwrap();
    let from_ply = striata_io::read(&ply).unwrap();
    assert_eq!(from_ply.appearance.georeference, mesh.appearance.georeference);
    striata_io::write(&glb, &from_ply, &Default::default()).unwrap();
    assert_eq!(striata_io::read(&glb).unwrap().appearance.georeference, mesh.appearance.georeference);
    let warnings = |name: &str| {
        let path = folder.path().join(name);
        let found = striata_io::write_with_report(&path, &mesh, &Default::default()).unwrap();
        found.iter().map(ToString::to_string).collect::<String>()
    };
    assert!(warnings("dem.stl").contains("the georeference is left out"), "{}", warnings("dem.stl"));
    assert_eq!(warnings("dem.obj"), "");
    let obj = fs::read_to_string(folder.path().join("dem.obj")).unwrap();
    assert!(obj.starts_with("# georeference {"), "{obj}");
    let text = striata_io::WriteOptions::default().with_ascii(true);
    striata_io::write(folder.path().join("text.ply"), &mesh, &text).unwrap();
    for name in ["dem.ply", "text.ply", "dem.obj", "dem.glb"] {
        let path = folder.path().join(name);
        assert_eq!(striata_io::read(&path).unwrap().appearance.georeference, mesh.appearance.georeference);
        let pieces = open_pieces(&path, &PieceOptions::default()).unwrap();
        assert_eq!(pieces.summary().appearance.georeference, mesh.appearance.georeference, "{name}");
    }
}
