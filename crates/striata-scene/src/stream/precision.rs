//! Precision of each mesh, from one tolerance for the scene.
//!
//! Bits of [`Precision::Bits`] are those of the longest side of the scene's box, in units of the scene. The
//! tolerance of a mesh is that of the scene divided by the largest factor by which an instance, a joint or an
//! animated scale enlarges it. A vertex with several joints moves by a weighted average of what each joint
//! would do, so it stays within the tolerance too. With morph targets, half of the tolerance is for the
//! positions and half for the displacements, for the largest weights that occur.
//!
//! Weights of joints are rounded as [`LayerOptions::weight_bits`](striata_stream::LayerOptions) says; what
//! this moves a vertex depends on how far its joints are apart, and is not part of the tolerance.

use striata::mesh::{IndexedMesh, Semantic};
use striata_io::Scene;
use striata_stream::{GridError, Precision, StreamOptions};

use super::motion::{mesh_scales, morph_extents, weighted_extent};

/// Meshes that are small in the scene get at least this many bits of their own, so that their shape
/// survives.
const MIN_BITS: u32 = 6;

/// Most bits of the displacements of morph targets.
const MAX_MORPH_BITS: u32 = 20;

/// Options and scale of a mesh.
#[derive(Clone, Debug)]
pub(super) struct MeshPrecision {
    pub options: StreamOptions,
    /// Largest factor from mesh units to scene units; 0 if the scene does not show the mesh.
    pub scale: f64,
}

/// Returns the options for each mesh.
pub(super) fn mesh_precisions(scene: &Scene, options: &StreamOptions) -> Vec<Option<MeshPrecision>> {
    let scales = mesh_scales(scene);
    let tolerance = scene_tolerance(scene, options.precision);
    let with_scale = scene.meshes().iter().zip(&scales).enumerate();
    let precision = |(index, (mesh, scale)): (usize, (&Option<IndexedMesh>, &Option<f64>))| {
        let mesh = mesh.as_ref()?;
        let scale = scale.filter(|scale| scale.is_finite() && *scale > 0.0);
        let mut own = options.clone();
        own.metadata.clear();
        let own = match tolerance.zip(scale) {
            Some((tolerance, scale)) => within(scene, index, mesh, tolerance / scale, own),
            None => own,
        };
        Some(MeshPrecision { options: own, scale: scale.unwrap_or(0.0) })
    };
    let mut precisions: Vec<_> = with_scale.map(precision).collect();
    let meshes: Vec<_> = scene.meshes().iter().map(Option::as_ref).collect();
    share_lattices(
        scene,
        &meshes,
        precisions.iter_mut().map(|own| own.as_mut().map(|own| &mut own.options)).collect(),
    );
    precisions
}

/// How much finer than it asks for a mesh is rounded at most, to meet its neighbors.
const FINER: f64 = 4.0;

/// Gives meshes that touch the same lattice, the finest that one of them asks for, so that they still touch when
/// they are rounded. `options` has those of each mesh.
pub(crate) fn share_lattices(
    scene: &Scene,
    meshes: &[Option<&IndexedMesh>],
    mut options: Vec<Option<&mut StreamOptions>>,
) {
    let is_exact = |own: &&mut StreamOptions| own.precision == Precision::Lossless;
    if options.iter().flatten().filter(|own| !is_exact(own)).count() < 2 {
        return;
    }
    let step = |mesh: usize, own: &StreamOptions| own.grid_step(meshes[mesh]?).ok();
    let steps: Vec<Option<f64>> = options
        .iter()
        .enumerate()
        .map(|(mesh, own)| own.as_deref().and_then(|own| step(mesh, own)))
        .collect();
    let least = steps.iter().flatten().copied().fold(f64::INFINITY, f64::min);
    for group in scene.touching_meshes(meshes, 0.25 * least) {
        let finest = group.iter().filter_map(|(mesh, _)| steps[*mesh]).fold(f64::INFINITY, f64::min);
        for (mesh, offset) in group {
            let Some(own) = options[mesh].as_deref_mut().filter(|own| !is_exact(own)) else { continue };
            let on_lattice = own.clone().with_precision(Precision::Lattice { step: finest, offset });
            let is_near = steps[mesh].is_some_and(|step| step <= FINER * finest);
            if is_near && step(mesh, &on_lattice).is_some() {
                *own = on_lattice;
            }
        }
    }
}

/// Returns how far positions may move, in units of the scene; [`None`] if they may not move, or the scene
/// shows nothing.
pub(super) fn scene_tolerance(scene: &Scene, precision: Precision) -> Option<f64> {
    let tolerance = match precision {
        Precision::Bits(bits) => {
            0.5 * 3f64.sqrt() * longest_side(scene)? / ((1u64 << bits.min(32)) - 1) as f64
        }
        Precision::Tolerance(tolerance) => tolerance,
        _ => return None,
    };
    (tolerance.is_finite() && tolerance > 0.0).then_some(tolerance)
}

/// Returns the longest side of the scene's box; [`None`] if the scene shows nothing.
pub(super) fn longest_side(scene: &Scene) -> Option<f64> {
    let bounds = scene.bounds()?;
    let side = |axis: usize| f64::from(bounds.max[axis]) - f64::from(bounds.min[axis]);
    Some((0..3).map(side).fold(0.0, f64::max)).filter(|side| side.is_finite() && *side > 0.0)
}

/// Sets the precision of a mesh that may move by a distance, mesh units.
fn within(
    scene: &Scene,
    index: usize,
    mesh: &IndexedMesh,
    tolerance: f64,
    mut options: StreamOptions,
) -> StreamOptions {
    let mut tolerance = tolerance;
    let extents = morph_extents(mesh);
    let is_morphed = mesh.layers.iter().any(|layer| matches!(layer.semantic, Semantic::MorphPosition(_)));
    if is_morphed {
        tolerance *= 0.5;
        let steps = weighted_extent(scene, index, &extents) * 0.5 * 3f64.sqrt() / tolerance;
        let needed = (1..MAX_MORPH_BITS).find(|&bits| f64::from((1u32 << bits) - 1) >= steps);
        let bits = needed.unwrap_or(MAX_MORPH_BITS).max(options.layers.generic_bits);
        options.layers = options.layers.with_generic_bits(bits);
    }
    let coarsest = options.clone().with_precision(Precision::Bits(MIN_BITS)).grid_step(mesh);
    if let Ok(step) = coarsest {
        tolerance = tolerance.min(0.5 * 3f64.sqrt() * step);
    }
    let wanted = options.with_precision(Precision::Tolerance(tolerance));
    match wanted.grid_step(mesh) {
        // The finest grid there is.
        Err(GridError::Tolerance { min_tolerance, .. }) => {
            wanted.with_precision(Precision::Tolerance(min_tolerance))
        }
        Err(_) => wanted.with_precision(Precision::Bits(MIN_BITS)),
        Ok(_) => wanted,
    }
}
