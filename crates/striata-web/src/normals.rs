//! Computes smooth normals for meshes without normals.
//!
//! Each triangle adds its normal, weighted by its area, to the positions of its corners. All vertices that
//! share a position get the direction of the sum, so seams do not show. Cost: linear time, 12 bytes per
//! position.

/// Returns unit normals of all vertices. `first_vertices` contains the first vertex of each position,
/// followed by the vertex count. A vertex whose triangles have no area gets the z axis.
pub(crate) fn of_vertices(
    positions: &[[f32; 3]],
    triangles: &[[u32; 3]],
    first_vertices: &[u32],
) -> Vec<[f32; 3]> {
    let mut sums = vec![[0.0f32; 3]; positions.len()];
    for triangle in triangles {
        let normal = area_normal(triangle.map(|v| positions[v as usize]));
        for v in triangle {
            add(&mut sums[*v as usize], normal);
        }
    }
    for wedges in first_vertices.windows(2) {
        let (first, end) = (wedges[0] as usize, wedges[1] as usize);
        let mut sum = [0.0; 3];
        sums[first..end].iter().for_each(|&one| add(&mut sum, one));
        sums[first..end].fill(unit(sum));
    }
    sums
}

fn add(sum: &mut [f32; 3], other: [f32; 3]) {
    *sum = [sum[0] + other[0], sum[1] + other[1], sum[2] + other[2]];
}

/// Normal whose length is twice the area of the triangle.
fn area_normal([a, b, c]: [[f32; 3]; 3]) -> [f32; 3] {
    let (u, v) = ([0, 1, 2].map(|i| b[i] - a[i]), [0, 1, 2].map(|i| c[i] - a[i]));
    [u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2], u[0] * v[1] - u[1] * v[0]]
}

fn unit(vector: [f32; 3]) -> [f32; 3] {
    // Scaled by the largest component first: squared areas in tiny units underflow.
    let largest = vector.iter().fold(0.0f32, |most, x| most.max(x.abs()));
    if !(largest > 0.0 && largest.is_finite()) {
        return [0.0, 0.0, 1.0];
    }
    let scaled = vector.map(|x| x / largest);
    let length = scaled.iter().map(|x| x * x).sum::<f32>().sqrt();
    scaled.map(|x| x / length)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn normals_are_equal_across_a_seam() {
        // A roof of two triangles over the edge from vertices 0, 1 to 2, 3, which are duplicated for the
        // two sides.
        let along = [0.0, 0.0, 0.0];
        let end = [0.0, 1.0, 0.0];
        let positions = [along, along, end, end, [1.0, 0.0, -1.0], [-1.0, 0.0, -1.0]];
        let normals = of_vertices(&positions, &[[0, 4, 2], [1, 3, 5]], &[0, 2, 4, 5, 6]);
        assert_eq!(normals[0], [0.0, 0.0, 1.0]);
        assert_eq!(normals[0], normals[1]);
        assert!(normals[4][0] > 0.7 && normals[5][0] < -0.7);
    }

    #[test]
    fn triangles_without_area_get_finite_normals() {
        let positions = [[0.0; 3], [1e-30, 0.0, 0.0], [0.0, 1e-30, 0.0], [f32::NAN; 3]];
        let normals = of_vertices(&positions, &[[0, 1, 2], [0, 1, 3]], &[0, 1, 2, 3, 4]);
        assert!(normals.iter().all(|n| n.iter().all(|x| x.is_finite())), "{normals:?}");
    }
}
