//! Building the model: \[KG98\] section 3.3, from the steps themselves or from a Multi-Triangulation.
//!
//! Either way fragments come as they are simplified, the finest first. Those that cover a new one are known by the triangles of its
//! ceiling, and it is put into their loops. Whether a triangle knows its covering fragment for good or only for the time being is all
//! that the two ways differ in.

use std::collections::HashMap;
use std::hash::{BuildHasherDefault, Hasher};

use striata::mesh::{FragmentSequence, FragmentedMesh};
use striata::model::{ModelError, StepVertices};

use super::LoopPatterns;
use super::records::{Head, Link, MAX_LOOPS, Records};
use super::rule::{RuleFinder, Shape};
use super::surface::Surface;
use crate::baseline::MultiTriangulation;

const NO_STEP: u32 = FragmentSequence::NO_STEP;

impl LoopPatterns {
    /// Builds the model from the steps in the order of simplification.
    ///
    /// # Errors
    /// [`ModelError`] naming the first step, or the triangle of the base, that the published form cannot hold: more groups than one, seams,
    /// stars that are not one fan, floors that do not fill their hole, more than 15 loops or 4096 rules.
    pub fn build(mesh: &FragmentedMesh) -> Result<Self, ModelError> {
        let fragments = &mesh.fragments;
        let levels = fragments.levels();
        check_form(
            mesh.mesh.groups.len(),
            levels.positions().vertex_count(),
            levels.positions().position_count(),
        )?;
        let corners: Vec<[u32; 3]> = fragments.faces().iter().map(|face| face.corners).collect();
        // What covers each triangle that is there, as far as simplification has come.
        let mut covering = vec![NO_STEP; corners.len()];
        let replaced_by = fragments.replacing_steps();
        let is_of_full = |face: &u32| replaced_by[*face as usize] == NO_STEP;
        let full = (0..corners.len() as u32).filter(is_of_full);
        let mut builder =
            Builder::new(&corners, levels.base_vertex_count() as u32, levels.step_count(), full)?;
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

    /// Builds the same model from an explicit one.
    ///
    /// # Errors
    /// As [`build`](Self::build).
    pub fn from_multi_triangulation(explicit: &MultiTriangulation) -> Result<Self, ModelError> {
        use striata::model::{LodModel, StoredModel};
        let step_count = explicit.step_count();
        let base_vertex_count = explicit.base_vertex_count();
        check_form(explicit.group_count(), explicit.vertex_count(), base_vertex_count + step_count)?;
        let triangles = explicit.triangles();
        let corners: Vec<[u32; 3]> = triangles.iter().map(|triangle| triangle.corners).collect();
        let upper = |number: u32| triangles[number as usize].upper;
        let full = (0..corners.len() as u32).filter(|&number| upper(number) == NO_STEP);
        let mut builder = Builder::new(&corners, base_vertex_count as u32, step_count, full)?;
        for step in (0..step_count as u32).rev() {
            let ceiling = explicit.ceiling(step);
            let covers = ceiling.iter().map(|&number| upper(number)).collect();
            builder.push(step, ceiling, explicit.floor(step), covers)?;
        }
        let base = explicit.base_triangle_count();
        builder.finish(base, (0..base as u32).map(upper).collect())
    }
}

/// Refuses what the published form has no words for: groups and seams.
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

/// Takes fragments from the finest to the coarsest.
struct Builder<'a> {
    /// Of every triangle that there ever is.
    corners: &'a [[u32; 3]],
    base_vertex_count: u32,
    /// The triangle left of each side, at the level that has been reached.
    sides: HashMap<u64, u32, BuildHasherDefault<SideHasher>>,
    rules: RuleFinder,
    /// By step.
    heads: Vec<Head>,
    /// The triangle that a fragment is found by: that of its floor at the anchors, or the one that it hangs on.
    anchored_at: Vec<u32>,
    /// Whether the one that makes that triangle leads the fragment's loop.
    is_led: Vec<bool>,
    /// Fragments that make a triangle with another's anchors which is not the one that is meant: covering, then covered.
    rivals: Vec<[u32; 2]>,
    /// Fragments without a floor, with the triangles that they hang on.
    hung: HashMap<u32, Vec<u32>>,
    /// By step: first of its links, and how many.
    places: Vec<[u32; 2]>,
    links: Vec<Link>,
}

