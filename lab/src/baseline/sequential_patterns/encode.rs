//! Encoder: describes each fragment by its position in the previous level.

use std::collections::HashMap;

use striata::mesh::{FragmentSequence, FragmentedMesh};
use striata::model::{Bits, ModelError};

use super::{
    ANCHOR_BITS, LONG_NEIGHBOR, LONG_NEIGHBOR_BITS, LONG_RULE, LONG_RULE_BITS, NEIGHBOR_BITS, OPENS_TWICE,
    OrderedNeighbors, RULE_BITS, SequentialPatterns,
};
use crate::baseline::loop_patterns::{LoopRegion, LoopRule, LoopShape, LoopSurface, Side, check_form};

impl SequentialPatterns {
    /// Encodes all levels of a mesh.
    ///
    /// # Errors
    /// [`ModelError`] with the first step, or the triangle of the base, that the published form cannot
    /// represent; the same limits apply as to [`LoopPatterns::build`](crate::baseline::LoopPatterns::build).
    pub fn encode(mesh: &FragmentedMesh) -> Result<Self, ModelError> {
        let fragments = &mesh.fragments;
        let levels = fragments.levels();
        let positions = levels.positions();
        check_form(mesh.mesh.groups.len(), positions.vertex_count(), positions.position_count())?;
        let base_vertex_count = levels.base_vertex_count();
        let base: Vec<[u32; 3]> =
            fragments.faces()[..fragments.base_face_count()].iter().map(|face| face.corners).collect();
        let surface = LoopSurface::new(&base, base_vertex_count)
            .map_err(|(place, reason)| ModelError::Listed { what: "triangle of the base", place, reason })?;
        if base_vertex_count > 3 * base.len() {
            let (found, limit) = (base_vertex_count as u64, 3 * base.len() as u64);
            return Err(ModelError::Form { what: "vertices of the base", found, limit });
        }
        let shapes = shapes_of(fragments)?;
        let (rules, rule_indices) = sort_rules(&shapes)?;
        let mut bytes = Vec::new();
        for count in [base_vertex_count, base.len(), shapes.len(), rules.len()] {
            bytes.extend_from_slice(&(count as u32).to_le_bytes());
        }
        base.as_flattened().iter().for_each(|v| bytes.extend_from_slice(&v.to_le_bytes()));
        for code in &rules {
            let rule = LoopRule::of_code(code);
            bytes.extend_from_slice(&[rule.ring_len() as u8, u8::from(rule.is_open)]);
            bytes.extend_from_slice(rule.apexes);
        }
        let mut writer = SequentialPatternsWriter {
            surface,
            bits: Bits::default(),
            neighbors: OrderedNeighbors::default(),
            region: LoopRegion::default(),
            star: Vec::new(),
        };
        for (step, (shape, rule_index)) in shapes.iter().zip(rule_indices).enumerate() {
            let vertex = (base_vertex_count + step) as u32;
            writer.push(vertex, shape, rule_index).map_err(|reason| ModelError::Step { step, reason })?;
        }
        bytes.extend_from_slice(writer.bits.as_bytes());
        Ok(Self { bytes, step_count: shapes.len(), fragment_bits: writer.bits.len() })
    }
}

/// Determines the shape of each fragment.
fn shapes_of(fragments: &FragmentSequence) -> Result<Vec<LoopShape>, ModelError> {
    let base_vertex_count = fragments.levels().base_vertex_count();
    let corners = |face: u32| fragments.faces()[face as usize].corners;
    let shape = |step: usize| {
        let ceiling: Vec<_> = fragments.ceiling(step as u32).map(corners).collect();
        let floor: Vec<_> = fragments.floor(step as u32).iter().map(|&face| corners(face)).collect();
        LoopShape::of((base_vertex_count + step) as u32, &ceiling, &floor)
            .map_err(|reason| ModelError::Step { step, reason })
    };
    (0..fragments.step_count()).map(shape).collect()
}

/// The codes of all rules, most frequent first, and the rule index of each shape.
fn sort_rules(shapes: &[LoopShape]) -> Result<(Vec<&[u8]>, Vec<u32>), ModelError> {
    let mut counts: HashMap<&[u8], u32> = HashMap::new();
    for shape in shapes {
        *counts.entry(&shape.code).or_insert(0) += 1;
    }
    let mut sorted: Vec<(&[u8], u32)> = counts.iter().map(|(&code, &count)| (code, count)).collect();
    sorted.sort_unstable_by(|a, b| b.1.cmp(&a.1).then(a.0.cmp(b.0)));
    let limit = 1 << LONG_RULE_BITS;
    if sorted.len() > limit {
        return Err(ModelError::Form { what: "rules", found: sorted.len() as u64, limit: limit as u64 });
    }
    sorted.iter().zip(0..).for_each(|(&(code, _), index)| *counts.entry(code).or_insert(0) = index);
    let rule_indices = shapes.iter().map(|shape| counts[&shape.code[..]]).collect();
    Ok((sorted.into_iter().map(|(code, _)| code).collect(), rule_indices))
}

struct SequentialPatternsWriter {
    surface: LoopSurface,
    bits: Bits,
    neighbors: OrderedNeighbors,
    region: LoopRegion,
    star: Vec<Side>,
}

impl SequentialPatternsWriter {
    fn push(&mut self, vertex: u32, shape: &LoopShape, rule_index: u32) -> Result<(), &'static str> {
        let rule = LoopRule::of_code(&shape.code);
        let a = shape.ring[0];
        self.neighbors.find(&self.surface, a);
        let index = self.find(rule, shape).ok_or("has a floor that does not match its anchors")?;
        let is_attached = rule.apexes.is_empty();
        if rule.is_open && !is_attached && !self.surface.is_openable(&self.region, &mut self.star) {
            return Err(OPENS_TWICE);
        }
        self.write(u64::from(rule_index), LONG_RULE, [RULE_BITS, LONG_RULE_BITS]);
        self.bits.push(u64::from(a), ANCHOR_BITS);
        let rank = self.neighbors.rank(index) as u64;
        self.write(rank, LONG_NEIGHBOR, [NEIGHBOR_BITS, LONG_NEIGHBOR_BITS]);
        self.surface.add_vertex();
        self.surface.replace_by_fan(vertex, rule, &mut self.region);
        Ok(())
    }

    /// Index of the second anchor among the neighbors of the first; leaves the floor in `region`.
    fn find(&mut self, rule: LoopRule, shape: &LoopShape) -> Option<usize> {
        let [a, b] = [shape.ring[0], shape.ring[1]];
        let mut indices = 0..self.neighbors.count();
        if rule.apexes.is_empty() {
            let last = indices.next_back()?;
            let is_it = !self.neighbors.is_closed && self.neighbors.vertex(&self.surface, last) == b;
            self.region.attach([a, b], self.neighbors.star[last.checked_sub(1)?].0);
            return is_it.then_some(last);
        }
        indices.find(|&index| {
            self.neighbors.vertex(&self.surface, index) == b
                && self.neighbors.side(index).is_some_and(|side| {
                    self.surface.find_floor(rule, side, &mut self.region) && self.region.ring == shape.ring
                })
        })
    }

    /// Writes a value, or an escape value followed by the wider value.
    fn write(&mut self, value: u64, long: u64, [width, long_width]: [u32; 2]) {
        if value < long {
            self.bits.push(value, width);
        } else {
            self.bits.push(long, width);
            self.bits.push(value, long_width);
        }
    }
}
