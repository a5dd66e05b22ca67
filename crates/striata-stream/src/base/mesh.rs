//! [`Base`]: the base mesh that the splits refine.

use crate::topology::surface::{NONE, Surface, SurfaceDefect};

/// A small closed surface. Its vertices are numbered alike on both sides: virtual ones first, then copies
/// of positions.
#[derive(Clone, Debug, Default)]
pub(crate) struct Base {
    /// Number of virtual vertices, each of which closes a boundary loop.
    pub virtual_count: u32,
    /// Position of each vertex that is not virtual; positions are numbered by first use.
    pub position_of_copy: Vec<u32>,
    /// Triangles over surface vertices, virtual or not.
    pub triangles: Vec<[u32; 3]>,
    /// For each corner (three per triangle), the corner across the edge that it faces.
    pub opposite: Vec<u32>,
    /// Grid coordinates of each position.
    pub grid_points: Vec<[i32; 3]>,
    /// First mesh vertex (wedge) of each position, followed by the number of mesh vertices.
    pub first_vertex: Vec<u32>,
    /// Mesh vertices of each triangle's corners; `NONE` in virtual triangles.
    pub corner_vertices: Vec<[u32; 3]>,
    /// Group of each triangle.
    pub groups: Vec<u32>,
}

impl Base {
    /// Returns the number of surface vertices.
    pub(crate) fn vertex_count(&self) -> usize {
        self.virtual_count as usize + self.position_of_copy.len()
    }

    /// Builds the surface.
    ///
    /// # Errors
    /// [`SurfaceDefect`] if the triangles do not form a closed surface.
    pub(crate) fn surface(&self) -> Result<Surface, SurfaceDefect> {
        let vertex_count = self.vertex_count() as u32;
        for (t, triangle) in self.triangles.iter().enumerate() {
            let is_vertex = triangle.iter().all(|&v| v < vertex_count);
            let [a, b, c] = triangle.map(|v| self.position_of(v));
            // Two virtual corners count as one position, too. So no two boundary loops meet at an edge, and
            // every vertex has at least two triangles.
            if !is_vertex || a == b || b == c || c == a {
                return Err(SurfaceDefect::Corners(t as u32));
            }
        }
        Surface::from_closed(&self.triangles, &self.opposite, vertex_count as usize, self.virtual_count)
    }

    /// Returns the position of a surface vertex, or `NONE` if it is virtual.
    pub(crate) fn position_of(&self, vertex: u32) -> u32 {
        let copy = vertex.checked_sub(self.virtual_count);
        copy.and_then(|copy| self.position_of_copy.get(copy as usize)).copied().unwrap_or(NONE)
    }

    /// Returns the grid coordinates of each surface vertex; zeros for virtual ones.
    pub(crate) fn surface_grid_points(&self) -> Vec<[i32; 3]> {
        let virtual_points = std::iter::repeat_n([0; 3], self.virtual_count as usize);
        virtual_points.chain(self.position_of_copy.iter().map(|&p| self.grid_points[p as usize])).collect()
    }

    /// Returns the grid coordinates of a surface vertex that is not virtual.
    pub(crate) fn grid_point(&self, vertex: u32) -> [i32; 3] {
        self.grid_points[self.position_of_copy[(vertex - self.virtual_count) as usize] as usize]
    }

    /// Returns one surface vertex for each position.
    ///
    /// # Errors
    /// [`SurfaceDefect::Position`] if a vertex has an unknown position, or a position has no vertex.
    pub(crate) fn vertex_of_position(&self) -> Result<Vec<u32>, SurfaceDefect> {
        let mut vertices = vec![NONE; self.grid_points.len()];
        for (copy, &position) in self.position_of_copy.iter().enumerate().rev() {
            let vertex = vertices.get_mut(position as usize).ok_or(SurfaceDefect::Position(position))?;
            *vertex = self.virtual_count + copy as u32;
        }
        match vertices.iter().position(|&v| v == NONE) {
            None => Ok(vertices),
            Some(position) => Err(SurfaceDefect::Position(position as u32)),
        }
    }

    /// Fills in one mesh vertex per position and a single group, for meshes without seams or groups.
    pub(crate) fn use_one_vertex_per_position(&mut self) {
        self.first_vertex = (0..=self.grid_points.len() as u32).collect();
        self.groups = vec![0; self.triangles.len()];
        let corner_vertices = self.triangles.iter().map(|t| {
            let positions = t.map(|v| self.position_of(v));
            if positions.contains(&NONE) { [NONE; 3] } else { positions }
        });
        self.corner_vertices = corner_vertices.collect();
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn triangles_with_two_virtual_corners_are_rejected() {
        // Two cones over an edge from the virtual vertex to itself: a single triangle around each tip.
        let cones = Base {
            virtual_count: 1,
            position_of_copy: vec![0, 1],
            triangles: vec![[1, 0, 0], [2, 0, 0]],
            opposite: vec![3, 2, 1, 0, 5, 4],
            grid_points: vec![[0; 3], [9; 3]],
            ..Base::default()
        };
        assert_eq!(cones.surface().map(|_| ()), Err(SurfaceDefect::Corners(0)));
        let pillow = Base {
            virtual_count: 1,
            position_of_copy: vec![0, 1],
            triangles: vec![[1, 2, 0], [2, 1, 0]],
            opposite: vec![4, 3, 5, 1, 0, 2],
            grid_points: vec![[0; 3], [9; 3]],
            ..Base::default()
        };
        assert_eq!(pillow.surface().map(|s| s.vertex_count()), Ok(3));
    }
}
