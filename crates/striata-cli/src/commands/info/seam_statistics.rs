//! Statistics of seams: how many positions and edges they split, and which attributes differ.
//!
//! A welded mesh has one vertex (wedge) for each different set of attributes at a position. An edge is a
//! **seam** if its triangles use different wedges at one of its ends. The counts show how much of a mesh
//! consists of seams, which simplification crosses only at a cost. Time and memory O(n).

use striata::mesh::{Adjacency, Semantic, Welded};

/// Difference between the wedges of a position.
#[derive(Clone, Debug, PartialEq, Eq)]
#[non_exhaustive]
pub(crate) enum SeamCause {
    /// The values of an attribute layer.
    Layer(Semantic),
    /// The materials of their triangles.
    Material,
}

/// Number of positions and edges of a mesh that are split, and the causes.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
#[non_exhaustive]
pub(crate) struct SeamStatistics {
    /// Number of positions that triangles use.
    pub position_count: usize,
    /// Number of wedges of all positions.
    pub wedge_count: usize,
    /// Number of positions with two or more wedges.
    pub split_position_count: usize,
    /// Largest number of wedges of a position.
    pub largest_wedge_count: usize,
    /// Number of edges with two or more triangles.
    pub inner_edge_count: usize,
    /// Number of inner edges along which wedges differ.
    pub seam_edge_count: usize,
    /// Number of split positions per cause, layers first. A position counts for each of its causes; causes
    /// without positions are omitted.
    pub causes: Vec<(SeamCause, usize)>,
}

impl SeamStatistics {
    /// Counts the seams of a welded mesh.
    pub(crate) fn of(welded: &Welded) -> Self {
        let positions = &welded.positions;
        let wedge_counts = || (0..positions.position_count() as u32).map(|p| positions.wedges(p).len());
        let mut statistics = Self {
            position_count: positions.position_count(),
            wedge_count: positions.vertex_count(),
            split_position_count: wedge_counts().filter(|&count| count > 1).count(),
            largest_wedge_count: wedge_counts().max().unwrap_or(0),
            causes: causes(welded),
            ..Self::default()
        };
        for edge in Adjacency::of_positions(&welded.mesh, positions).edges().filter(|e| e.side_count() > 1) {
            let mut ends = edge.sides().map(|side| ends_of_side(welded, side));
            let first = ends.next();
            statistics.inner_edge_count += 1;
            statistics.seam_edge_count += usize::from(ends.any(|other| Some(other) != first));
        }
        statistics
    }
}

/// Returns the vertices at both ends of a side, that of the lower position first.
fn ends_of_side(welded: &Welded, side: u32) -> [u32; 2] {
    let corners = welded.mesh.triangles[side as usize / 3];
    let (from, to) = (corners[side as usize % 3], corners[(side as usize + 1) % 3]);
    // Wedges of a position are consecutive, so vertices have the same order as their positions.
    [from.min(to), from.max(to)]
}

fn causes(welded: &Welded) -> Vec<(SeamCause, usize)> {
    let mesh = &welded.mesh;
    let layers = mesh.layers.iter().map(|layer| {
        let (size, bytes) = (layer.vertex_bytes(), layer.data.as_bytes());
        let value = |v: u32| &bytes[v as usize * size..][..size];
        (SeamCause::Layer(layer.semantic.clone()), count_split(welded, value))
    });
    let materials = materials_of_vertices(welded);
    let of_material = (SeamCause::Material, count_split(welded, |v| materials[v as usize]));
    layers.chain([of_material]).filter(|&(_, count)| count > 0).collect()
}

/// Counts positions whose wedges do not all have the same value.
fn count_split<T: PartialEq>(welded: &Welded, value: impl Fn(u32) -> T) -> usize {
    let is_split = |&p: &u32| {
        let mut values = welded.positions.wedges(p).map(&value);
        let first = values.next();
        values.any(|other| Some(other) != first)
    };
    (0..welded.positions.position_count() as u32).filter(is_split).count()
}

/// Returns the material of each vertex; after welding, no vertex has two.
fn materials_of_vertices(welded: &Welded) -> Vec<Option<u32>> {
    let mut materials = vec![None; welded.mesh.vertex_count()];
    for group in &welded.mesh.groups {
        for &v in welded.mesh.triangles[group.range()].iter().flatten() {
            materials[v as usize] = group.material;
        }
    }
    materials
}

#[cfg(test)]
mod tests {
    use super::*;
    use striata::mesh::{AttributeLayer, IndexedMesh, shapes, weld};

    fn of(mesh: &IndexedMesh) -> SeamStatistics {
        SeamStatistics::of(&weld(mesh).expect("shapes are consistent"))
    }

    #[test]
    fn smooth_meshes_have_no_seams() {
        let found = of(&shapes::icosphere(1, 1.0));
        assert_eq!((found.position_count, found.wedge_count, found.largest_wedge_count), (42, 42, 1));
        assert_eq!((found.inner_edge_count, found.seam_edge_count), (120, 0));
        assert_eq!(found.causes, vec![]);
        assert_eq!(of(&IndexedMesh::default()), SeamStatistics::default());
    }

    #[test]
    fn hard_edges_are_seams_of_the_normals() {
        let found = of(&shapes::hard_cube());
        // The diagonals of the sides are not seams.
        assert_eq!((found.inner_edge_count, found.seam_edge_count), (18, 12));
        assert_eq!((found.split_position_count, found.largest_wedge_count, found.wedge_count), (8, 3, 24));
        assert_eq!(found.causes, vec![(SeamCause::Layer(Semantic::Normal), 8)]);
    }

    #[test]
    fn borders_of_charts_and_materials_are_seams() {
        let cylinder = of(&shapes::uv_cylinder(5, 2));
        assert_eq!((cylinder.seam_edge_count, cylinder.split_position_count), (2, 3));
        assert_eq!(cylinder.causes, vec![(SeamCause::Layer(Semantic::TexCoord(0)), 3)]);
        let ball = of(&shapes::two_material_sphere(6, 8));
        assert!(ball.seam_edge_count > 0);
        assert_eq!(ball.causes, vec![(SeamCause::Material, ball.split_position_count)]);
    }

    #[test]
    fn a_position_may_have_several_causes() {
        let mut mesh = shapes::hard_cube();
        let colors = (0..mesh.vertex_count()).flat_map(|v| [v as f32, 0.0, 0.0]).collect();
        mesh.layers.push(AttributeLayer::from_f32(Semantic::Color(0), 3, colors));
        let found = of(&mesh);
        let [normal, color] = [Semantic::Normal, Semantic::Color(0)].map(|s| (SeamCause::Layer(s), 8));
        assert_eq!(found.causes, vec![normal, color]);
    }
}
