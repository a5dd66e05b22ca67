//! Levels whose vertices are fitted to the original.

use striata_testing::meshes;

use striata::mesh::{
    AttributeLayer, DistanceOptions, IndexedMesh, Semantic, SurfaceSamples, TriangleTree, shapes,
    surface_distance, weld,
};
use striata::simplify::{
    Placement, SequenceOptions, Simplified, SimplifyOptions, Target, fit_level, fit_within, simplify,
};

fn level_of(mesh: &IndexedMesh, triangles: usize) -> Simplified {
    let options = SimplifyOptions::default().with_target(Target::Triangles(triangles));
    simplify(mesh, &options).expect("a valid mesh")
}

fn fitted(mesh: &IndexedMesh, level: &Simplified, options: &SequenceOptions) -> IndexedMesh {
    let fitted = fit_level(mesh, level.clone(), options).expect("a valid mesh");
    fitted.mesh.check().expect("a valid mesh");
    assert_eq!((&fitted.mesh.triangles, &fitted.mesh.groups), (&level.mesh.triangles, &level.mesh.groups));
    fitted.mesh
}

fn rms(mesh: &IndexedMesh, level: &IndexedMesh) -> f64 {
    let options = DistanceOptions::default().with_sample_count(20_000);
    surface_distance(mesh, level, &options).expect("meshes with triangles").rms
}

/// A wavy sheet with normals, and texture coordinates and colors that are functions of the place.
fn attributed_sheet() -> IndexedMesh {
    let mut mesh = shapes::grid(60, 60);
    let (mut normals, mut uvs, mut colors) = (Vec::new(), Vec::new(), Vec::new());
    for p in &mut mesh.positions {
        let (x, y) = (p[0] / 6.0, p[1] / 9.0);
        p[2] = 2.0 * x.sin() * y.cos();
        let slope = [-(2.0 / 6.0) * x.cos() * y.cos(), (2.0 / 9.0) * x.sin() * y.sin(), 1.0f32];
        let length = slope.iter().map(|s| s * s).sum::<f32>().sqrt();
        normals.extend(slope.map(|s| s / length));
        uvs.extend([p[0] / 60.0 + 0.02 * y.sin(), p[1] / 60.0 + 0.03 * x.cos()]);
        colors.extend([0.5 + 0.5 * x.sin(), 0.5 + 0.4 * y.cos(), 0.3]);
    }
    mesh.layers = vec![
        AttributeLayer::from_f32(Semantic::Normal, 3, normals),
        AttributeLayer::from_f32(Semantic::TexCoord(0), 2, uvs),
        AttributeLayer::from_f32(Semantic::Color(0), 3, colors),
    ];
    mesh
}

/// Mean difference of a layer between a mesh and the nearest points of a level.
fn layer_error(mesh: &IndexedMesh, level: &IndexedMesh, semantic: &Semantic) -> f64 {
    let [own, other] = [mesh, level].map(|mesh| mesh.layer(semantic).expect("the layer"));
    let mixed = |mesh: &IndexedMesh, layer: &AttributeLayer, t: usize, shares: [f64; 3]| {
        let corners = mesh.triangles[t];
        let value = |k| {
            let parts = (0..3).map(|c| shares[c] * f64::from(layer.get(corners[c] as usize, k)));
            parts.sum::<f64>()
        };
        (0..usize::from(layer.component_count)).map(value).collect::<Vec<f64>>()
    };
    let tree = TriangleTree::new(level).expect("a valid mesh");
    let chunks = SurfaceSamples::new(mesh, 5_000, 1).map_area_chunks(|samples| {
        let mut sum = 0.0;
        for sample in samples {
            let found = tree.nearest(sample.point).expect("a triangle").triangle as usize;
            // The sheet is a height field, so the shares are nearly those in plan.
            let [a, b, c] = level.triangles[found].map(|v| level.positions[v as usize].map(f64::from));
            let area = |p: [f64; 3], q: [f64; 3], r: [f64; 3]| {
                (q[0] - p[0]) * (r[1] - p[1]) - (q[1] - p[1]) * (r[0] - p[0])
            };
            let whole = area(a, b, c);
            let at = sample.point;
            let shares = [area(at, b, c) / whole, area(a, at, c) / whole, area(a, b, at) / whole];
            let (wanted, shown) =
                (mixed(mesh, own, sample.triangle, sample.weights), mixed(level, other, found, shares));
            sum += wanted.iter().zip(&shown).map(|(a, b)| (a - b).powi(2)).sum::<f64>().sqrt();
        }
        sum
    });
    chunks.iter().sum::<f64>() / 5_000.0
}

