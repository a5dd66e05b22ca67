//! Regions of an image: connected texels that a mesh shows, which are its charts.
//!
//! A coarse triangle may have corners in several charts. Between its corners the image then shows whatever lies
//! between the charts, so all corners move to one of them. That smears the colors of one triangle.

use super::coverage::Coverage;

/// The regions of an image as runs of texels.
pub(crate) struct Regions {
    size: [u32; 2],
    /// First run of each row, and one beyond the last.
    rows: Vec<u32>,
    /// First texel, one beyond the last, and region of each run.
    runs: Vec<[u32; 3]>,
}

impl Regions {
    /// The regions of a coverage; `None` if everything counts.
    pub(super) fn new(coverage: &Coverage) -> Option<Self> {
        if coverage.is_whole {
            return None;
        }
        let size = [coverage.width, coverage.height];
        let (mut rows, mut runs): (Vec<u32>, Vec<[u32; 3]>) = (vec![0], Vec::new());
        let mut parents: Vec<u32> = Vec::new();
        for y in 0..size[1] {
            let above = rows.len().checked_sub(2).map_or(0, |row| rows[row] as usize)..runs.len();
            let mut above = above.peekable();
            let mut x = 0;
            while x < size[0] {
                if !coverage.has(x, y) {
                    x += 1;
                    continue;
                }
                let first = x;
                while x < size[0] && coverage.has(x, y) {
                    x += 1;
                }
                let own = parents.len() as u32;
                parents.push(own);
                // Runs above that end before this one also end before the next.
                while let Some(&run) = above.peek() {
                    if runs[run][0] >= x {
                        break;
                    }
                    if runs[run][1] > first {
                        join(&mut parents, own, runs[run][2]);
                    }
                    if runs[run][1] > x {
                        break;
                    }
                    above.next();
                }
                runs.push([first, x, own]);
            }
            rows.push(runs.len() as u32);
        }
        for run in &mut runs {
            run[2] = root(&mut parents, run[2]);
        }
        Some(Self { size, rows, runs })
    }

    /// The region of a place in texels; `None` if it is between regions.
    pub(super) fn at(&self, texel: [f64; 2]) -> Option<u32> {
        let [x, y] = [0, 1].map(|a| (texel[a].floor() as i64).rem_euclid(i64::from(self.size[a])) as u32);
        let runs = &self.runs[self.rows[y as usize] as usize..self.rows[y as usize + 1] as usize];
        let run = runs.get(runs.partition_point(|run| run[1] <= x))?;
        (run[0] <= x).then_some(run[2])
    }
}

/// Joins two sets, whose root is their least member.
pub(super) fn join(parents: &mut [u32], a: u32, b: u32) {
    let (a, b) = (root(parents, a), root(parents, b));
    parents[a.max(b) as usize] = a.min(b);
}

/// The root of the set that an element is in.
pub(super) fn root(parents: &mut [u32], mut id: u32) -> u32 {
    while parents[id as usize] != id {
        parents[id as usize] = parents[parents[id as usize] as usize];
        id = parents[id as usize];
    }
    id
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn regions_are_connected_along_rows_and_columns() {
        let mut coverage = Coverage::new([12, 6], false);
        let picture =
            ["##..##......", "#...#..###..", "#####..#.#..", ".......#.#..", "..##...###..", "..##........"];
        for (y, x) in (0..6).flat_map(|y| (0..12).map(move |x| (y, x))) {
            if picture[y].as_bytes()[x] == b'#' {
                let [x, y] = [x as f64 + 0.5, y as f64 + 0.5];
                coverage.add([[x, y]; 3]);
            }
        }
        let regions = Regions::new(&coverage).unwrap();
        let at = |x: usize, y: usize| regions.at([x as f64 + 0.5, y as f64 + 0.5]);
        for (y, x) in (0..6).flat_map(|y| (0..12).map(move |x| (y, x))) {
            assert_eq!(at(x, y).is_some(), picture[y].as_bytes()[x] == b'#', "{x} {y}");
        }
        assert_eq!(at(0, 0), at(5, 0));
        assert_eq!(at(7, 1), at(9, 4));
        let all: std::collections::BTreeSet<_> = [at(0, 0), at(7, 1), at(2, 5)].into();
        assert_eq!(all.len(), 3);
    }
}
