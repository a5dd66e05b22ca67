//! Building the records: one pass from the full mesh to the base, following where each vertex stands.

use super::drops::drop_superfluous;
use super::record::{Edit, LONG_RECORD, head_bytes, write_record};
use super::{LodStrips, LodStripsError, LodStripsParts, MAX_STRIP_INDICES, StepVertices};
use crate::mesh::{CollapseSequence, IndexedMesh, RefinableMesh};
use crate::strip::{StripSet, strip_triangles};

impl LodStrips<'static> {
    /// Builds the model from strips of the full mesh; strips longer than [`MAX_STRIP_INDICES`] are cut.
    ///
    /// # Errors
    /// [`LodStripsError`] where the strips are not those of the mesh: other groups, other numbers of
    /// triangles, vertices that are not there.
    pub fn build(refinable: &RefinableMesh, strips: &StripSet) -> Result<Self, LodStripsError> {
        check_strips(&refinable.mesh, strips)?;
        let strips = sorted_by_place(&strips.cut(MAX_STRIP_INDICES), &refinable.mesh.positions);
        let sequence = &refinable.sequence;
        let mut builder = Builder::new(sequence, &strips);
        let mut reversed = Vec::new();
        let mut lengths = Vec::with_capacity(sequence.step_count());
        for step in (0..sequence.step_count()).rev() {
            let start = reversed.len();
            builder.write_step(step, &mut reversed);
            lengths.push(reversed.len() - start);
        }
        let (arena, record_lengths) = in_refinement_order(&reversed, &lengths);
        let parts = LodStripsParts {
            indices: strips.indices().to_vec().into(),
            offsets: strips.offsets().to_vec().into(),
            group_offsets: strips.group_offsets().to_vec().into(),
            record_lengths: record_lengths.into(),
            arena: arena.into(),
        };
        Ok(Self::unchecked(StepVertices::of_sequence(sequence).into_owned(), parts))
    }
}

impl<'a> StepVertices<'a> {
    /// The vertices of the steps as the sequence has them.
    pub(crate) fn of_sequence(sequence: &'a CollapseSequence) -> Self {
        let positions = sequence.positions();
        let firsts = &positions.first_vertices()[sequence.base_position_count()..];
        Self {
            vertex_count: positions.vertex_count(),
            base_vertex_count: sequence.base_vertex_count() as u32,
            firsts: if positions.is_identity() { [].as_slice().into() } else { firsts.into() },
            targets: sequence.targets().into(),
        }
    }

    fn into_owned(self) -> StepVertices<'static> {
        StepVertices {
            vertex_count: self.vertex_count,
            base_vertex_count: self.base_vertex_count,
            firsts: self.firsts.into_owned().into(),
            targets: self.targets.into_owned().into(),
        }
    }
}

fn check_strips(mesh: &IndexedMesh, strips: &StripSet) -> Result<(), LodStripsError> {
    let groups = mesh.groups_or_whole();
    if strips.group_count() != groups.len() {
        return Err(LodStripsError::GroupCount { found: strips.group_count(), expected: groups.len() });
    }
    let vertex_count = mesh.vertex_count();
    for (strip, indices) in strips.strips().enumerate() {
        if let Some(&vertex) = indices.iter().find(|&&v| v as usize >= vertex_count) {
            return Err(LodStripsError::Vertex { strip, vertex, vertex_count });
        }
    }
    for (group, expected) in groups.iter().map(|g| g.count as usize).enumerate() {
        let found = strips.group_strips(group).map(|s| strip_triangles(strips.strip(s)).count()).sum();
        if found != expected {
            return Err(LodStripsError::TriangleCount { group, found, expected });
        }
    }
    Ok(())
}

/// The strips of each group along a space-filling curve: those that meet at a vertex get near numbers.
fn sorted_by_place(strips: &StripSet, positions: &[[f32; 3]]) -> StripSet {
    let mut min = [f64::INFINITY; 3];
    let mut extent = 0f64;
    for p in positions {
        (0..3).for_each(|a| min[a] = min[a].min(f64::from(p[a])));
    }
    for p in positions {
        (0..3).for_each(|a| extent = extent.max(f64::from(p[a]) - min[a]));
    }
    let scale = if extent > 0.0 { 1023.0 / extent } else { 0.0 };
    let code = |strip: usize| {
        let indices = strips.strip(strip);
        let mut code = 0;
        for axis in 0..3 {
            let sum: f64 = indices.iter().map(|&v| f64::from(positions[v as usize][axis]) - min[axis]).sum();
            code |= spread_bits((sum * scale / indices.len().max(1) as f64) as u32) << axis;
        }
        code
    };
    let mut out = StripSet::new();
    for group in 0..strips.group_count() {
        let mut order: Vec<(u32, usize)> = strips.group_strips(group).map(|s| (code(s), s)).collect();
        order.sort_unstable();
        for (_, strip) in order {
            out.push(strips.strip(strip));
        }
        out.end_group();
    }
    out
}