#[test]
fn attributes_come_closer_with_the_surface() {
    let mesh = attributed_sheet();
    let level = level_of(&mesh, 500);
    let fitted = fitted(&mesh, &level, &SequenceOptions::default());
    assert!(rms(&mesh, &fitted) < 0.65 * rms(&mesh, &level.mesh));
    for semantic in [Semantic::Normal, Semantic::TexCoord(0), Semantic::Color(0)] {
        let [before, after] = [&level.mesh, &fitted].map(|level| layer_error(&mesh, level, &semantic));
        assert!(after < 0.75 * before, "{semantic}: {after} against {before}");
    }
    let normals = fitted.layer(&Semantic::Normal).expect("normals");
    for v in 0..fitted.vertex_count() {
        let length = (0..3).map(|k| normals.get(v, k).powi(2)).sum::<f32>();
        assert!((length - 1.0).abs() < 1e-5);
    }
}

#[test]
fn flat_faces_and_straight_borders_stay() {
    let mesh = shapes::grid(20, 20);
    let level = level_of(&mesh, 200);
    assert_eq!(fitted(&mesh, &level, &SequenceOptions::default()), level.mesh);
}

#[test]
fn curved_borders_are_fitted_too() {
    // A disc: all of it is flat, so only the border can come closer.
    let mut mesh = shapes::grid(48, 48);
    for p in &mut mesh.positions {
        let (x, y) = (p[0] / 24.0 - 1.0, p[1] / 24.0 - 1.0);
        (p[0], p[1]) = (x * (1.0 - 0.5 * y * y).sqrt(), y * (1.0 - 0.5 * x * x).sqrt());
    }
    let level = level_of(&mesh, 40);
    let fitted = fitted(&mesh, &level, &SequenceOptions::default());
    assert!(rms(&mesh, &fitted) < 0.8 * rms(&mesh, &level.mesh));
}

#[test]
fn locked_vertices_identifiers_and_plans_stay() {
    let mut mesh = attributed_sheet();
    let ids = (0..mesh.vertex_count()).map(|v| v as f32).collect();
    mesh.layers.push(AttributeLayer::from_f32(Semantic::Generic("id".into()), 1, ids));
    let level = level_of(&mesh, 600);
    let options = SequenceOptions::default().with_height_field(true).with_locked_vertices(vec![0, 60, 1_830]);
    let fitted = fitted(&mesh, &level, &options);
    let plan = |mesh: &IndexedMesh| mesh.positions.iter().map(|p| [p[0], p[1]]).collect::<Vec<_>>();
    assert_eq!(plan(&fitted), plan(&level.mesh));
    assert_ne!(fitted.positions, level.mesh.positions);
    assert_eq!(fitted.layers[3], level.mesh.layers[3]);
    for v in options.locked_vertices {
        let place = mesh.positions[v as usize];
        let at = level.mesh.positions.iter().position(|p| *p == place);
        assert!(at.is_none_or(|v| fitted.positions[v] == place), "{v}");
    }
}

