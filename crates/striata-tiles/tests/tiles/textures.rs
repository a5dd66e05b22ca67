//! Textures of tiles: points have the colors that they have in the mesh, whatever level and atlas they are in.

use std::fs;
use std::path::Path;

use crate::common::built;
use serde_json::{Value, json};
use striata::ignore_progress;
use striata::mesh::{Appearance, AttributeLayer, Image, IndexedMesh, Material, Semantic, TriangleGroup};
use striata_scene::textures::{ImageFormat, RgbaImage, TextureRole};
use striata_tiles::{TileFormat, TilesOptions, TilesReport, write_tiles};

/// Cells of the surface along each side.
const CELLS: usize = 96;
/// Texels of a chart's side, and of its place in an image.
const CHART_TEXELS: usize = 52;
const PLACE_TEXELS: usize = 64;

/// Color of a point of the surface, which is smooth across charts.
fn color(x: f64, y: f64) -> [f64; 3] {
    [
        127.0 + 110.0 * (6.0 * x + 2.0 * y).sin(),
        127.0 + 110.0 * (5.0 * y - 3.0 * x + 1.0).sin(),
        127.0 + 110.0 * (4.0 * x + 4.0 * y).cos(),
    ]
}

fn opacity(x: f64, y: f64) -> f64 {
    127.0 + 120.0 * (5.0 * x - 4.0 * y).sin()
}

/// A surface whose charts are scattered over `images` images, half of them upside down, with black between them.
struct Scan {
    mesh: IndexedMesh,
}

/// Image and place of a chart, and whether it is upside down.
fn place_of(chart: usize, images: usize, charts: usize) -> (usize, [usize; 2], bool) {
    let shuffled = chart * 29 % (charts * charts);
    let (image, place) = (shuffled % images, shuffled / images);
    (image, [place % charts, place / charts], chart % 2 == 1)
}

fn encoded(width: usize, height: usize, rgba: Vec<u8>) -> Vec<u8> {
    let image = RgbaImage { width: width as u32, height: height as u32, rgba: rgba.into() };
    image.encode(ImageFormat::Png, true, 100).unwrap().bytes
}

fn image(name: &str, bytes: Vec<u8>) -> Image {
    Image { name: name.to_owned(), uri: String::new(), mime_type: "image/png".to_owned(), bytes }
}

fn appearance(materials: &[Value], images: Vec<Image>) -> Appearance {
    let material = |value: &Value| Material {
        name: value["name"].as_str().unwrap_or_default().to_owned(),
        gltf_json: value.to_string(),
    };
    Appearance {
        materials: materials.iter().map(material).collect(),
        textures_json: (0..images.len()).map(|i| json!({ "source": i }).to_string()).collect(),
        images,
        ..Appearance::default()
    }
}

