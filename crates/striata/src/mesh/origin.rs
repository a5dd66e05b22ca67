//! Coordinates that single precision cannot hold: an origin in doubles, and positions relative to it.
//!
//! Surveys and photogrammetry give coordinates of six or seven digits before the point. `f32` keeps 24 bits,
//! which is half a meter at 6,400 km, so that a dense scan becomes a staircase. Positions relative to an origin
//! near the mesh are off by at most 6e-8 of its diagonal, and all code in single precision stays as it is.
//! Because a level of collapses uses vertices of the input, the input's own doubles can travel with them
//! ([`IndexedMesh::exact_positions`]), so that a file in and a file out agree in every digit.
//!
//! The origin is the median of the coordinates instead of the center of the bounds, so that a few stray
//! vertices cannot draw it away. It is a multiple of a power of two near the size of the mesh, which keeps
//! differences exact.

use super::IndexedMesh;

/// An axis gets an origin if its median is farther from zero than this share of the mesh's size.
const FAR: f64 = 0.5;

/// Largest number of positions that the origin is chosen from; of more, evenly spaced ones are taken.
const MAX_SAMPLES: usize = 1 << 16;

/// Returns an origin for positions in doubles, relative to which single precision keeps them; zero on every
/// axis on which the coordinates themselves are small enough.
pub fn origin_of(positions: &[[f64; 3]]) -> [f64; 3] {
    let stride = positions.len().div_ceil(MAX_SAMPLES).max(1);
    let Extent { median, size } = Extent::of(positions.iter().step_by(stride).copied());
    let step = if size > 0.0 { (size / 8.0).log2().floor().exp2() } else { 0.0 };
    median.map(|median| {
        let rounded = if step > 0.0 { (median / step).round() * step } else { median };
        if median.abs() > FAR * size && rounded.is_finite() { rounded } else { 0.0 }
    })
}

/// Middle and size of most of a mesh, however far away the rest may be.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub(crate) struct Extent {
    /// Median of each coordinate.
    pub median: [f64; 3],
    /// Twice the diagonal of the box between the quartiles: the diagonal of bounds that are filled evenly.
    pub size: f64,
}

impl Extent {
    /// Finds the extent of some points; those that are not finite do not count.
    fn of(points: impl Iterator<Item = [f64; 3]>) -> Self {
        let points: Vec<[f64; 3]> = points.filter(|p| p.iter().all(|x| x.is_finite())).collect();
        let Some(last) = points.len().checked_sub(1) else { return Self::default() };
        let quartiles = [0, 1, 2].map(|axis| {
            let mut sorted: Vec<f64> = points.iter().map(|p| p[axis]).collect();
            sorted.sort_unstable_by(f64::total_cmp);
            [sorted[last / 4], sorted[last / 2], sorted[last - last / 4]]
        });
        let size = quartiles.iter().map(|[low, _, high]| 4.0 * (high - low).powi(2)).sum::<f64>().sqrt();
        Self { median: quartiles.map(|[_, median, _]| median), size }
    }

    /// Finds the extent of positions from at most `most` evenly spaced ones.
    pub(crate) fn of_positions(positions: &[[f32; 3]], most: usize) -> Self {
        let stride = positions.len().div_ceil(most).max(1);
        Self::of(positions.iter().step_by(stride).map(|p| p.map(f64::from)))
    }
}

impl IndexedMesh {
    /// Replaces all positions by those of a file in doubles: chooses the [`origin`](Self::origin), and keeps the
    /// doubles as [`exact_positions`](Self::exact_positions).
    pub fn set_file_positions(&mut self, positions: Vec<[f64; 3]>) {
        self.origin = origin_of(&positions);
        self.positions = positions.iter().map(|&p| relative_position(p, self.origin)).collect();
        self.exact_positions = positions;
    }

    /// Coordinates of a vertex in the file, in mesh units: its exact position if there is one.
    ///
    /// # Panics
    /// If the vertex does not exist.
    pub fn file_position(&self, vertex: usize) -> [f64; 3] {
        match self.exact_positions.get(vertex) {
            Some(&exact) => exact,
            None => [0, 1, 2].map(|axis| self.origin[axis] + f64::from(self.positions[vertex][axis])),
        }
    }

    /// Smallest and largest coordinates in the file, in mesh units; `None` if no position is finite.
    pub fn file_bounds(&self) -> Option<[[f64; 3]; 2]> {
        if self.exact_positions.is_empty() {
            let bounds = self.bounds()?;
            return Some([bounds.min, bounds.max].map(|corner| self.in_file(corner)));
        }
        let finite = self.exact_positions.iter().filter(|p| p.iter().all(|x| x.is_finite()));
        finite.fold(None, |bounds: Option<[[f64; 3]; 2]>, &p| {
            let [min, max] = bounds.unwrap_or([p; 2]);
            let fold = |a: [f64; 3], keep: fn(f64, f64) -> f64| [0, 1, 2].map(|axis| keep(a[axis], p[axis]));
            Some([fold(min, f64::min), fold(max, f64::max)])
        })
    }

    /// Converts a point relative to the origin to the coordinates of the file.
    pub fn in_file(&self, point: [f32; 3]) -> [f64; 3] {
        [0, 1, 2].map(|axis| self.origin[axis] + f64::from(point[axis]))
    }

