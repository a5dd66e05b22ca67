//! Normals of triangles and vertices, for formats that need them if the mesh has none.

use std::ops::Range;

/// Returns the normal times twice the area, as `f64` because of tiny and huge meshes.
fn area_normal(positions: &[[f32; 3]], triangle: [u32; 3]) -> [f64; 3] {
    let [a, b, c] = triangle.map(|v| positions[v as usize].map(f64::from));
    let (u, v) = ([0, 1, 2].map(|i| b[i] - a[i]), [0, 1, 2].map(|i| c[i] - a[i]));
    [u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2], u[0] * v[1] - u[1] * v[0]]
}

/// Normalizes a vector; [`None`] if it is zero or not finite.
pub(crate) fn unit(vector: [f64; 3]) -> Option<[f32; 3]> {
    let largest = vector.iter().fold(0.0f64, |m, x| m.max(x.abs()));
    if !(largest > 0.0 && largest.is_finite()) {
        return None;
    }
    let scaled = vector.map(|x| x / largest);
    let length = scaled.iter().map(|x| x * x).sum::<f64>().sqrt();
    Some(scaled.map(|x| (x / length) as f32))
}

/// Returns the normal of a triangle, or zero if it has no area.
pub(crate) fn of_triangle(positions: &[[f32; 3]], triangle: [u32; 3]) -> [f32; 3] {
    unit(area_normal(positions, triangle)).unwrap_or([0.0; 3])
}

/// Returns area-weighted normals of the vertices in `range`, from the triangles entirely inside it.
///
/// Vertices without such a triangle get +z, because the result must be unit vectors.
pub(crate) fn of_vertices(
    positions: &[[f32; 3]],
    triangles: &[[u32; 3]],
    range: Range<usize>,
) -> Vec<[f32; 3]> {
    let mut sums = NormalSums::of(range.len());
    for &triangle in triangles {
        if triangle.iter().all(|&v| range.contains(&(v as usize))) {
            sums.add(area_normal(positions, triangle), triangle.map(|v| v as usize - range.start));
        }
    }
    sums.into_normals()
}

/// Sums of the normals of the triangles around each vertex.
pub(crate) struct NormalSums(Vec<[f64; 3]>);

impl NormalSums {
    /// Starts with zero for each vertex.
    pub(crate) fn of(vertex_count: usize) -> Self {
        Self(vec![[0.0; 3]; vertex_count])
    }

    /// Adds a triangle of a part of the mesh; `numbers` are those of the part's vertices in the whole mesh.
    #[cfg(all(feature = "pieces", not(target_family = "wasm")))]
    pub(crate) fn add_triangle(&mut self, positions: &[[f32; 3]], triangle: [u32; 3], numbers: &[u32]) {
        let corners = triangle.map(|vertex| numbers[vertex as usize] as usize);
        self.add(area_normal(positions, triangle), corners);
    }

    fn add(&mut self, normal: [f64; 3], corners: [usize; 3]) {
        for vertex in corners {
            let sum = &mut self.0[vertex];
            *sum = [0, 1, 2].map(|i| sum[i] + normal[i]);
        }
    }

    /// Normalizes the sums; a sum of zero becomes +z.
    pub(crate) fn into_normals(self) -> Vec<[f32; 3]> {
        self.0.into_iter().map(|sum| unit(sum).unwrap_or([0.0, 0.0, 1.0])).collect()
    }
}
