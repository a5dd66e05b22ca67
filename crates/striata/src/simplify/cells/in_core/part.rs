//! Simplifies one cell of a level, or all that is left.

use super::routed::RoutedLevel;
use super::surface::{DividedSurface, NONE};
use crate::mesh::{IndexedMesh, PositionIndex, Welded};
use crate::simplify::collapse::simplifier::{PartOfMesh, SimplifiedPart, Simplifier};
use crate::simplify::collapse::witness::WitnessVertex;
use crate::simplify::{SequenceOptions, SimplifyError, StopReason, TopologyRule};
use crate::{ProgressFn, ignore_progress};

/// The changes of simplifying a part, in the numbering of the whole mesh.
pub(super) struct PartResult {
    pub removed: Vec<u32>,
    /// Target of each removed position.
    pub targets: Vec<u32>,
    pub keys: Vec<f32>,
    /// Error that each step contributes, mesh units.
    pub errors: Vec<f32>,
    pub removed_triangle_counts: Vec<u8>,
    /// Triangles that are left of those inside.
    pub triangles: Vec<[u32; 3]>,
    /// Key and witness of each position of the part that is left.
    pub states: Vec<(u32, f32, (u32, f32))>,
    /// Witnesses of positions of other cells.
    pub witnesses_outside: Vec<(u32, (u32, f32))>,
    pub stop_reason: StopReason,
}

/// The mesh of a part, without attributes. Its positions are first those of the part itself, then those around it.
struct CellPart {
    positions: Vec<u32>,
    own_count: usize,
    welded: Welded,
    inside_count: usize,
    /// Positions that must stay.
    locked: Vec<u32>,
}

/// Simplifies a cell to half of its triangles.
pub(super) fn simplify_part(
    surface: &DividedSurface<'_>,
    options: &SequenceOptions,
    (routed, cell): (&RoutedLevel, usize),
) -> Result<PartResult, SimplifyError> {
    let [inside, border] = routed.triangles(cell);
    let own = routed.positions(cell);
    let of = |&t: &u32| surface.triangles[t as usize];
    let corners = || border.iter().flat_map(&of);
    let is_own = |p: u32| routed.cell_of[p as usize] == cell as u32;
    let mut outside: Vec<u32> = corners().filter(|&p| !is_own(p)).collect();
    outside.sort_unstable();
    outside.dedup();
    let number = |p: u32| {
        if is_own(p) {
            routed.number_in_cell[p as usize]
        } else {
            (own.len() + outside.binary_search(&p).unwrap_or_default()) as u32
        }
    };
    let triangles: Vec<[u32; 3]> = inside.iter().chain(border).map(|t| of(t).map(number)).collect();
    let locked = own.iter().filter(|&&p| surface.is_locked[p as usize]).copied();
    let locked = locked.chain(corners()).map(number).collect();
    let positions = [own, &outside].concat();
    let part = CellPart::new(surface, positions, own.len(), triangles, (inside.len(), locked));
    let options = SequenceOptions {
        base_triangle_count: border.len() + inside.len().div_ceil(2),
        topology: TopologyRule::Keep,
        ..options.clone()
    };
    part.simplify(surface, options, 0.0, &mut ignore_progress)
}

/// Simplifies all that is left, to a number of triangles; `worst` is the largest error so far, mesh units.
pub(super) fn simplify_rest(
    surface: &DividedSurface<'_>,
    options: &SequenceOptions,
    (wanted, worst): (usize, f32),
    progress: &mut ProgressFn<'_>,
) -> Result<PartResult, SimplifyError> {
    let count = surface.is_removed.len() as u32;
    let positions: Vec<u32> = (0..count).filter(|&p| !surface.is_removed[p as usize]).collect();
    let mut number = vec![NONE; count as usize];
    (0..).zip(&positions).for_each(|(i, &p)| number[p as usize] = i);
    let triangles = surface.triangles.iter().map(|t| t.map(|p| number[p as usize])).collect();
    let locked = positions.iter().filter(|&&p| surface.is_locked[p as usize]).map(|&p| number[p as usize]);
    let locked = locked.collect();
    let (own_count, inside_count) = (positions.len(), surface.triangles.len());
    let part = CellPart::new(surface, positions, own_count, triangles, (inside_count, locked));
    let options = SequenceOptions { base_triangle_count: wanted, ..options.clone() };
    part.simplify(surface, options, worst, progress)
}