/// The low 10 bits with two zeros between neighbours.
fn spread_bits(value: u32) -> u32 {
    let mut x = value & 0x3ff;
    x = (x | x << 16) & 0x0300_00ff;
    x = (x | x << 8) & 0x0300_f00f;
    x = (x | x << 4) & 0x030c_30c3;
    (x | x << 2) & 0x0924_9249
}

/// Turns records written from the full mesh down into the arena, which is read from the base up.
fn in_refinement_order(reversed: &[u8], lengths: &[usize]) -> (Vec<u8>, Vec<u8>) {
    let mut arena = Vec::with_capacity(reversed.len());
    let mut record_lengths = Vec::with_capacity(lengths.len());
    let mut end = reversed.len();
    for &length in lengths.iter().rev() {
        let body = &reversed[end - length..end];
        end -= length;
        if length < usize::from(LONG_RECORD) {
            record_lengths.push(length as u8);
            arena.extend_from_slice(body);
        } else {
            let ends = (length as u32 + 8).to_le_bytes();
            record_lengths.push(LONG_RECORD);
            arena.extend(ends);
            arena.extend_from_slice(body);
            arena.extend(ends);
        }
    }
    (arena, record_lengths)
}

struct Builder<'s> {
    sequence: &'s CollapseSequence,
    strips: &'s StripSet,
    head_bytes: usize,
    slots: Vec<u32>,
    lengths: Vec<u32>,
    /// Strips that may hold each vertex: all that do, and some that no longer do.
    strips_of: Vec<Vec<u32>>,
    edits: Vec<Edit>,
    touched: Vec<u32>,
    changed: Vec<u32>,
}

impl<'s> Builder<'s> {
    fn new(sequence: &'s CollapseSequence, strips: &'s StripSet) -> Self {
        let mut strips_of = vec![Vec::new(); sequence.positions().vertex_count()];
        for (strip, indices) in strips.strips().enumerate() {
            for &v in indices {
                let list: &mut Vec<u32> = &mut strips_of[v as usize];
                if list.last() != Some(&(strip as u32)) {
                    list.push(strip as u32);
                }
            }
        }
        Self {
            sequence,
            strips,
            head_bytes: head_bytes(strips.strip_count()),
            slots: strips.indices().to_vec(),
            lengths: strips.strips().map(|s| s.len() as u32).collect(),
            strips_of,
            edits: Vec::new(),
            touched: Vec::new(),
            changed: Vec::new(),
        }
    }

    fn write_step(&mut self, step: usize, out: &mut Vec<u8>) {
        let vertices = self.sequence.step_vertices(step);
        let wedge_count = vertices.end - vertices.start;
        self.touched.clear();
        for v in vertices.clone() {
            self.touched.append(&mut self.strips_of[v as usize]);
        }
        self.touched.sort_unstable();
        self.touched.dedup();
        let touched = std::mem::take(&mut self.touched);
        let mut used = 0;
        for &strip in &touched {
            if used == self.edits.len() {
                self.edits.push(Edit::default());
            }
            used += usize::from(self.edit_strip(strip, vertices.clone(), used));
        }
        self.touched = touched;
        write_record(&self.edits[..used], wedge_count, self.head_bytes, out);
    }

    /// Substitutes and drops in one strip; false where none of the vertices is left in it.
    fn edit_strip(&mut self, strip: u32, vertices: std::ops::Range<u32>, edit: usize) -> bool {
        let first = self.strips.offsets()[strip as usize] as usize;
        let length = &mut self.lengths[strip as usize];
        let slot = &mut self.slots[first..first + *length as usize];
        let edit = &mut self.edits[edit];
        edit.strip = strip;
        edit.places.clear();
        edit.drops.clear();
        for (place, v) in slot.iter_mut().enumerate() {
            if vertices.contains(v) {
                edit.places.push((place as u32, *v - vertices.start));
                *v = self.sequence.target(*v);
                let list = &mut self.strips_of[*v as usize];
                if list.last() != Some(&strip) {
                    list.push(strip);
                }
            }
        }
        if edit.places.is_empty() {
            return false;
        }
        self.changed.clear();
        self.changed.extend(edit.places.iter().map(|p| p.0));
        *length = drop_superfluous(slot, &mut self.changed, &mut edit.drops) as u32;
        true
    }
}
