//! Appending steps: a backward replay of the new ones finds what each of them needs and changes.
//!
//! The finest level is known, with the triangles that the new steps have changed or added. Going from the last new step down to the
//! first, the triangles at a vertex are exactly its star at the level where its step was refined. Collapsing it leads to
//! the next step's level.

use std::ops::Range;

use glam::DVec3;
use striata::view::{NormalCone, Part, Sphere};

use super::hierarchy::{ALL_THROUGH, GrowingHierarchy, NONE};
use crate::reader::prefix::{PrefixMesh, is_proper};

/// Entries that the lists of needs may have for each new step on average, and beyond that in all. Meshes take about 6 a step. A list
/// that would exceed the sum stands for its largest entry and all older steps, so that damaged streams do not exhaust memory.
const MOST_NEEDS_A_STEP: usize = 24;
const SPARE_NEEDS: usize = 1 << 15;

impl GrowingHierarchy {
    /// Appends the steps that have arrived since the last call.
    ///
    /// `changed` lists the older triangles with other corners than before, without repetitions, as
    /// [`StreamUpdate`](crate::StreamUpdate) does; further triangles do no harm. `error` is the error of the level that
    /// lacks a step, mesh units, and must not rise with the step.
    ///
    /// # Panics
    /// If the mesh is not the one of the last call with more steps.
    pub fn grow(&mut self, mesh: &PrefixMesh<'_>, changed: &[u32], error: impl Fn(usize) -> f32) {
        if mesh.first_vertices.is_empty() {
            return;
        }
        let new = self.step_count()..mesh.step_count();
        let old_count = self.first_triangles.last().copied().unwrap_or(0);
        self.append_vertices(mesh, new.clone());
        let changed = changed.iter().copied().filter(|&t| t < old_count);
        let mut replay = Replay::new(mesh, new.start, changed.chain(old_count..mesh.triangles.len() as u32));
        let mut found = Found::default();
        for step in new.clone().rev() {
            replay.collapse(self, step, &mut found);
            found.parts.push(replay.change.part(error(step)));
        }
        self.append(new.clone(), found);
        self.nest(new);
    }

    fn append_vertices(&mut self, mesh: &PrefixMesh<'_>, new: Range<usize>) {
        if self.first_triangles.is_empty() {
            self.base_vertex_count = mesh.base_vertex_count() as u32;
            self.first_triangles.push(mesh.triangle_count_at(0) as u32);
            self.first_needs.push(0);
            self.first_root = NONE;
        }
        let mut triangle_count = self.first_triangles[new.start];
        for step in new {
            triangle_count += u32::from(mesh.added_triangle_counts[step]);
            self.first_triangles.push(triangle_count);
            self.steps.extend(mesh.step_vertices(step).map(|_| step as u32));
        }
    }

    /// Appends what the replay found, which stands in falling order.
    fn append(&mut self, new: Range<usize>, found: Found) {
        self.parts.extend(found.parts.into_iter().rev());
        let mut end = found.needs.len();
        for ((step, parent), &count) in
            new.zip(found.parents.into_iter().rev()).zip(found.need_counts.iter().rev())
        {
            let first = end - count as usize;
            self.needs.extend_from_slice(&found.needs[first..end]);
            self.first_needs.push(self.needs.len() as u32);
            end = first;
            self.parents.push(parent);
            self.first_children.push(NONE);
            let list = match parent {
                NONE => &mut self.first_root,
                parent => &mut self.first_children[parent as usize],
            };
            self.next_siblings.push(std::mem::replace(list, step as u32));
        }
    }

    /// Widens parts so that each step's holds those of the new steps below it.
    fn nest(&mut self, new: Range<usize>) {
        for step in new.clone().rev() {
            let (mut below, mut parent) = (step, self.parents[step]);
            while parent != NONE {
                let (older, newer) = self.parts.split_at_mut(below);
                let has_changed = widen(&mut older[parent as usize], &newer[0]);
                // A new parent passes its part on when its own turn comes.
                if !has_changed || parent as usize >= new.start {
                    break;
                }
                (below, parent) = (parent as usize, self.parents[parent as usize]);
            }
        }
    }
}

