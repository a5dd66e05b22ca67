//! meshoptimizer's simplifier, with attributes.
//!
//! Normals and colors have the weights that gltfpack uses. gltfpack gives texture coordinates no weight,
//! since it keeps their seams. Here they get the weight that meshoptimizer's documentation recommends, the
//! reciprocal root of the mean triangle area in UV space; without it, levels across seams would be useless.

use std::time::Instant;

use meshopt::{SimplifyOptions, VertexDataAdapter, simplify_with_attributes_and_locks, typed_to_bytes};
use striata::mesh::{IndexedMesh, Semantic};

use super::contender::{Level, Simplify};
use super::error_limits::with_smallest_limit;

/// Weight of each component of a normal.
const NORMAL_WEIGHT: f32 = 0.5;
/// Weight of each channel of a color.
const COLOR_WEIGHT: f32 = 1.0;

/// Interleaved attributes of all vertices.
struct InterleavedAttributes {
    values: Vec<f32>,
    weights: Vec<f32>,
}

/// Prepares the simplifier for a mesh; a permissive one may collapse across seams.
pub(super) fn prepare(mesh: &IndexedMesh, is_permissive: bool) -> Simplify<'_> {
    let attributes = InterleavedAttributes::of(mesh);
    let mut options = SimplifyOptions::Prune;
    options.set(SimplifyOptions::Permissive, is_permissive);
    Box::new(move |request| {
        with_smallest_limit(request, |limit| {
            simplify(mesh, &attributes, options, request.target_count, limit)
        })
    })
}

fn simplify(
    mesh: &IndexedMesh,
    attributes: &InterleavedAttributes,
    options: SimplifyOptions,
    target_count: usize,
    error_limit: f64,
) -> Result<Option<Level>, String> {
    let started = Instant::now();
    let vertices = VertexDataAdapter::new(typed_to_bytes(&mesh.positions), size_of::<[f32; 3]>(), 0);
    let vertices = vertices.map_err(|error| error.to_string())?;
    let indices = simplify_with_attributes_and_locks(
        mesh.triangles.as_flattened(),
        &vertices,
        &attributes.values,
        &attributes.weights,
        attributes.weights.len() * size_of::<f32>(),
        &vec![false; mesh.vertex_count()],
        3 * target_count,
        error_limit as f32,
        options,
        None,
    );
    let secs = started.elapsed().as_secs_f64();
    if indices.is_empty() {
        return Ok(None);
    }
    let level = IndexedMesh {
        positions: mesh.positions.clone(),
        triangles: indices.as_chunks().0.to_vec(),
        layers: mesh.layers.clone(),
        ..IndexedMesh::default()
    };
    Ok(Some(Level { mesh: level.without_unused_vertices(), secs, error: None, error_limit: None }))
}

impl InterleavedAttributes {
    fn of(mesh: &IndexedMesh) -> Self {
        let layers: Vec<_> = mesh
            .layers
            .iter()
            .map(|layer| (layer, usize::from(layer.component_count).min(3), weight(mesh, &layer.semantic)))
            .filter(|(_, _, weight)| *weight > 0.0)
            .collect();
        let weights = layers.iter().flat_map(|&(_, count, weight)| vec![weight; count]).collect();
        let of_vertex = |v: usize| {
            layers.iter().flat_map(move |&(layer, count, _)| (0..count).map(move |k| layer.get(v, k)))
        };
        Self { values: (0..mesh.vertex_count()).flat_map(of_vertex).collect(), weights }
    }
}

fn weight(mesh: &IndexedMesh, semantic: &Semantic) -> f32 {
    match semantic {
        Semantic::Normal => NORMAL_WEIGHT,
        Semantic::Color(_) => COLOR_WEIGHT,
        Semantic::TexCoord(_) => {
            let area = mean_uv_area(mesh, semantic);
            if area > 0.0 { (1.0 / area.sqrt()) as f32 } else { 0.0 }
        }
        _ => 0.0,
    }
}

fn mean_uv_area(mesh: &IndexedMesh, semantic: &Semantic) -> f64 {
    let Some(layer) = mesh.layer(semantic) else { return 0.0 };
    let areas = mesh.triangles.iter().map(|corners| {
        let [a, b, c] = corners.map(|v| [0, 1].map(|k| f64::from(layer.get(v as usize, k))));
        ((b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0])).abs() / 2.0
    });
    areas.sum::<f64>() / mesh.triangle_count().max(1) as f64
}

#[cfg(test)]
mod tests {
    use striata::mesh::{AttributeLayer, shapes};

    use super::*;
    use crate::compare::assets::contender::Request;

    #[test]
    fn attributes_are_interleaved() {
        let positions = vec![[0., 0., 0.], [3., 0., 0.], [3., 6., 0.], [0., 6., 0.]];
        let mut mesh = IndexedMesh::new(positions, vec![[0, 1, 2], [0, 2, 3]]);
        mesh.layers.push(AttributeLayer::from_f32(Semantic::Normal, 3, [0., 0., 1.].repeat(4)));
        let uvs = mesh.positions.iter().flat_map(|p| [p[0], p[1]]).collect();
        mesh.layers.push(AttributeLayer::from_f32(Semantic::TexCoord(0), 2, uvs));
        let found = InterleavedAttributes::of(&mesh);
        assert_eq!(found.values.len(), 4 * 5);
        assert_eq!(found.values[5..10], [0., 0., 1., 3., 0.]);
        // Both triangles have an area of 9 in UV space.
        assert_eq!(found.weights, [0.5, 0.5, 0.5, 1.0 / 3.0, 1.0 / 3.0]);
    }

    #[test]
    fn ball_reaches_its_target() {
        let ball = shapes::icosphere(4, 1.0);
        let request = Request::new(25.0, ball.triangle_count());
        for is_permissive in [false, true] {
            let level = prepare(&ball, is_permissive)(&request).expect("a level").mesh;
            level.check().expect("a sound mesh");
            let count = level.triangle_count();
            assert!(count <= request.target_count && count + 4 > request.target_count, "{count}");
        }
    }
}
