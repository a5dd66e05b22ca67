//! The surface that cells simplify, between two levels.

use crate::mesh::Welded;
use crate::simplify::SequenceOptions;
use crate::simplify::collapse::attributes::AttributeSpace;
use crate::simplify::scaled_space::ScaledSpace;

/// No vertex.
pub(super) const NONE: u32 = u32::MAX;

/// The surface between two levels.
pub(super) struct DividedSurface<'a> {
    pub welded: &'a Welded,
    pub space: ScaledSpace,
    pub attributes: Option<AttributeSpace>,
    pub triangles: Vec<[u32; 3]>,
    pub is_locked: Vec<bool>,
    pub is_removed: Vec<bool>,
    /// Key of the last step that changed a triangle at each position.
    pub latest: Vec<f32>,
    /// Removed vertex that is measured from each position, or `NONE`; and its distance, scaled units.
    pub witnesses: Vec<(u32, f32)>,
}

impl<'a> DividedSurface<'a> {
    pub(super) fn new(welded: &'a Welded, options: &SequenceOptions) -> Self {
        let position_count = welded.positions.position_count();
        let mut is_locked = vec![false; position_count];
        for &vertex in &options.locked_vertices {
            let position = welded.position_of_source.get(vertex as usize);
            if let Some(is_locked) = position.and_then(|&p| is_locked.get_mut(p as usize)) {
                *is_locked = true;
            }
        }
        let space = ScaledSpace::of(&welded.mesh);
        Self {
            welded,
            attributes: AttributeSpace::new(welded, options, space.scale),
            space,
            triangles: welded.mesh.triangles.clone(),
            is_locked,
            is_removed: vec![false; position_count],
            latest: vec![0.0; position_count],
            witnesses: vec![(NONE, 0.0); position_count],
        }
    }
}

impl DividedSurface<'_> {
    /// Adds witnesses that cells left at positions of other cells, which may have been removed since.
    pub(super) fn add_witnesses(&mut self, witnesses: Vec<(u32, (u32, f32))>, targets: &[u32]) {
        for (mut p, witness) in witnesses {
            while self.is_removed[p as usize] {
                p = targets[p as usize];
            }
            let current = &mut self.witnesses[p as usize];
            if current.0 == NONE || witness.1 > current.1 {
                *current = witness;
            }
        }
    }
}
