//! Meshes simplified in cells: the steps of all cells together are one sequence of the whole mesh.

use std::collections::BTreeMap;

use striata::mesh::{AttributeLayer, IndexedMesh, Semantic, shapes};
use striata::simplify::cells::{CellHierarchy, CellMesh, CellOptions, Partition, build_in_cells};

fn cell_mesh(mesh: &IndexedMesh) -> CellMesh {
    let mut groups = vec![0; if mesh.groups.is_empty() { 0 } else { mesh.triangles.len() }];
    for (index, group) in (0..).zip(&mesh.groups) {
        groups[group.range()].fill(index);
    }
    CellMesh {
        positions: mesh.positions.clone(),
        layers: mesh.layers.clone(),
        triangles: mesh.triangles.clone(),
        groups,
        ..CellMesh::default()
    }
}

fn build(mesh: &IndexedMesh, cell_triangle_count: usize) -> CellHierarchy {
    let partition = Partition::new(&mesh.positions, 2.0, cell_triangle_count);
    assert!(partition.levels().len() > 1, "the mesh is larger than a cell");
    let materials = mesh.groups.iter().map(|group| group.material).collect();
    let options = CellOptions::new(mesh.diagonal()).with_materials(materials);
    build_in_cells(cell_mesh(mesh), &partition, &options).unwrap()
}

/// Position and attributes of a vertex.
type Value = (Vec<u32>, Vec<u8>);

fn values(positions: &[[f32; 3]], layers: &[AttributeLayer]) -> Vec<Value> {
    let value = |(v, p): (usize, &[f32; 3])| {
        let bytes = layers.iter().flat_map(|layer| {
            let n = layer.vertex_bytes();
            &layer.data.as_bytes()[v * n..][..n]
        });
        (p.map(|x| (x + 0.0).to_bits()).to_vec(), bytes.copied().collect())
    };
    positions.iter().enumerate().map(value).collect()
}

type Soup = BTreeMap<Vec<Value>, i64>;

fn add(soup: &mut Soup, corners: [&Value; 3], count: i64) {
    let first = (0..3).min_by_key(|&i| corners[i]).unwrap();
    let key: Vec<Value> = (0..3).map(|i| corners[(first + i) % 3].clone()).collect();
    if key[0].0 == key[1].0 || key[1].0 == key[2].0 || key[2].0 == key[0].0 {
        return;
    }
    let sum = soup.entry(key).or_default();
    *sum += count;
}

fn soup_of(positions: &[[f32; 3]], layers: &[AttributeLayer], triangles: &[[u32; 3]]) -> Soup {
    let values = values(positions, layers);
    let mut soup = Soup::new();
    triangles.iter().for_each(|t| add(&mut soup, t.map(|v| &values[v as usize]), 1));
    soup
}

/// Checks that each step follows those that it depends on, and that the base mesh and the pages, loaded in any
/// order that respects keys, end at the full mesh.
fn check(mesh: &IndexedMesh, hierarchy: &CellHierarchy) {
    let mut targets: BTreeMap<Value, (Value, f32)> = BTreeMap::new();
    let mut key_of: BTreeMap<Vec<u32>, f32> = BTreeMap::new();
    let base = &hierarchy.base;
    let mut soup = soup_of(&base.positions, &base.layers, &base.triangles);
    for cell in hierarchy.cells.iter().rev() {
        let steps = &cell.steps;
        let values = values(&steps.positions, &steps.layers);
        let owned = steps.targets.len() as u32;
        for (p, wedges) in steps.first.windows(2).enumerate() {
            let known = key_of.insert(values[wedges[0] as usize].0.clone(), steps.keys[p]);
            assert_eq!(known, None, "a position is removed once");
            for v in wedges[0]..wedges[1] {
                let target = values[steps.targets[v as usize] as usize].clone();
                targets.insert(values[v as usize].clone(), (target, steps.keys[p]));
            }
        }
        let collapse = |mut v: u32| {
            while v < owned {
                v = steps.targets[v as usize];
            }
            &values[v as usize]
        };
        for t in &steps.triangles {
            add(&mut soup, t.map(collapse), -1);
        }
        assert!(soup.values().all(|&count| count >= 0), "a cell replaces triangles that exist");
        for t in &steps.triangles {
            add(&mut soup, t.map(|v| &values[v as usize]), 1);
        }
    }
    soup.retain(|_, count| *count != 0);
    assert_eq!(soup, soup_of(&mesh.positions, &mesh.layers, &mesh.triangles));
    for (target, key) in targets.values() {
        assert!(key_of.get(&target.0).is_none_or(|above| above > key), "a target has a larger key");
    }
    check_levels(mesh, &targets);
}