impl Scan {
    /// With `charts` charts along each side.
    fn new(images: usize, charts: usize, alpha_mode: &str) -> Self {
        let side = charts * PLACE_TEXELS;
        let mut pixels = vec![vec![0u8; side * side * 4]; images];
        let margin = (PLACE_TEXELS - CHART_TEXELS) / 2;
        let (mut positions, mut texcoords, mut triangles, mut groups) = (vec![], vec![], vec![], vec![]);
        for (image, pixels) in pixels.iter_mut().enumerate() {
            let first = triangles.len() as u32;
            for chart in (0..charts * charts).filter(|&chart| place_of(chart, images, charts).0 == image) {
                let (_, place, is_turned) = place_of(chart, images, charts);
                let corner = [chart % charts, chart / charts];
                // Texels reach one beyond the chart.
                for (i, j) in (0..CHART_TEXELS + 2).flat_map(|i| (0..CHART_TEXELS + 2).map(move |j| (i, j))) {
                    let inside = [i, j].map(|k| (k as f64 - 0.5) / CHART_TEXELS as f64);
                    let inside = if is_turned { inside.map(|t| 1.0 - t) } else { inside };
                    let [x, y] = [0, 1].map(|a| (corner[a] as f64 + inside[a]) / charts as f64);
                    let [u, v] = [i, j].map(|k| k + margin - 1);
                    let at = (place[1] * PLACE_TEXELS + v) * side + place[0] * PLACE_TEXELS + u;
                    let [r, g, b] = color(x, y).map(|c| c.round() as u8);
                    pixels[4 * at..][..4].copy_from_slice(&[r, g, b, opacity(x, y).round() as u8]);
                }
                let count = CELLS / charts;
                let base = positions.len() as u32;
                for (i, j) in (0..=count).flat_map(|j| (0..=count).map(move |i| (i, j))) {
                    let inside = [i, j].map(|k| k as f64 / count as f64);
                    let [x, y] = [0, 1].map(|a| (corner[a] as f64 + inside[a]) / charts as f64);
                    positions.push([x as f32, y as f32, (0.1 * (9.0 * x).sin() * (7.0 * y).cos()) as f32]);
                    let inside = if is_turned { inside.map(|t| 1.0 - t) } else { inside };
                    let texel = |a: usize| {
                        (place[a] * PLACE_TEXELS + margin) as f64 + inside[a] * CHART_TEXELS as f64
                    };
                    texcoords.extend([0, 1].map(|a| (texel(a) / side as f64) as f32));
                }
                let row = count as u32 + 1;
                for (i, j) in (0..count as u32).flat_map(|j| (0..count as u32).map(move |i| (i, j))) {
                    let [a, b] = [base + j * row + i, base + (j + 1) * row + i];
                    triangles.extend([[a, a + 1, b + 1], [a, b + 1, b]]);
                }
            }
            let count = triangles.len() as u32 - first;
            groups.push(TriangleGroup { name: String::new(), material: Some(image as u32), first, count });
        }
        let material = |i: usize| {
            json!({
                "name": format!("part {i}"),
                "alphaMode": alpha_mode,
                "pbrMetallicRoughness": { "baseColorTexture": { "index": i }, "metallicFactor": 0.0 },
            })
        };
        let images: Vec<Image> = (0..)
            .zip(pixels)
            .map(|(i, rgba)| image(&format!("page {i}"), encoded(side, side, rgba)))
            .collect();
        let materials: Vec<Value> = (0..images.len()).map(material).collect();
        let mut mesh = IndexedMesh::new(positions, triangles);
        mesh.layers = vec![AttributeLayer::from_f32(Semantic::TexCoord(0), 2, texcoords)];
        mesh.groups = groups;
        mesh.appearance = appearance(&materials, images);
        Self { mesh }
    }
}

fn options() -> TilesOptions {
    let mut options = TilesOptions::default();
    (options.tile_triangles, options.texture_quality) = (1000, 95);
    options
}

fn with(set: impl Fn(&mut TilesOptions)) -> TilesOptions {
    let mut options = options();
    set(&mut options);
    options
}

/// The tiles of a mesh with their levels.
struct TexturedTiles {
    report: TilesReport,
    tiles: Vec<(u32, IndexedMesh, [f64; 3])>,
    files: Vec<Vec<u8>>,
}

fn tiled(mesh: &IndexedMesh, options: &TilesOptions) -> TexturedTiles {
    let (folder, mut file) = built(mesh);
    let output = folder.path().join("tiles");
    let report = write_tiles(&mut file, &output, options, &mut ignore_progress).unwrap();
    let tileset: Value = serde_json::from_slice(&fs::read(output.join("tileset.json")).unwrap()).unwrap();
    let shift = [12, 13, 14].map(|i| tileset["root"]["transform"][i].as_f64().unwrap());
    let (mut tiles, mut files) = (Vec::new(), Vec::new());
    for level in 0..report.levels.len() as u32 {
        for path in sorted(&output.join(level.to_string())) {
            files.push(fs::read(&path).unwrap());
            tiles.push((level, striata_io::read(&path).unwrap(), shift));
        }
    }
    TexturedTiles { report, tiles, files }
}

fn sorted(folder: &Path) -> Vec<std::path::PathBuf> {
    let mut paths: Vec<_> = fs::read_dir(folder).unwrap().map(|file| file.unwrap().path()).collect();
    paths.sort();
    paths
}

/// The image of the color of a material, the offset of its texture coordinates, and its type.
fn base_color(mesh: &IndexedMesh, material: u32) -> (RgbaImage, [f64; 2], String) {
    let json: Value = serde_json::from_str(&mesh.appearance.materials[material as usize].gltf_json).unwrap();
    // The emissive image if there is one.
    let reference = json.get("emissiveTexture").unwrap_or(&json["pbrMetallicRoughness"]["baseColorTexture"]);
    let offset = reference.pointer("/extensions/KHR_texture_transform/offset");
    let offset = [0, 1].map(|a| offset.map_or(0.0, |offset| offset[a].as_f64().unwrap()));
    let texture = &mesh.appearance.textures_json[reference["index"].as_u64().unwrap() as usize];
    let texture: Value = serde_json::from_str(texture).unwrap();
    let image = &mesh.appearance.images[texture["source"].as_u64().unwrap() as usize];
    let pixels = RgbaImage::decode(&image.bytes, TextureRole::default(), 1 << 14).unwrap();
    (pixels, offset, image.mime_type.clone())
}