impl<'a> Builder<'a> {
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
            is_led: vec![false; step_count],
            rivals: Vec::new(),
            hung: HashMap::new(),
            places: vec![[0; 2]; step_count],
            links: Vec::new(),
        };
        let head = |step| Head { anchors: [0; 2], rule: 0, down: Link::back_to(step) };
        builder.heads.extend((0..step_count as u32).map(head));
        for (place, triangle) in full.enumerate() {
            if !builder.put(triangle) {
                let reason = "runs along an edge as another triangle does";
                return Err(ModelError::Listed { what: "triangle", place, reason });
            }
        }
        Ok(builder)
    }

    /// Adds the sides of a triangle; false where one is there already.
    fn put(&mut self, triangle: u32) -> bool {
        let [a, b, c] = self.corners[triangle as usize];
        [[a, b], [b, c], [c, a]].into_iter().all(|side| self.sides.insert(key(side), triangle).is_none())
    }

    /// Takes the next fragment, where `covers` is what covers the triangles of its ceiling, [`NO_STEP`] where nothing does.
    fn push(
        &mut self,
        step: u32,
        ceiling: &[u32],
        floor: &[u32],
        mut covers: Vec<u32>,
    ) -> Result<(), ModelError> {
        let refused = |reason| ModelError::Step { step: step as usize, reason };
        let of = |list: &[u32]| list.iter().map(|&t| self.corners[t as usize]).collect::<Vec<_>>();
        let shape = Shape::of(self.base_vertex_count + step, &of(ceiling), &of(floor)).map_err(refused)?;
        for &triangle in ceiling {
            let [a, b, c] = self.corners[triangle as usize];
            for side in [[a, b], [b, c], [c, a]] {
                self.sides.remove(&key(side));
            }
        }
        if !floor.iter().all(|&triangle| self.put(triangle)) {
            return Err(refused("leaves an edge that two triangles run along in the same way"));
        }
        let anchors = [shape.ring[0], shape.ring[1]];
        self.anchored_at[step as usize] = if floor.is_empty() {
            self.hang(step, anchors).map_err(refused)?
        } else {
            self.sides[&key(anchors)]
        };
        if shape.code[0] == 1 && !self.is_openable([shape.ring[0], shape.ring[shape.ring.len() - 1]]) {
            return Err(refused("closes a hole at a vertex that has another border"));
        }
        covers.extend(ceiling.iter().flat_map(|triangle| self.hung.get(triangle).into_iter().flatten()));
        covers.retain(|&cover| cover != NO_STEP);
        covers.sort_unstable();
        covers.dedup();
        if covers.len() > MAX_LOOPS {
            let (found, limit) = (covers.len() as u64, MAX_LOOPS as u64);
            return Err(ModelError::Form { what: "loops through one fragment", found, limit });
        }
        let head = &mut self.heads[step as usize];
        (head.anchors, head.rule) = (anchors, self.rules.number_of(shape.code));
        self.put_into_loops(step, ceiling, &covers);
        Ok(())
    }

    /// Whether a floor between the ends of an open ring has a border there, or closes a hole so that the ends have none.
    fn is_openable(&self, [first, last]: [u32; 2]) -> bool {
        let is_glued = self.sides.contains_key(&key([first, last]));
        !is_glued || self.is_closed_around(first, last) && self.is_closed_around(last, first)
    }

    /// Whether the triangles around a vertex lead from a neighbor back to it.
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

    /// The triangle that a fragment without a floor hangs on.
    fn hang(&mut self, step: u32, [a, b]: [u32; 2]) -> Result<u32, &'static str> {
        let on = *self.sides.get(&key([b, a])).ok_or("takes the last triangle of a piece")?;
        self.hung.entry(on).or_default().push(step);
        Ok(on)
    }

    /// Puts a fragment into the loops of those that cover it: first, where it makes the triangle that the loop's fragment is found by.
    fn put_into_loops(&mut self, step: u32, ceiling: &[u32], covers: &[u32]) {
        self.places[step as usize] = [self.links.len() as u32, covers.len() as u32];
        for (number, &cover) in covers.iter().enumerate() {
            let own = Link::to(step, number);
            let Head { anchors, down, .. } = self.heads[cover as usize];
            let leads = ceiling.contains(&self.anchored_at[cover as usize]);
            if !leads && ceiling.iter().any(|&t| has_side(&self.corners[t as usize], anchors)) {
                self.rivals.push([cover, step]);
            }
            if leads || !self.is_led[cover as usize] {
                self.links.push(down);
                self.heads[cover as usize].down = own;
                self.is_led[cover as usize] |= leads;
            } else {
                let [first, _] = self.places[down.step as usize];
                let at = first as usize + down.number();
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
        // A fragment whose anchors are of the base is found where no triangle of its loop's first fragment has them.
        let is_found = |&[cover, step]: &[u32; 2]| {
            self.is_led[cover as usize] || self.heads[cover as usize].down.step != step
        };
        if let Some([cover, _]) = self.rivals.iter().find(|pair| !is_found(pair)) {
            let reason = "has anchors that name two triangles";
            return Err(ModelError::Step { step: *cover as usize, reason });
        }
        let base = &self.corners[..base_triangle_count];
        Surface::new(base, self.base_vertex_count as usize)
            .map_err(|(place, reason)| ModelError::Listed { what: "triangle of the base", place, reason })?;
        let of_base = 0..base_triangle_count as u32;
        covers.extend(of_base.flat_map(|triangle| self.hung.remove(&triangle).unwrap_or_default()));
        covers.retain(|&cover| cover != NO_STEP);
        covers.sort_unstable();
        covers.dedup();
        let (rules, renumbered) = self.rules.finish()?;
        let mut records = Records::default();
        for (head, &[first, count]) in self.heads.iter().zip(&self.places) {
            let head = Head { rule: renumbered[head.rule as usize], ..*head };
            records.push(&head, &self.links[first as usize..(first + count) as usize]);
        }
        Ok(LoopPatterns {
            vertices: StepVertices::one_a_step(self.base_vertex_count, records.len()),
            base: base.to_vec(),
            base_covers: covers,
            rules,
            records,
        })
    }
}

/// A side as one number.
fn key([from, to]: [u32; 2]) -> u64 {
    u64::from(from) << 32 | u64::from(to)
}

/// Mixes one number: sides are looked up a dozen times a fragment, and their numbers are close to each other.
#[derive(Default)]
struct SideHasher(u64);

impl Hasher for SideHasher {
    fn finish(&self) -> u64 {
        self.0
    }

    fn write_u64(&mut self, number: u64) {
        let mixed = (number ^ number >> 31).wrapping_mul(0x9E37_79B9_7F4A_7C15);
        self.0 = (mixed ^ mixed >> 29).wrapping_mul(0xBF58_476D_1CE4_E5B9) ^ mixed >> 32;
    }

    fn write(&mut self, bytes: &[u8]) {
        bytes.iter().for_each(|&byte| self.write_u64(self.0 << 8 | u64::from(byte)));
    }
}

fn has_side([a, b, c]: &[u32; 3], side: [u32; 2]) -> bool {
    [[*a, *b], [*b, *c], [*c, *a]].contains(&side)
}
