//! A second way to cut a level: over the assembled mesh as a whole, step by step. It is slow and simple, and serves as
//! the oracle of [`striata_paged::CutPages`].

use std::collections::BTreeMap;

use striata::view::{NormalCone, Part, Sphere};
use striata_paged::Assembled;

const NONE: u32 = u32::MAX;

/// Triangles by the bits of their positions, with attributes as bytes, and how many there are of each.
pub(crate) type Soup = BTreeMap<[(Vec<u32>, Vec<u8>); 3], i32>;

/// A level: its triangles, and the number of refined steps.
pub(crate) struct ReferenceCut {
    /// The triangles.
    pub soup: Soup,
    /// Number of steps that are refined.
    pub refined_count: usize,
    /// Largest error of a step that is not refined.
    pub error: f32,
}

/// Adds a triangle to a soup.
pub(crate) fn add(soup: &mut Soup, corners: [(Vec<u32>, Vec<u8>); 3]) {
    let first = (0..3).min_by_key(|&i| &corners[i]).unwrap();
    *soup.entry([0, 1, 2].map(|i| corners[(first + i) % 3].clone())).or_default() += 1;
}

/// All triangles of a mesh.
pub(crate) fn soup_of(mesh: &striata::mesh::IndexedMesh) -> Soup {
    let mut soup = Soup::new();
    mesh.triangles.iter().for_each(|t| add(&mut soup, t.map(|v| value(mesh, v))));
    soup
}

fn value(mesh: &striata::mesh::IndexedMesh, v: u32) -> (Vec<u32>, Vec<u8>) {
    let bytes = mesh.layers.iter().flat_map(|layer| {
        let n = layer.vertex_bytes();
        layer.data.as_bytes()[v as usize * n..][..n].to_vec()
    });
    (mesh.positions[v as usize].map(f32::to_bits).to_vec(), bytes.collect())
}

/// The triangles at each position while steps are undone.
struct Surface<'a> {
    assembled: &'a Assembled,
    corners: Vec<[u32; 3]>,
    is_alive: Vec<bool>,
    head: Vec<u32>,
    tail: Vec<u32>,
    next: Vec<u32>,
    star: Vec<u32>,
}

impl<'a> Surface<'a> {
    fn new(assembled: &'a Assembled) -> Self {
        let mesh = &assembled.refinable.mesh;
        let positions = assembled.refinable.sequence.positions();
        let mut surface = Self {
            assembled,
            corners: mesh.triangles.clone(),
            is_alive: vec![true; mesh.triangles.len()],
            head: vec![NONE; positions.position_count()],
            tail: vec![NONE; positions.position_count()],
            next: vec![NONE; 3 * mesh.triangles.len()],
            star: Vec::new(),
        };
        for (corner, &v) in (0..).zip(mesh.triangles.as_flattened()) {
            surface.link(positions.position_of(v), corner);
        }
        surface
    }

    fn link(&mut self, position: u32, corner: u32) {
        match self.tail[position as usize] {
            NONE => self.head[position as usize] = corner,
            last => self.next[last as usize] = corner,
        }
        self.tail[position as usize] = corner;
    }

    /// Finds the corners at a position.
    fn gather(&mut self, position: u32) {
        self.star.clear();
        let mut corner = std::mem::replace(&mut self.head[position as usize], NONE);
        self.tail[position as usize] = NONE;
        while corner != NONE {
            let next = std::mem::replace(&mut self.next[corner as usize], NONE);
            // Triangles that are gone leave the list, or hubs would be searched again and again.
            if self.is_alive[corner as usize / 3] {
                self.star.push(corner);
                self.link(position, corner);
            }
            corner = next;
        }
    }

    /// Squared length of the longest edge at the gathered position.
    fn radius_squared(&self, center: [f32; 3]) -> f32 {
        let positions = &self.assembled.refinable.mesh.positions;
        let ring = self.star.iter().flat_map(|&corner| self.corners[corner as usize / 3]);
        let squared = |v: u32| (0..3).map(|a| (positions[v as usize][a] - center[a]).powi(2)).sum::<f32>();
        ring.map(squared).fold(0.0, f32::max)
    }

    /// Undoes the step of the gathered position.
    fn collapse(&mut self) {
        let sequence = &self.assembled.refinable.sequence;
        let star = std::mem::take(&mut self.star);
        for &corner in &star {
            let t = corner as usize / 3;
            let slot = corner as usize % 3;
            let target = sequence.target(self.corners[t][slot]);
            self.corners[t][slot] = target;
            let at = self.corners[t].map(|v| sequence.positions().position_of(v));
            self.is_alive[t] = at[0] != at[1] && at[1] != at[2] && at[2] != at[0];
        }
        for &corner in &star {
            if !self.is_alive[corner as usize / 3] {
                continue;
            }
            let v = self.corners[corner as usize / 3][corner as usize % 3];
            self.next[corner as usize] = NONE;
            self.link(sequence.positions().position_of(v), corner);
        }
        self.star = star;
    }
}

/// Makes the coarsest level that refines every wanted step, and what these need.
pub(crate) fn reference_cut(assembled: &Assembled, is_wanted: impl Fn(&Part) -> bool) -> ReferenceCut {
    let sequence = &assembled.refinable.sequence;
    let base = sequence.base_position_count();
    let mut surface = Surface::new(assembled);
    let mut is_kept = vec![false; sequence.positions().position_count()];
    let (mut refined_count, mut error) = (0, 0.0f32);
    for step in (0..sequence.step_count()).rev() {
        let position = (base + step) as u32;
        surface.gather(position);
        let first = sequence.positions().first_vertex(position);
        let center = assembled.refinable.mesh.positions[first as usize];
        let sphere = Sphere { center, radius: surface.radius_squared(center).sqrt() };
        let part = Part { sphere, cone: NormalCone::ALL, error: assembled.step_errors[step] };
        if !is_kept[position as usize] && !is_wanted(&part) {
            error = error.max(part.error);
            surface.collapse();
            continue;
        }
        refined_count += 1;
        let target = sequence.positions().position_of(sequence.target(first));
        is_kept[target as usize] = true;
        for &corner in &surface.star {
            for v in surface.corners[corner as usize / 3] {
                is_kept[sequence.positions().position_of(v) as usize] = true;
            }
        }
    }
    let mut soup = Soup::new();
    for (corners, _) in surface.corners.iter().zip(&surface.is_alive).filter(|(_, is_alive)| **is_alive) {
        add(&mut soup, corners.map(|v| value(&assembled.refinable.mesh, v)));
    }
    ReferenceCut { soup, refined_count, error }
}
