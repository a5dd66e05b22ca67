//! Which cell of a level each triangle and each position belongs to.

use std::ops::Range;

use super::surface::DividedSurface;
use crate::parallel::map;
use crate::simplify::cells::PartitionLevel;

/// Each cell has about this many samples, from which space is divided.
const SAMPLES_PER_CELL: usize = 256;

/// Positions whose cells are found at a time.
const CHUNK: usize = 1 << 14;

/// The cells of a level.
pub(super) struct RoutedLevel {
    /// Cell of every position that is left.
    pub cell_of: Vec<u32>,
    /// Number of each position among those of its cell.
    pub number_in_cell: Vec<u32>,
    /// Positions, and indices of triangles inside and at the border of each cell.
    positions: CellLists,
    inside: CellLists,
    border: CellLists,
    is_onward: Vec<bool>,
}

/// Lists of indices by cell, one after the other.
struct CellLists {
    /// Start of each list, then the end of the last one.
    first: Vec<u32>,
    items: Vec<u32>,
}

impl CellLists {
    /// Lists items by cell, in the order in which `each` calls the function that it is given.
    fn new(cell_count: usize, each: impl Fn(&mut dyn FnMut(u32, u32))) -> Self {
        let mut first = vec![0u32; cell_count + 1];
        each(&mut |cell, _| first[cell as usize + 1] += 1);
        for cell in 0..cell_count {
            first[cell + 1] += first[cell];
        }
        let mut items = vec![0; first[cell_count] as usize];
        let mut next = first.clone();
        each(&mut |cell, item| {
            let at = &mut next[cell as usize];
            items[*at as usize] = item;
            *at += 1;
        });
        Self { first, items }
    }

    fn of(&self, cell: usize) -> &[u32] {
        let range: Range<usize> = self.first[cell] as usize..self.first[cell + 1] as usize;
        &self.items[range]
    }
}

impl RoutedLevel {
    pub(super) fn new(surface: &DividedSurface<'_>, number: usize, cell_triangles: usize) -> Self {
        let (triangles, is_removed) = (&surface.triangles, &surface.is_removed);
        let mesh = &surface.welded.mesh;
        let left: Vec<u32> = (0..is_removed.len() as u32).filter(|&p| !is_removed[p as usize]).collect();
        let cells = triangles.len() as f64 / cell_triangles as f64;
        let stride = (left.len() as f64 / (cells * SAMPLES_PER_CELL as f64)).max(1.0) as usize;
        let samples: Vec<[f32; 3]> =
            left.iter().step_by(stride).map(|&p| mesh.positions[p as usize]).collect();
        let level = PartitionLevel::numbered(number, &samples, samples.len() as f64 / cells);
        let cell_count = level.cell_count() as usize;
        let chunk = |i: usize| -> Vec<u32> {
            let positions = &mesh.positions[i * CHUNK..mesh.positions.len().min((i + 1) * CHUNK)];
            positions.iter().map(|&p| level.cell_of(p)).collect()
        };
        let cell_of = map(0..mesh.positions.len().div_ceil(CHUNK), chunk).concat();
        let cells_of = |t: &[u32; 3]| t.map(|v| cell_of[v as usize]);
        let is_onward: Vec<bool> = triangles.iter().map(cells_of).map(|[a, b, c]| a != b || b != c).collect();
        let indexed = || (0..).zip(triangles).zip(&is_onward);
        let inside = CellLists::new(cell_count, |add| {
            indexed()
                .filter(|(_, is_onward)| !**is_onward)
                .for_each(|((t, corners), _)| add(cells_of(corners)[0], t));
        });
        let border = CellLists::new(cell_count, |add| {
            for ((t, corners), _) in indexed().filter(|(_, is_onward)| **is_onward) {
                let cells = cells_of(corners);
                (0..3).filter(|&i| !cells[..i].contains(&cells[i])).for_each(|i| add(cells[i], t));
            }
        });
        let positions =
            CellLists::new(cell_count, |add| left.iter().for_each(|&p| add(cell_of[p as usize], p)));
        let mut number_in_cell = vec![0; cell_of.len()];
        for cell in 0..cell_count {
            (0..).zip(positions.of(cell)).for_each(|(i, &p)| number_in_cell[p as usize] = i);
        }
        Self { cell_of, number_in_cell, positions, inside, border, is_onward }
    }

    pub(super) fn cell_count(&self) -> usize {
        self.positions.first.len() - 1
    }

    /// Positions of a cell, in increasing order.
    pub(super) fn positions(&self, cell: usize) -> &[u32] {
        self.positions.of(cell)
    }

    /// Triangles whose corners all belong to a cell, and those with one or two such corners.
    pub(super) fn triangles(&self, cell: usize) -> [&[u32]; 2] {
        [self.inside.of(cell), self.border.of(cell)]
    }

    /// Triangles that no cell may change.
    pub(super) fn onward(&self, surface: &DividedSurface<'_>) -> Vec<[u32; 3]> {
        surface
            .triangles
            .iter()
            .zip(&self.is_onward)
            .filter(|(_, is_onward)| **is_onward)
            .map(|(&t, _)| t)
            .collect()
    }
}
