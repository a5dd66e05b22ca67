//! The surroundings of a new vertex in local units.
//!
//! All coordinates are relative to the center of the ring and shifted so that the ring's radius has
//! eleven bits. They then fit in 16 bits, and the widths of densities are constants.

use crate::topology::neighborhood::Neighborhood;
use crate::topology::surface::next;

/// Maximum number of ring vertices that are used, one per lane.
pub(super) const LANES: usize = 8;
/// Limit of local coordinates.
const REACH: i64 = 12_000;

/// A point in local units.
pub(super) type Point = [i32; 3];

/// The surroundings of a new vertex in local units.
#[derive(Clone, Debug, Default)]
pub(super) struct LocalRing {
    /// Grid coordinates of the ring's center, the local origin.
    pub origin: [i32; 3],
    /// Local units are grid units times 2 to this power, which is at least -16.
    pub shift: i32,
    /// Scale of local units as a factor, in 1/65536.
    pub factor: i64,
    /// Root mean square distance of the ring from its center, in local units: 1024 to 2047.
    pub radius: i32,
    /// Vertices of the ring.
    pub ids: [u32; LANES],
    /// Their positions; `None` for virtual vertices.
    pub ring: [Option<Point>; LANES],
    /// The vertex across each ring edge, if it is known.
    pub apexes: [Option<Point>; LANES],
    /// Number of entries in these lists.
    pub count: usize,
}

impl LocalRing {
    /// Gathers the surroundings of a vertex.
    pub(super) fn gather(&mut self, neighborhood: &Neighborhood<'_>) {
        self.count = neighborhood.corners.len().min(LANES);
        let mut known = [[0; 3]; LANES];
        let mut known_count = 0;
        let mut coords = [None; LANES];
        for (i, &corner) in neighborhood.corners[..self.count].iter().enumerate() {
            self.ids[i] = neighborhood.surface.vertex(next(corner));
            coords[i] = neighborhood.coords_of(self.ids[i]);
            if let Some(coords) = coords[i] {
                known[known_count] = coords;
                known_count += 1;
            }
        }
        self.measure(&known[..known_count]);
        for (i, &coords) in coords[..self.count].iter().enumerate() {
            self.ring[i] = coords.map(|p| self.to_local(p));
        }
        for (i, &corner) in neighborhood.corners[..self.count].iter().enumerate() {
            let across = neighborhood.surface.opposite(corner);
            self.apexes[i] = self.find(neighborhood, neighborhood.surface.vertex(across));
        }
    }

    /// Returns the local position of a vertex, if it is known.
    fn find(&self, neighborhood: &Neighborhood<'_>, vertex: u32) -> Option<Point> {
        neighborhood.coords_of(vertex).map(|p| self.to_local(p))
    }

    /// Computes the origin, scale and radius from the known ring vertices.
    fn measure(&mut self, known: &[[i32; 3]]) {
        let inverse = 65_536 / known.len().max(1) as i64;
        let first = known.first().copied().unwrap_or_default();
        let off = |p: &[i32; 3], from: &[i32; 3], a: usize| i64::from(p[a].wrapping_sub(from[a]));
        self.origin = std::array::from_fn(|a| {
            let sum: i64 = known.iter().map(|p| off(p, &first, a)).sum();
            first[a].wrapping_add(((sum * inverse + 32_768) >> 16) as i32)
        });
        // Grids have fewer bits than this limit, and the squares can be summed without overflow.
        let square = |p: &[i32; 3], a: usize| off(p, &self.origin, a).clamp(-1 << 21, 1 << 21).pow(2);
        let sum: i64 = known.iter().map(|p| square(p, 0) + square(p, 1) + square(p, 2)).sum();
        // In 1/16 grid units, clamped so that the radius is not zero.
        let mean = ((sum * inverse) >> 8).max(64) as u64;
        let spare = mean.ilog2().saturating_sub(30).div_ceil(2);
        let radius = ((mean >> (2 * spare)) as u32).isqrt() << spare;
        self.shift = 14 - radius.ilog2() as i32;
        self.factor = 1 << (16 + self.shift);
        self.radius = ((i64::from(radius) * self.factor) >> 20) as i32;
    }

    /// Converts grid coordinates to local units.
    #[inline]
    pub(super) fn to_local(&self, coords: [i32; 3]) -> Point {
        [0, 1, 2].map(|a| self.to_local_axis(coords[a], a))
    }

    /// Converts one grid coordinate to local units.
    #[inline]
    pub(super) fn to_local_axis(&self, coordinate: i32, axis: usize) -> i32 {
        let off = i64::from(coordinate.wrapping_sub(self.origin[axis]));
        ((off * self.factor) >> 16).clamp(-REACH, REACH) as i32
    }

    /// Returns the grid coordinate nearest to a local one.
    #[inline]
    pub(super) fn to_grid(&self, local: i32, axis: usize) -> i32 {
        let shift = self.shift;
        let off = if shift > 0 { (local + (1 << (shift - 1))) >> shift } else { local << -shift };
        self.origin[axis].wrapping_add(off)
    }

    /// Returns the border between a grid coordinate and the one below it, in local units.
    #[inline]
    pub(super) fn border(&self, coordinate: i32, axis: usize) -> i16 {
        let twice = 2 * i64::from(coordinate.wrapping_sub(self.origin[axis])) - 1;
        ((twice * self.factor) >> 17).clamp(-20_000, 20_000) as i16
    }
}