/// Widens a part so that it holds one below it; returns whether that changed it.
fn widen(part: &mut Part, below: &Part) -> bool {
    let radius = part.sphere.with_sphere(&below.sphere).radius;
    let cone = part.cone.with_cone(&below.cone);
    let error = part.error.max(below.error);
    // A cone that keeps its angle keeps its axis.
    let has_changed = radius > part.sphere.radius || cone.cos < part.cone.cos || error > part.error;
    if has_changed {
        (part.sphere.radius, part.cone, part.error) = (radius, cone, error);
    }
    has_changed
}

/// The triangles that come or go with a step.
#[derive(Default)]
struct Change {
    center: [f32; 3],
    /// Square of the distance of the farthest corner from the center.
    square: f64,
    normals: Vec<DVec3>,
}

impl Change {
    fn begin(&mut self, center: [f32; 3]) {
        (self.center, self.square) = (center, 0.0);
        self.normals.clear();
    }

    // Corners one by one: arrays of them that go through memory cost half of the time of growing.
    #[inline(always)]
    fn add(&mut self, positions: &[[f32; 3]], [a, b, c]: [u32; 3]) {
        let center = place(self.center);
        let a = place(positions[a as usize]) - center;
        let b = place(positions[b as usize]) - center;
        let c = place(positions[c as usize]) - center;
        self.square = self.square.max(a.length_squared()).max(b.length_squared()).max(c.length_squared());
        self.normals.extend((b - a).cross(c - a).try_normalize());
    }

    fn part(&self, error: f32) -> Part {
        // Rounded up, so that the farthest corner is held.
        let radius = if self.square > 0.0 { (self.square.sqrt() as f32).next_up() } else { 0.0 };
        let sphere = Sphere { center: self.center, radius };
        let cone = NormalCone::of_normals(self.normals.iter().map(DVec3::to_array));
        Part { sphere, cone, error }
    }
}

#[inline(always)]
fn place([x, y, z]: [f32; 3]) -> DVec3 {
    DVec3::new(x.into(), y.into(), z.into())
}

/// What the replay finds of each step, last step first.
#[derive(Default)]
struct Found {
    parents: Vec<u32>,
    need_counts: Vec<u32>,
    needs: Vec<u32>,
    parts: Vec<Part>,
}

/// The triangles that new steps have changed or added, chained by their new vertices.
struct Replay<'m> {
    mesh: PrefixMesh<'m>,
    first_new_vertex: u32,
    /// Corners at the level that the replay has come to.
    corners: Vec<[u32; 3]>,
    /// The last step whose star each triangle was in.
    stars: Vec<u32>,
    /// First link of each new vertex. A link is a triangle times three and the corner that has the vertex.
    heads: Vec<u32>,
    next: Vec<[u32; 3]>,
    star: Vec<u32>,
    change: Change,
}

impl<'m> Replay<'m> {
    fn new(mesh: &PrefixMesh<'m>, first_step: usize, triangles: impl Iterator<Item = u32>) -> Self {
        let first_new_vertex = mesh.vertex_count_at(first_step) as u32;
        let mut replay = Self {
            mesh: *mesh,
            first_new_vertex,
            corners: Vec::new(),
            stars: Vec::new(),
            heads: vec![NONE; mesh.positions.len() - first_new_vertex as usize],
            next: Vec::new(),
            star: Vec::new(),
            change: Change::default(),
        };
        for triangle in triangles {
            let corners = mesh.triangles[triangle as usize];
            if is_proper(&corners) && corners.iter().any(|&v| v >= first_new_vertex) {
                replay.corners.push(corners);
            }
        }
        replay.stars = vec![NONE; replay.corners.len()];
        replay.next = vec![[NONE; 3]; replay.corners.len()];
        for triangle in 0..replay.corners.len() {
            (0..3).for_each(|corner| replay.link(triangle, corner));
        }
        replay
    }

