//! Collapses as fragments: what stands around the removed position, and the same with the target in its place.

use crate::mesh::{CollapseSequence, IndexedMesh, RefinableMesh};

use super::{Face, Fragment, FragmentSequence, FragmentedMesh};

const NONE: u32 = u32::MAX;

impl FragmentedMesh {
    /// The fragments of a collapse sequence: its levels, and any other state that their order allows.
    ///
    /// The error of a floor is that of the level that its step leads to. Triangles with a corner twice, which such a mesh should not
    /// have, are left out.
    pub fn from_collapses(refinable: &RefinableMesh) -> Self {
        let RefinableMesh { mesh, sequence } = refinable;
        let mut stars = Stars::new(mesh);
        let mut fragments: Vec<Fragment> = Vec::with_capacity(sequence.step_count());
        for step in (0..sequence.step_count()).rev() {
            fragments.push(stars.collapse(sequence, step));
        }
        let base = stars.faces();
        let positions = sequence.positions().clone();
        let fragments = FragmentSequence::from_fragments(positions, base, fragments.into_iter().rev())
            .expect("what a collapse leaves is there when it is undone");
        Self { mesh: mesh.clone(), fragments }
    }
}

/// The current triangles, chained by each of their corners.
struct Stars {
    /// Group of each triangle.
    groups: Vec<u32>,
    triangles: Vec<[u32; 3]>,
    is_gone: Vec<bool>,
    /// First corner (three times the triangle, plus which) at each vertex.
    head: Vec<u32>,
    next: Vec<u32>,
    around: Vec<u32>,
}

impl Stars {
    fn new(mesh: &IndexedMesh) -> Self {
        let mut groups = vec![0; mesh.triangle_count()];
        for (number, group) in mesh.groups.iter().enumerate() {
            groups[group.range()].fill(number as u32);
        }
        let mut stars = Self {
            groups,
            triangles: mesh.triangles.clone(),
            is_gone: mesh.triangles.iter().map(|&[a, b, c]| a == b || b == c || c == a).collect(),
            head: vec![NONE; mesh.vertex_count()],
            next: vec![NONE; 3 * mesh.triangle_count()],
            around: Vec::new(),
        };
        for corner in (0..stars.next.len()).rev() {
            let v = stars.triangles[corner / 3][corner % 3] as usize;
            stars.next[corner] = std::mem::replace(&mut stars.head[v], corner as u32);
        }
        stars
    }

    fn face(&self, triangle: u32) -> Face {
        Face { corners: self.triangles[triangle as usize], group: self.groups[triangle as usize] }
    }

    fn faces(&self) -> Vec<Face> {
        let there = (0..self.triangles.len() as u32).filter(|&t| !self.is_gone[t as usize]);
        there.map(|t| self.face(t)).collect()
    }

    fn collapse(&mut self, sequence: &CollapseSequence, step: usize) -> Fragment {
        let own = sequence.step_vertices(step);
        self.around.clear();
        for v in own.clone() {
            self.hand_over(v, sequence.target(v));
        }
        self.around.sort_unstable();
        self.around.dedup();
        let mut fragment = Fragment { error: sequence.error_at(step), ..Fragment::default() };
        for i in 0..self.around.len() {
            let t = self.around[i];
            fragment.ceiling.push(self.face(t));
            let shown = |v: u32| if own.contains(&v) { sequence.target(v) } else { v };
            let [a, b, c] = self.triangles[t as usize].map(shown);
            self.triangles[t as usize] = [a, b, c];
            if a == b || b == c || c == a {
                self.is_gone[t as usize] = true;
            } else {
                fragment.floor.push(self.face(t));
            }
        }
        fragment
    }

    /// Gives the corners at `v` to `target`, those of triangles that are gone dropped, and lists their triangles.
    fn hand_over(&mut self, v: u32, target: u32) {
        let mut corner = self.head[v as usize];
        self.head[v as usize] = NONE;
        while corner != NONE {
            let following = self.next[corner as usize];
            if !self.is_gone[corner as usize / 3] {
                self.around.push(corner / 3);
                let head = &mut self.head[target as usize];
                self.next[corner as usize] = std::mem::replace(head, corner);
            }
            corner = following;
        }
    }
}
