//! The order in which meshes are refined and images follow: the largest improvement per byte first.
//!
//! **Geometry.** A chunk of a mesh reduces its error, measured in units of the scene. Errors fall in steps,
//! so a chunk may gain nothing by itself; runs of chunks are therefore weighed together (the lower convex
//! hull of error over bytes), and a mesh's runs improve less per byte from one to the next.
//!
//! **Images.** An image cannot be shown in part, so it is one item. Its benefit is expressed as the geometric
//! error that would change the picture as much. In a picture of the scene, an error `e` changes a
//! strip of that width along outlines, which are about four diagonals long, by a contrast of a quarter: `e D`
//! in all. A preview changes the area on which the image is seen (a quarter of the area of the surface, by
//! Cauchy's formula) by the contrast it has lost, which was measured: `A c / 4`. So the image stands for an
//! error of `A c / (4 D)`. Normals count half of it and other maps a quarter, because less of them shows in a
//! picture.
//!
//! **Animations** are one item that counts as an error of one percent of the diagonal: a moving scene of that
//! accuracy is worth more than a finer one that stands still.

use std::ops::Range;

/// Lengths of the chunks of a mesh, and the errors that they reduce.
#[derive(Clone, Debug, Default)]
pub(super) struct MeshCosts {
    /// Length of each chunk after the base, bytes.
    pub bytes: Vec<u64>,
    /// Error before each of these chunks, units of the scene; 0 after the last.
    pub errors: Vec<f64>,
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
    /// The image with this index.
    Image(usize),
    /// The data of all animations.
    Animations,
}

/// Returns all chunks and other items in the order of their improvement per byte.
pub(super) fn schedule(meshes: &[MeshCosts], others: &[WholeCosts]) -> Vec<Item> {
    let mut items: Vec<(f64, Item)> = Vec::new();
    for (mesh, costs) in meshes.iter().enumerate() {
        let runs = runs(costs).into_iter();
        items.extend(runs.map(|(gain, chunks)| (gain, Item::Chunks { mesh, chunks })));
    }
    items.extend(others.iter().map(|costs| (costs.error / costs.bytes.max(1) as f64, costs.item.clone())));
    // Stable: the runs of a mesh keep their order.
    items.sort_by(|(a, _), (b, _)| b.total_cmp(a));
    items.into_iter().map(|(_, item)| item).collect()
}

/// Divides the chunks of a mesh into runs of falling improvement per byte.
fn runs(costs: &MeshCosts) -> Vec<(f64, Range<usize>)> {
    let mut runs: Vec<(f64, u64, Range<usize>)> = Vec::new();
    let after = costs.errors.iter().skip(1).copied().chain([0.0]);
    for (chunk, ((&bytes, &before), after)) in costs.bytes.iter().zip(&costs.errors).zip(after).enumerate() {
        let mut run = (before - after, bytes.max(1), chunk..chunk + 1);
        let rate = |run: &(f64, u64, Range<usize>)| run.0 / run.1 as f64;
        while let Some(last) = runs.pop_if(|last| rate(last) <= rate(&run)) {
            run = (last.0 + run.0, last.1 + run.1, last.2.start..run.2.end);
        }
        runs.push(run);
    }
    runs.into_iter().map(|(gain, bytes, chunks)| (gain / bytes as f64, chunks)).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn runs_contain_all_chunks_in_order_and_gain_less_and_less() {
        let costs = MeshCosts { bytes: vec![10, 10, 50, 5, 100], errors: vec![8.0, 8.0, 4.0, 4.0, 1.0] };
        let runs = runs(&costs);
        assert!(runs.windows(2).all(|pair| pair[0].0 > pair[1].0));
        let chunks: Vec<usize> = runs.iter().flat_map(|(_, chunks)| chunks.clone()).collect();
        assert_eq!(chunks, [0, 1, 2, 3, 4]);
        assert_eq!(runs[0].1, 0..2);
    }

    #[test]
    fn the_larger_improvement_per_byte_comes_first() {
        let small = MeshCosts { bytes: vec![100, 100], errors: vec![1.0, 0.1] };
        let large = MeshCosts { bytes: vec![100, 100], errors: vec![10.0, 0.5] };
        let image = |image, bytes, error| WholeCosts { item: Item::Image(image), bytes, error };
        let images = [image(0, 1000, 2.0), image(1, 100, 0.7), image(2, 100, 0.0)];
        let chunks = |mesh, chunks| Item::Chunks { mesh, chunks };
        let expected = [
            chunks(1, 0..1),
            chunks(0, 0..1),
            Item::Image(1),
            chunks(1, 1..2),
            Item::Image(0),
            chunks(0, 1..2),
            Item::Image(2),
        ];
        assert_eq!(schedule(&[small, large], &images), expected);
    }
}
