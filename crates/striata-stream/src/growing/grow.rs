//! Appends steps to a hierarchy: a backward replay of the new steps finds their dependencies and bounds.
//!
//! The replay starts at the finest level, with the triangles that the new steps have changed or added. It
//! collapses the new steps from last to first, so the triangles at a vertex are exactly its star at the
//! level at which its step was refined.

use std::ops::Range;

use glam::DVec3;
use striata::view::{NormalCone, Part, Sphere};

use super::hierarchy::{ALL_UP_TO, GrowingHierarchy, NONE};
use crate::reader::prefix::{PrefixMesh, is_proper};

/// Maximum length of the dependency lists: an average per new step, plus a constant. Meshes need about 6
/// entries per step. A list that would exceed the total is replaced by one entry for its largest step and
/// all older ones, so that damaged streams cannot exhaust memory.
const MAX_DEPENDENCIES_PER_STEP: usize = 24;
const EXTRA_DEPENDENCIES: usize = 1 << 15;

impl GrowingHierarchy {
    /// Appends the steps that have been decoded since the last call.
    ///
    /// `changed` lists the older triangles whose corners have changed, without repetitions, as
    /// [`StreamUpdate`](crate::StreamUpdate) does; extra triangles are harmless. `error(step)` is the error
    /// in mesh units of the level just before the step is refined; it must not increase with the step.
    ///
    /// # Panics
    /// If the mesh is not the mesh of the last call with steps appended.
    pub fn grow(&mut self, mesh: &PrefixMesh<'_>, changed: &[u32], error: impl Fn(usize) -> f32) {
        if mesh.first_vertices.is_empty() {
            return;
        }
        let new = self.step_count()..mesh.step_count();
        let old_count = self.first_triangles.last().copied().unwrap_or(0);
        self.append_vertices(mesh, new.clone());
        let changed = changed.iter().copied().filter(|&t| t < old_count);
        let mut replay =
            GrowthReplay::new(mesh, new.start, changed.chain(old_count..mesh.triangles.len() as u32));
        let mut results = ReplayResults::default();
        for step in new.clone().rev() {
            replay.collapse(self, step, &mut results);
            results.parts.push(replay.bounds.part(error(step)));
        }
        self.append(new.clone(), results);
        self.nest_bounds(new);
    }

    fn append_vertices(&mut self, mesh: &PrefixMesh<'_>, new: Range<usize>) {
        if self.first_triangles.is_empty() {
            self.base_vertex_count = mesh.base_vertex_count() as u32;
            self.first_triangles.push(mesh.triangle_count_at(0) as u32);
            self.first_dependencies.push(0);
            self.first_root = NONE;
        }
        let mut triangle_count = self.first_triangles[new.start];
        for step in new {
            triangle_count += u32::from(mesh.added_triangle_counts[step]);
            self.first_triangles.push(triangle_count);
            self.steps.extend(mesh.step_vertices(step).map(|_| step as u32));
        }
    }