/// Interpolated pixel, for an image that repeats.
fn sample(image: &RgbaImage, [u, v]: [f64; 2]) -> [f64; 4] {
    let [x, y] = [u * f64::from(image.width) - 0.5, v * f64::from(image.height) - 0.5];
    let mut sum = [0.0; 4];
    for (i, j) in [(0, 0), (1, 0), (0, 1), (1, 1)] {
        let weight =
            (1.0 - (x - x.floor() - f64::from(i)).abs()) * (1.0 - (y - y.floor() - f64::from(j)).abs());
        let [column, row] = [
            (x.floor() as i64 + i64::from(i)).rem_euclid(image.width.into()),
            (y.floor() as i64 + i64::from(j)).rem_euclid(image.height.into()),
        ];
        let at = 4 * (row as usize * image.width as usize + column as usize);
        (0..4).for_each(|c| sum[c] += weight * f64::from(image.rgba[at + c]));
    }
    sum
}

/// Calls `visit` with level, place, color and area of points of all triangles.
fn each_point(tiles: &TexturedTiles, mut visit: impl FnMut(u32, [f64; 3], [f64; 4], f64)) {
    for (level, mesh, shift) in &tiles.tiles {
        let uv = mesh.layer(&Semantic::TexCoord(0)).unwrap();
        for group in &mesh.groups {
            let (image, offset, _) = base_color(mesh, group.material.unwrap());
            for corners in &mesh.triangles[group.first as usize..(group.first + group.count) as usize] {
                let place = |v: u32| {
                    let [x, y, z] =
                        [0, 1, 2].map(|a| f64::from(mesh.positions[v as usize][a]) + mesh.origin[a]);
                    [x + shift[0], shift[1] - z, y + shift[2]]
                };
                let [a, b, c] = corners.map(place);
                let area = 0.5 * ((b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0]));
                for weights in [[0.34, 0.33, 0.33], [0.94, 0.03, 0.03], [0.05, 0.9, 0.05], [0.0, 0.5, 0.5]] {
                    let at = [0, 1, 2].map(|i| weights[0] * a[i] + weights[1] * b[i] + weights[2] * c[i]);
                    let mixed = |i: usize| -> f64 {
                        (0..3).map(|k| weights[k] * f64::from(uv.get(corners[k] as usize, i))).sum()
                    };
                    let uv = [0, 1].map(|i| offset[i] + mixed(i));
                    visit(*level, at, sample(&image, uv), area);
                }
            }
        }
    }
}

/// Share of the area of each level with another color than the surface, by more than this.
fn wrong_share(tiles: &TexturedTiles, channels: usize, limit: f64) -> Vec<f64> {
    let mut shares = vec![[0.0; 2]; tiles.report.levels.len()];
    each_point(tiles, |level, [x, y, _], found, area| {
        let [r, g, b] = color(x, y);
        let expected = [r, g, b, opacity(x, y)];
        let is_wrong = (0..channels).any(|c| (found[c] - expected[c]).abs() > limit);
        shares[level as usize][0] += if is_wrong { area } else { 0.0 };
        shares[level as usize][1] += area;
    });
    shares.into_iter().map(|[wrong, all]| wrong / all).collect()
}

#[test]
fn points_have_the_colors_of_the_mesh() {
    let tiles = tiled(&Scan::new(2, 8, "OPAQUE").mesh, &options());
    assert!(tiles.report.levels.len() >= 3 && tiles.report.atlases > 10, "{:?}", tiles.report);
    assert_eq!(tiles.report.left_out, [""; 0]);
    let wrong = wrong_share(&tiles, 3, 12.0);
    assert!(wrong.iter().all(|&share| share < 1e-3), "{wrong:?}");
    for (_, mesh, _) in &tiles.tiles {
        for material in 0..mesh.appearance.materials.len() as u32 {
            assert_eq!(base_color(mesh, material).2, "image/jpeg");
        }
    }
    for (index, level) in tiles.report.levels.iter().enumerate().skip(1) {
        assert!(level.error >= tiles.report.levels[index - 1].error, "{:?}", tiles.report.levels);
    }
    let again = tiled(&Scan::new(2, 8, "OPAQUE").mesh, &options());
    assert_eq!(again.files, tiles.files);
}

