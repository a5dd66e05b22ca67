//! Charts: the parts of a tile that are connected in an image, and their places in an atlas.

use std::collections::{BTreeMap, HashMap};

use striata::mesh::IndexedMesh;

use super::regions::{join, root};

/// Largest side of an atlas, pixels: what browsers on small devices draw.
pub(super) const MAX_ATLAS_SIDE: u32 = 8192;
/// Largest number of charts of an atlas: packing takes time for each pair.
const MAX_CHARTS: usize = 1 << 15;
/// Smallest and largest border around a chart, pixels.
const GUTTERS: [u32; 2] = [2, 8];
/// A chart has a border of this share of its shorter side.
const GUTTER_SHARE: u32 = 8;
/// Largest number of texels along the side of a pixel.
const MAX_REDUCTION: f64 = 16_384.0;

/// Triangles that are connected in an image.
#[derive(Clone, Debug)]
pub(super) struct AtlasChart {
    pub triangles: Vec<u32>,
    /// Bounds, texels.
    bounds: [[f64; 2]; 2],
    /// Area of the surface, and in texels.
    pub areas: [f64; 2],
    /// Texels of a pixel.
    pub step: f64,
    /// First corner inside of the border, texels.
    pub start: [f64; 2],
    pub gutter: u32,
    /// Size in the atlas with borders, pixels.
    pub size: [u32; 2],
    /// First corner in the atlas, pixels.
    pub place: [u32; 2],
}

/// Area of a triangle.
pub(super) fn area([a, b, c]: [[f64; 3]; 3]) -> f64 {
    let (p, q) = ([0, 1, 2].map(|i| b[i] - a[i]), [0, 1, 2].map(|i| c[i] - a[i]));
    let cross = [0, 1, 2].map(|i| p[(i + 1) % 3] * q[(i + 2) % 3] - p[(i + 2) % 3] * q[(i + 1) % 3]);
    0.5 * cross.iter().map(|x| x * x).sum::<f64>().sqrt()
}

/// The charts of some triangles; `None` if a texture coordinate is not a number.
pub(super) fn charts(
    mesh: &IndexedMesh,
    triangles: &[u32],
    texel_place: &dyn Fn(u32) -> [f64; 2],
) -> Option<Vec<AtlasChart>> {
    // Vertices that differ only in other attributes are one point.
    let mut points: HashMap<([u32; 3], [u64; 2]), u32> = HashMap::new();
    let mut parents: Vec<u32> = Vec::new();
    let mut corners = Vec::with_capacity(triangles.len());
    for &triangle in triangles {
        let places = mesh.triangles[triangle as usize].map(|v| (v, texel_place(v)));
        if places.iter().any(|(_, at)| at.iter().any(|x| !x.is_finite() || x.abs() > 1e9)) {
            return None;
        }
        let ids = places.map(|(v, at)| {
            let key = (mesh.positions[v as usize].map(f32::to_bits), at.map(|x| (x + 0.0).to_bits()));
            *points.entry(key).or_insert_with(|| {
                parents.push(parents.len() as u32);
                parents.len() as u32 - 1
            })
        });
        join(&mut parents, ids[0], ids[1]);
        join(&mut parents, ids[0], ids[2]);
        corners.push((ids[0], places.map(|(_, at)| at)));
    }
    let mut found: BTreeMap<u32, AtlasChart> = BTreeMap::new();
    for (&triangle, &(id, at)) in triangles.iter().zip(&corners) {
        let chart = found.entry(root(&mut parents, id)).or_insert_with(|| AtlasChart::new(at[0]));
        chart.triangles.push(triangle);
        for corner in at {
            chart.bounds[0] = [0, 1].map(|a| chart.bounds[0][a].min(corner[a]));
            chart.bounds[1] = [0, 1].map(|a| chart.bounds[1][a].max(corner[a]));
        }
        let positions = mesh.triangles[triangle as usize].map(|v| mesh.positions[v as usize].map(f64::from));
        chart.areas[0] += area(positions);
        chart.areas[1] += area(at.map(|[x, y]| [x, y, 0.0]));
    }
    Some(found.into_values().collect())
}

/// Texels of a pixel that is `texel` long on a surface, at least 1.
pub(super) fn step_for([surface, texels]: [f64; 2], texel: f64) -> f64 {
    if texels == 0.0 || texel == 0.0 {
        return 1.0;
    }
    (texel / (surface / texels).sqrt()).clamp(1.0, MAX_REDUCTION)
}

impl AtlasChart {
    fn new(at: [f64; 2]) -> Self {
        Self {
            triangles: Vec::new(),
            bounds: [at; 2],
            areas: [0.0; 2],
            step: 1.0,
            start: [0.0; 2],
            gutter: 0,
            size: [0; 2],
            place: [0; 2],
        }
    }

