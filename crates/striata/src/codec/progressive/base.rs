//! The base mesh that the splits begin with.

use super::super::entropy::Coder;
use super::surface::{Surface, SurfaceDefect};

/// A closed surface of few triangles, its vertices numbered as on both sides: virtual ones, then copies of positions.
#[derive(Clone, Debug, Default)]
pub(super) struct Base {
    /// Vertices that stand for boundary loops.
    pub(super) virtual_count: u32,
    /// The position of each vertex that is not virtual; positions are met in order.
    pub(super) position_of_copy: Vec<u32>,
    /// Triangles over virtual vertices and copies.
    pub(super) triangles: Vec<[u32; 3]>,
    /// Grid coordinates of each position.
    pub(super) places: Vec<[i32; 3]>,
}

impl Base {
    /// Vertices of the surface.
    pub(super) fn vertex_count(&self) -> usize {
        self.virtual_count as usize + self.position_of_copy.len()
    }

    /// The surface, or what is wrong with the triangles.
    pub(super) fn surface(&self) -> Result<Surface, SurfaceDefect> {
        Surface::from_closed(&self.triangles, self.vertex_count(), self.virtual_count)
    }

    /// Grid coordinates by vertex of the surface; zeros for virtual ones.
    pub(super) fn surface_places(&self) -> Vec<[i32; 3]> {
        let virtual_places = std::iter::repeat_n([0; 3], self.virtual_count as usize);
        virtual_places.chain(self.position_of_copy.iter().map(|&p| self.places[p as usize])).collect()
    }

    /// Codes all of it, counts first.
    pub(super) fn code<C: Coder>(&mut self, coder: &mut C) {
        let counts = [
            self.virtual_count,
            self.position_of_copy.len() as u32,
            self.triangles.len() as u32,
            self.places.len() as u32,
        ];
        let counts = counts.map(|n| coder.raw(n, 24));
        self.virtual_count = counts[0];
        self.position_of_copy.resize(counts[1] as usize, 0);
        self.triangles.resize(counts[2] as usize, [0; 3]);
        self.places.resize(counts[3] as usize, [0; 3]);
        for value in &mut self.position_of_copy {
            *value = coder.raw(*value, 24);
        }
        for value in self.triangles.as_flattened_mut() {
            *value = coder.raw(*value, 24);
        }
        for value in self.places.as_flattened_mut() {
            *value = coder.raw(*value as u32, 24) as i32;
        }
    }
}
