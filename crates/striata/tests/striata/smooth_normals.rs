//! Normals of levels of smooth surfaces, which highlights show.

use striata::mesh::{AttributeLayer, IndexedMesh, Semantic, shapes};
use striata::simplify::{AttributeWeights, SequenceOptions, SimplifyOptions, Target, simplify};

/// Quads along each side of the surface.
const SIDE: u32 = 40;

fn height(x: f32, y: f32) -> f32 {
    3.0 * (0.25 * x).sin() * (0.2 * y).cos()
}

fn normal(x: f32, y: f32) -> [f32; 3] {
    let slope_x = 0.75 * (0.25 * x).cos() * (0.2 * y).cos();
    let slope_y = -0.6 * (0.25 * x).sin() * (0.2 * y).sin();
    let length = (slope_x * slope_x + slope_y * slope_y + 1.0).sqrt();
    [-slope_x / length, -slope_y / length, 1.0 / length]
}

/// Smooth hills with the normals of the exact surface.
fn hills() -> IndexedMesh {
    let mut mesh = shapes::height_field(SIDE, SIDE, |x, y| height(x as f32, y as f32));
    let normals = mesh.positions.iter().flat_map(|&[x, y, _]| normal(x, y)).collect();
    mesh.layers.push(AttributeLayer::from_f32(Semantic::Normal, 3, normals));
    mesh
}

/// Mean angle between the normals of a level and the exact ones, in degrees.
fn mean_angle(level: &IndexedMesh) -> f64 {
    let normals = level.layer(&Semantic::Normal).expect("levels keep normals");
    let (mut sum, mut count) = (0.0, 0);
    for (x, y) in (0..SIDE * SIDE).map(|i| ((i % SIDE) as f32 + 0.5, (i / SIDE) as f32 + 0.5)) {
        let weights = level.triangles.iter().find_map(|&triangle| {
            let [a, b, c] = triangle.map(|v| level.positions[v as usize]);
            let area = |p: [f32; 3], q: [f32; 3]| (p[0] - x) * (q[1] - y) - (p[1] - y) * (q[0] - x);
            let parts = [area(b, c), area(c, a), area(a, b)];
            let whole: f32 = parts.iter().sum();
            let weights = parts.map(|part| part / whole);
            weights.iter().all(|&weight| weight >= -1e-4).then_some((triangle, weights))
        });
        let (triangle, weights) = weights.expect("the level covers the plane");
        let shown: [f32; 3] = std::array::from_fn(|axis| {
            triangle.into_iter().zip(weights).map(|(v, weight)| weight * normals.get(v as usize, axis)).sum()
        });
        let length = shown.iter().map(|n| n * n).sum::<f32>().sqrt();
        let cosine: f32 = shown.iter().zip(normal(x, y)).map(|(a, b)| a * b).sum::<f32>() / length;
        sum += f64::from(cosine.clamp(-1.0, 1.0).acos().to_degrees());
        count += 1;
    }
    sum / f64::from(count)
}

#[test]
fn normals_count_at_every_size_of_triangles() {
    let mesh = hills();
    let at = |normal: f32, share: f64| {
        let weights = AttributeWeights { normal, ..AttributeWeights::default() };
        let sequence = SequenceOptions::default().with_attribute_weights(weights);
        let target = Target::Triangles((share * mesh.triangle_count() as f64) as usize);
        let options = SimplifyOptions::default().with_sequence(sequence).with_target(target);
        mean_angle(&simplify(&mesh, &options).expect("the mesh is valid").mesh)
    };
    for share in [0.5, 0.2, 0.08, 0.04] {
        let [without, with] = [0.0, AttributeWeights::default().normal].map(|weight| at(weight, share));
        assert!(with < 0.85 * without, "share {share}: {with} degrees, without weight {without}");
    }
}
