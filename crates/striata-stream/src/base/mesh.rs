//! The base mesh that the splits begin with.

use crate::topology::surface::{NONE, Surface, SurfaceDefect};

/// A closed surface of few triangles, its vertices numbered as on both sides: virtual ones, then copies of positions.
#[derive(Clone, Debug, Default)]
pub(crate) struct Base {
    /// Vertices that stand for boundary loops.
    pub(crate) virtual_count: u32,
    /// The position of each vertex that is not virtual; positions are met in order.
    pub(crate) position_of_copy: Vec<u32>,
    /// Triangles over virtual vertices and copies.
    pub(crate) triangles: Vec<[u32; 3]>,
    /// The corner across the edge that each corner faces, three a triangle.
    pub(crate) opposite: Vec<u32>,
    /// Grid coordinates of each position.
    pub(crate) places: Vec<[i32; 3]>,
    /// First vertex of the mesh of each position, closed by their number.
    pub(crate) first_vertex: Vec<u32>,
    /// The vertices of the mesh that the corners of each triangle show; none in virtual triangles.
    pub(crate) shown: Vec<[u32; 3]>,
    /// The group of each triangle.
    pub(crate) groups: Vec<u32>,
}

impl Base {
    /// Vertices of the surface.
    pub(crate) fn vertex_count(&self) -> usize {
        self.virtual_count as usize + self.position_of_copy.len()
    }

    /// The surface, or what is wrong with the triangles.
    pub(crate) fn surface(&self) -> Result<Surface, SurfaceDefect> {
        let vertex_count = self.vertex_count() as u32;
        for (t, triangle) in self.triangles.iter().enumerate() {
            let is_vertex = triangle.iter().all(|&v| v < vertex_count);
            let [a, b, c] = triangle.map(|v| self.position_of(v));
            // Two virtual corners count as one position as well: no boundary loops meet at an edge, and around a vertex
            // there are at least two triangles then.
            if !is_vertex || a == b || b == c || c == a {
                return Err(SurfaceDefect::Corners(t as u32));
            }
        }
        Surface::from_closed(&self.triangles, &self.opposite, vertex_count as usize, self.virtual_count)
    }

    /// The position of a vertex of the surface; none of virtual ones.
    pub(crate) fn position_of(&self, vertex: u32) -> u32 {
        let copy = vertex.checked_sub(self.virtual_count);
        copy.and_then(|copy| self.position_of_copy.get(copy as usize)).copied().unwrap_or(NONE)
    }

    /// Grid coordinates by vertex of the surface; zeros for virtual ones.
    pub(crate) fn surface_places(&self) -> Vec<[i32; 3]> {
        let virtual_places = std::iter::repeat_n([0; 3], self.virtual_count as usize);
        virtual_places.chain(self.position_of_copy.iter().map(|&p| self.places[p as usize])).collect()
    }

    /// Grid coordinates of a vertex of the surface that is not virtual.
    pub(crate) fn place(&self, vertex: u32) -> [i32; 3] {
        self.places[self.position_of_copy[(vertex - self.virtual_count) as usize] as usize]
    }

    /// Some vertex of the surface for each position.
    ///
    /// # Errors
    /// Where positions and vertices do not fit together.
    pub(crate) fn vertex_of_position(&self) -> Result<Vec<u32>, SurfaceDefect> {
        let mut vertices = vec![NONE; self.places.len()];
        for (copy, &position) in self.position_of_copy.iter().enumerate().rev() {
            let vertex = vertices.get_mut(position as usize).ok_or(SurfaceDefect::Position(position))?;
            *vertex = self.virtual_count + copy as u32;
        }
        match vertices.iter().position(|&v| v == NONE) {
            None => Ok(vertices),
            Some(position) => Err(SurfaceDefect::Position(position as u32)),
        }
    }

    /// What corners show where each position is one vertex and there are no groups.
    pub(crate) fn show_positions(&mut self) {
        self.first_vertex = (0..=self.places.len() as u32).collect();
        self.groups = vec![0; self.triangles.len()];
        let shown = self.triangles.iter().map(|t| {
            let positions = t.map(|v| self.position_of(v));
            if positions.contains(&NONE) { [NONE; 3] } else { positions }
        });
        self.shown = shown.collect();
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn two_virtual_corners_of_a_triangle_are_no_surface() {
        // Two cones over an edge from the virtual vertex to itself: one triangle around each tip.
        let cones = Base {
            virtual_count: 1,
            position_of_copy: vec![0, 1],
            triangles: vec![[1, 0, 0], [2, 0, 0]],
            opposite: vec![3, 2, 1, 0, 5, 4],
            places: vec![[0; 3], [9; 3]],
            ..Base::default()
        };
        assert_eq!(cones.surface().map(|_| ()), Err(SurfaceDefect::Corners(0)));
        let pillow = Base {
            virtual_count: 1,
            position_of_copy: vec![0, 1],
            triangles: vec![[1, 2, 0], [2, 1, 0]],
            opposite: vec![4, 3, 5, 1, 0, 2],
            places: vec![[0; 3], [9; 3]],
            ..Base::default()
        };
        assert_eq!(pillow.surface().map(|s| s.vertex_count()), Ok(3));
    }
}
