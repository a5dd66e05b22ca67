//! Cells, and the triangles that they consist of.

use std::collections::BTreeMap;
use std::ops::Range;

/// Cell type of points (`VTK_POLY_VERTEX`).
pub(super) const POINTS: u8 = 2;
/// Cell type of lines (`VTK_POLY_LINE`).
pub(super) const LINES: u8 = 4;
/// Cell type of triangles (`VTK_TRIANGLE`).
pub(super) const TRIANGLE: u8 = 5;
/// Cell type of triangle strips (`VTK_TRIANGLE_STRIP`).
pub(super) const STRIP: u8 = 6;
/// Cell type of polygons (`VTK_POLYGON`).
pub(super) const POLYGON: u8 = 7;

/// Cells of all types in the order of the file.
#[derive(Debug, Default)]
pub(super) struct Cells {
    kinds: Vec<u8>,
    /// One past the last entry of each cell in `corners`.
    ends: Vec<usize>,
    /// Points of the cells.
    corners: Vec<u32>,
}

/// Triangles of cells.
#[derive(Debug, Default)]
pub(super) struct CellSurface {
    pub triangles: Vec<[u32; 3]>,
    /// Cell of each triangle.
    pub cells: Vec<u32>,
    /// Numbers of cells that are not part of the surface, by what they are.
    pub left_out: BTreeMap<&'static str, usize>,
    /// Number of curved cells, of which only the corners are used.
    pub curved_count: usize,
}

/// Name of cells with a volume among those left out.
pub(super) const VOLUMES: &str = "volume cells";

impl Cells {
    pub(super) fn len(&self) -> usize {
        self.kinds.len()
    }

    /// Appends a cell. The points are numbered from `first_point`, and there are `point_count` of them.
    pub(super) fn push(
        &mut self,
        kind: u8,
        points: &[i64],
        first_point: usize,
        point_count: usize,
    ) -> Result<(), String> {
        for &point in points {
            let Some(point) = usize::try_from(point).ok().filter(|&point| point < point_count) else {
                return Err(format!("cell {}: point {point} of {point_count} does not exist", self.len()));
            };
            let Ok(corner) = u32::try_from(first_point + point) else {
                return Err("there are more points than 32-bit numbers can address".to_owned());
            };
            self.corners.push(corner);
        }
        self.kinds.push(kind);
        self.ends.push(self.corners.len());
        Ok(())
    }

    /// Appends cells as XML files list them: the points of all cells, and where each cell ends.
    pub(super) fn push_list(
        &mut self,
        kinds: impl Fn(usize) -> Option<u8>,
        connectivity: &[i64],
        ends: &[i64],
        points: Range<usize>,
    ) -> Result<(), String> {
        let mut start = 0;
        for (number, &end) in ends.iter().enumerate() {
            let range = usize::try_from(end).ok().and_then(|end| connectivity.get(start..end));
            let Some(corners) = range else {
                let count = connectivity.len();
                return Err(format!("cell {number} ends at entry {end} of {count}, and begins at {start}"));
            };
            let kind = kinds(number).ok_or_else(|| format!("cell {number} has no type"))?;
            self.push(kind, corners, points.start, points.len())?;
            start += corners.len();
        }
        Ok(())
    }

    /// Returns the triangles of all cells.
    pub(super) fn surface(&self) -> CellSurface {
        let mut surface = CellSurface::default();
        let mut start = 0;
        for (cell, (&kind, &end)) in self.kinds.iter().zip(&self.ends).enumerate() {
            surface.add(kind, &self.corners[start..end]);
            // There are fewer cells than 32-bit numbers, or they would have no corners.
            surface.cells.resize(surface.triangles.len(), cell as u32);
            start = end;
        }
        surface
    }
}

impl CellSurface {
    /// Adds the triangles of a cell, or counts it.
    fn add(&mut self, kind: u8, p: &[u32]) {
        let what = match kind {
            0 => return,
            1 | 2 => "points",
            3 | 4 | 21 | 35 | 68 | 75 => "lines",
            TRIANGLE | POLYGON | 9 if p.len() >= 3 => return self.fan(p),
            STRIP if p.len() >= 3 => return self.strip(p),
            // Pixels: the third and the fourth point are exchanged.
            8 if p.len() == 4 => return self.fan(&[p[0], p[1], p[3], p[2]]),
            // Quadratic cells: their corners, then the points on their edges, then those inside.
            22 | 34 if p.len() >= 6 => return self.quadratic_triangle(p),
            23 | 28 if p.len() >= 8 => return self.quadratic_quad(p),
            30 if p.len() == 6 => return self.fan(&[p[0], p[4], p[1], p[2], p[5], p[3]]),
            36 if p.len() >= 6 && p.len().is_multiple_of(2) => {
                let (corners, middles) = p.split_at(p.len() / 2);
                let ring: Vec<u32> = corners.iter().zip(middles).flat_map(|(&a, &b)| [a, b]).collect();
                return self.fan(&ring);
            }
            // Lagrange and Bezier cells: their corners come first.
            69 | 76 if p.len() >= 3 => return self.curved(&p[..3]),
            70 | 77 if p.len() >= 4 => return self.curved(&p[..4]),
            5..=9 | 22 | 23 | 28 | 30 | 34 | 36 | 69 | 70 | 76 | 77 => "cells with too few points",
            10..=16 | 24..=27 | 29 | 31..=33 | 37..=42 | 71..=74 | 78..=81 => VOLUMES,
            _ => "cells of an unknown type",
        };
        *self.left_out.entry(what).or_default() += 1;
    }

