//! Levels of meshes whose materials have textures.

use striata::mesh::{AttributeLayer, IndexedMesh, Material, Semantic, TriangleGroup, replay};
use striata::simplify::{BaseColor, SequenceOptions, TextureLevels, Wrap, build_sequence};

/// Quads along each side of the sheet.
const SIDE: usize = 24;
/// Patches along each side of the palette.
const PATCHES: usize = 16;

/// A flat sheet in the plane z = 0. `patch_of` returns the column and row of each quad's patch of the
/// palette; quads of one patch share vertices. `spread` is the share of a patch that the coordinates cover.
fn sheet(patch_of: impl Fn(usize, usize) -> [usize; 2], spread: f32) -> IndexedMesh {
    let (mut positions, mut uvs, mut triangles) = (Vec::new(), Vec::new(), Vec::new());
    let mut known = std::collections::BTreeMap::new();
    for (x, y) in (0..SIDE * SIDE).map(|i| (i % SIDE, i / SIDE)) {
        let patch = patch_of(x, y);
        let corners = [(0, 0), (1, 0), (1, 1), (0, 1)].map(|(dx, dy)| {
            let at = [x + dx, y + dy];
            *known.entry((patch, at)).or_insert_with(|| {
                let unit = at.map(|c| c as f32 / SIDE as f32);
                positions.push([unit[0], unit[1], 0.0]);
                for axis in 0..2 {
                    let inside = 0.5 + spread * (unit[axis] - 0.5);
                    uvs.push((patch[axis] as f32 + inside) / PATCHES as f32);
                }
                positions.len() as u32 - 1
            })
        });
        let [a, b, c, d] = corners;
        triangles.extend([[a, b, c], [a, c, d]]);
    }
    let count = triangles.len() as u32;
    let mut mesh = IndexedMesh::new(positions, triangles);
    mesh.layers.push(AttributeLayer::from_f32(Semantic::TexCoord(0), 2, uvs));
    mesh.appearance.materials = vec![Material::default()];
    mesh.groups = vec![TriangleGroup { first: 0, count, material: Some(0), ..TriangleGroup::default() }];
    mesh
}

/// Color of a patch: neighbors differ in every channel, but the first row and the last one are equal.
fn color_of([column, row]: [usize; 2]) -> [u8; 4] {
    if row == 0 || row == PATCHES - 1 {
        return [255, 0, 255, 255];
    }
    let channel = |a: usize, b: usize| (((a * column + b * row) * 97) % 256) as u8;
    [channel(1, 5), channel(3, 1), channel(7, 3), 255]
}

fn palette() -> BaseColor {
    const PIXELS: usize = 8;
    let side = PATCHES * PIXELS;
    let pixels: Vec<_> = (0..side * side).map(|i| color_of([i % side / PIXELS, i / side / PIXELS])).collect();
    let texture = TextureLevels::new(side as u32, side as u32, &pixels, false);
    BaseColor::new(texture.expect("the size is right"))
}

/// Level with about this number of triangles.
fn level(mesh: &IndexedMesh, options: &SequenceOptions, triangle_count: usize) -> IndexedMesh {
    let options = options.clone().with_base_triangle_count(triangle_count);
    let refinable = build_sequence(mesh, &options).expect("the mesh is sound").refinable;
    replay(&refinable, 0)
}

/// Share of the sheet that shows another color than it should.
fn wrong_share(level: &IndexedMesh, patch_of: impl Fn(usize, usize) -> [usize; 2]) -> f64 {
    const POINTS: usize = 4 * SIDE;
    let uv = &level.layers[0];
    let side =
        |p: [f32; 3], q: [f32; 3], x: f32, y: f32| (q[0] - p[0]) * (y - p[1]) - (q[1] - p[1]) * (x - p[0]);
    let mut wrong = 0;
    for (i, j) in (0..POINTS * POINTS).map(|k| (k % POINTS, k / POINTS)) {
        let [x, y] = [i, j].map(|c| (c as f32 + 0.5) / POINTS as f32);
        let shown = level.triangles.iter().find_map(|t| {
            let [a, b, c] = t.map(|v| level.positions[v as usize]);
            let weights = [side(b, c, x, y), side(c, a, x, y), side(a, b, x, y)];
            let sum: f32 = weights.iter().sum();
            let is_inside = sum > 0.0 && weights.iter().all(|&w| w >= -1e-6 * sum);
            is_inside.then(|| {
                [0, 1].map(|axis| {
                    let at = |k: usize| weights[k] * uv.get(t[k] as usize, axis) / sum;
                    ((at(0) + at(1) + at(2)) * PATCHES as f32) as usize
                })
            })
        });
        let expected = color_of(patch_of(i * SIDE / POINTS, j * SIDE / POINTS));
        wrong += usize::from(shown.map(color_of) != Some(expected));
    }
    wrong as f64 / (POINTS * POINTS) as f64
}

/// A disk and a ring in neighboring patches, and a checkerboard of patches that are far apart, but look the same.
fn picture(x: usize, y: usize) -> [usize; 2] {
    let from_center = |c: usize| 2 * c as i64 + 1 - SIDE as i64;
    let (dx, dy) = (from_center(x), from_center(y));
    match dx * dx + dy * dy {
        0..60 => [4, 4],
        60..180 => [5, 4],
        _ if (x / 2 + y / 2).is_multiple_of(2) => [0, 0],
        _ => [15, 15],
    }
}

#[test]
fn patches_of_a_palette_do_not_mix() {
    let mesh = sheet(picture, 0.0);
    let usual = SequenceOptions::default();
    let colored = usual.clone().with_base_colors(vec![Some(palette())]);
    let [before, after] = [&usual, &colored].map(|options| wrong_share(&level(&mesh, options, 100), picture));
    assert!(after < 0.1 * before, "{after} of {before}");
}

#[test]
fn unknown_colors_change_nothing_and_known_ones_do() {
    let mesh = sheet(picture, 0.6);
    let usual = SequenceOptions::default();
    let sequence = |options: &SequenceOptions| {
        build_sequence(&mesh, options).expect("the mesh is sound").refinable.sequence
    };
    let expected = sequence(&usual);
    assert!(sequence(&usual.clone().with_base_colors(vec![None])) == expected);
    let mut other_set = palette();
    other_set.texcoord_set = 1;
    assert!(sequence(&usual.clone().with_base_colors(vec![Some(other_set)])) == expected, "no such layer");
    let colored = usual.clone().with_base_colors(vec![Some(palette())]);
    let found = sequence(&colored);
    assert!(found != expected && found == sequence(&colored));
    let mut clamped = palette();
    clamped.wrap = [Wrap::ClampToEdge; 2];
    assert!(sequence(&usual.clone().with_base_colors(vec![Some(clamped)])) == found, "all are inside");
}