    /// Appends the results of the replay, which are in falling order of steps.
    fn append(&mut self, new: Range<usize>, results: ReplayResults) {
        self.parts.extend(results.parts.into_iter().rev());
        let mut end = results.dependencies.len();
        for ((step, parent), &count) in
            new.zip(results.parents.into_iter().rev()).zip(results.dependency_counts.iter().rev())
        {
            let first = end - count as usize;
            self.dependencies.extend_from_slice(&results.dependencies[first..end]);
            self.first_dependencies.push(self.dependencies.len() as u32);
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

    /// Widens bounds so that each step's bounds include those of the new steps below it.
    fn nest_bounds(&mut self, new: Range<usize>) {
        for step in new.clone().rev() {
            let (mut below, mut parent) = (step, self.parents[step]);
            while parent != NONE {
                let (older, newer) = self.parts.split_at_mut(below);
                let has_changed = widen(&mut older[parent as usize], &newer[0]);
                // A new parent passes its bounds on when the loop reaches it.
                if !has_changed || parent as usize >= new.start {
                    break;
                }
                (below, parent) = (parent as usize, self.parents[parent as usize]);
            }
        }
    }
}

/// Widens a part to include one below it; returns whether that changed it.
fn widen(part: &mut Part, below: &Part) -> bool {
    let radius = part.sphere.with_sphere(&below.sphere).radius;
    let cone = part.cone.with_cone(&below.cone);
    let error = part.error.max(below.error);
    // A cone that keeps its angle also keeps its axis.
    let has_changed = radius > part.sphere.radius || cone.cos < part.cone.cos || error > part.error;
    if has_changed {
        (part.sphere.radius, part.cone, part.error) = (radius, cone, error);
    }
    has_changed
}

/// Bounds of the triangles that a step adds, changes or removes.
#[derive(Default)]
struct BoundsBuilder {
    center: [f32; 3],
    /// Squared distance from the center to the farthest corner.
    radius_squared: f64,
    normals: Vec<DVec3>,
}

impl BoundsBuilder {
    fn begin(&mut self, center: [f32; 3]) {
        (self.center, self.radius_squared) = (center, 0.0);
        self.normals.clear();
    }

    // The corners are unrolled: passing them through arrays in memory costs half of the time of growing.
    #[inline(always)]
    fn add(&mut self, positions: &[[f32; 3]], [a, b, c]: [u32; 3]) {
        let center = to_dvec3(self.center);
        let a = to_dvec3(positions[a as usize]) - center;
        let b = to_dvec3(positions[b as usize]) - center;
        let c = to_dvec3(positions[c as usize]) - center;
        self.radius_squared =
            self.radius_squared.max(a.length_squared()).max(b.length_squared()).max(c.length_squared());
        self.normals.extend((b - a).cross(c - a).try_normalize());
    }

    fn part(&self, error: f32) -> Part {
        // Rounded up, so that the sphere includes the farthest corner.
        let radius =
            if self.radius_squared > 0.0 { (self.radius_squared.sqrt() as f32).next_up() } else { 0.0 };
        let sphere = Sphere { center: self.center, radius };
        let cone = NormalCone::of_normals(self.normals.iter().map(DVec3::to_array));
        Part { sphere, cone, error }
    }
}

#[inline(always)]
fn to_dvec3([x, y, z]: [f32; 3]) -> DVec3 {
    DVec3::new(x.into(), y.into(), z.into())
}

/// Results of the replay for each new step, last step first.
#[derive(Default)]
struct ReplayResults {
    parents: Vec<u32>,
    dependency_counts: Vec<u32>,
    dependencies: Vec<u32>,
    parts: Vec<Part>,
}

/// The triangles that new steps have changed or added, in linked lists by new vertex.
struct GrowthReplay<'m> {
    mesh: PrefixMesh<'m>,
    first_new_vertex: u32,
    /// Corners at the level that the replay has reached.
    corners: Vec<[u32; 3]>,
    /// The step whose star last contained each triangle.
    last_star_step: Vec<u32>,
    /// First link of each new vertex's list. A link is three times the triangle plus the corner at which
    /// the vertex is.
    heads: Vec<u32>,
    next: Vec<[u32; 3]>,
    star: Vec<u32>,
    bounds: BoundsBuilder,
}

impl<'m> GrowthReplay<'m> {
    fn new(mesh: &PrefixMesh<'m>, first_step: usize, triangles: impl Iterator<Item = u32>) -> Self {
        let first_new_vertex = mesh.vertex_count_at(first_step) as u32;
        let mut replay = Self {
            mesh: *mesh,
            first_new_vertex,
            corners: Vec::new(),
            last_star_step: Vec::new(),
            heads: vec![NONE; mesh.positions.len() - first_new_vertex as usize],
            next: Vec::new(),
            star: Vec::new(),
            bounds: BoundsBuilder::default(),
        };
        for triangle in triangles {
            let corners = mesh.triangles[triangle as usize];
            if is_proper(&corners) && corners.iter().any(|&v| v >= first_new_vertex) {
                replay.corners.push(corners);
            }
        }
        replay.last_star_step = vec![NONE; replay.corners.len()];
        replay.next = vec![[NONE; 3]; replay.corners.len()];
        for triangle in 0..replay.corners.len() {
            (0..3).for_each(|corner| replay.link(triangle, corner));
        }
        replay
    }