/// Checks that every triangle of a level consists of vertices that the level has.
fn check_levels(mesh: &IndexedMesh, targets: &BTreeMap<Value, (Value, f32)>) {
    let values = values(&mesh.positions, &mesh.layers);
    let mut keys: Vec<f32> = targets.values().map(|(_, key)| *key).collect();
    keys.sort_by(f32::total_cmp);
    for share in [0.1, 0.5, 0.9] {
        let threshold = keys[(share * keys.len() as f64) as usize];
        for value in &values {
            let mut at = value;
            while let Some((target, key)) = targets.get(at)
                && *key < threshold
            {
                at = target;
            }
            assert!(targets.get(at).is_none_or(|(_, key)| *key >= threshold));
        }
    }
}

#[test]
fn closed_surface() {
    let mesh = shapes::torus(160, 80, 1.0, 0.4);
    let hierarchy = build(&mesh, 2000);
    assert!(hierarchy.base.triangles.len() < 200, "{} triangles are left", hierarchy.base.triangles.len());
    check(&mesh, &hierarchy);
}

#[test]
fn open_surface_with_attributes_and_seams() {
    let mut mesh = shapes::grid(90, 90);
    let texcoords = mesh.positions.iter().flat_map(|p| [p[0], p[1]]).collect();
    mesh.layers.push(AttributeLayer::from_f32(Semantic::TexCoord(0), 2, texcoords));
    // Split normals: every triangle has its own.
    let order: Vec<u32> = mesh.triangles.as_flattened().to_vec();
    let mut soup = IndexedMesh {
        positions: order.iter().map(|&v| mesh.positions[v as usize]).collect(),
        layers: mesh.layers.iter().map(|layer| layer.gather(&order)).collect(),
        triangles: (0..mesh.triangles.len() as u32).map(|t| [3 * t, 3 * t + 1, 3 * t + 2]).collect(),
        ..IndexedMesh::default()
    };
    let normal = |t: usize| {
        let side = (t / 2) % 7;
        [0.1 * side as f32, 0.0, 1.0]
    };
    let normals = (0..mesh.triangles.len()).flat_map(|t| [normal(t); 3].concat()).collect();
    soup.layers.insert(0, AttributeLayer::from_f32(Semantic::Normal, 3, normals));
    check(&soup, &build(&soup, 1000));
}

#[test]
fn parts_vanish_across_cells() {
    let mut mesh = IndexedMesh::default();
    let part = shapes::icosphere(1, 1.0);
    for i in 0..300u32 {
        let (x, y, z) = ((i % 10) as f32, ((i / 10) % 10) as f32, (i / 100) as f32);
        let offset = mesh.positions.len() as u32;
        mesh.positions
            .extend(part.positions.iter().map(|p| [3.0 * x + p[0], 3.0 * y + p[1], 3.0 * z + p[2]]));
        mesh.triangles.extend(part.triangles.iter().map(|t| t.map(|v| v + offset)));
    }
    let hierarchy = build(&mesh, 1000);
    check(&mesh, &hierarchy);
    assert!(hierarchy.base.triangles.len() < 1000);
}

#[test]
fn tangled_triangles() {
    let mut seed = 1u64;
    let mut random = move |n: u64| {
        seed = seed.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        (seed >> 33) % n
    };
    for size in [100u64, 400] {
        let positions: Vec<[f32; 3]> =
            (0..size).map(|_| [0; 3].map(|_: i32| random(40) as f32 * 0.25)).collect();
        let triangles: Vec<[u32; 3]> =
            (0..6 * size).map(|_| [0; 3].map(|_: i32| random(size) as u32)).collect();
        let proper = |t: &[u32; 3]| {
            let [a, b, c] = t.map(|v| positions[v as usize]);
            a != b && b != c && c != a
        };
        let mesh = IndexedMesh::new(positions.clone(), triangles.into_iter().filter(proper).collect());
        check(&mesh, &build(&mesh, 100));
    }
}
