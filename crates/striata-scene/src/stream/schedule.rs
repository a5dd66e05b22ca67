//! The order in which meshes are refined and images follow: the largest improvement per byte first.
//!
//! **Geometry.** A chunk of a mesh reduces its summed squared error, attributes included, by which levels of the scene
//! share out triangles, too. Chunks may gain nothing by themselves; runs of chunks are therefore weighed together (the
//! lower convex hull of error over bytes), and a mesh's runs improve less per byte from one to the next.
//!
//! **Images.** An image cannot be shown in part, so it is one item. Its benefit is expressed as the geometric
//! error that would change the picture as much. In a picture of the scene, an error `e` changes a
//! strip of that width along outlines, which are about four diagonals long, by a contrast of a quarter: `e D`
//! in all. An image changes the area on which it is seen (a quarter of the area of the surface, by Cauchy's formula)
//! by the contrast that its preview has lost, which was measured: `A c / 4`. So it stands for an error of
//! `A c / (4 D)`, and its preview for the same with the contrast that its average color has lost. Normals count half of it and other maps a quarter, because less of them shows in a
//! picture. The summed squared error `S` of all geometry that is still to come is, for this comparison, an error of
//! `8 √S / D`: the largest error is about eight times the root mean square, and the surface about the squared diagonal.
//!
//! **Animations** are one item that counts as an error of one percent of the diagonal: a moving scene of that
//! accuracy is worth more than a finer one that stands still.

use std::ops::Range;

/// Lengths of the chunks of a mesh, and the squared errors that they reduce.
#[derive(Clone, Debug, Default)]
pub(super) struct MeshCosts {
    /// Length of each chunk after the base, bytes.
    pub bytes: Vec<u64>,
    /// Summed squared error that each of these chunks takes away, units of the scene to the fourth power.
    pub gains: Vec<f64>,
}

/// Bytes and error of an item that is of no use in part.
#[derive(Clone, Debug)]
pub(super) struct WholeCosts {
    pub item: Item,
    /// Length, bytes.
    pub bytes: u64,
    /// Geometric error that would change the picture as much, units of the scene.
    pub error: f64,
}

impl WholeCosts {
    /// Improvement per byte.
    pub(super) fn rate(&self) -> f64 {
        self.error / self.bytes.max(1) as f64
    }
}

/// Largest error of a level as a multiple of the root mean square.
const LARGEST_OF_RMS: f64 = 8.0;

/// Error that animations count as, as a share of the diagonal of the scene.
pub(super) const ANIMATION_ERROR: f64 = 0.01;

/// Something that follows in one piece.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(super) enum Item {
    /// Chunks of a mesh, counted from the one after its base.
    Chunks {
        /// Index of the mesh.
        mesh: usize,
        chunks: Range<usize>,
    },
    /// The preview of the image with this index.
    Preview(usize),
    /// The image with this index.
    Image(usize),
    /// The data of all animations.
    Animations,
}

/// Returns all chunks and other items in the order of their improvement per byte, for a scene with this diagonal.
pub(super) fn schedule(meshes: &[MeshCosts], others: &[WholeCosts], diagonal: f64) -> Vec<Item> {
    let mut parts: Vec<(usize, PartRun)> = Vec::new();
    for (mesh, costs) in meshes.iter().enumerate() {
        let own = runs(costs.bytes.iter().copied().zip(costs.gains.iter().copied()));
        parts.extend(own.into_iter().map(|run| (mesh, run)));
    }
    // Stable: the runs of a mesh keep their order.
    parts.sort_by(|(_, a), (_, b)| b.rate().total_cmp(&a.rate()));
    // The error that is left before each part, as a length.
    let mut left: f64 = 0.0;
    let mut errors: Vec<f64> = vec![0.0];
    for (_, run) in parts.iter().rev() {
        left += run.gain.max(0.0);
        errors.push(if diagonal > 0.0 { LARGEST_OF_RMS * left.sqrt() / diagonal } else { 0.0 });
    }
    errors.reverse();
    let gains = errors.windows(2).map(|pair| pair[0] - pair[1]);
    let geometry = runs(parts.iter().map(|(_, run)| run.bytes).zip(gains));
    let chunks = |run: &PartRun| {
        let parts = parts[run.range.clone()].iter();
        parts.map(|(mesh, run)| Item::Chunks { mesh: *mesh, chunks: run.range.clone() }).collect()
    };
    let mut items: Vec<(f64, Vec<Item>)> = geometry.iter().map(|run| (run.rate(), chunks(run))).collect();
    items.extend(others.iter().map(|costs| (costs.rate(), vec![costs.item.clone()])));
    items.sort_by(|(a, _), (b, _)| b.total_cmp(a));
    items.into_iter().flat_map(|(_, items)| items).collect()
}