    /// Whether single precision cannot hold the coordinates of the file, so that outputs need doubles.
    pub fn needs_doubles(&self) -> bool {
        !self.exact_positions.is_empty() || self.origin != [0.0; 3]
    }

    /// Largest distance between a position and the coordinates that the file gives it, in mesh units; 0 if the
    /// file has no more digits than positions keep.
    pub fn rounding(&self) -> f64 {
        let distance = |(exact, &p): (&[f64; 3], &[f32; 3])| {
            let near = self.in_file(p);
            (0..3).map(|axis| (exact[axis] - near[axis]).powi(2)).sum::<f64>().sqrt()
        };
        self.exact_positions.iter().zip(&self.positions).map(distance).fold(0.0, f64::max)
    }

    /// Moves the origin without moving the mesh: positions become relative to the new one, rounded once.
    pub fn set_origin(&mut self, origin: [f64; 3]) {
        if origin == self.origin {
            return;
        }
        let moved = (0..self.positions.len()).map(|v| relative_position(self.file_position(v), origin));
        (self.positions, self.origin) = (moved.collect(), origin);
    }

    /// Exact positions of some vertices, in that order; empty if the mesh has none.
    pub fn gathered_exact_positions(&self, order: &[u32]) -> Vec<[f64; 3]> {
        if self.exact_positions.is_empty() {
            return Vec::new();
        }
        order.iter().map(|&v| self.exact_positions[v as usize]).collect()
    }
}

/// Returns a point of a file relative to an origin, rounded to single precision.
#[inline]
pub fn relative_position(point: [f64; 3], origin: [f64; 3]) -> [f32; 3] {
    [0, 1, 2].map(|axis| (point[axis] - origin[axis]) as f32)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::mesh::{shapes, weld};
    use crate::{Lod, LodOptions, Target};

    /// A terrain in the coordinates of a survey.
    fn survey(scale: f64, offset: [f64; 3]) -> IndexedMesh {
        let mut mesh = shapes::terrain(30, 5);
        let positions = mesh.positions.iter();
        let file = positions.map(|p| [0, 1, 2].map(|axis| f64::from(p[axis]) * scale + offset[axis]));
        mesh.set_file_positions(file.collect());
        mesh
    }

    #[test]
    fn positions_keep_a_ten_millionth_of_the_diagonal_anywhere() {
        for scale in [1e-6, 1.0, 1e6] {
            for offset in [[0.0; 3], [5e5, 5e6, 123.456], [6.4e6, -1e-3, -6.4e6]] {
                let mesh = survey(scale, offset.map(|x| x * scale));
                let diagonal = mesh.diagonal();
                assert!(
                    mesh.rounding() <= 1e-7 * diagonal,
                    "{scale} {offset:?}: {}",
                    mesh.rounding() / diagonal
                );
                let is_far = offset.map(|x| (x * scale).abs() > diagonal);
                assert_eq!(mesh.origin.map(|x| x != 0.0), is_far, "{scale} {offset:?}");
            }
        }
    }

    #[test]
    fn a_stray_vertex_does_not_move_the_origin() {
        let mut far = survey(1.0, [5e5, 5e6, 0.0]);
        let origin = far.origin;
        let mut positions = far.exact_positions.clone();
        positions.extend([[0.0; 3], [1e12, 0.0, f64::NAN]]);
        far.set_file_positions(positions);
        assert_eq!(far.origin, origin);
    }

    #[test]
    fn levels_have_the_coordinates_of_the_file() {
        let mesh = survey(0.05, [5e5, 5e6, 123.456]);
        let known: std::collections::BTreeSet<[u64; 3]> =
            mesh.exact_positions.iter().map(|p| p.map(f64::to_bits)).collect();
        let lod = Lod::build(&mesh, &LodOptions::default()).unwrap();
        for triangles in [10, 300, 100_000] {
            let level = lod.level(Target::Triangles(triangles)).to_mesh();
            level.check().unwrap();
            assert_eq!(level.exact_positions.len(), level.positions.len());
            for vertex in 0..level.vertex_count() {
                assert!(known.contains(&level.file_position(vertex).map(f64::to_bits)));
                assert_eq!(
                    level.positions[vertex],
                    relative_position(level.file_position(vertex), mesh.origin),
                    "both belong to one vertex"
                );
            }
        }
        assert_eq!(weld(&mesh).unwrap().mesh.origin, mesh.origin);
    }

    #[test]
    fn moving_the_origin_moves_nothing() {
        let mut mesh = survey(1.0, [5e5, 5e6, 0.0]);
        let bounds = mesh.file_bounds().unwrap();
        mesh.exact_positions.clear();
        mesh.set_origin([5e5 + 8.0, 5e6 - 8.0, 0.0]);
        let moved = mesh.file_bounds().unwrap();
        for (before, after) in bounds.iter().flatten().zip(moved.iter().flatten()) {
            assert!((before - after).abs() < 1e-5, "{before} {after}");
        }
    }

    #[test]
    fn a_single_point_far_away_is_its_own_origin() {
        assert_eq!(origin_of(&[[1e7 + 0.1, 0.0, 3.0]; 4]), [1e7 + 0.1, 0.0, 3.0]);
        assert_eq!(origin_of(&[[f64::NAN; 3]]), [0.0; 3]);
        assert_eq!(origin_of(&[]), [0.0; 3]);
    }
}
