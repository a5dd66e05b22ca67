//! Conversion of collapses to fragments: the triangles around a removed position, before and after its
//! collapse.

use crate::mesh::{CollapseSequence, IndexedMesh, RefinableMesh};

use super::{Face, Fragment, FragmentSequence, FragmentedMesh};

const NONE: u32 = u32::MAX;

impl FragmentedMesh {
    /// Converts a collapse sequence to fragments, which allow the same levels and any other state that the
    /// order of the steps permits.
    ///
    /// The error of a floor is the error of the level that the collapse leads to. Degenerate triangles,
    /// which such a mesh should not contain, are left out.
    pub fn from_collapses(refinable: &RefinableMesh) -> Self {
        let RefinableMesh { mesh, sequence } = refinable;
        let mut stars = VertexStars::new(mesh);
        let mut fragments: Vec<Fragment> = Vec::with_capacity(sequence.step_count());
        for step in (0..sequence.step_count()).rev() {
            fragments.push(stars.collapse(sequence, step));
        }
        let base = stars.faces();
        let positions = sequence.positions().clone();
        let fragments = FragmentSequence::from_fragments(positions, base, fragments.into_iter().rev())
            .expect("the floor of a collapse exists when the collapse is undone");
        Self { mesh: mesh.clone(), fragments }
    }
}

/// The current triangles, with a linked list of corners for each vertex.
struct VertexStars {
    /// Group of each triangle.
    groups: Vec<u32>,
    triangles: Vec<[u32; 3]>,
    is_removed: Vec<bool>,
    /// First corner (`3 * triangle + k`) of each vertex's list.
    head: Vec<u32>,
    next: Vec<u32>,
    around: Vec<u32>,
}

impl VertexStars {
    fn new(mesh: &IndexedMesh) -> Self {
        let mut groups = vec![0; mesh.triangle_count()];
        for (index, group) in mesh.groups.iter().enumerate() {
            groups[group.range()].fill(index as u32);
        }
        let mut stars = Self {
            groups,
            triangles: mesh.triangles.clone(),
            is_removed: mesh.triangles.iter().map(|&[a, b, c]| a == b || b == c || c == a).collect(),
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
        let present = (0..self.triangles.len() as u32).filter(|&t| !self.is_removed[t as usize]);
        present.map(|t| self.face(t)).collect()
    }

    fn collapse(&mut self, sequence: &CollapseSequence, step: usize) -> Fragment {
        let own = sequence.step_vertices(step);
        self.around.clear();
        for v in own.clone() {
            self.move_corners(v, sequence.target(v));
        }
        self.around.sort_unstable();
        self.around.dedup();
        let mut fragment = Fragment { error: sequence.error_at(step), ..Fragment::default() };
        for i in 0..self.around.len() {
            let t = self.around[i];
            fragment.ceiling.push(self.face(t));
            let substitute = |v: u32| if own.contains(&v) { sequence.target(v) } else { v };
            let [a, b, c] = self.triangles[t as usize].map(substitute);
            self.triangles[t as usize] = [a, b, c];
            if a == b || b == c || c == a {
                self.is_removed[t as usize] = true;
            } else {
                fragment.floor.push(self.face(t));
            }
        }
        fragment
    }

    /// Moves the corners of `v` to the list of `target`, dropping those of removed triangles, and collects
    /// the triangles.
    fn move_corners(&mut self, v: u32, target: u32) {
        let mut corner = self.head[v as usize];
        self.head[v as usize] = NONE;
        while corner != NONE {
            let following = self.next[corner as usize];
            if !self.is_removed[corner as usize / 3] {
                self.around.push(corner / 3);
                let head = &mut self.head[target as usize];
                self.next[corner as usize] = std::mem::replace(head, corner);
            }
            corner = following;
        }
    }
}
