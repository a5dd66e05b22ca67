//! Measures how far the original vertices are from a simplified group.

use crate::mesh::TriangleTree;

/// Largest number of removed vertices that are kept for each position of a cluster.
const KEPT: usize = 3;
/// Distances below this share of the largest one are not distinguished.
const MEASURED_SHARE: f32 = 0.5;

/// A vertex of the original mesh that has been removed.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct RemovedVertex {
    /// A position near it that is left.
    pub position: u32,
    /// Place of the vertex, mesh units.
    pub place: [f32; 3],
    /// Distance from the surface when it was last measured, mesh units.
    pub distance: f32,
}

/// Keeps those of each position that are farthest away, sorted by position and falling distance.
pub(super) fn keep_farthest(removed: &mut Vec<RemovedVertex>) {
    removed.sort_by(|a, b| a.position.cmp(&b.position).then(b.distance.total_cmp(&a.distance)));
    let mut run = (u32::MAX, 0);
    removed.retain(|r| {
        run = if run.0 == r.position { (run.0, run.1 + 1) } else { (r.position, 1) };
        run.1 <= KEPT
    });
}

/// The surface of a simplified group, with positions of its own numbering.
pub(super) struct GroupSurface<'a> {
    triangles: &'a [[u32; 3]],
    places: &'a [[f32; 3]],
    tree: TriangleTree,
    /// A triangle at each position, if there is one.
    triangle_at: Vec<usize>,
    /// The largest distance so far, mesh units.
    pub error: f32,
}

impl<'a> GroupSurface<'a> {
    /// A surface with triangles between positions; distances below `error` change nothing.
    pub(super) fn new(triangles: &'a [[u32; 3]], places: &'a [[f32; 3]], error: f32) -> Self {
        let mut triangle_at = vec![usize::MAX; places.len()];
        for (i, t) in triangles.iter().enumerate() {
            t.iter().for_each(|&p| triangle_at[p as usize] = i);
        }
        let corners = triangles.iter().map(|t| t.map(|p| places[p as usize])).collect();
        Self { triangles, places, tree: TriangleTree::of_triangles(corners), triangle_at, error }
    }

    /// Measures a removed vertex, and finds a position near it that is left. Returns that and the triangle nearest to it,
    /// or nearly; [`None`] if nothing is left.
    pub(super) fn measure(&mut self, removed: RemovedVertex) -> Option<(usize, RemovedVertex)> {
        let RemovedVertex { position, place, .. } = removed;
        let mut triangle = self.triangle_at[position as usize];
        let enough = f64::from(MEASURED_SHARE * self.error);
        let distance = self.tree.distance_within(place.map(f64::from), enough, &mut triangle) as f32;
        let [a, b, c] = *self.triangles.get(triangle)?;
        self.error = self.error.max(distance);
        let squared = |p: u32| -> f32 {
            let other = self.places[p as usize];
            (0..3).map(|axis| (place[axis] - other[axis]).powi(2)).sum()
        };
        let position = [b, c].into_iter().fold(a, |p, q| if squared(q) < squared(p) { q } else { p });
        Some((triangle, RemovedVertex { position, place, distance }))
    }
}