impl CellPart {
    fn new(
        surface: &DividedSurface<'_>,
        positions: Vec<u32>,
        own_count: usize,
        triangles: Vec<[u32; 3]>,
        (inside_count, locked): (usize, Vec<u32>),
    ) -> Self {
        let place = |&p: &u32| surface.welded.mesh.positions[p as usize];
        let welded = Welded {
            mesh: IndexedMesh::new(positions.iter().map(place).collect(), triangles),
            positions: PositionIndex::identity(positions.len()),
            source_vertex: Vec::new(),
            position_of_source: (0..positions.len() as u32).collect(),
            degenerate_triangle_count: 0,
            merged_vertex_count: 0,
        };
        Self { positions, own_count, welded, inside_count, locked }
    }

    fn simplify(
        &self,
        surface: &DividedSurface<'_>,
        mut options: SequenceOptions,
        worst: f32,
        progress: &mut ProgressFn<'_>,
    ) -> Result<PartResult, SimplifyError> {
        options.locked_vertices.clone_from(&self.locked);
        // What says so otherwise is known for the whole mesh only.
        options.height_field =
            Some(options.height_field.unwrap_or(!surface.welded.mesh.appearance.georeference.is_empty()));
        let is_cut = self.inside_count < self.welded.mesh.triangles.len();
        let scale = surface.space.scale;
        let part = PartOfMesh {
            scale,
            is_cut,
            latest: self.positions.iter().map(|&p| surface.latest[p as usize]).collect(),
            attributes: surface.attributes.as_ref().map(|space| space.gathered(&self.positions)),
        };
        let mut simplifier = Simplifier::of_part(&self.welded, &options, part);
        let space = crate::simplify::scaled_space::ScaledSpace::with_scale(&self.welded.mesh, scale);
        let mut carried = Vec::new();
        for (i, &p) in (0..).zip(&self.positions[..self.own_count]) {
            let (vertex, distance) = surface.witnesses[p as usize];
            if vertex != NONE {
                let place = space.scaled(surface.welded.mesh.positions[vertex as usize]).as_vec3();
                simplifier.witnesses_mut().carry(i, place, distance);
                carried.push(vertex);
            }
        }
        let worst = (f64::from(worst) / scale) as f32;
        simplifier.witnesses_mut().raise(worst * worst);
        let part = simplifier.run_part(progress)?;
        Ok(self.result(part, &carried))
    }

    fn result(&self, part: SimplifiedPart, carried: &[u32]) -> PartResult {
        let SimplifiedPart { record, stop_reason, order, witnesses } = part;
        let global = |v: u32| self.positions[v as usize];
        // Targets of a later step are final already.
        let mut current: Vec<u32> = (0..self.positions.len() as u32).collect();
        for &v in record.removed.iter().rev() {
            current[v as usize] = current[record.targets[v as usize] as usize];
        }
        let inside = &self.welded.mesh.triangles[..self.inside_count];
        let triangles = inside.iter().map(|t| t.map(|v| current[v as usize]));
        let triangles = triangles.filter(|&[a, b, c]| a != b && b != c && c != a).map(|t| t.map(global));
        let mut states: Vec<(u32, f32, (u32, f32))> =
            (0..self.own_count as u32).map(|v| (global(v), order.latest[v as usize], (NONE, 0.0))).collect();
        let mut witnesses_outside = Vec::new();
        for witness in witnesses.stored() {
            let vertex = match witness.vertex {
                WitnessVertex::Own(v) => global(v),
                WitnessVertex::Carried(i) => carried[i as usize],
            };
            match states.get_mut(witness.position as usize) {
                Some(state) => state.2 = (vertex, witness.distance),
                None => witnesses_outside.push((global(witness.position), (vertex, witness.distance))),
            }
        }
        let is_left = |&(v, _): &(u32, &(u32, f32, (u32, f32)))| current[v as usize] == v;
        let states = (0..).zip(&states).filter(is_left).map(|(_, &state)| state).collect();
        PartResult {
            targets: record.removed.iter().map(|&v| global(record.targets[v as usize])).collect(),
            removed: record.removed.iter().map(|&v| global(v)).collect(),
            keys: order.keys,
            errors: record.errors,
            removed_triangle_counts: record.removed_triangle_counts,
            triangles: triangles.collect(),
            states,
            witnesses_outside,
            stop_reason,
        }
    }
}