    /// Chains a triangle to the vertex at one of its corners, if that is a new one.
    fn link(&mut self, triangle: usize, corner: usize) {
        let vertex = self.corners[triangle][corner];
        if let Some(new) = vertex.checked_sub(self.first_new_vertex) {
            let link = (3 * triangle + corner) as u32;
            self.next[triangle][corner] = std::mem::replace(&mut self.heads[new as usize], link);
        }
    }

    /// Undoes a step: finds what it needs, its parent, and what it changes.
    fn collapse(&mut self, hierarchy: &GrowingHierarchy, step: usize, found: &mut Found) {
        let vertices = self.mesh.step_vertices(step);
        self.gather_star(step, vertices.clone());
        self.change.begin(self.mesh.positions[vertices.start as usize]);
        let first_need = found.needs.len();
        let mut parent = None;
        for at in 0..self.star.len() {
            let triangle = self.star[at] as usize;
            let star = self.corners[triangle];
            let floor = star.map(|v| if vertices.contains(&v) { self.target(v) } else { v });
            let around = star.iter().filter(|v| !vertices.contains(v));
            found.needs.extend(around.filter_map(|&v| hierarchy.step_of(v)));
            self.change.add(self.mesh.positions, star);
            if is_proper(&floor) {
                let youngest = floor[0].max(floor[1]).max(floor[2]);
                // As the base is older than all steps, none is less than any step.
                let above = hierarchy.step_of(youngest);
                parent = Some(parent.map_or(above, |parent: Option<u32>| parent.min(above)));
                self.change.add(self.mesh.positions, floor);
            }
            self.replace(triangle, floor);
        }
        if parent.is_some() {
            found.needs.extend(hierarchy.step_of(self.target(vertices.start)));
        }
        dedup_from(&mut found.needs, first_need);
        shorten_from(&mut found.needs, first_need, found.parents.len());
        found.need_counts.push((found.needs.len() - first_need) as u32);
        found.parents.push(parent.flatten().unwrap_or(NONE));
    }

    fn target(&self, vertex: u32) -> u32 {
        self.mesh.targets[vertex as usize - self.mesh.base_vertex_count()]
    }

    /// Finds the triangles around a step's vertices, each once, also where wedges of the position meet in it.
    fn gather_star(&mut self, step: usize, vertices: Range<u32>) {
        self.star.clear();
        for vertex in vertices {
            let mut link = self.heads[(vertex - self.first_new_vertex) as usize];
            while link != NONE {
                let (triangle, corner) = (link as usize / 3, link as usize % 3);
                if is_proper(&self.corners[triangle]) && self.stars[triangle] != step as u32 {
                    self.stars[triangle] = step as u32;
                    self.star.push(triangle as u32);
                }
                link = self.next[triangle][corner];
            }
        }
    }

    /// Gives a triangle the corners that it has without the step.
    fn replace(&mut self, triangle: usize, floor: [u32; 3]) {
        let star = std::mem::replace(&mut self.corners[triangle], floor);
        if is_proper(&floor) {
            (0..3).filter(|&i| star[i] != floor[i]).for_each(|corner| self.link(triangle, corner));
        }
    }
}

/// Shortens the last list of needs if all of them together are longer than so many steps may have.
pub(super) fn shorten_from(needs: &mut Vec<u32>, first: usize, step_count: usize) {
    if needs.len() > MOST_NEEDS_A_STEP * step_count + SPARE_NEEDS && needs.len() > first {
        needs[first] = needs[needs.len() - 1] | ALL_THROUGH;
        needs.truncate(first + 1);
    }
}

/// Sorts the end of a list and drops repetitions from it.
fn dedup_from(list: &mut Vec<u32>, first: usize) {
    list[first..].sort_unstable();
    let mut kept = first;
    for at in first..list.len() {
        if at == first || list[at] != list[kept - 1] {
            list[kept] = list[at];
            kept += 1;
        }
    }
    list.truncate(kept);
}
