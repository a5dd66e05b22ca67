//! Builds the model, \[KG98\] section 3.3: from the steps themselves or from a Multi-Triangulation.
//!
//! In both cases fragments arrive in the order of simplification, finest first. The fragments that cover a
//! new one are found through the triangles of its ceiling, and the new one is added to their loops. The two
//! cases differ only in whether a triangle stores its covering fragment permanently or only during the build.

use std::collections::HashMap;
use std::hash::{BuildHasherDefault, Hasher};

use striata::mesh::{FragmentSequence, FragmentedMesh};
use striata::model::{ModelError, StepVertices};

use super::LoopPatterns;
use super::records::{LoopHead, LoopLink, LoopRecords, MAX_LOOPS};
use super::rule::{LoopShape, RuleFinder};
use super::surface::LoopSurface;
use crate::baseline::MultiTriangulation;

const NO_STEP: u32 = FragmentSequence::NO_STEP;

impl LoopPatterns {
    /// Builds the model from the steps, in the order of simplification.
    ///
    /// # Errors
    /// [`ModelError`] with the first step, or the triangle of the base, that the published form cannot
    /// represent: more than one group, seams, stars that are not one fan, floors that do not fill their
    /// hole, more than 15 loops or 4096 rules.
    pub fn build(mesh: &FragmentedMesh) -> Result<Self, ModelError> {
        let fragments = &mesh.fragments;
        let levels = fragments.levels();
        check_form(
            mesh.mesh.groups.len(),
            levels.positions().vertex_count(),
            levels.positions().position_count(),
        )?;
        let corners: Vec<[u32; 3]> = fragments.faces().iter().map(|face| face.corners).collect();
        // The fragment that covers each triangle, as far as simplification has come.
        let mut covering = vec![NO_STEP; corners.len()];
        let replacing_steps = fragments.replacing_steps();
        let is_in_full_mesh = |face: &u32| replacing_steps[*face as usize] == NO_STEP;
        let full = (0..corners.len() as u32).filter(is_in_full_mesh);
        let mut builder =
            LoopPatternsBuilder::new(&corners, levels.base_vertex_count() as u32, levels.step_count(), full)?;
        let mut ceiling = Vec::new();
        for step in (0..levels.step_count() as u32).rev() {
            ceiling.clear();
            ceiling.extend(fragments.ceiling(step));
            let covers = ceiling.iter().map(|&face| covering[face as usize]).collect();
            builder.push(step, &ceiling, fragments.floor(step), covers)?;
            fragments.floor(step).iter().for_each(|&face| covering[face as usize] = step);
        }
        let base = fragments.base_face_count();
        builder.finish(base, covering[..base].to_vec())
    }

    /// Builds an equal model from an explicit Multi-Triangulation.
    ///
    /// # Errors
    /// See [`build`](Self::build).
    pub fn from_multi_triangulation(explicit: &MultiTriangulation) -> Result<Self, ModelError> {
        use striata::model::{LodModel, StoredModel};
        let step_count = explicit.step_count();
        let base_vertex_count = explicit.base_vertex_count();
        check_form(explicit.group_count(), explicit.vertex_count(), base_vertex_count + step_count)?;
        let triangles = explicit.triangles();
        let corners: Vec<[u32; 3]> = triangles.iter().map(|triangle| triangle.corners).collect();
        let upper = |index: u32| triangles[index as usize].upper;
        let full = (0..corners.len() as u32).filter(|&index| upper(index) == NO_STEP);
        let mut builder = LoopPatternsBuilder::new(&corners, base_vertex_count as u32, step_count, full)?;
        for step in (0..step_count as u32).rev() {
            let ceiling = explicit.ceiling(step);
            let covers = ceiling.iter().map(|&index| upper(index)).collect();
            builder.push(step, ceiling, explicit.floor(step), covers)?;
        }
        let base = explicit.base_triangle_count();
        builder.finish(base, (0..base as u32).map(upper).collect())
    }
}

/// Rejects meshes with several groups or with seams, which the published form cannot represent.
pub(in crate::baseline) fn check_form(
    group_count: usize,
    vertex_count: usize,
    position_count: usize,
) -> Result<(), ModelError> {
    if group_count > 1 {
        let (found, limit) = (group_count as u64, 1);
        return Err(ModelError::Form { what: "group of triangles", found, limit });
    }
    if vertex_count != position_count {
        let (found, limit) = (vertex_count as u64, position_count as u64);
        return Err(ModelError::Form { what: "vertices (one a position)", found, limit });
    }
    Ok(())
}