#[test]
fn numbers_that_are_not_finite_do_not_spread() {
    let mut mesh = attributed_sheet();
    let value = |p: &[f32; 3]| if p[0] > 50.0 { f32::NAN } else { p[2] };
    let values = mesh.positions.iter().map(value).collect();
    mesh.layers.push(AttributeLayer::from_f32(Semantic::Generic("height".into()), 1, values));
    let level = level_of(&mesh, 600);
    let fitted = fitted(&mesh, &level, &SequenceOptions::default());
    let heights = fitted.layer(&Semantic::Generic("height".into())).expect("heights");
    for (v, p) in fitted.positions.iter().enumerate() {
        assert!((heights.get(v, 0) - p[2]).abs() < 0.3 || p[0] > 45.0, "{} at {p:?}", heights.get(v, 0));
    }
}

#[test]
fn levels_beyond_the_limit_become_finer() {
    let mesh = shapes::icosphere(4, 1.0);
    let coarse = level_of(&mesh, 300);
    let none = SequenceOptions::default();
    let mut limits = Vec::new();
    let level_within = |limit: f64| {
        limits.push(limit);
        let finer = SimplifyOptions::default().with_target(Target::Error(limit));
        if limits.len() == 1 { coarse.clone() } else { simplify(&mesh, &finer).expect("a valid mesh") }
    };
    let level =
        fit_within(&mesh, level_within, &none, 2e-3, &mut striata::ignore_progress).expect("a valid mesh");
    assert!(level.error <= 2e-3 && level.mesh.triangle_count() > 300, "{}", level.error);
    assert!(limits.len() > 1 && limits.is_sorted_by(|a, b| a > b), "{limits:?}");
    // Nothing but the full mesh is within 0.
    let full = fit_within(
        &mesh,
        |limit| level_of(&mesh, if limit > 0.0 { 300 } else { 1 << 20 }),
        &none,
        0.0,
        &mut striata::ignore_progress,
    );
    assert_eq!(full.expect("a valid mesh").mesh.triangle_count(), mesh.triangle_count());
}

#[test]
fn what_refers_to_vertices_keeps_them() {
    let plain = attributed_sheet();
    assert_eq!(Placement::for_one_level(&plain), Placement::Optimal);
    let with = |change: &dyn Fn(&mut IndexedMesh)| {
        let mut mesh = plain.clone();
        change(&mut mesh);
        Placement::for_one_level(&mesh)
    };
    let layer = |semantic| AttributeLayer::from_f32(semantic, 1, vec![1.0; plain.vertex_count()]);
    let changes: [&dyn Fn(&mut IndexedMesh); 6] = [
        &|mesh| mesh.origin = [1e6, 0.0, 0.0],
        &|mesh| mesh.exact_positions = mesh.positions.iter().map(|p| p.map(f64::from)).collect(),
        &|mesh| mesh.appearance.georeference = "{}".to_owned(),
        &|mesh| mesh.layers.push(layer(Semantic::Generic("id".into()))),
        &|mesh| mesh.layers.push(layer(Semantic::Joints(0))),
        &|mesh| mesh.layers.push(layer(Semantic::MorphPosition(0))),
    ];
    for (i, change) in changes.into_iter().enumerate() {
        assert_eq!(with(change), Placement::Subset, "{i}");
    }
}

#[test]
fn assets_come_closer() {
    let mut ratios = Vec::new();
    for seed in 0..24u64 {
        let mesh = weld(&meshes::asset(1 + seed as usize % 6, seed)).expect("a valid mesh").mesh;
        for share in [0.6, 0.3, 0.1] {
            let level = level_of(&mesh, (share * mesh.triangle_count() as f64) as usize);
            if level.mesh.triangles.is_empty() {
                continue;
            }
            let fitted = fitted(&mesh, &level, &SequenceOptions::default());
            let noise = 1e-4 * mesh.diagonal();
            ratios.push((rms(&mesh, &fitted) + noise) / (rms(&mesh, &level.mesh) + noise));
        }
    }
    let mean = (ratios.iter().map(|ratio| ratio.ln()).sum::<f64>() / ratios.len() as f64).exp();
    let worst = ratios.iter().copied().fold(0.0, f64::max);
    // Charts of a few triangles leave their vertices little room.
    assert!(mean < 0.9 && worst < 1.1, "mean {mean}, worst {worst}");
}