#[test]
fn opacity_is_kept() {
    let tiles = tiled(&Scan::new(1, 8, "BLEND").mesh, &options());
    let wrong = wrong_share(&tiles, 4, 12.0);
    assert!(wrong.iter().all(|&share| share < 1e-3), "{wrong:?}");
    assert_eq!(base_color(&tiles.tiles[0].1, 0).2, "image/png");
}

#[test]
fn smaller_images_have_smaller_atlases() {
    let mut mesh = Scan::new(1, 8, "OPAQUE").mesh;
    let full = RgbaImage::decode(&mesh.appearance.images[0].bytes, TextureRole::default(), 1 << 14).unwrap();
    let side = full.width / 4;
    // The middle of each square of four by four texels.
    let texel = |i: u32| {
        let at = |x: u32, y: u32| 4 * (y * full.width + x) as usize;
        let [x, y] = [4 * (i % side) + 1, 4 * (i / side) + 1];
        [0, 1, 2, 3].map(|c| {
            let sum = [at(x, y), at(x + 1, y), at(x, y + 1), at(x + 1, y + 1)]
                .map(|at| u32::from(full.rgba[at + c]));
            (sum.iter().sum::<u32>() / 4) as u8
        })
    };
    let rgba = (0..side * side).flat_map(texel).collect();
    mesh.appearance.images.push(image("glow", encoded(side as usize, side as usize, rgba)));
    mesh.appearance.textures_json.push(json!({ "source": 1 }).to_string());
    let mut material: Value = serde_json::from_str(&mesh.appearance.materials[0].gltf_json).unwrap();
    material["emissiveTexture"] = json!({ "index": 1 });
    mesh.appearance.materials[0].gltf_json = material.to_string();
    let tiles = tiled(&mesh, &options());
    assert!(tiles.report.atlases > 10);
    let (_, finest, _) = &tiles.tiles[0];
    let sizes = finest.appearance.images.iter().map(|image| {
        let pixels = RgbaImage::decode(&image.bytes, TextureRole::default(), 1 << 14).unwrap();
        [pixels.width, pixels.height]
    });
    let sizes: Vec<[u32; 2]> = sizes.collect();
    assert!(
        sizes.contains(&sizes[0].map(|side| side / 4)) || sizes.contains(&sizes[0].map(|side| side * 4)),
        "{sizes:?}"
    );
    let (mut wrong, mut all) = (0.0, 0.0);
    each_point(&tiles, |_, [x, y, _], found, area| {
        // Texels at the borders of charts also have the color between charts.
        if [x, y].iter().all(|t| (0.1..0.9).contains(&(8.0 * t).fract())) {
            let expected = color(x, y);
            all += area;
            wrong += if (0..3).any(|c| (found[c] - expected[c]).abs() > 12.0) { area } else { 0.0 };
        }
    });
    assert!(all > 4.0 && wrong < 1e-3 * all, "{wrong} of {all}");
}

#[test]
fn colors_between_charts_are_not_shown() {
    // Coarse levels have about a triangle for each chart.
    let tiles = tiled(&Scan::new(1, 24, "OPAQUE").mesh, &options());
    assert!(tiles.report.left_out[0].contains("corners in several"), "{:?}", tiles.report.left_out);
    let (mut black, mut all) = (0.0, 0.0);
    each_point(&tiles, |_, _, found, area| {
        all += area;
        black += if found[..3].iter().all(|&x| x < 12.0) { area } else { 0.0 };
    });
    assert!(black < 1e-3 * all, "{black} of {all}");
    let wrong = wrong_share(&tiles, 3, 12.0);
    assert!(wrong[0] < 1e-3 && wrong[1] < 0.05, "{wrong:?}");
}

