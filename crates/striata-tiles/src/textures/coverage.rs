//! Which texels of an image a mesh shows.
//!
//! Texture atlases are black, or whatever else, between their charts. Reduced copies must not mix that with the charts,
//! so they are averages of texels that triangles reach.

/// A bit for each texel.
#[derive(Clone, Debug)]
pub(crate) struct Coverage {
    pub width: u32,
    pub height: u32,
    row_words: usize,
    bits: Vec<u64>,
    /// Whether everything counts, because the image repeats.
    pub is_whole: bool,
}

impl Coverage {
    /// A coverage of nothing, or of everything.
    pub(crate) fn new([width, height]: [u32; 2], is_whole: bool) -> Self {
        let row_words = width.div_ceil(64) as usize;
        let bits = if is_whole { Vec::new() } else { vec![0; row_words * height as usize] };
        Self { width, height, row_words, bits, is_whole }
    }

    pub(crate) fn is_empty(&self) -> bool {
        !self.is_whole && self.bits.iter().all(|&word| word == 0)
    }

    /// Whether a texel is reached.
    pub(crate) fn has(&self, x: u32, y: u32) -> bool {
        self.is_whole || self.bits[y as usize * self.row_words + x as usize / 64] >> (x % 64) & 1 == 1
    }

    /// Whether a texel or one next to it is reached.
    pub(crate) fn is_near(&self, x: u32, y: u32) -> bool {
        let ends = |at: u32, side: u32| at.saturating_sub(1)..=(at + 1).min(side - 1);
        ends(y, self.height).any(|y| ends(x, self.width).any(|x| self.has(x, y)))
    }

    /// Adds the texels that a triangle reaches, in texels from the first corner of the image, which repeats.
    pub(crate) fn add(&mut self, corners: [[f64; 2]; 3]) {
        if self.is_whole {
            return;
        }
        let range = |a: usize| {
            let values = corners.map(|corner| corner[a]);
            (
                values.iter().copied().fold(f64::INFINITY, f64::min),
                values.into_iter().fold(f64::NEG_INFINITY, f64::max),
            )
        };
        let ((left, right), (top, bottom)) = (range(0), range(1));
        let fits = right - left <= f64::from(self.width) && bottom - top <= f64::from(self.height);
        // Also for what is not a number.
        if !fits || !corners.iter().flatten().all(|x| x.abs() < 1e9) {
            self.is_whole = true;
            return;
        }
        for y in top.floor() as i64..=bottom.floor() as i64 {
            let (mut first, mut last) = (f64::INFINITY, f64::NEG_INFINITY);
            for i in 0..3 {
                let Some([a, b]) = within(corners[i], corners[(i + 1) % 3], y as f64) else { continue };
                (first, last) = (first.min(a.min(b)), last.max(a.max(b)));
            }
            if first <= last {
                self.add_row(y, first.floor() as i64, last.floor() as i64);
            }
        }
    }

    fn add_row(&mut self, y: i64, first: i64, last: i64) {
        let row = y.rem_euclid(i64::from(self.height)) as usize * self.row_words;
        for x in first..=last {
            let x = x.rem_euclid(i64::from(self.width)) as usize;
            self.bits[row + x / 64] |= 1 << (x % 64);
        }
    }
}

/// The ends of the part of an edge that is between `y` and `y + 1`, across.
fn within(from: [f64; 2], to: [f64; 2], y: f64) -> Option<[f64; 2]> {
    let [low, high] = if from[1] <= to[1] { [from, to] } else { [to, from] };
    if high[1] < y || low[1] > y + 1.0 {
        return None;
    }
    let at = |limit: f64, own: [f64; 2]| {
        if low[1] == high[1] {
            own[0]
        } else {
            low[0] + (limit - low[1]) / (high[1] - low[1]) * (high[0] - low[0])
        }
    };
    let a = if low[1] >= y { low[0] } else { at(y, low) };
    let b = if high[1] <= y + 1.0 { high[0] } else { at(y + 1.0, high) };
    Some([a, b])
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_point_of_a_triangle_is_on_a_texel_that_counts() {
        let mut coverage = Coverage::new([100, 40], false);
        let corners = [[70.3, 5.5], [112.7, 9.1], [95.2, 33.9]];
        coverage.add(corners);
        for (i, j) in (0..=20).flat_map(|i| (0..=20 - i).map(move |j| (i, j))) {
            let weights = [f64::from(i) / 20.0, f64::from(j) / 20.0, f64::from(20 - i - j) / 20.0];
            let [x, y] = [0, 1].map(|a| (0..3).map(|c| weights[c] * corners[c][a]).sum::<f64>());
            assert!(coverage.has(x as u32 % 100, y as u32), "{x} {y}");
        }
        assert!(!coverage.has(60, 5) && !coverage.has(20, 5) && !coverage.has(95, 36));
        assert!(coverage.is_near(69, 4) && !coverage.is_whole);
        coverage.add([[0.0, 0.0], [101.0, 0.0], [0.0, 1.0]]);
        assert!(coverage.is_whole && coverage.has(60, 5));
    }
}