    /// Links a triangle to the vertex at one of its corners, if that vertex is new.
    fn link(&mut self, triangle: usize, corner: usize) {
        let vertex = self.corners[triangle][corner];
        if let Some(new) = vertex.checked_sub(self.first_new_vertex) {
            let link = (3 * triangle + corner) as u32;
            self.next[triangle][corner] = std::mem::replace(&mut self.heads[new as usize], link);
        }
    }

    /// Undoes a step and records its dependencies, its parent and its bounds.
    fn collapse(&mut self, hierarchy: &GrowingHierarchy, step: usize, results: &mut ReplayResults) {
        let vertices = self.mesh.step_vertices(step);
        self.gather_star(step, vertices.clone());
        self.bounds.begin(self.mesh.positions[vertices.start as usize]);
        let first_dependency = results.dependencies.len();
        let mut parent = None;
        for at in 0..self.star.len() {
            let triangle = self.star[at] as usize;
            let star = self.corners[triangle];
            let floor = star.map(|v| if vertices.contains(&v) { self.target(v) } else { v });
            let around = star.iter().filter(|v| !vertices.contains(v));
            results.dependencies.extend(around.filter_map(|&v| hierarchy.step_of(v)));
            self.bounds.add(self.mesh.positions, star);
            if is_proper(&floor) {
                let youngest = floor[0].max(floor[1]).max(floor[2]);
                // `None`, a vertex of the base, compares less than any step.
                let above = hierarchy.step_of(youngest);
                parent = Some(parent.map_or(above, |parent: Option<u32>| parent.min(above)));
                self.bounds.add(self.mesh.positions, floor);
            }
            self.replace(triangle, floor);
        }
        if parent.is_some() {
            results.dependencies.extend(hierarchy.step_of(self.target(vertices.start)));
        }
        dedup_from(&mut results.dependencies, first_dependency);
        limit_dependencies(&mut results.dependencies, first_dependency, results.parents.len());
        results.dependency_counts.push((results.dependencies.len() - first_dependency) as u32);
        results.parents.push(parent.flatten().unwrap_or(NONE));
    }

    fn target(&self, vertex: u32) -> u32 {
        self.mesh.targets[vertex as usize - self.mesh.base_vertex_count()]
    }

    /// Gathers the triangles around a step's vertices, each once even if several of its corners are wedges
    /// of the position.
    fn gather_star(&mut self, step: usize, vertices: Range<u32>) {
        self.star.clear();
        for vertex in vertices {
            let mut link = self.heads[(vertex - self.first_new_vertex) as usize];
            while link != NONE {
                let (triangle, corner) = (link as usize / 3, link as usize % 3);
                if is_proper(&self.corners[triangle]) && self.last_star_step[triangle] != step as u32 {
                    self.last_star_step[triangle] = step as u32;
                    self.star.push(triangle as u32);
                }
                link = self.next[triangle][corner];
            }
        }
    }

    /// Sets a triangle's corners to those that it has before the step.
    fn replace(&mut self, triangle: usize, floor: [u32; 3]) {
        let star = std::mem::replace(&mut self.corners[triangle], floor);
        if is_proper(&floor) {
            (0..3).filter(|&i| star[i] != floor[i]).for_each(|corner| self.link(triangle, corner));
        }
    }
}

/// Replaces the last list of dependencies by a single entry if all lists together exceed the maximum.
pub(super) fn limit_dependencies(dependencies: &mut Vec<u32>, first: usize, step_count: usize) {
    if dependencies.len() > MAX_DEPENDENCIES_PER_STEP * step_count + EXTRA_DEPENDENCIES
        && dependencies.len() > first
    {
        dependencies[first] = dependencies[dependencies.len() - 1] | ALL_UP_TO;
        dependencies.truncate(first + 1);
    }
}

/// Sorts the list from index `first` on and removes duplicates there.
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