    /// Chooses the size in an atlas, a multiple of `unit`.
    pub(super) fn set_size(&mut self, step: f64, unit: u32) {
        self.step = step;
        let [low, high] = self.bounds;
        // Pixels are aligned with those of reduced copies.
        self.start = low.map(|x| (x / step).floor() * step);
        let inner = [0, 1].map(|a| (((high[a] - self.start[a]) / step).ceil() as u32).max(1));
        self.gutter =
            (inner[0].min(inner[1]) / GUTTER_SHARE).clamp(GUTTERS[0], GUTTERS[1]).next_multiple_of(unit);
        self.size = inner.map(|x| (x + 2 * self.gutter).next_multiple_of(unit));
    }

    /// Number of pixels.
    pub(super) fn pixel_count(&self) -> u64 {
        u64::from(self.size[0]) * u64::from(self.size[1])
    }

    /// Place of a texel in the atlas, pixels.
    pub(super) fn pixel_of(&self, texel: [f64; 2]) -> [f64; 2] {
        [0, 1].map(|a| f64::from(self.place[a] + self.gutter) + (texel[a] - self.start[a]) / self.step)
    }
}

/// Places charts in an atlas and returns its size; `None` if it would be too large, or if there are too many.
///
/// ```text
///            ____
///   __      |    |     the skyline: where it begins, and the height of each step;
///  |  |_____|    |__   the next chart, by height, goes where its lower edge is lowest
/// ```
pub(super) fn packed(charts: &mut [AtlasChart]) -> Option<[u32; 2]> {
    let area: u64 = charts.iter().map(AtlasChart::pixel_count).sum();
    let widest = charts.iter().map(|chart| chart.size[0]).max()?;
    // Some pixels below the skyline are lost.
    let side = ((area as f64 * 1.1).sqrt().ceil() as u32).max(widest);
    if side > MAX_ATLAS_SIDE || charts.len() > MAX_CHARTS {
        return None;
    }
    let mut order: Vec<usize> = (0..charts.len()).collect();
    order.sort_by_key(|&i| std::cmp::Reverse((charts[i].size[1], charts[i].size[0])));
    let mut skyline = vec![[0, 0]];
    let mut size = [0; 2];
    for i in order {
        let chart = &mut charts[i];
        let [width, height] = chart.size;
        let steps_below = |first: usize| {
            let end = skyline[first][0] + width;
            skyline[first..].iter().take_while(move |step| step[0] < end).map(|step| step[1])
        };
        let fitting = (0..skyline.len()).take_while(|&step| skyline[step][0] + width <= side);
        let lower_edge = |&step: &usize| steps_below(step).max().unwrap_or(0);
        let first = fitting.min_by_key(lower_edge)?;
        let (count, y) = (steps_below(first).count(), lower_edge(&first));
        let (x, last) = (skyline[first][0], skyline[first + count - 1][1]);
        let next = skyline.get(first + count).map_or(side, |step| step[0]);
        let rest = (x + width < next).then_some([x + width, last]);
        skyline.splice(first..first + count, [[x, y + height]].into_iter().chain(rest));
        chart.place = [x, y];
        size = [size[0].max(x + width), size[1].max(y + height)];
    }
    (size[1] <= MAX_ATLAS_SIDE).then_some(size)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn charts_do_not_overlap_and_waste_little() {
        let mut random = 1u32;
        let mut below = |limit: u32| {
            random = random.wrapping_mul(1_664_525).wrapping_add(1_013_904_223);
            (random >> 8) % limit
        };
        for (count, limits) in
            [(1, [9, 300]), (2, [300, 9]), (300, [60, 60]), (300, [200, 12]), (2000, [20, 90])]
        {
            let mut charts: Vec<AtlasChart> = (0..count).map(|_| AtlasChart::new([0.0; 2])).collect();
            for chart in &mut charts {
                chart.size = limits.map(|limit| 3 + below(limit));
            }
            // A column and a row.
            charts[0].size = [8, 254];
            charts[count - 1].size = [250, 9];
            let size = packed(&mut charts).unwrap();
            let mut is_used = vec![false; size[0] as usize * size[1] as usize];
            for chart in &charts {
                for (x, y) in (0..chart.size[0]).flat_map(|x| (0..chart.size[1]).map(move |y| (x, y))) {
                    let at = (chart.place[1] + y) as usize * size[0] as usize + (chart.place[0] + x) as usize;
                    assert!(chart.place[0] + x < size[0] && !std::mem::replace(&mut is_used[at], true));
                }
            }
            let used = is_used.iter().filter(|&&is_used| is_used).count();
            assert!(count < 100 || used * 10 > is_used.len() * 8, "{used} of {}", is_used.len());
        }
    }
}