/// Builds the model from fragments that arrive from the finest to the coarsest.
struct LoopPatternsBuilder<'a> {
    /// Corners of the triangles of all levels.
    corners: &'a [[u32; 3]],
    base_vertex_count: u32,
    /// The triangle to the left of each directed edge, at the current level.
    sides: HashMap<u64, u32, BuildHasherDefault<SideHasher>>,
    rules: RuleFinder,
    /// The head of each step.
    heads: Vec<LoopHead>,
    /// For each fragment, the triangle that identifies it: the floor triangle at its anchors, or the
    /// triangle it is attached to.
    anchored_at: Vec<u32>,
    /// Whether the fragment that creates this triangle is the first in the fragment's loop.
    has_leader: Vec<bool>,
    /// Pairs of a covering fragment and a fragment that it covers, where the covered one creates a triangle
    /// that contains both anchors of the covering one but is not the triangle at which it is located.
    rivals: Vec<[u32; 2]>,
    /// Fragments without a floor, by the triangle that they are attached to.
    attached: HashMap<u32, Vec<u32>>,
    /// By step: its first link and its number of links.
    link_ranges: Vec<[u32; 2]>,
    links: Vec<LoopLink>,
}

impl<'a> LoopPatternsBuilder<'a> {
    fn new(
        corners: &'a [[u32; 3]],
        base_vertex_count: u32,
        step_count: usize,
        full: impl Iterator<Item = u32>,
    ) -> Result<Self, ModelError> {
        let mut builder = Self {
            corners,
            base_vertex_count,
            sides: HashMap::default(),
            rules: RuleFinder::default(),
            heads: Vec::with_capacity(step_count),
            anchored_at: vec![NO_STEP; step_count],
            has_leader: vec![false; step_count],
            rivals: Vec::new(),
            attached: HashMap::new(),
            link_ranges: vec![[0; 2]; step_count],
            links: Vec::new(),
        };
        let head = |step| LoopHead { anchors: [0; 2], rule: 0, down: LoopLink::back_to(step) };
        builder.heads.extend((0..step_count as u32).map(head));
        for (place, triangle) in full.enumerate() {
            if !builder.add_edges(triangle) {
                let reason = "has an edge in the same direction as another triangle";
                return Err(ModelError::Listed { what: "triangle", place, reason });
            }
        }
        Ok(builder)
    }

    /// Adds the edges of a triangle; returns false if another triangle already has one of them.
    fn add_edges(&mut self, triangle: u32) -> bool {
        let [a, b, c] = self.corners[triangle as usize];
        [[a, b], [b, c], [c, a]].into_iter().all(|side| self.sides.insert(key(side), triangle).is_none())
    }

    /// Adds the next fragment. `covers` contains the fragment that covers each triangle of its ceiling, or
    /// [`NO_STEP`].
    fn push(
        &mut self,
        step: u32,
        ceiling: &[u32],
        floor: &[u32],
        mut covers: Vec<u32>,
    ) -> Result<(), ModelError> {
        let refused = |reason| ModelError::Step { step: step as usize, reason };
        let of = |list: &[u32]| list.iter().map(|&t| self.corners[t as usize]).collect::<Vec<_>>();
        let shape =
            LoopShape::of(self.base_vertex_count + step, &of(ceiling), &of(floor)).map_err(refused)?;
        for &triangle in ceiling {
            let [a, b, c] = self.corners[triangle as usize];
            for side in [[a, b], [b, c], [c, a]] {
                self.sides.remove(&key(side));
            }
        }
        if !floor.iter().all(|&triangle| self.add_edges(triangle)) {
            return Err(refused("creates an edge that two triangles use in the same direction"));
        }
        let anchors = [shape.ring[0], shape.ring[1]];
        self.anchored_at[step as usize] = if floor.is_empty() {
            self.attach(step, anchors).map_err(refused)?
        } else {
            self.sides[&key(anchors)]
        };
        if shape.code[0] == 1 && !self.is_openable([shape.ring[0], shape.ring[shape.ring.len() - 1]]) {
            return Err(refused("closes a hole at a vertex that has another border"));
        }
        covers.extend(ceiling.iter().flat_map(|triangle| self.attached.get(triangle).into_iter().flatten()));
        covers.retain(|&cover| cover != NO_STEP);
        covers.sort_unstable();
        covers.dedup();
        if covers.len() > MAX_LOOPS {
            let (found, limit) = (covers.len() as u64, MAX_LOOPS as u64);
            return Err(ModelError::Form { what: "loops through one fragment", found, limit });
        }
        let head = &mut self.heads[step as usize];
        (head.anchors, head.rule) = (anchors, self.rules.index_of(shape.code));
        self.add_to_loops(step, ceiling, &covers);
        Ok(())
    }

    /// Whether the edge between the ends of an open ring is a border, or closes a hole so that neither end
    /// has a border.
    fn is_openable(&self, [first, last]: [u32; 2]) -> bool {
        let is_glued = self.sides.contains_key(&key([first, last]));
        !is_glued || self.is_closed_around(first, last) && self.is_closed_around(last, first)
    }