    fn curved(&mut self, corners: &[u32]) {
        self.curved_count += 1;
        self.fan(corners);
    }

    fn fan(&mut self, p: &[u32]) {
        self.triangles.extend(p[1..].windows(2).map(|edge| [p[0], edge[0], edge[1]]));
    }

    fn strip(&mut self, p: &[u32]) {
        let triangle = |(number, corners): (usize, &[u32])| match number % 2 {
            0 => [corners[0], corners[1], corners[2]],
            _ => [corners[1], corners[0], corners[2]],
        };
        self.triangles.extend(p.windows(3).enumerate().map(triangle));
    }

    /// ```text
    ///     2
    ///    5 4      one triangle at each corner, and one in the middle
    ///   0 3 1
    /// ```
    fn quadratic_triangle(&mut self, p: &[u32]) {
        self.triangles.extend([[0, 3, 5], [3, 1, 4], [5, 4, 2], [3, 4, 5]].map(|t| t.map(|i: usize| p[i])));
    }

    /// ```text
    ///   3 6 2
    ///   7   5     one triangle at each corner, and two in the middle
    ///   0 4 1
    /// ```
    fn quadratic_quad(&mut self, p: &[u32]) {
        let corners = [[0, 4, 7], [4, 1, 5], [5, 2, 6], [6, 3, 7]];
        let middle = match p.get(8) {
            Some(_) => [[4, 5, 8], [5, 6, 8], [6, 7, 8], [7, 4, 8]].to_vec(),
            None => [[4, 5, 6], [4, 6, 7]].to_vec(),
        };
        self.triangles.extend(corners.into_iter().chain(middle).map(|t| t.map(|i: usize| p[i])));
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn surface_of(kind: u8, count: u32) -> CellSurface {
        let points: Vec<i64> = (0..i64::from(count)).collect();
        let mut cells = Cells::default();
        cells.push(kind, &points, 0, points.len()).unwrap();
        cells.surface()
    }

    #[test]
    fn cells_become_triangles() {
        assert_eq!(surface_of(9, 4).triangles, [[0, 1, 2], [0, 2, 3]]);
        assert_eq!(surface_of(8, 4).triangles, [[0, 1, 3], [0, 3, 2]]);
        assert_eq!(surface_of(STRIP, 5).triangles, [[0, 1, 2], [2, 1, 3], [2, 3, 4]]);
        assert_eq!(surface_of(POLYGON, 5).cells, [0; 3]);
        for (kind, points, triangles) in
            [(22, 6, 4), (34, 7, 4), (23, 8, 6), (28, 9, 8), (30, 6, 4), (36, 8, 6)]
        {
            assert_eq!(surface_of(kind, points).triangles.len(), triangles, "{kind}");
        }
        assert_eq!(surface_of(70, 16).curved_count, 1);
    }

    #[test]
    fn other_cells_are_counted() {
        for (kind, points, what) in [
            (1, 1, "points"),
            (LINES, 3, "lines"),
            (10, 4, VOLUMES),
            (42, 9, VOLUMES),
            (TRIANGLE, 2, "cells with too few points"),
            (200, 3, "cells of an unknown type"),
        ] {
            let surface = surface_of(kind, points);
            assert_eq!((surface.triangles.len(), surface.left_out[what]), (0, 1), "{kind}");
        }
    }

    #[test]
    fn points_that_do_not_exist_are_refused() {
        let mut cells = Cells::default();
        assert!(cells.push(TRIANGLE, &[0, 1, 3], 0, 3).is_err());
        assert!(Cells::default().push(TRIANGLE, &[0, 1, -1], 0, 3).is_err());
        let list = |ends: &[i64]| Cells::default().push_list(|_| Some(7), &[0, 1, 2], ends, 0..3);
        assert_eq!(list(&[3]), Ok(()));
        assert!(list(&[4]).is_err() && list(&[2, 1]).is_err() && list(&[-1]).is_err());
    }
}
