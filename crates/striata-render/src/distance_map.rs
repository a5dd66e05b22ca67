//! Distance maps: how far each vertex of the original is from a level, as colors.

use striata::mesh::{IndexedMesh, MeshError, TriangleTree};

use super::paint::Color;
use super::srgb::from_srgb;

/// Distance of each vertex of a mesh from another surface.
#[derive(Clone, Debug, PartialEq)]
pub struct DistanceMap {
    /// Distance of each vertex, mesh units; 0 for vertices that no triangle uses.
    pub distances: Vec<f64>,
    /// Largest distance.
    pub max: f64,
}

impl DistanceMap {
    /// Measures the distances of all vertices that triangles use.
    ///
    /// # Errors
    /// If the other surface is not a valid mesh.
    pub fn of(original: &IndexedMesh, level: &IndexedMesh) -> Result<Self, MeshError> {
        let tree = TriangleTree::new(level)?;
        let mut is_used = vec![false; original.vertex_count()];
        original.triangles.iter().flatten().for_each(|&v| is_used[v as usize] = true);
        let distance = |(position, is_used): (&[f32; 3], bool)| {
            if is_used { tree.distance_to(position.map(f64::from)) } else { 0.0 }
        };
        let distances: Vec<f64> = original.positions.iter().zip(is_used).map(distance).collect();
        let max = distances.iter().copied().fold(0.0, f64::max);
        Ok(Self { distances, max })
    }

    /// Vertex colors; distances of `top` and more get the last color.
    pub fn colors(&self, top: f64) -> Vec<Color> {
        let share = |distance: f64| if top > 0.0 { (distance / top).min(1.0) } else { 0.0 };
        self.distances.iter().map(|&distance| bytes(color_at(share(distance)))).collect()
    }
}

/// Color of a fraction of the largest distance, linear light: the inferno map in reverse, from pale for
/// close to dark for far. Its darkest part is left out because it looks like shadow.
pub(crate) fn color_at(share: f64) -> [f32; 3] {
    const DARKEST: f64 = 0.22;
    // Interpolated between entries of the map, because its 8-bit colors are too coarse in the dark.
    let position = 255.0 * (1.0 - (1.0 - DARKEST) * share.clamp(0.0, 1.0));
    let (below, above) = (position.floor(), position.ceil());
    let [a, b] = [below, above].map(|at| {
        let color = colorous::INFERNO.eval_continuous(at / 255.0);
        [color.r, color.g, color.b].map(from_srgb)
    });
    let weight = (position - below) as f32;
    [0, 1, 2].map(|k| a[k] + weight * (b[k] - a[k]))
}

fn bytes([r, g, b]: [f32; 3]) -> Color {
    let [r, g, b] = [r, g, b].map(|light| (255.0 * light + 0.5) as u8);
    [r, g, b, 255]
}

#[cfg(test)]
mod tests {
    use striata::mesh::shapes;

    use super::*;

    #[test]
    fn distances_are_measured_from_the_surface() {
        let level = shapes::grid(1, 1);
        let flat = level.positions[0];
        let axis = (0..3).find(|&k| level.positions.iter().all(|p| p[k] == flat[k])).expect("it is flat");
        let mut above: [f32; 3] = [0, 1, 2].map(|k| (level.positions[1][k] + level.positions[2][k]) / 2.0);
        above[axis] += 0.25;
        let mut original = level.clone();
        original.positions.extend([above, [0.0, 0.0, 9.0]]);
        original.triangles.push([0, 1, 4]);
        let heat = DistanceMap::of(&original, &level).expect("sound meshes");
        assert!((heat.max - 0.25).abs() < 1e-6 && heat.distances[..4] == [0.0; 4], "{heat:?}");
        assert_eq!(heat.distances[5], 0.0, "no triangle uses this vertex");
        let colors = heat.colors(heat.max);
        assert_eq!((colors[0], colors[4]), (bytes(color_at(0.0)), bytes(color_at(1.0))));
        assert_eq!(heat.colors(0.0)[4], bytes(color_at(0.0)));
    }

    #[test]
    fn larger_distances_are_darker() {
        let light = |step: u32| {
            let [r, g, b] = color_at(f64::from(step) / 64.0);
            0.2126 * r + 0.7152 * g + 0.0722 * b
        };
        assert!(light(0) > 0.9 && light(64) < 0.04, "{} {}", light(0), light(64));
        for step in 0..64 {
            assert!(light(step + 1) < light(step), "step {step}");
        }
    }
}