    /// Whether the triangles around a vertex lead from a neighbor back to that neighbor.
    fn is_closed_around(&self, vertex: u32, neighbor: u32) -> bool {
        let mut at = neighbor;
        while let Some(&triangle) = self.sides.get(&key([vertex, at])) {
            let corners = &self.corners[triangle as usize];
            let turn = corners.iter().position(|&v| v == vertex).unwrap_or(0);
            at = corners[(turn + 2) % 3];
            if at == neighbor {
                return true;
            }
        }
        false
    }

    /// Attaches a fragment without a floor to the triangle across its edge, and returns that triangle.
    fn attach(&mut self, step: u32, [a, b]: [u32; 2]) -> Result<u32, &'static str> {
        let on = *self.sides.get(&key([b, a])).ok_or("removes the last triangle of a component")?;
        self.attached.entry(on).or_default().push(step);
        Ok(on)
    }

    /// Adds a fragment to the loops of the fragments that cover it, and puts it first if it creates the
    /// triangle that identifies the covering fragment.
    fn add_to_loops(&mut self, step: u32, ceiling: &[u32], covers: &[u32]) {
        self.link_ranges[step as usize] = [self.links.len() as u32, covers.len() as u32];
        for (index, &cover) in covers.iter().enumerate() {
            let own = LoopLink::to(step, index);
            let LoopHead { anchors, down, .. } = self.heads[cover as usize];
            let leads = ceiling.contains(&self.anchored_at[cover as usize]);
            if !leads && ceiling.iter().any(|&t| has_side(&self.corners[t as usize], anchors)) {
                self.rivals.push([cover, step]);
            }
            if leads || !self.has_leader[cover as usize] {
                self.links.push(down);
                self.heads[cover as usize].down = own;
                self.has_leader[cover as usize] |= leads;
            } else {
                let [first, _] = self.link_ranges[down.step as usize];
                let at = first as usize + down.loop_index();
                self.links.push(self.links[at]);
                self.links[at] = own;
            }
        }
    }

    fn finish(
        mut self,
        base_triangle_count: usize,
        mut covers: Vec<u32>,
    ) -> Result<LoopPatterns, ModelError> {
        // A fragment whose anchors are in the base is identified unless a triangle of its loop's first
        // fragment has the same anchors.
        let is_found = |&[cover, step]: &[u32; 2]| {
            self.has_leader[cover as usize] || self.heads[cover as usize].down.step != step
        };
        if let Some([cover, _]) = self.rivals.iter().find(|pair| !is_found(pair)) {
            let reason = "has anchors that two triangles share";
            return Err(ModelError::Step { step: *cover as usize, reason });
        }
        let base = &self.corners[..base_triangle_count];
        LoopSurface::new(base, self.base_vertex_count as usize)
            .map_err(|(place, reason)| ModelError::Listed { what: "triangle of the base", place, reason })?;
        let of_base = 0..base_triangle_count as u32;
        covers.extend(of_base.flat_map(|triangle| self.attached.remove(&triangle).unwrap_or_default()));
        covers.retain(|&cover| cover != NO_STEP);
        covers.sort_unstable();
        covers.dedup();
        let (rules, new_indices) = self.rules.finish()?;
        let mut records = LoopRecords::default();
        for (head, &[first, count]) in self.heads.iter().zip(&self.link_ranges) {
            let head = LoopHead { rule: new_indices[head.rule as usize], ..*head };
            records.push(&head, &self.links[first as usize..(first + count) as usize]);
        }
        Ok(LoopPatterns {
            vertices: StepVertices::one_per_step(self.base_vertex_count, records.len()),
            base: base.to_vec(),
            base_covers: covers,
            rules,
            records,
        })
    }
}

/// Packs a directed edge into one integer.
fn key([from, to]: [u32; 2]) -> u64 {
    u64::from(from) << 32 | u64::from(to)
}

/// Hasher for a single integer. Each fragment looks up a dozen edges, and their keys are close to each other.
#[derive(Default)]
struct SideHasher(u64);

impl Hasher for SideHasher {
    fn finish(&self) -> u64 {
        self.0
    }

    fn write_u64(&mut self, value: u64) {
        let mixed = (value ^ value >> 31).wrapping_mul(0x9E37_79B9_7F4A_7C15);
        self.0 = (mixed ^ mixed >> 29).wrapping_mul(0xBF58_476D_1CE4_E5B9) ^ mixed >> 32;
    }

    fn write(&mut self, bytes: &[u8]) {
        bytes.iter().for_each(|&byte| self.write_u64(self.0 << 8 | u64::from(byte)));
    }
}

fn has_side([a, b, c]: &[u32; 3], side: [u32; 2]) -> bool {
    [[*a, *b], [*b, *c], [*c, *a]].contains(&side)
}