#[test]
fn images_that_repeat_stay_whole_and_missing_ones_are_named() {
    let mut mesh = Scan::new(2, 8, "OPAQUE").mesh;
    // Twelve copies along each side, of colors that repeat.
    let side = 32;
    let wave = |t: f64, shift: f64| 127.0 + 100.0 * (std::f64::consts::TAU * t + shift).sin();
    let waves = |u: f64, v: f64| [wave(u, 0.0), wave(v, 1.0), wave(u + v, 2.0)];
    let pixel = |i: usize| {
        let [u, v] = [i % side, i / side].map(|k| (k as f64 + 0.5) / side as f64);
        let [r, g, b] = waves(u, v).map(|x| x.round() as u8);
        [r, g, b, 255]
    };
    let rgba: Vec<u8> = (0..side * side).flat_map(pixel).collect();
    let uv = mesh.positions.iter().flat_map(|p| [12.0 * p[0], 12.0 * p[1]]).collect();
    mesh.layers = vec![AttributeLayer::from_f32(Semantic::TexCoord(0), 2, uv)];
    let material = |name: &str| {
        let transform = json!({ "KHR_texture_transform": { "offset": [0.25, 0.0] } });
        let texture = json!({ "index": 0, "extensions": transform });
        json!({ "name": name, "pbrMetallicRoughness": { "baseColorTexture": texture, "metallicFactor": 0.0 } })
    };
    let mut glowing = material("glowing");
    glowing["emissiveTexture"] = json!({ "index": 1 });
    let missing = Image { uri: "lost.png".to_owned(), ..image("", Vec::new()) };
    let images = vec![image("waves", encoded(side, side, rgba)), missing];
    mesh.appearance = appearance(&[material("plain"), glowing], images);
    let tiles = tiled(&mesh, &with(|options| options.format = TileFormat::Meshopt));
    assert_eq!(tiles.report.left_out, ["the image lost.png is left out: it is missing"]);
    let (_, top, _) = tiles.tiles.last().unwrap();
    assert_eq!(top.appearance.images.len(), 2);
    for material in &top.appearance.materials {
        assert!(material.gltf_json.contains("KHR_texture_transform"), "{}", material.gltf_json);
        assert!(!material.gltf_json.contains("emissiveTexture"), "{}", material.gltf_json);
    }
    // The largest tiles need the whole image, the smallest ones a part of it.
    assert!(tiles.report.atlases > 0);
    let (mut wrong, mut all) = (0.0, 0.0);
    each_point(&tiles, |_, [x, y, _], found, area| {
        let expected = waves(12.0 * x + 0.25, 12.0 * y);
        all += area;
        wrong += if (0..3).any(|c| (found[c] - expected[c]).abs() > 16.0) { area } else { 0.0 };
    });
    assert!(wrong < 1e-3 * all, "{wrong} of {all}");
}

#[test]
fn images_that_repeat_do_not_divide_tiles() {
    let mut mesh = Scan::new(2, 8, "OPAQUE").mesh;
    let side = 2048;
    let plain = image("plain", encoded(side, side, [90, 120, 60, 255].repeat(side * side)));
    let material = json!({ "pbrMetallicRoughness": { "baseColorTexture": { "index": 0 } } });
    let count = |copies: f32, has_textures: bool, mesh: &mut IndexedMesh| {
        let uv = mesh.positions.iter().flat_map(|p| [copies * p[0], copies * p[1]]).collect();
        mesh.layers = vec![AttributeLayer::from_f32(Semantic::TexCoord(0), 2, uv)];
        mesh.appearance = appearance(&[material.clone(), material.clone()], vec![plain.clone()]);
        let few = |options: &mut TilesOptions| {
            (options.tile_triangles, options.has_textures) = (100_000, has_textures);
        };
        tiled(mesh, &with(few)).report.tiles
    };
    let untextured = count(1.0, false, &mut mesh);
    assert_eq!(count(12.0, true, &mut mesh), untextured);
    assert!(count(0.9, true, &mut mesh) > untextured);
}

#[test]
fn without_textures_coordinates_stay() {
    let mesh = Scan::new(1, 8, "OPAQUE").mesh;
    let tiles = tiled(&mesh, &with(|options| options.has_textures = false));
    assert_eq!((tiles.report.image_bytes, &tiles.report.left_out[..]), (0, &[][..]));
    for (_, mesh, _) in &tiles.tiles {
        assert!(mesh.appearance.images.is_empty() && mesh.layer(&Semantic::TexCoord(0)).is_some());
        assert!(!mesh.appearance.materials[0].gltf_json.contains("Texture"));
    }
}