/// Consecutive parts that are weighed together.
struct PartRun {
    gain: f64,
    bytes: u64,
    range: Range<usize>,
}

impl PartRun {
    fn rate(&self) -> f64 {
        self.gain / self.bytes as f64
    }
}

/// Divides parts, given by their bytes and gains, into runs of falling improvement per byte.
fn runs(parts: impl Iterator<Item = (u64, f64)>) -> Vec<PartRun> {
    let mut runs: Vec<PartRun> = Vec::new();
    for (part, (bytes, gain)) in parts.enumerate() {
        let mut run = PartRun { gain, bytes: bytes.max(1), range: part..part + 1 };
        while let Some(last) = runs.pop_if(|last| last.rate() <= run.rate()) {
            run = PartRun {
                gain: last.gain + run.gain,
                bytes: last.bytes + run.bytes,
                range: last.range.start..run.range.end,
            };
        }
        runs.push(run);
    }
    runs
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn runs_contain_all_parts_in_order_and_gain_less_and_less() {
        let runs = runs([10, 10, 50, 5, 100].into_iter().zip([0.0, 4.0, 0.0, 3.0, 1.0]));
        assert!(runs.windows(2).all(|pair| pair[0].rate() > pair[1].rate()));
        let parts: Vec<usize> = runs.iter().flat_map(|run| run.range.clone()).collect();
        assert_eq!(parts, [0, 1, 2, 3, 4]);
        assert_eq!(runs[0].range, 0..2);
    }

    #[test]
    fn the_larger_improvement_per_byte_comes_first() {
        let costs = |gains: [f64; 2]| MeshCosts { bytes: vec![100, 100], gains: gains.to_vec() };
        // Before and after the parts, the error is 20, 10, 5, 3 and 0.
        let (small, large) = (costs([75.0, 9.0]), costs([300.0, 16.0]));
        let image = |image, bytes, error| WholeCosts { item: Item::Image(image), bytes, error };
        let images = [image(0, 1000, 45.0), image(1, 100, 7.0), image(2, 100, 0.0)];
        let chunks = |mesh, chunks| Item::Chunks { mesh, chunks };
        let expected = [
            chunks(1, 0..1),
            Item::Image(1),
            chunks(0, 0..1),
            Item::Image(0),
            chunks(1, 1..2),
            chunks(0, 1..2),
            Item::Image(2),
        ];
        assert_eq!(schedule(&[small, large], &images, 8.0), expected);
    }

    #[test]
    fn a_mesh_with_a_large_error_that_needs_many_bytes_waits_for_others() {
        // The first mesh has the largest error, the second ones gain more per byte.
        let slow = MeshCosts { bytes: vec![10_000], gains: vec![100.0] };
        let quick = MeshCosts { bytes: vec![100], gains: vec![16.0] };
        let order = schedule(&[slow, quick], &[], 1.0);
        assert_eq!(order[0], Item::Chunks { mesh: 1, chunks: 0..1 });
    }
}
