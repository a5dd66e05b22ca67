//! Triangles in the order in which steps add them, so that every level uses a prefix of them.

use striata::mesh::RefinableMesh;

/// The triangles of a mesh, ordered by the step that adds them: those of the base first.
#[derive(Debug)]
pub(crate) struct StepOrder {
    pub triangles: Vec<[u32; 3]>,
    /// Group of each triangle.
    pub groups: Vec<u32>,
    /// Number of triangles that each step adds.
    pub added_counts: Vec<u8>,
}

impl StepOrder {
    /// Orders the triangles of a mesh; [`None`] if a step adds more than 255, as where that many share an edge.
    pub(crate) fn of(refinable: &RefinableMesh) -> Option<Self> {
        let RefinableMesh { mesh, sequence } = refinable;
        let mut group_of = vec![0; mesh.triangles.len()];
        for (number, group) in (0u32..).zip(&mesh.groups) {
            let range = group.first as usize..(group.first + group.count) as usize;
            if let Some(triangles) = group_of.get_mut(range) {
                triangles.fill(number);
            }
        }
        // Counting sort by split count: the base first.
        let steps: Vec<usize> =
            mesh.triangles.iter().map(|&corners| split_count_of(refinable, corners)).collect();
        let mut counts = vec![0u32; sequence.step_count() + 1];
        steps.iter().for_each(|&step| counts[step] += 1);
        let added_counts = counts[1..].iter().map(|&count| u8::try_from(count).ok());
        let added_counts = added_counts.collect::<Option<_>>()?;
        let mut next = 0;
        let mut places: Vec<u32> = counts
            .iter()
            .map(|&count| {
                next += count;
                next - count
            })
            .collect();
        let mut triangles = vec![[0; 3]; mesh.triangles.len()];
        let mut groups = vec![0; triangles.len()];
        for (triangle, &step) in steps.iter().enumerate() {
            let place = places[step] as usize;
            places[step] += 1;
            triangles[place] = mesh.triangles[triangle];
            groups[place] = group_of[triangle];
        }
        Some(Self { triangles, groups, added_counts })
    }
}

/// Split count of the coarsest level that contains a triangle: at coarser ones, two of its corners share a
/// position.
fn split_count_of(RefinableMesh { sequence, .. }: &RefinableMesh, corners: [u32; 3]) -> usize {
    let index = sequence.positions();
    let base_count = sequence.base_position_count() as u32;
    let mut corners = corners;
    loop {
        let positions = corners.map(|corner| index.position_of(corner));
        let last = (0..3).max_by_key(|&i| positions[i]).unwrap_or(0);
        if positions[last] < base_count {
            return 0;
        }
        let target = sequence.target(corners[last]);
        let position = index.position_of(target);
        if (0..3).any(|i| i != last && positions[i] == position) {
            return (positions[last] - base_count) as usize + 1;
        }
        corners[last] = target;
    }
}
